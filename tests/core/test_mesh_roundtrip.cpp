#include <QtTest>
#include <clocale>
#include <locale>

#include "test_mesh_files.h"

using namespace wend;
using samples::Encoding;

Q_DECLARE_METATYPE(samples::Encoding)

namespace {

MeshFile flatFile() {
    auto file = toMeshFile<2>(samples::awkwardMesh<2>(4));
    file.uv = file.points.topRows<2>() / 7;
    const auto vertices = file.points.cols();
    samples::Random random;
    MeshField heat{"heat", false, 1, {}}, flow{"flow", false, 3, {}}, ref{"ref", true, 1, {}};
    for (Eigen::Index v = 0; v < vertices; ++v) heat.values.push_back(random() * 1e-300);
    for (Eigen::Index v = 0; v < 3 * vertices; ++v) flow.values.push_back(random(-1e20, 1e20));
    for (std::size_t c = 0; c < file.triangles.size(); ++c) ref.values.push_back(static_cast<double>(c / 8));
    file.fields = {heat, flow, ref};
    return file;
}

MeshFile volumeFile() {
    auto file = toMeshFile<3>(samples::awkwardMesh<3>(3));
    MeshField ref{"ref", true, 1, {}}, stress{"stress", true, 9, {}};
    for (std::size_t c = 0; c < file.tetrahedra.size(); ++c) {
        ref.values.push_back(static_cast<double>(c % 3));
        for (int k = 0; k < 9; ++k) stress.values.push_back(static_cast<double>(c) + k / 9.0);
    }
    file.fields = {ref, stress};
    return file;
}

const MeshField* find(const MeshFile& file, const std::string& name) {
    for (const auto& field : file.fields)
        if (field.name == name) return &field;
    return nullptr;
}

void allFormats(bool volumes) {
    QTest::addColumn<Encoding>("encoding");
    for (const auto& encoding : samples::encodings())
        if (!volumes || encoding.tetrahedra) QTest::newRow(encoding.name) << encoding;
}

MeshFile wentThrough(const MeshFile& file, const Encoding& encoding) {
    const samples::Folder folder;
    writeMeshFile(folder.path(encoding.file), file, encoding.options);
    return readMeshFile(folder.path(encoding.file));
}

/// STL numbers vertices by their first use: compare the corners' positions.
bool sameCorners(const MeshFile& a, const MeshFile& b, bool exact) {
    if (a.triangles.size() != b.triangles.size()) return false;
    for (std::size_t t = 0; t < a.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            for (int x = 0; x < 3; ++x) {
                const double p = a.points(x, a.triangles[t][k]), q = b.points(x, b.triangles[t][k]);
                if ((exact ? p : static_cast<double>(static_cast<float>(p))) != q) return false;
            }
    return true;
}

bool isStl(const Encoding& encoding) {
    return std::string(encoding.file).ends_with(".stl");
}

}  // namespace

class TestMeshRoundtrip : public QObject {
    Q_OBJECT

  private slots:
    void triangles_data() { allFormats(false); }
    void triangles() {
        QFETCH(Encoding, encoding);
        const auto file = flatFile(), back = wentThrough(file, encoding);
        if (isStl(encoding)) {
            QVERIFY(sameCorners(file, back, encoding.exact));
            return;
        }
        QVERIFY(samples::sameBits(file.points, back.points));
        QVERIFY(file.triangles == back.triangles);
        QVERIFY(back.tetrahedra.empty());
        if (encoding.uv) QVERIFY(samples::sameBits(file.uv, back.uv));
        if (!encoding.fields) return;
        QVERIFY(find(back, "heat") && find(back, "heat")->values == file.fields[0].values);
        QVERIFY(find(back, "ref") && find(back, "ref")->values == file.fields[2].values);
        QVERIFY(find(back, "ref")->perCell && !find(back, "heat")->perCell);
        if (std::string(encoding.file) == "a.ply") {  // a property per component
            for (std::size_t v = 0; v < file.fields[0].values.size(); ++v)
                QCOMPARE(find(back, "flow_2")->values[v], file.fields[1].values[3 * v + 2]);
        } else {
            QCOMPARE(find(back, "flow")->components, 3);
            QCOMPARE(find(back, "flow")->values, file.fields[1].values);
        }
    }

