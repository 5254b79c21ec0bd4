// MED, CGNS, Exodus and XDMF files: everything read is written again, and damaged files are refused in one
// line, whatever the HDF5 library does with them.

#include <QtTest>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/hdf5/hdf5_tree.h"
#include "test_mesh_files.h"

using namespace wend;

namespace {

/// One cell of every kind that the formats hold, in an order that mixes kinds, each with nodes of its own.
MeshFile everyKind() {
    MeshFile file;
    std::vector<Eigen::Vector3d> points;
    samples::Random random(5);
    std::vector<int> kinds(kCellKinds);
    std::iota(kinds.begin(), kinds.end(), 0);
    for (int round = 0; round < 2; ++round)
        for (const int k : kinds) {
            const CellKindFacts& facts = factsOf(static_cast<CellKind>(k));
            if (facts.nodes == 0 || facts.corners == 0) continue;
            std::vector<int> nodes;
            for (int n = 0; n < facts.nodes; ++n) {
                nodes.push_back(static_cast<int>(points.size()));
                points.emplace_back(random(0, 1), random(0, 1), random(0, 1) / 3);
            }
            file.cells.add(static_cast<CellKind>(k), nodes);
        }
    file.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t v = 0; v < points.size(); ++v) file.points.col(static_cast<Eigen::Index>(v)) = points[v];
    return file;
}

/// Groups of every dimension and of vertices, which overlap; names with blanks, letters of any script,
/// slashes and of the greatest length; values of every sort.
MeshFile vocabulary() {
    MeshFile file = everyKind();
    std::map<int, std::vector<int>> byDimension;
    for (int c = 0; c < file.cells.size(); ++c) byDimension[file.cells.dimension(c)].push_back(c);
    const std::string names[] = {"points of rest", "Wände/λ", "fixed end",
                                 "a volume with a name that is longer than 32 letters"};
    for (auto& [dimension, cells] : byDimension) {
        file.groups.push_back({names[dimension], dimension, 0, cells, {}, false});
        file.groups.push_back({"", dimension, 40 + dimension, {cells.back()}, {}, false});
        if (dimension == 0) file.groups.pop_back();  // as the last one of vertices
    }
    file.groups.push_back({"held nodes", 0, 0, {}, {0, 3, 7}, false});
    MeshField whole{"count", true, 1, {}, {}, formats::Scalar::Int32}, heat{"heat", false, 1, {}},
        flow{"flow", false, 3, {}};
    for (int c = 0; c < file.cells.size(); ++c) whole.values.push_back(10 * c - 3);
    for (Eigen::Index v = 0; v < file.points.cols(); ++v) {
        heat.values.push_back(1.0 / (1.0 + static_cast<double>(v)));
        for (int k = 0; k < 3; ++k) flow.values.push_back(static_cast<double>(v) + k / 3.0);
    }
    file.fields = {heat, flow, whole};
    formats::finishCells(file);
    return file;
}

std::map<std::pair<int, std::string>, std::pair<std::vector<int>, std::vector<int>>> groupsOf(
    const MeshFile& file) {
    std::map<std::pair<int, std::string>, std::pair<std::vector<int>, std::vector<int>>> groups;
    for (const MeshGroup& group : file.groups)
        groups[{group.dimension, group.name.empty() ? std::to_string(group.tag) : group.name}] = {
            group.cells, group.vertices};
    return groups;
}

/// The members of groups by their nodes, and all cells as a group without a name.
std::map<std::pair<int, std::string>, std::set<std::set<int>>> byNodes(const MeshFile& mesh) {
    std::map<std::pair<int, std::string>, std::set<std::set<int>>> groups;
    for (const MeshGroup& group : mesh.groups) {
        auto& all = groups[{group.dimension, group.name.empty() ? std::to_string(group.tag) : group.name}];
        for (const int c : group.cells) all.insert({mesh.cells[c].begin(), mesh.cells[c].end()});
        for (const int v : group.vertices) all.insert({v});
    }
    for (int c = 0; c < mesh.cells.size(); ++c)
        groups[{-1, ""}].insert({mesh.cells[c].begin(), mesh.cells[c].end()});
    return groups;
}

