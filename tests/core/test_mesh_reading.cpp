// Files as other programs write them: variants of each format that Wend itself does not write.

#include <QtTest>
#include <bit>
#include <cstring>

#include "core/mesh/formats/base64.h"
#include "core/mesh/formats/scalar_type.h"
#include "core/mesh/formats/vtu_array.h"
#include "test_mesh_files.h"

using namespace wend;
using formats::Scalar;

namespace {

MeshFile readAs(const std::string& name, const std::string& bytes) {
    const samples::Folder folder;
    return readMeshFile(folder.put(name, bytes));
}

using Triangles = std::vector<std::array<int, 3>>;
using Tetrahedra = std::vector<std::array<int, 4>>;

std::vector<double> flat(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

std::vector<double> valuesOf(const MeshFile& file, const std::string& name) {
    for (const auto& field : file.fields)
        if (field.name == name) return field.values;
    return {};
}

const std::vector<double> cornersOfSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const Triangles square = {{0, 1, 2}, {0, 2, 3}};

/// Numbers as bytes of a type and order.
std::string packed(const std::vector<double>& values, Scalar type, std::endian order) {
    std::string bytes;
    for (double value : values) formats::appendReal(bytes, value, type, order);
    return bytes;
}

std::string plyHeader(const std::string& format, const std::string& vertexExtra = "",
                      const std::string& list = "uchar int") {
    return "ply\r\nformat " + format +
           " 1.0\ncomment made by hand\nobj_info x\nelement vertex 4\nproperty float x\n" +
           "property float y\nproperty float z\n" + vertexExtra + "element face 1\nproperty list " + list +
           " vertex_index\nend_header\n";
}

const std::string vtuCells =
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray><DataArray type=\"UInt8\" "
    "Name=\"types\">9</DataArray></Cells>";

std::string vtu(const std::string& attributes, const std::string& pointArray,
                const std::string& behind = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" " + attributes +
           "><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" + pointArray +
           "</Points>" + vtuCells + "</Piece></UnstructuredGrid>" + behind + "</VTKFile>";
}

}  // namespace

class TestMeshReading : public QObject {
    Q_OBJECT