    void tetrahedra_data() { allFormats(true); }
    void tetrahedra() {
        QFETCH(Encoding, encoding);
        const auto file = volumeFile(), back = wentThrough(file, encoding);
        QVERIFY(samples::sameBits(file.points, back.points));
        QVERIFY(file.tetrahedra == back.tetrahedra);
        QVERIFY(back.triangles.empty());
        if (encoding.fields) {
            QCOMPARE(find(back, "stress")->values, file.fields[1].values);
            QCOMPARE(find(back, "stress")->components, 9);
        }
    }

    /// The cells' tags have another name in every format, but their values survive.
    void tags_data() { allFormats(true); }
    void tags() {
        QFETCH(Encoding, encoding);
        auto file = volumeFile();
        file.fields.resize(1);
        for (double& ref : file.fields[0].values) ref += 5;
        const auto back = wentThrough(file, encoding);
        bool found = false;
        for (const char* name : {"ref", "physical", "attribute"})
            found = found || (find(back, name) && find(back, name)->values == file.fields[0].values);
        QVERIFY(found);
    }

    /// Boundary triangles of a volume are kept where the format knows them.
    void boundaries_data() { allFormats(true); }
    void boundaries() {
        QFETCH(Encoding, encoding);
        auto file = volumeFile();
        for (const auto& facet : facetsOf<3>(samples::grid<3>(3)))
            if (!facet.interior()) file.triangles.push_back(facet.vertices);
        const auto back = wentThrough(file, encoding);
        QVERIFY(file.tetrahedra == back.tetrahedra);
        if (encoding.triangles3d) QVERIFY(file.triangles == back.triangles);
        if (encoding.fields) QCOMPARE(find(back, "ref")->values, file.fields[0].values);
    }

    /// The labels of boundaries are kept, and their names in Gmsh's files.
    void labels_data() { allFormats(true); }
    void labels() {
        QFETCH(Encoding, encoding);
        auto file = volumeFile();
        for (const auto& facet : facetsOf<3>(samples::grid<3>(3)))
            if (!facet.interior()) file.triangles.push_back(facet.vertices);
        for (std::size_t t = 0; t < file.triangles.size(); ++t)
            file.labels.push_back(static_cast<int>(t / 7 % 3));
        file.labelNames = {"left side", "right \"side\""};
        const auto back = wentThrough(file, encoding);
        if (!encoding.triangles3d) return;
        QCOMPARE(back.labels, file.labels);
        if (encoding.fields) QCOMPARE(find(back, "stress")->values, file.fields[1].values);
        if (std::string(encoding.file).ends_with(".msh"))
            QVERIFY(back.labelNames == (std::vector<std::string>{"left side", "right 'side'"}));
    }

    void surfaceInSpace_data() { allFormats(false); }
    void surfaceInSpace() {
        QFETCH(Encoding, encoding);
        auto file = flatFile();
        file.fields.clear();
        file.points.row(2) = file.points.row(0).array().sin() + 1e-3;
        if (!encoding.triangles3d) {
            QVERIFY_THROWS_EXCEPTION(InputError, wentThrough(file, encoding));
            return;
        }
        const auto back = wentThrough(file, encoding);
        if (isStl(encoding))
            QVERIFY(sameCorners(file, back, encoding.exact));
        else
            QVERIFY(samples::sameBits(file.points, back.points));
    }

