#include <QtTest>

#include "core/base/number_text.h"
#include "core/mesh/formats/mesh_format.h"
#include "test_mesh_files.h"

using namespace wend;
using samples::Encoding;

Q_DECLARE_METATYPE(samples::Encoding)

namespace {

MeshFile smallFile(bool volume) {
    auto file =
        volume ? toMeshFile<3>(samples::jitteredGrid<3>(1)) : toMeshFile<2>(samples::jitteredGrid<2>(2));
    MeshField ref{"ref", true, 1, {}}, flow{"flow", false, 2, {}};
    ref.values.assign(volume ? file.tetrahedra.size() : file.triangles.size(), 2);
    flow.values.assign(2 * file.points.cols(), 0.5);
    file.fields = {ref, flow};
    return file;
}

/// The mesh as the file or files of an encoding, without a file system, which would take most of the time.
std::vector<formats::MeshSource> sourcesOf(const Encoding& encoding, bool volume) {
    const auto& format = formats::formatOf(encoding.file);
    std::vector<formats::MeshSource> sources;
    for (auto& bytes : formats::printed(format, smallFile(volume), encoding.options))
        sources.push_back(
            {"a" + std::string(sources.size() < format.extensions.size() ? format.extensions[sources.size()]
                                                                         : ".face"),
             std::move(bytes)});
    return sources;
}

/// Either a mesh or an InputError with the file's name: anything else, also a crash, ends the test.
bool isReadOrRefused(const std::vector<formats::MeshSource>& sources, bool& read) {
    read = false;
    try {
        formats::readSources(formats::formatOf(sources[0].path), sources);
        read = true;
        return true;
    } catch (const InputError& error) {
        return error.file().starts_with("a.") && !error.reason().empty() &&
               std::string(error.what()).find('\n') == std::string::npos;
    } catch (const std::exception& error) {
        qWarning("%s", error.what());
        return false;
    }
}

void allEncodings() {
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<bool>("volume");
    for (const auto& encoding : samples::encodings())
        for (bool volume : {false, true})
            if (!volume || encoding.tetrahedra)
                QTest::addRow("%s%s", encoding.name, volume ? ", volume" : "") << encoding << volume;
}

}  // namespace

class TestMeshDamage : public QObject {
    Q_OBJECT

    static std::string numberText(double value) {
        std::string text;
        appendNumber(text, value);
        return text;
    }

  private slots:
    void truncated_data() { allEncodings(); }
    /// The file is truncated at every byte. If more than its last line is lost, it is refused.
    void truncated() {
        QFETCH(Encoding, encoding);
        QFETCH(bool, volume);
        auto sources = sourcesOf(encoding, volume);
        for (auto& source : sources) {
            const auto whole = source.bytes;
            int accepted = 0;
            for (std::size_t length = 0; length < whole.size(); ++length) {
                source.bytes = whole.substr(0, length);
                bool read = false;
                QVERIFY2(isReadOrRefused(sources, read), qPrintable(QString("%1 bytes").arg(length)));
                accepted += read;
            }
            source.bytes = whole;
            // OBJ has no counts: any number of whole faces is a good file
            if (source.path != "a.obj") QVERIFY2(accepted <= 60, qPrintable(QString::number(accepted)));
        }
    }

    void changedBytes_data() { allEncodings(); }
    void changedBytes() {
        QFETCH(Encoding, encoding);
        QFETCH(bool, volume);
        auto sources = sourcesOf(encoding, volume);
        samples::Random random(17);
        for (auto& source : sources) {
            const auto whole = source.bytes;
            for (int round = 0; round < 2000; ++round) {
                auto bytes = whole;
                const int changes = 1 + random.index(round % 5 + 1);
                for (int k = 0; k < changes; ++k) {
                    char& byte = bytes[random.index(static_cast<int>(bytes.size()))];
                    const char digits[] = "0123456789-. \n";
                    const char values[] = {static_cast<char>(byte ^ (1 << random.index(8))),
                                           static_cast<char>(random.index(256)), digits[random.index(14)],
                                           '\xff', '\0'};
                    byte = values[random.index(5)];
                }
                source.bytes = bytes;
                bool read = false;
                if (!isReadOrRefused(sources, read)) {
                    QFAIL(qPrintable(QString("round %1").arg(round)));
                }
            }
            source.bytes = whole;
        }
    }