const MeshField* find(const MeshFile& file, const std::string& name) {
    for (const auto& field : file.fields)
        if (field.name == name) return &field;
    return nullptr;
}

formats::MeshSource printedAs(const std::string& name, const MeshFile& file, bool compressed = false) {
    MeshWriteOptions options;
    if (compressed) options.encoding = MeshWriteOptions::Encoding::Compressed;
    return {name, formats::printed(formats::formatOf(name), file, options)[0]};
}

}  // namespace

class TestHdf5Formats : public QObject {
    Q_OBJECT

  private slots:
    /// A tree of every type of value comes back as it was.
    void trees() {
        Hdf5Node root;
        Hdf5Node& group = root.group("ä group");
        group.with("whole", Hdf5Array::of(std::int64_t(-7), formats::Scalar::Int16));
        group.with("text", Hdf5Array::of("a text"));
        const std::vector<double> reals{0.5, -1e300, 3};
        const std::vector<std::int64_t> whole{1, -2, 3, 4, 5, 1LL << 40};
        group.dataSet("reals", Hdf5Array::of(reals, {3}));
        group.dataSet("whole", Hdf5Array::of(whole, {2, 3}));
        group.dataSet("empty", Hdf5Array::of(std::vector<double>(), {0}));
        group.group("deeper").dataSet("one", Hdf5Array::of(2.5));
        for (const bool compressed : {false, true}) {
            const Hdf5Node back = readHdf5(printHdf5(root, compressed));
            const Hdf5Node* found = back.find("ä group");
            QVERIFY(found && found->isGroup);
            QCOMPARE(found->attribute("whole")->integers(), std::vector<std::int64_t>{-7});
            QVERIFY(found->attribute("whole")->type == formats::Scalar::Int16);
            QCOMPARE(found->attribute("text")->text(), std::string("a text"));
            QCOMPARE(found->at("reals").reals(), reals);
            QCOMPARE(found->at("whole").integers(), whole);
            QCOMPARE(found->at("whole").shape, (std::vector<std::int64_t>{2, 3}));
            QCOMPARE(found->at("empty").size(), std::size_t(0));
            QCOMPARE(found->at("deeper/one").reals(), std::vector<double>{2.5});
        }
        QCOMPARE(printHdf5(root, false), printHdf5(root, false));  // no dates in it
    }