    /// A user's locale with a decimal comma changes neither writing nor reading.
    void locale_data() { allFormats(false); }
    void locale() {
        QFETCH(Encoding, encoding);
        const samples::Folder folder;
        const auto file = flatFile();
        writeMeshFile(folder.path(encoding.file), file, encoding.options);
        const std::string before = folder.get(encoding.file);
        const std::string old = std::setlocale(LC_ALL, nullptr);
        struct Comma : std::numpunct<char> {
            char do_decimal_point() const override { return ','; }
            std::string do_grouping() const override { return "\3"; }
        };
        const std::locale oldCpp = std::locale::global(std::locale(std::locale::classic(), new Comma));
        qputenv("LOCPATH", WEND_LOCALES);
        const bool isGerman = std::setlocale(LC_ALL, "de_DE.UTF-8");
        const std::string point = std::localeconv()->decimal_point;
        writeMeshFile(folder.path(encoding.file), file, encoding.options);
        const auto back = readMeshFile(folder.path(encoding.file));
        std::locale::global(oldCpp);
        std::setlocale(LC_ALL, old.c_str());
        QVERIFY(isGerman && point == ",");
        QCOMPARE(folder.get(encoding.file), before);
        QCOMPARE(back.triangles.size(), file.triangles.size());
        if (encoding.exact && !isStl(encoding)) QVERIFY(samples::sameBits(file.points, back.points));
    }

    void partition() {
        const auto flat = samples::awkwardMesh<2>(3);
        const auto flatBack = meshFrom<2>(toMeshFile(flat));
        QVERIFY(samples::sameBits(flat.points, flatBack.points) && flat.cells == flatBack.cells);
        const auto solid = samples::awkwardMesh<3>(2);
        const auto solidBack = meshFrom<3>(toMeshFile(solid));
        QVERIFY(samples::sameBits(solid.points, solidBack.points) && solid.cells == solidBack.cells);
        QVERIFY(isVolume(toMeshFile(solid)) && !isVolume(toMeshFile(flat)));

        auto raised = toMeshFile(flat);
        raised.points.row(2).setConstant(3);
        QVERIFY(samples::sameBits(meshFrom<2>(raised).points, flat.points));
        raised.points(2, 5) = 3.001;
        QVERIFY_THROWS_EXCEPTION(InputError, meshFrom<2>(raised));
        QVERIFY_THROWS_EXCEPTION(InputError, meshFrom<2>(toMeshFile(solid)));
        QVERIFY_THROWS_EXCEPTION(InputError, meshFrom<3>(toMeshFile(flat)));
        auto inverted = toMeshFile(solid);
        std::swap(inverted.tetrahedra[4][0], inverted.tetrahedra[4][1]);
        const auto turned = meshFrom<3>(inverted);  // a matter of order
        for (const auto& cell : turned.cells) QVERIFY(cellMeasure<3>(turned.points, cell) > 0);
        auto folded = toMeshFile(samples::grid<2>(2));
        folded.points.col(4) = Eigen::Vector3d(1.2, 0.5, 0);  // the middle, over the right side
        QVERIFY_THROWS_EXCEPTION(InputError, meshFrom<2>(folded));
    }

    void notDamagedByAFailure() {
        const samples::Folder folder;
        const auto good = toMeshFile(samples::grid<2>(2));
        const auto solid = toMeshFile(samples::grid<3>(1));
        writeMeshFile(folder.path("a.obj"), good);
        const auto before = folder.get("a.obj");
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("a.obj"), solid));
        auto bad = good;
        bad.points(0, 0) = std::nan("");
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("a.obj"), bad));
        bad = good;
        bad.triangles[0][0] = 1000;
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("a.obj"), bad));
        bad = good;
        bad.fields.push_back({"short", false, 1, {1, 2}});
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("a.obj"), bad));
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("no/such/a.obj"), good));
        QVERIFY_THROWS_EXCEPTION(InputError, writeMeshFile(folder.path("a.xyz"), good));
        QCOMPARE(folder.get("a.obj"), before);
        QCOMPARE(QDir(folder.path("").c_str()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }
};

QTEST_APPLESS_MAIN(TestMeshRoundtrip)
#include "test_mesh_roundtrip.moc"