    /// Pieces of the file are left out or doubled: counts no longer fit.
    void shuffled_data() { allEncodings(); }
    void shuffled() {
        QFETCH(Encoding, encoding);
        QFETCH(bool, volume);
        auto sources = sourcesOf(encoding, volume);
        samples::Random random(23);
        for (auto& source : sources) {
            const auto whole = source.bytes;
            for (int round = 0; round < 500; ++round) {
                const int from = random.index(static_cast<int>(whole.size())), size = random.index(60);
                const int to = random.index(static_cast<int>(whole.size()));
                auto bytes = whole;
                if (round % 2)
                    bytes.erase(from, size);
                else
                    bytes.insert(to, whole.substr(from, size));
                source.bytes = bytes;
                bool read = false;
                QVERIFY(isReadOrRefused(sources, read));
            }
            source.bytes = whole;
        }
    }

    /// Every file is read under every other extension.
    void ofAnotherKind_data() { allEncodings(); }
    void ofAnotherKind() {
        QFETCH(Encoding, encoding);
        QFETCH(bool, volume);
        const auto bytes = sourcesOf(encoding, volume).front().bytes;
        for (const auto& format : formats::meshFormats()) {
            const std::string extension(format.extensions.front());
            if (std::string(encoding.file).ends_with(extension)) continue;
            if (extension == ".inp" && std::string(encoding.name) == "ucd") continue;  // told by its content
            const std::vector<formats::MeshSource> sources = {{"a" + extension, bytes}, {"a.ele", bytes}};
            QVERIFY_THROWS_EXCEPTION(InputError, formats::readSources(format, sources));
        }
    }

    void rubbish_data() {
        QTest::addColumn<QString>("extension");
        for (const auto& extension : meshFileExtensions())
            QTest::newRow(extension.c_str()) << extension.c_str();
    }
    void rubbish() {
        QFETCH(QString, extension);
        const auto refused = [&](const std::string& bytes) {
            bool read = false;
            return isReadOrRefused({{"a" + extension.toStdString(), bytes}, {"a.ele", bytes}}, read) && !read;
        };
        QVERIFY(refused(""));
        QVERIFY(refused("\n\n  \n"));
        QVERIFY(refused(std::string(1000, '\0')));
        QVERIFY(refused("\x89PNG\r\n\x1a\n" + std::string(200, '\x7f')));
        QVERIFY(refused("{\"format\": \"wend\"}"));
        QVERIFY(refused(std::string(100000, '9')));
        QVERIFY(refused(std::string(100000, '<')));
        samples::Random random;
        for (int round = 0; round < 200; ++round) {
            std::string noise(1 + random.index(300), ' ');
            for (char& c : noise) c = static_cast<char>(random.index(256));
            QVERIFY(refused(noise));
        }
    }