  private slots:
    void squares_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        const auto add = [](const char* row, const char* name, const std::string& bytes) {
            QTest::newRow(row) << name << QByteArray::fromStdString(bytes);
        };
        const std::string vs = "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n";
        add("obj", "a.obj",
            "mtllib x.mtl\n" + vs + "vn 0 0 1\ng x\nusemtl m\ns off\nf 1//1 2//1 3//1 4//1 # quad\n");
        add("obj, CRLF", "a.OBJ", "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3\r\nf 1 3 4\r\n");
        add("obj, negative", "a.obj", vs + "f -4 -3 -2 -1\n");
        add("obj, face first", "a.obj", "f 1 2 3 4\n" + vs);
        add("obj, continued", "a.obj", vs + "f 1 2 \\\n 3 4\n");
        add("obj, byte order mark", "a.obj", "\xef\xbb\xbf" + vs + "f 1 2 3 4\nl 1 2\np 1\n");
        add("off", "a.off", "# x\nOFF\n\n4 1 0 # counts\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n");
        add("off, one line", "a.off", "OFF 4 2 5 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2\n3 0 2 3");
        add("off, no edges", "a.off", "OFF\n4 1\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
        add("coff", "a.off",
            "COFF\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n0 1 0 9 9 9 9\n4 0 1 2 3 0.5 0.5 "
            "0.5\n");
        add("stcnoff", "a.off", "STCNOFF\n4 1 0\n0 0 0 1 1\n1 0 0 2 2\n1 1 0 3 3\n0 1 0 4 4\n4 0 1 2 3\n");
        add("off, no word", "a.off", "# counts\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255\n");
        add("off, more faces", "a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
        add("off, appearance", "a.off",
            "appearance {\n +texturing\n texture { # a\n file a.pgm }\n}\nSTOFF 4 1 0\n0 0 0 1 1\n1 0 0 2 2\n"
            "1 1 0 3 3\n0 1 0 4 4\n4 0 1 2 3\n");
        const std::vector<double> corners = cornersOfSquare;
        for (const auto& [format, order] : {std::pair("binary_little_endian", std::endian::little),
                                            {"binary_big_endian", std::endian::big}})
            add(format, "a.ply",
                plyHeader(format) + packed(corners, Scalar::Float32, order) + "\x04" +
                    packed({0, 1, 2, 3}, Scalar::Int32, order));
        add("ply ascii", "a.ply", plyHeader("ascii") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
        add("ply, short indices", "a.ply",
            plyHeader("binary_big_endian", "", "uint ushort") +
                packed(corners, Scalar::Float32, std::endian::big) +
                packed({4}, Scalar::UInt32, std::endian::big) +
                packed({0, 1, 2, 3}, Scalar::UInt16, std::endian::big));
        add("ply, lists and other elements", "a.ply",
            "ply\nformat ascii 1.0\nelement material 2\nproperty uchar red\nproperty list uchar float "
            "weights\n"
            "element vertex 4\nproperty double z\nproperty double y\nproperty list char int near\nproperty "
            "double x\n"
            "element face 2\nproperty uchar flags\nproperty list uchar uint vertex_indices\n"
            "property list uchar float texcoord\nend_header\n"
            "1 2 0.5 0.5\n3 0\n0 0 0 0\n0 0 1 7 1\n0 1 0 1\n0 1 2 7 7 0\n0 3 0 1 2 2 .1 .2\n1 3 0 2 3 0\n");
        const auto strips = [](const char* lists) {
            return std::string(
                       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                       "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                       "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n") +
                   lists;
        };
        add("ply, strips that end within a list", "a.ply", strips("9 0 1 2 -1 -1 0 2 3 -1\n"));
        add("ply, a strip that turns a corner", "a.ply", strips("6 0 1 2 2 0 3\n"));
        add("stl", "a.stl",
            "SOLID\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
            "endfacet\nendsolid\nsolid again\nfacet normal nan nan nan\nouter loop\nvertex -0 0 0\n"
            "vertex 1 1 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid again\n");
        std::string stl = "solid, but binary";
        stl.resize(80);
        stl += packed({2}, Scalar::UInt32, std::endian::little);
        for (const auto& t : square) {
            stl += packed({0, 0, 1}, Scalar::Float32, std::endian::little);
            for (int v : t)
                stl += packed({corners[3 * v], corners[3 * v + 1], 0}, Scalar::Float32, std::endian::little);
            stl += std::string(2, '\0');
        }
        add("stl, binary that begins with solid", "a.stl", stl);
        add("medit", "a.mesh",
            "MeshVersionFormatted\n2\n# c\nDimension\n3\nVertices\n4\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n"
            "Edges\n1\n1 2 5\nCorners 1 1\nQuadrilaterals\n1\n1 2 3 4 7\nRequiredVertices\n1\n1\nEnd\n");
        add("medit, flat", "a.mesh",
            "MeshVersionFormatted 1\nDimension 2\nVertices 4\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
            "Triangles 2\n1 2 3 1\n1 3 4 1\n");
        const std::string nodes2 = "$Nodes\n4\n10 0 0 0\n5 1 0 0\n7 1 1 0\n1000000 0 1 0\n$EndNodes\n";
        add("gmsh 2", "a.msh",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"a b\"\n$EndPhysicalNames\n" +
                nodes2 +
                "$Elements\n3\n1 15 2 0 1 10\n2 1 2 0 1 10 5\n9 3 3 4 6 0 10 5 7 1000000\n$EndElements\n"
                "$NodeData\n1\n\"x\"\n1\n0\n3\n0\n1\n1\n10 1\n$EndNodeData\n");
        add("gmsh 4", "a.msh",
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 0\n1 0 0 0 0\n2 0 0 0 1 1 1 1 5 2 1 -1\n"
            "3 0 0 0 1 1 0 2 8 9 1 2\n$EndEntities\n$Nodes\n3 4 1 9\n0 1 0 1\n9\n0 0 0\n1 2 1 1\n2\n1 0 0 "
            "0.5\n"
            "2 3 1 2\n3\n4\n1 1 0 0.1 0.2\n0 1 0 0.3 0.4\n$EndNodes\n"
            "$Elements\n2 3 1 3\n1 2 1 1\n1 9 2\n2 3 2 2\n2 9 2 3\n3 9 3 4\n$EndElements\n");
        add("vtk, polydata", "a.vtk",
            "# vtk DataFile Version 2.0\ntitle\nASCII\n\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n1 1 "
            "0 0 1 0\n"
            "LINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 2 3\n");
        add("vtk, pixel", "a.vtk",
            "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 int\n0 0 0 1 0 0 1 1 "
            "0 0 1 0\n"
            "CELLS 2 7\n1 0\n4 0 1 3 2\nCELL_TYPES 2\n1 8\n");
        add("vtk 5.1", "a.vtk",
            "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 1 "
            "1 0 0 1 0\n"
            "METADATA\nINFORMATION 0\n\nCELLS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n0 "
            "1 2 0 2 3\n"
            "CELL_TYPES 2\n5\n5\n");
        add("vtk 5.1, binary", "a.vtk",
            "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n" +
                packed(corners, Scalar::Float32, std::endian::big) +
                "\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n" + packed({0, 4}, Scalar::Int64, std::endian::big) +
                "\nCONNECTIVITY vtktypeint64\n" + packed({0, 1, 2, 3}, Scalar::Int64, std::endian::big) +
                "\n");
        add("vtk, strip", "a.vtk",
            "# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 "
            "0\n"
            "TRIANGLE_STRIPS 2 8\n3 0 1 2\n3 0 2 3\n");
        add("ucd", "a.inp",
            "# c\n4 3 0 0 0\n10 0 0 0\n5 1 0 0\n7 1 1 0\n1000000 0 1 0\n"
            "1 1 line 10 5\n2 1 tri 10 5 7\n9 1 TRI 10 7 1000000\n");
        add("ucd, quadrilateral", "a.inp",
            "4 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n1 0 quad 1 2 3 4\n");
        const std::string polyData =
            "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"4\" "
            "NumberOfVerts=\"1\" NumberOfLines=\"1\" NumberOfStrips=\"%1\" "
            "NumberOfPolys=\"%2\"><Points><DataArray "
            "type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 "
            "0</DataArray></Points>"
            "<Verts><DataArray type=\"Int32\" Name=\"connectivity\">3</DataArray><DataArray type=\"Int32\" "
            "Name=\"offsets\">1</DataArray></Verts><Lines><DataArray type=\"Int32\" Name=\"connectivity\">0 "
            "2 3"
            "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">3</DataArray></Lines><%3><DataArray "
            "type=\"Int64\" Name=\"connectivity\">%4</DataArray><DataArray type=\"Int64\" Name=\"offsets\">%5"
            "</DataArray></%3></Piece></PolyData></VTKFile>";
        const auto poly = [&](const char* stripCount, const char* polygonCount, const char* section,
                              const char* nodes, const char* offsets) {
            return QString::fromStdString(polyData)
                .arg(stripCount, polygonCount, section, nodes, offsets)
                .toStdString();
        };
        add("vtp", "a.vtp", poly("0", "2", "Polys", "0 1 2 0 2 3", "3 6"));
        add("vtp, quadrilateral", "a.vtp", poly("0", "1", "Polys", "0 1 2 3", "4"));
        add("vtp, strips", "a.vtp", poly("2", "0", "Strips", "0 1 2 0 2 3", "3 6"));
        add("vtu, text", "a.vtu",
            vtu("",
                "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 1 0 0 1 1 "
                "0 0 1 0\n</DataArray>"));
        for (const auto order : {std::endian::little, std::endian::big})
            for (const auto header : {Scalar::UInt32, Scalar::UInt64})
                for (const bool compressed : {false, true})
                    for (int way = 0; way < 4; ++way) addVtu(order, header, compressed, way);
    }

    void squares() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        MeshFile file;
        try {
            file = readAs(name.toStdString(), bytes.toStdString());
        } catch (const InputError& error) {
            QFAIL(error.what());
        }
        QVERIFY(flat(file.points) == cornersOfSquare);
        QVERIFY(file.triangles == square);
        QVERIFY(file.tetrahedra.empty());
        requireValid(meshFrom<2>(file));
    }

    void polygonsBecomeFans() {
        const auto file =
            readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 2 3 4 5 1\nf 1 2 3\n");
        QVERIFY((file.triangles == Triangles{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {0, 1, 2}}));
    }
    void negativeIndicesCountFromTheLatest() {
        const auto file = readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
        QVERIFY(file.triangles == square);
    }
    /// Texture coordinates count back from their own latest one in the same way.
    void negativeTexturesCountFromTheLatest() {
        const auto file = readAs("a.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 9 9\nvt .1 .2\nvt .3 .4\nvt .5 .6\n"
                                 "f -3/-3 -2/-2 -1/-1\nv 0 1 0\nvt .7 .8\nf 1/-4 3/-2/1 4/-1\n");
        QCOMPARE(flat(file.uv), (std::vector<double>{.1, .2, .3, .4, .5, .6, .7, .8}));
        QVERIFY_THROWS_EXCEPTION(InputError,
                                 readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/-2 2/1 3/1\n"));
    }
    /// An entity in several groups is put into the first.
    void firstGroupOfAnEntity() {
        const auto file = readAs("a.msh",
                                 "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 2 0\n"
                                 "3 0 0 0 1 1 0 3 7 8 9 0\n4 0 0 0 1 1 0 1 5 0\n$EndEntities\n"
                                 "$Nodes\n1 4 1 4\n2 3 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                 "$EndNodes\n$Elements\n2 2 1 2\n2 3 2 1\n1 1 2 3\n2 4 2 1\n2 1 3 4\n"
                                 "$EndElements\n");
        QCOMPARE(valuesOf(file, "physical"), (std::vector<double>{7, 5}));
        QCOMPARE(valuesOf(file, "entity"), (std::vector<double>{3, 4}));
    }
    void objTexture() {
        const std::string vs = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\n";
        const std::string vts = "vt .5 .25\nvt 1 0\nvt 1 1 0\nvt 0 1\nvt 7 7\n";
        auto file = readAs("a.obj", vs + vts + "vn 0 0 1\nf 1/1 2/2 3/3\nf 1/1/1 3/-2/1 4/4/1\n");
        QVERIFY((flat(file.uv) ==
                 std::vector<double>{.5, .25, 1, 0, 1, 1, 0, 1, 0, 0}));  // the first of a seam counts
        file = readAs("a.obj",
                      vs + "vt .5 .25\nvt 1 0\nvt 1 1\nf 1/-3 2/-2 3/-1\nvt 0 1\nf 1/1 3/-2 4/-1\nvt 7 7\n");
        QVERIFY((flat(file.uv) ==
                 std::vector<double>{.5, .25, 1, 0, 1, 1, 0, 1, 0, 0}));  // counted from the latest
        file = readAs("a.obj", vs + vts + "f 1/1 2/2 3/3\nf 1 3 4\n");
        QCOMPARE(file.uv.cols(), 0);  // not everywhere
        QVERIFY_THROWS_EXCEPTION(InputError, readAs("a.obj", vs + vts + "f 1/1 2/2 3/6\n"));
    }
    void plyTextureAndFields() {
        for (const auto& [u, v] : {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}}) {
            const std::string extra =
                std::string("property uchar red\nproperty float ") + u + "\nproperty float " + v + "\n";
            const auto file = readAs("a.ply", plyHeader("ascii", extra) +
                                                  "0 0 0 9 .5 .25\n1 0 0 8 1 0\n1 1 0 7 1 1\n"
                                                  "0 1 0 255 0 1\n4 0 1 2 3\n");
            QCOMPARE(flat(file.uv), (std::vector<double>{.5, .25, 1, 0, 1, 1, 0, 1}));
            QCOMPARE(valuesOf(file, "red"), (std::vector<double>{9, 8, 7, 255}));
            QCOMPARE(file.fields.size(), std::size_t(1));
        }
    }
    void splitPolygonsKeepTheirValues() {
        const std::string vtk =
            "# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 "
            "0\n"
            "LINES 1 3\n2 0 1\nPOLYGONS 2 9\n4 0 1 2 3\n3 0 1 3\nCELL_DATA 3\nSCALARS a%20b "
            "int\nLOOKUP_TABLE default\n5 6 7\n"
            "VECTORS v float\n0 0 0 1 2 3 4 5 6\nPOINT_DATA 4\nTEXTURE_COORDINATES tc 2 float\n0 0 1 0 1 1 0 "
            "1\n"
            "SCALARS s double 2\nLOOKUP_TABLE t\n1 2 3 4 5 6 nan -inf\nLOOKUP_TABLE t 1\n0 0 0 1\n"
            "FIELD FieldData 1\nf 1 4 float\n1 2 3 4\nMETADATA\nCOMPONENT_NAMES\nx\n\nCOLOR_SCALARS c 1\n0 "
            "0.5 1 1\n";
        const auto file = readAs("a.vtk", vtk);
        QCOMPARE(valuesOf(file, "a b"), (std::vector<double>{6, 6, 7}));
        QCOMPARE(valuesOf(file, "v"), (std::vector<double>{1, 2, 3, 1, 2, 3, 4, 5, 6}));
        QCOMPARE(flat(file.uv), (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
        QCOMPARE(valuesOf(file, "f"), (std::vector<double>{1, 2, 3, 4}));
        QCOMPARE(valuesOf(file, "c"), (std::vector<double>{0, 0.5, 1, 1}));
        QVERIFY(std::isnan(valuesOf(file, "s")[6]));  // a field may hold it
    }
    void mixedCellsOfAVolume() {
        const std::string points = "POINTS 5 float\n0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n";
        const auto file =
            readAs("a.vtk", "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n" + points +
                                "CELLS 4 17\n3 0 1 2\n4 0 1 2 3\n2 0 1\n4 1 2 3 4\nCELL_TYPES 4\n5 10 3 10\n"
                                "CELL_DATA 4\nSCALARS m int\nLOOKUP_TABLE default\n1 2 3 4\n");
        QVERIFY((file.tetrahedra == Tetrahedra{{0, 1, 2, 3}, {1, 2, 3, 4}}));
        QVERIFY((file.triangles == Triangles{{0, 1, 2}}));
        QCOMPARE(valuesOf(file, "m"), (std::vector<double>{2, 4}));
    }
    /// The numbers of nodes and cells are names, for values as well.
    void ucdValues() {
        const auto file =
            readAs("a.inp",
                   "5 3 4 1 0\n3 0 0 0\n1 1 0 0\n2 0 1 0\n9 0 0 1\n4 1 1 1\n"
                   "7 4 tet 3 1 2 9\n5 2 tri 3 1 2\n6 8 tet 1 2 9 4\n2 1 3\n"
                   "heat, K\nflow of it, m/s\n1 5 1 2 3\n3 6 4 5 6\n2 7 7 8 9\n4 8 0 0 1\n9 9 nan 0 2\n"
                   "1 1\nstress, Pa\n6 30\n7 10\n5 20\n");
        QVERIFY((file.tetrahedra == Tetrahedra{{0, 1, 2, 3}, {1, 2, 3, 4}}));
        QVERIFY((file.triangles == Triangles{{0, 1, 2}}));
        QCOMPARE(valuesOf(file, "heat"), (std::vector<double>{6, 5, 7, 9, 8}));
        QCOMPARE(valuesOf(file, "flow of it")[2], 6.0);
        QVERIFY(std::isnan(valuesOf(file, "flow of it")[9]));
        QCOMPARE(valuesOf(file, "stress"), (std::vector<double>{10, 30}));
        QCOMPARE(valuesOf(file, "material"), (std::vector<double>{4, 8}));
    }
    void gmshTags() {
        const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
        const auto file =
            readAs("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes +
                                "$Elements\n2\n1 2 2 9 8 1 2 3\n2 4 2 6 5 1 2 3 4\n$EndElements\n");
        QCOMPARE(valuesOf(file, "physical"), std::vector<double>{6});
        QCOMPARE(valuesOf(file, "entity"), std::vector<double>{5});
        QCOMPARE(file.triangles.size(), std::size_t(1));
    }
    void gmshEntityOfTwoGroupsIsOfTheFirst() {
        const auto file =
            readAs("a.msh",
                   "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n4 0 0 0 1 1 1 3 8 9 7 "
                   "0\n$EndEntities\n"
                   "$Nodes\n1 4 1 4\n3 4 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
                   "$Elements\n1 1 1 1\n3 4 4 1\n1 1 2 3 4\n$EndElements\n");
        QCOMPARE(valuesOf(file, "physical"), std::vector<double>{8});
        QCOMPARE(valuesOf(file, "entity"), std::vector<double>{4});
        const auto parted = readAs("a.msh",
                                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
                                   "3 0 1 0\n4 0 0 1\n$EndNodes\n"
                                   "$Elements\n1\n2 4 4 6 5 1 9 1 2 3 4\n$EndElements\n");
        QCOMPARE(valuesOf(parted, "physical"), std::vector<double>{6});
        QCOMPARE(valuesOf(parted, "entity"), std::vector<double>{5});
    }
    void meditReferences() {
        const auto file =
            readAs("a.mesh",
                   "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 1\n1 0 0 2\n0 1 0 3\n"
                   "0 0 1 4\nTetrahedra\n1\n1 2 3 4 77\nTriangles\n1\n1 2 3 5\nEnd\n");
        QCOMPARE(file.fields.size(), std::size_t(2));
        QCOMPARE(file.fields[0].values, (std::vector<double>{1, 2, 3, 4}));
        QVERIFY(file.fields[1].perCell);
        QCOMPARE(file.fields[1].values, std::vector<double>{77});
    }
    void tetgenPairs_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<QString>("opened");
        for (int first : {0, 1})
            for (const char* opened : {"a.node", "a.ele"})
                QTest::addRow("from %d, %s", first, opened) << first << opened;
    }
    void tetgenPairs() {
        QFETCH(int, first);
        QFETCH(QString, opened);
        const samples::Folder folder;
        const auto n = [&](int k) { return std::to_string(k + first) + " "; };
        folder.put("a.node", "# made by hand\n\n4 3 2 1\n" + n(0) + "0 0 0 .5 1 9\n" + n(1) +
                                 "1 0 0 .25 2 8 # x\n" + n(2) + "0 1 0 0 3 7\n" + n(3) +
                                 "0 0 1 0 4 6\n# end\n");
        folder.put("a.ele", "1 4 1\n" + n(0) + n(0) + n(1) + n(2) + n(3) + "42\n");
        const auto file = readMeshFile(folder.path(opened.toStdString()));
        QVERIFY((file.tetrahedra == Tetrahedra{{0, 1, 2, 3}}));
        QCOMPARE(file.fields[0].values, (std::vector<double>{.5, 1, .25, 2, 0, 3, 0, 4}));
        QCOMPARE(file.fields[1].values, (std::vector<double>{9, 8, 7, 6}));
        QVERIFY(file.fields[2].perCell);
        QCOMPARE(file.fields[2].values, std::vector<double>{42});
    }
    void trianglePair() {
        const samples::Folder folder;
        folder.put("b.node", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
        folder.put("b.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
        const auto file = readMeshFile(folder.path("b.ele"));
        QVERIFY(flat(file.points) == cornersOfSquare && file.triangles == square);
    }
    void base64() {
        for (const auto& [bytes, text] : {std::pair<std::string, std::string>("", ""),
                                          {"f", "Zg=="},
                                          {"fo", "Zm8="},
                                          {"foo", "Zm9v"},
                                          {"foob", "Zm9vYg=="},
                                          {"foobar", "Zm9vYmFy"}}) {  // RFC 4648
            QCOMPARE(formats::encodeBase64(bytes), text);
            QCOMPARE(formats::decodeBase64(text), bytes);
        }
        QVERIFY_THROWS_EXCEPTION(InputError, formats::decodeBase64("Zm9*"));
    }
    void compressedBlocks() {
        for (std::size_t size : {0, 1, 32767, 32768, 32769, 100000}) {
            std::string bytes(size, 'x');
            for (std::size_t i = 0; i < size; i += 7) bytes[i] = static_cast<char>(i);
            formats::VtuEncoding encoding;
            encoding.compressor = formats::VtuEncoding::Compressor::Zlib;
            QVERIFY(formats::decodeVtuArray(formats::encodeVtuArray(bytes, encoding), encoding) == bytes);
        }
    }

  private:
    /// `way` is 0 for inline base64, 1 for the same with a separate header, 2 for appended base64, 3 for
    /// appended raw data
    static void addVtu(std::endian order, Scalar header, bool compressed, int way) {
        if (compressed && way == 1) return;
        using enum formats::VtuEncoding::Compressor;
        formats::VtuEncoding encoding{order, header, compressed ? Zlib : None, way != 3};
        const auto points = packed(cornersOfSquare, Scalar::Float32, order);
        auto data = formats::encodeVtuArray(points, encoding);
        if (way == 1)
            data = formats::encodeBase64(packed({double(points.size())}, header, order)) +
                   formats::encodeBase64(points);
        const std::string attributes =
            std::string("byte_order=\"") + (order == std::endian::big ? "Big" : "Little") +
            "Endian\" header_type=\"" + (header == Scalar::UInt32 ? "UInt32" : "UInt64") + "\"" +
            (compressed ? " compressor=\"vtkZLibDataCompressor\"" : "");
        const std::string array = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=";
        const std::string before = "0123";  // the array does not begin at 0
        const std::string bytes =
            way < 2 ? vtu(attributes, array + "\"binary\">\n  " + data + "\n</DataArray>")
                    : vtu(attributes, array + "\"appended\" offset=\"4\"/>",
                          std::string("<AppendedData encoding=\"") + (way == 3 ? "raw" : "base64") +
                              "\">\n _" + before + data + "\n</AppendedData>");
        QTest::addRow("vtu %s %s", qPrintable(QString::fromStdString(attributes).remove('"')),
                      std::to_string(way).c_str())
            << "a.vtu" << QByteArray::fromStdString(bytes);
    }
};

QTEST_APPLESS_MAIN(TestMeshReading)
#include "test_mesh_reading.moc"