    void vocabularies_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("compressed");
        for (const char* name : {"a.med", "a.xdmf"})
            for (const bool compressed : {false, true})
                QTest::addRow("%s %d", name, compressed) << QString(name) << compressed;
    }
    /// Cells in their order, groups, and values, to the last bit; and all of it again when written twice.
    void vocabularies() {
        QFETCH(QString, name);
        QFETCH(bool, compressed);
        const MeshFile file = vocabulary();
        const auto source = printedAs(name.toStdString(), file, compressed);
        const auto& format = formats::formatOf(source.path);
        const MeshFile back = formats::readSources(format, std::span(&source, 1));
        QVERIFY(samples::sameBits(back.points, file.points));
        QVERIFY(back.cells.kinds == file.cells.kinds);
        QCOMPARE(back.cells.nodes, file.cells.nodes);
        QVERIFY(back.notices.empty());
        auto wanted = groupsOf(file), got = groupsOf(back);
        QCOMPARE(got.size(), wanted.size());
        for (const auto& [key, members] : wanted) {
            QVERIFY2(got.contains(key), key.second.c_str());
            QVERIFY(got[key] == members);
        }
        QCOMPARE(find(back, "heat")->values, find(file, "heat")->values);
        QCOMPARE(find(back, "flow")->values, find(file, "flow")->values);
        QCOMPARE(find(back, "flow")->components, 3);
        QCOMPARE(find(back, "count")->ofCells, find(file, "count")->ofCells);
        QVERIFY(find(back, "count")->type == formats::Scalar::Int32);
        QCOMPARE(printedAs(source.path, back, compressed).bytes, source.bytes);
    }

    /// CGNS has the cells of the highest dimension first, and values of these.
    void cgns() {
        for (const bool compressed : {false, true}) {
            const MeshFile file = vocabulary();
            auto source = printedAs("a.cgns", file, compressed);
            const auto& format = formats::formatOf("a.cgns");
            const MeshFile back = formats::readSources(format, std::span(&source, 1));
            QVERIFY(samples::sameBits(back.points, file.points));
            QVERIFY(back.notices.empty());
            QCOMPARE(byNodes(back), byNodes(file));
            QCOMPARE(find(back, "heat")->values, find(file, "heat")->values);
            QCOMPARE(find(back, "flow")->values, find(file, "flow")->values);
            std::vector<double> wanted;
            for (int c = 0; c < file.cells.size(); ++c)
                if (file.cells.dimension(c) == 3)
                    wanted.push_back(find(file, "count")->ofCells[static_cast<std::size_t>(c)]);
            std::vector<double> got = find(back, "count")->ofCells;
            got.resize(wanted.size());
            QCOMPARE(got, wanted);
            source = printedAs("a.cgns", back, compressed);
            const MeshFile again = formats::readSources(format, std::span(&source, 1));
            QCOMPARE(printedAs("a.cgns", again, compressed).bytes, source.bytes);
        }
    }

    /// Exodus has cells in blocks, and faces as sides of cells: cells, groups and values are the same in that
    /// order, also when written twice.
    void exodus() {
        MeshFile file = vocabulary();
        const int first = static_cast<int>(file.points.cols()), hexahedron = file.cells.size();
        file.points.conservativeResize(3, first + 8);
        const Eigen::Vector3d corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                           {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        std::vector<int> nodes;
        for (int k = 0; k < 8; ++k) {
            file.points.col(first + k) = corners[k] + Eigen::Vector3d(7, 7, 7);
            nodes.push_back(first + k);
        }
        file.cells.add(CellKind::Hexahedron, nodes);
        file.cells.add(CellKind::Quad, std::array{first, first + 3, first + 2, first + 1});
        file.cells.add(CellKind::Quad, std::array{first + 4, first + 5, first + 6, first + 7});
        file.groups.push_back({"inlet", 2, 0, {hexahedron + 1}, {}, false});
        file.groups.push_back({"wall λ with a name of more than 32 letters",
                               2,
                               0,
                               {hexahedron + 1, hexahedron + 2},
                               {},
                               false});
        file.fields = {{"heat", false, 1, {}}, {"flow", false, 3, {}}};
        for (int v = 0; v < 4 * (first + 8); ++v)
            file.fields[v < first + 8 ? 0 : 1].values.push_back(1.0 / (1 + v));
        file.fileFields = {{"time", false, 1, {2.5}}};
        auto source = printedAs("a.exo", file);
        const auto& format = formats::formatOf("a.exo");
        const MeshFile back = formats::readSources(format, std::span(&source, 1));
        QVERIFY(samples::sameBits(back.points, file.points));
        QVERIFY(back.notices.empty());
        const auto wanted = byNodes(file), got = byNodes(back);
        for (const auto& [key, members] : wanted) {
            QVERIFY2(got.contains(key), key.second.c_str());
            QVERIFY2(got.at(key) == members, key.second.c_str());
        }
        QCOMPARE(find(back, "heat")->values, file.fields[0].values);
        QCOMPARE(find(back, "flow")->values, file.fields[1].values);
        QCOMPARE(back.fileFields.at(0).values, std::vector<double>{2.5});
        source = printedAs("a.exo", back);
        const MeshFile again = formats::readSources(format, std::span(&source, 1));
        QCOMPARE(printedAs("a.exo", again).bytes, source.bytes);
    }

    /// Bytes are changed, truncated and removed: the result is a mesh, or one line.
    void damaged_data() {
        vocabularies_data();
        QTest::newRow("a.exo") << QString("a.exo") << false;
        QTest::newRow("a.cgns") << QString("a.cgns") << false;
        QTest::newRow("a.cgns, compressed") << QString("a.cgns") << true;
    }
    void damaged() {
        QFETCH(QString, name);
        QFETCH(bool, compressed);
        auto source = printedAs(name.toStdString(), vocabulary(), compressed);
        const auto& format = formats::formatOf(source.path);
        const std::string whole = source.bytes;
        samples::Random random(compressed ? 3 : 4);
        int refused = 0;
        for (int round = 0; round < 60; ++round) {
            source.bytes = whole;
            const auto size = static_cast<int>(whole.size());
            if (round % 3 == 0) {
                source.bytes.resize(random.index(size));
            } else if (round % 3 == 1) {
                for (int k = 0; k < 1 + round / 5; ++k)
                    source.bytes[random.index(round % 2 ? size : std::min(size, 4000))] =
                        static_cast<char>(random.index(256));
            } else {
                source.bytes.erase(random.index(size), random.index(200));
            }
            try {
                formats::readSources(format, std::span(&source, 1));
            } catch (const InputError& error) {
                ++refused;
                QVERIFY(error.file() == source.path && !error.reason().empty());
                QVERIFY2(std::string(error.what()).find('\n') == std::string::npos, error.what());
            }
        }
        QVERIFY(refused > 15);
    }

    void otherFiles_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QString>("reason");
        QTest::newRow("text") << "a.med"
                              << "MED"
                              << "is no HDF5 file";
        QTest::newRow("old CGNS") << "a.cgns"
                                  << "@(#)ADF Database Version B01010>"
                                  << "adf2hdf";
        QTest::newRow("no XML") << "a.xdmf"
                                << "<Xdmf"
                                << "not valid XML";
        QTest::newRow("no grid") << "a.xdmf"
                                 << "<Xdmf><Domain/></Xdmf>"
                                 << "there is no <Grid> in it";
        QTest::newRow("a missing file")
            << "a.xdmf"
            << "<Xdmf><Domain><Grid><Geometry GeometryType='XYZ'><DataItem Dimensions='3 3' "
               "Format='HDF'>b.h5:/x</DataItem></Geometry></Grid></Domain></Xdmf>"
            << "b.h5";
        QTest::newRow("too few numbers")
            << "a.xdmf"
            << "<Xdmf><Domain><Grid><Geometry GeometryType='XYZ'><DataItem Dimensions='3 3'>1 2 "
               "3</DataItem></Geometry></Grid></Domain></Xdmf>"
            << "<Geometry>: has 3 numbers where 9 are announced";
        QTest::newRow("a structured grid")
            << "a.xdmf"
            << "<Xdmf><Domain><Grid><Geometry GeometryType='ORIGIN_DXDYDZ'/></Grid></Domain></Xdmf>"
            << "the type 'ORIGIN_DXDYDZ' is not read";
    }
    void otherFiles() {
        QFETCH(QString, name);
        QFETCH(QString, bytes);
        QFETCH(QString, reason);
        const samples::Folder folder;
        try {
            readMeshFile(folder.put(name.toStdString(), bytes.toStdString()));
            QFAIL("was read");
        } catch (const InputError& error) {
            QVERIFY2(QString(error.what()).contains(reason), error.what());
        }
    }

    /// Numbers in an HDF5 file beside the XML, as most programs write them; the last step of a series, whose
    /// mesh the first one has.
    void xdmfOfOthers() {
        const samples::Folder folder;
        Hdf5Node root;
        const std::vector<double> points{0, 0, 1, 0, 1, 1, 0, 1}, heat{1, 2, 3, 4};
        const std::vector<std::int64_t> cells{0, 1, 2, 0, 2, 3};
        Hdf5Node& mesh = root.group("Mesh");
        mesh.dataSet("xy", Hdf5Array::of(points, {4, 2}));
        mesh.dataSet("cells", Hdf5Array::of(cells, {2, 3}));
        root.dataSet("heat", Hdf5Array::of(heat, {4, 1}));
        folder.put("values.h5", printHdf5(root, false));
        const MeshFile file = readMeshFile(folder.put(
            "a.xdmf",
            "<?xml version='1.0'?><Xdmf Version='3.0'><Domain><Grid GridType='Collection' "
            "CollectionType='Temporal'><Grid><Geometry GeometryType='XY'><DataItem Dimensions='4 2' "
            "Format='HDF'>values.h5:/Mesh/xy</DataItem></Geometry><Topology TopologyType='Triangle' "
            "NumberOfElements='2'><DataItem NumberType='UInt' Dimensions='2 3' Format='HDF'> "
            "values.h5:/Mesh/cells\n</DataItem></Topology></Grid><Grid><Time Value='1'/><Attribute "
            "Name='heat' "
            "Center='Node'><DataItem Dimensions='4 1' Format='HDF'>values.h5:/heat</DataItem></Attribute>"
            "</Grid></Grid></Domain></Xdmf>"));
        QCOMPARE(file.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
        QCOMPARE(find(file, "heat")->values, heat);
        QCOMPARE(file.notices, std::vector<std::string>{"its 1 other step"});
    }

    /// Collections within collections as deep as the file is long.
    void deepGrids() {
        constexpr int kDepth = 100000;
        const samples::Folder folder;
        std::string text = "<Xdmf><Domain>";
        for (int k = 0; k < kDepth; ++k) text += "<Grid GridType='Collection'>";
        text +=
            "<Grid><Geometry GeometryType='XY'><DataItem Dimensions='3 2'>0 0 1 0 0 1</DataItem></Geometry>"
            "<Topology TopologyType='Triangle'><DataItem Dimensions='1 3'>0 1 2</DataItem></Topology></Grid>";
        for (int k = 0; k < kDepth; ++k) text += "</Grid>";
        const MeshFile file = readMeshFile(folder.put("a.xdmf", text + "</Domain></Xdmf>"));
        QCOMPARE(file.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
    }

    /// A structured zone of 3 × 2 × 2 vertices is two hexahedra; the face i = 1 is a group of vertices.
    void structuredZones() {
        const auto text = [](const char* value) {
            Hdf5Array array = Hdf5Array::of(std::vector<std::int64_t>(value, value + std::strlen(value)),
                                            {std::ssize(std::string_view(value))}, formats::Scalar::Int8);
            return array;
        };
        const auto add = [](Hdf5Node& parent, const char* name, const char* label) -> Hdf5Node& {
            return parent.group(name).with("label", Hdf5Array::of(label, 33));
        };
        Hdf5Node root;
        Hdf5Node& base = add(root, "B", "CGNSBase_t");
        base.dataSet(" data", Hdf5Array::of(std::vector<std::int64_t>{3, 3}, {2}, formats::Scalar::Int32));
        Hdf5Node& zone = add(base, "Z", "Zone_t");
        zone.dataSet(" data", Hdf5Array::of(std::vector<std::int64_t>{3, 2, 2, 2, 1, 1, 0, 0, 0}, {3, 3},
                                            formats::Scalar::Int32));
        add(zone, "ZoneType", "ZoneType_t").dataSet(" data", text("Structured"));
        std::array<std::vector<double>, 3> x;
        for (int v = 0; v < 12; ++v) x[0].push_back(v % 3), x[1].push_back(v / 3 % 2), x[2].push_back(v / 6);
        Hdf5Node& points = add(zone, "GridCoordinates", "GridCoordinates_t");
        for (int k = 0; k < 3; ++k)
            add(points, (std::string("Coordinate") + "XYZ"[k]).c_str(), "DataArray_t")
                .dataSet(" data", Hdf5Array::of(x[k], {2, 2, 3}));
        Hdf5Node& inlet = add(add(zone, "ZoneBC", "ZoneBC_t"), "inlet", "BC_t");
        add(inlet, "PointRange", "IndexRange_t")
            .dataSet(" data", Hdf5Array::of(std::vector<std::int64_t>{1, 1, 1, 1, 2, 2}, {2, 3},
                                            formats::Scalar::Int32));
        const samples::Folder folder;
        const MeshFile file = readMeshFile(folder.put("a.cgns", printHdf5(root, false)));
        QCOMPARE(file.cells.size(), 2);
        double volume = 0;
        for (const auto& cell : file.tetrahedra) volume += cellMeasure<3>(file.points, cell);
        QCOMPARE(volume, 2.0);
        QCOMPARE(file.groups.size(), std::size_t(1));
        QCOMPARE(file.groups[0].name, std::string("inlet"));
        QCOMPARE(file.groups[0].vertices, (std::vector<int>{0, 3, 6, 9}));
    }
};

QTEST_GUILESS_MAIN(TestHdf5Formats)
#include "test_hdf5_formats.moc"