    /// No size from a header is allocated unless the file can hold it.
    void absurdCounts_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        const char* many[] = {"2000000000", "9999999999999", "99999999999999999999999", "-1", "1e9"};
        for (const char* count : many) {
            const QByteArray n(count);
            QTest::newRow(("off " + n).constData()) << "a.off"
                                                    << "OFF\n" + n + " 1 0\n0 0 0\n";
            QTest::newRow(("off faces " + n).constData()) << "a.off"
                                                          << "OFF\n1 " + n + " 0\n0 0 0\n";
            QTest::newRow(("off corners " + n).constData()) << "a.off"
                                                            << "OFF\n1 1 0\n0 0 0\n" + n + " 0 0 0\n";
            QTest::newRow(("ply " + n).constData())
                << "a.ply"
                << "ply\nformat ascii 1.0\nelement vertex " + n + "\nproperty float x\nend_header\n1\n";
            QTest::newRow(("ply nothing " + n).constData())
                << "a.ply"
                << "ply\nformat binary_little_endian 1.0\nelement vertex " + n + "\nend_header\n";
            QTest::newRow(("medit " + n).constData())
                << "a.mesh"
                << "MeshVersionFormatted 1\nDimension 3\nVertices\n" + n + "\n0 0 0 0\n";
            QTest::newRow(("gmsh 2 " + n).constData())
                << "a.msh"
                << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + n + "\n1 0 0 0\n$EndNodes\n";
            QTest::newRow(("gmsh 4 blocks " + n).constData())
                << "a.msh"
                << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n" + n + " 1 1 1\n";
            QTest::newRow(("gmsh 4 nodes " + n).constData())
                << "a.msh"
                << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + n + " 1 1\n0 1 0 1\n1\n0 0 0\n";
            QTest::newRow(("gmsh tags " + n).constData())
                << "a.msh"
                << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 2 " +
                       n + "\n";
            QTest::newRow(("vtk points " + n).constData())
                << "a.vtk"
                << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS " + n + " float\n0 0 0\n";
            QTest::newRow(("vtk cells " + n).constData()) << "a.vtk"
                                                          << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET "
                                                             "POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS " +
                                                                 n + " 4\n";
            QTest::newRow(("vtk size " + n).constData()) << "a.vtk"
                                                         << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET "
                                                            "POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS 1 " +
                                                                n + "\n";
            QTest::newRow(("vtk offsets " + n).constData())
                << "a.vtk"
                << "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOLYGONS " + n +
                       " 3\nOFFSETS vtktypeint64\n\n";
            QTest::newRow(("vtk field " + n).constData())
                << "a.vtk"
                << "# vtk DataFile Version 3.0\nx\nASCII\nFIELD f 1\nname " + n + " " + n + " float\n";
            QTest::newRow(("vtu points " + n).constData())
                << "a.vtu"
                << "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"" + n +
                       "\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\"/></Points></Piece>"
                       "</UnstructuredGrid></VTKFile>";
            QTest::newRow(("tetgen " + n).constData()) << "a.node" << n + " 3 0 0\n1 0 0 0\n";
            QTest::newRow(("tetgen attributes " + n).constData()) << "a.node"
                                                                  << "1 3 " + n + " 0\n1 0 0 0\n";
        }
        QByteArray stl(84, 0);
        stl.replace(80, 4, "\xff\xff\xff\xff");
        QTest::newRow("stl") << "a.stl" << stl + QByteArray(50, 0);
        // base64: uncompressed length 2^31, and a compressed array of 2^40 blocks
        for (const char* data : {"AAAAgA==", "AAAAAAABAAA="})
            for (const char* compressor : {"", "compressor=\"vtkZLibDataCompressor\" header_type=\"UInt64\""})
                QTest::addRow("vtu %s %s", data, compressor)
                    << "a.vtu"
                    << QByteArray("<VTKFile type=\"UnstructuredGrid\" ") + compressor +
                           "><UnstructuredGrid><Piece NumberOfPoints=\"1\" "
                           "NumberOfCells=\"1\"><Points><DataArray "
                           "type=\"Float32\" format=\"binary\">" +
                           data + "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>";
    }
    void absurdCounts() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        const samples::Folder folder;
        folder.put("a.ele", "1 4 0\n1 1 1 1 1\n");
        folder.put(name.toStdString(), bytes.toStdString());
        QVERIFY_THROWS_EXCEPTION(InputError, readMeshFile(folder.path(name.toStdString())));
    }

    /// The place and the reason are checked word by word.
    void reasons_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("reason");
        const QByteArray points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        QTest::newRow("nan") << "a.obj" << QByteArray("v 0 0 0\nv 1 nan 0\n")
                             << "line 2: 'nan' is not a finite number (y is expected)";
        QTest::newRow("inf") << "a.off" << QByteArray("OFF\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n")
                             << "line 3: 'inf' is not a finite number (a coordinate is expected)";
        QTest::newRow("letter") << "a.obj" << QByteArray("# a\nv 0 0 0x\n")
                                << "line 2: '0x' is not a number (z is expected)";
        QTest::newRow("short line") << "a.obj" << QByteArray("v 0 0\nv 1 1 1\n")
                                    << "line 1: the line ends where z is expected";
        QTest::newRow("index") << "a.obj" << points + "f 1 2 4\n"
                               << "line 4: 4 is named, but there are only 3 vertices";
        QTest::newRow("index 0") << "a.obj" << points + "f 1 2 0\n"
                                 << "line 4: vertices are counted from 1, there is no number 0";
        QTest::newRow("index back") << "a.obj" << points + "f 1 2 -4\n"
                                    << "line 4: -4 counts back beyond the first";
        QTest::newRow("two corners") << "a.obj" << points + "f 1 2\n"
                                     << "line 4: a face needs three corners";
        QTest::newRow("other text") << "a.obj" << QByteArray("solid x\n")
                                    << "line 1: 'solid' is no keyword of an OBJ file";
        QTest::newRow("no faces")
            << "a.obj" << points
            << "holds 3 points, but neither triangles nor tetrahedra between them: a surface has to be made "
               "of the points first, as MeshLab and CloudCompare do";
        QTest::newRow("no vertices") << "a.obj" << QByteArray("o x\n") << "there is no vertex in it";
        QTest::newRow("off end") << "a.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n")
                                 << "line 6: the file ends where a vertex number is expected";
        QTest::newRow("off more")
            << "a.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\nmore\n")
            << "line 7: 'more' is not a whole number (the number of corners is expected)";
        QTest::newRow("off other text") << "a.off" << QByteArray("solid x\n")
                                        << "line 1: begins with 'solid' instead of OFF: no OFF file";
        QTest::newRow("off of four") << "a.off" << QByteArray("4OFF\n8 6 12\n")
                                     << "line 1: '4OFF': its points have four coordinates; only points in "
                                        "space, which have three, are read";
        QTest::newRow("off of any") << "a.off" << QByteArray("nOFF 5\n8 6 12\n")
                                    << "line 1: 'nOFF': its points have any number of coordinates; only "
                                       "points in space, which have three, are read";
        const QByteArray cloud =
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
        const QByteArray two = "end_header\n0 0 0\n1 0 0\n";
        QTest::newRow("ply of points")
            << "a.ply" << cloud + two
            << "holds 2 points, but neither triangles nor tetrahedra between them: a surface has to be made "
               "of the points first, as MeshLab and CloudCompare do";
        QTest::newRow("ply of strips")
            << "a.ply"
            << cloud + "element tristrips 1\nproperty list int int vertex_indices\n" + two + "3 0 1 2\n"
            << "strip 0 names vertex 2, but there are only 2 (counted from 0)";
        QTest::newRow("off appearance")
            << "a.off" << QByteArray("appearance {\n+face {\n}\nOFF\n3 1 0\n")
            << "line 5: the file ends where the end of the appearance is expected";
        QTest::newRow("stl") << "a.stl" << QByteArray("solid x\nfacet normal 0 0 1\nouter lop\n")
                             << "line 3: 'lop' where 'loop' is expected";
        const auto ucd = [](const char* name, const char* text, const char* reason) {
            QTest::newRow(name) << "a.inp" << QByteArray(text) << reason;
        };
        ucd("ucd nodes", "900000000 1 0 0 0\n1 0 0 0\n",
            "line 1: there should be 900000000 nodes, but the file is too short for so many");
        ucd("ucd twice", "2 1 0 0 0\n1 0 0 0\n1 1 0 0\n", "line 3: node 1 is there a second time");
        ucd("ucd unknown", "2 1 0 0 0\n1 0 0 0\n2 1 0 0\n1 0 tri 1 2 3\n", "line 4: node 3 is not there");
        ucd("ucd kind", "1 1 0 0 0\n1 0 0 0\n1 0 cone 1 1 1 1 1 1\n",
            "line 3: 'cone' is no kind of cell that is read");
        ucd("ucd components", "3 1 2 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0 tri 1 2 3\n1 1\nx, y\n",
            "line 6: the fields have 1 components where the first line says 2");
        ucd("ucd end", "3 1 1 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0 tri 1 2 3\n1 1\nx, y\n1 5\n2",
            "line 9: the file ends where a value is expected");
        ucd("ucd binary", "\7abc", "line 1: a binary UCD file is not read");
        QTest::newRow("medit index")
            << "a.mesh"
            << QByteArray("MeshVersionFormatted 1\nDimension 2\nVertices 1\n0 0 0\nTriangles 1\n1 1 2 0\n")
            << "line 6: vertex 2 is named, but there are only 1";
        QTest::newRow("medit hexahedra")
            << "a.mesh" << QByteArray("MeshVersionFormatted 1\nDimension 3\nHexahedra 1\n1 1 1 1 1 1 1 1 0\n")
            << "line 4: vertex 1 is named, but there are only 0";
        QTest::newRow("gmsh version") << "a.msh" << QByteArray("$MeshFormat\n5 0 8\n$EndMeshFormat\n")
                                      << "line 2: version '5' is not read; save the mesh as 4.1 or 2.2";
        QTest::newRow("gmsh node")
            << "a.msh"
            << QByteArray(
                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n7 0 0 0\n$EndNodes\n"
                   "$Elements\n1\n1 2 0 7 7 8\n$EndElements\n")
            << "line 10: there is no node of number 8";
        QTest::newRow("gmsh hexahedron")
            << "a.msh"
            << QByteArray(
                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n7 0 0 0\n$EndNodes\n"
                   "$Elements\n1\n1 92 0 7 7 8\n$EndElements\n")
            << "line 10: a hexahedron of third order is not read";
        QTest::newRow("vtk kind")
            << "a.vtk" << QByteArray("# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_GRID\n")
            << "line 4: 'STRUCTURED_GRID': only UNSTRUCTURED_GRID and POLYDATA are read";
        QTest::newRow("vtk binary end")
            << "a.vtk"
            << QByteArray("# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 1 float\n1234")
            << "byte offset 61: there should be 1 points, but the file is too short for so many";
        QTest::newRow("vtu compressor")
            << "a.vtu"
            << QByteArray("<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkBestDataCompressor\"/>")
            << "line 1: <VTKFile>: it is compressed by 'vtkBestDataCompressor', which is not read";
        QTest::newRow("xml") << "a.vtu" << QByteArray("<VTKFile>\n<a></b>\n</VTKFile>")
                             << "line 2: not valid XML: Start-end tags mismatch";
        QTest::newRow("ply type") << "a.ply"
                                  << QByteArray("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n")
                                  << "line 4: 'quad' is no type of a PLY file";
    }
    void reasons() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, reason);
        const samples::Folder folder;
        const auto path = folder.put(name.toStdString(), bytes.toStdString());
        try {
            readMeshFile(path);
            QFAIL("was read");
        } catch (const InputError& error) {
            QCOMPARE(QString::fromStdString(error.reason()), reason);
            QCOMPARE(error.file(), path);
        }
    }

    void files() {
        const samples::Folder folder;
        const auto reason = [&](const std::string& name) {
            try {
                readMeshFile(folder.path(name));
            } catch (const InputError& error) {
                return QString::fromStdString(error.what()).remove((folder.path("") + "/").c_str());
            }
            return QString();
        };
        QCOMPARE(reason("none.obj"), "none.obj: does not exist");
        folder.put("empty.ply", "");
        QCOMPARE(reason("empty.ply"), "empty.ply: is empty");
        folder.put("a.blend", "x");
        QVERIFY(reason("a.blend").startsWith(
            "a.blend: the mesh format is not known: '.blend' is none of .obj .ply"));
        QVERIFY(reason("noextension").contains("without an extension is none of .obj"));
        QDir(folder.path("").c_str()).mkdir("folder.obj");
        QCOMPARE(reason("folder.obj"), "folder.obj: is a folder");
        folder.put("pair.node", "1 3 0 0\n1 0 0 0\n");
        QCOMPARE(reason("pair.node"), "pair.ele: does not exist");
        folder.put("pair.ele", "1 4 0\n1 1 1 1 2\n");
        QCOMPARE(reason("pair.node"),
                 "pair.ele: line 2: point 2 is named, but there are only 1, counted from 1");
        QCOMPARE(reason("pair.ele"),
                 "pair.ele: line 2: point 2 is named, but there are only 1, counted from 1");
        folder.put("pair.node", "1 3 0 0\n1 0 0 x\n");
        QCOMPARE(reason("pair.ele"), "pair.node: line 2: 'x' is not a number (a coordinate is expected)");
    }

    void numbers() {
        QCOMPARE(numberText(0.1), "0.10000000000000001");
        QCOMPARE(numberText(-1), "-1");
        QCOMPARE(parseNumber("+2.5").value(), 2.5);
        QCOMPARE(parseNumber("1e-400").value(), 0.0);
        for (const char* text : {"", " 1", "1 ", "1,5", "1e400", "+-1", "++1", "0x10", "1.2.3", "--1", "e5"})
            QVERIFY2(!parseNumber(text), text);
        samples::Random random;
        for (int i = 0; i < 1000; ++i) {
            const double value = random(-1, 1) * std::pow(10.0, random.index(600) - 300);
            QCOMPARE(parseNumber(numberText(value)).value(), value);
        }
    }
};

QTEST_APPLESS_MAIN(TestMeshDamage)
#include "test_mesh_damage.moc"
