// .vtu files that another program wrote (tests/data/vtu/make.py), and headers whose sizes no file of that
// length can have.

#include <sys/resource.h>

#include <QtTest>

#include "core/mesh/formats/vtu_array.h"
#include "test_mesh_files.h"

using namespace wend;
using formats::Scalar;
using formats::VtuEncoding;

namespace {

const QString kData = QStringLiteral(WEND_SOURCE_DIR "/tests/data/vtu");

const MeshField* fieldOf(const MeshFile& file, const std::string& name) {
    for (const MeshField& field : file.fields)
        if (field.name == name) return &field;
    return nullptr;
}

/// The most memory that this process ever had, in megabytes.
double mostMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// A compressed array of so many blocks of a megabyte of zeros, whose header may say something else.
std::string zeros(std::size_t blocks) {
    const VtuEncoding plain{std::endian::little, Scalar::UInt32, VtuEncoding::Compressor::Zlib, false};
    const std::string megabyte(std::size_t(1) << 15, '\0');
    const std::string one = formats::encodeVtuArray(megabyte, plain);  // 1 block: 4 words and the data
    const std::string data = one.substr(16);
    std::string bytes;
    const auto word = [&](std::size_t value) {
        formats::appendInteger(bytes, static_cast<std::int64_t>(value), Scalar::UInt32, std::endian::little);
    };
    word(32 * blocks), word(std::size_t(1) << 15), word(0);
    for (std::size_t b = 0; b < 32 * blocks; ++b) word(data.size());
    for (std::size_t b = 0; b < 32 * blocks; ++b) bytes += data;
    return bytes;
}

/// A tetrahedron with fields that all lie in one place, appended.
std::string fileWith(int fields, int components, const std::string& appended) {
    std::string arrays;
    for (int f = 0; f < fields; ++f)
        arrays += "<DataArray type='Int8' Name='f' format='appended' offset='0' NumberOfComponents='" +
                  std::to_string(components) + "'/>";
    return "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian' header_type='UInt32' "
           "compressor='vtkZLibDataCompressor'>\n<UnstructuredGrid><Piece NumberOfPoints='4' "
           "NumberOfCells='1'>\n<Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>"
           "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n<Cells><DataArray type='Int32' "
           "Name='connectivity'>0 1 2 3</DataArray><DataArray type='Int32' Name='offsets'>4</DataArray>"
           "<DataArray type='UInt8' Name='types'>10</DataArray></Cells>\n<PointData>" +
           arrays + "</PointData>\n</Piece></UnstructuredGrid>\n<AppendedData encoding='raw'>_" + appended +
           "\n</AppendedData></VTKFile>\n";
}

}  // namespace

class TestMeshVtu : public QObject {
    Q_OBJECT

  private slots:
    void foreignFiles_data();
    void foreignFiles();
    void claims_data();
    void claims();
};

void TestMeshVtu::foreignFiles_data() {
    QTest::addColumn<QString>("name");
    const QStringList names = QDir(kData).entryList({"*.vtu"});
    QCOMPARE(names.size(), 40);
    for (const QString& name : names) QTest::newRow(qPrintable(name)) << name;
}

void TestMeshVtu::foreignFiles() {
    QFETCH(QString, name);
    const MeshFile file = readMeshFile((kData + '/' + name).toStdString());
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
    points.rightCols<3>() = Eigen::Matrix3d::Identity();
    QCOMPARE(file.points, points);
    QCOMPARE(file.tetrahedra, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}}));
    const MeshField *heat = fieldOf(file, "heat"), *label = fieldOf(file, "label");
    QVERIFY(heat && !heat->perCell && heat->values == (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
    QVERIFY(label && label->perCell && label->values == std::vector<double>{7});
}

void TestMeshVtu::claims_data() {
    QTest::addColumn<int>("megabytes");
    QTest::addColumn<int>("fields");
    QTest::addColumn<int>("components");
    QTest::addColumn<QString>("reason");
    QTest::newRow("another number of values")
        << 400 << 1 << 1 << "has 419430400 numbers where 4 times 1 are needed";
    QTest::newRow("beyond sense") << 400 << 1 << 104857600 << "the number of components makes no sense";
    QTest::newRow("again and again") << 2 << 100 << 524288
                                     << "it claims more numbers than such a file can hold";
}

/// 400 MB of zeros in 500 kB, or 2 MB a hundred times over (as numbers 1.6 GB), are refused before they are
/// unpacked.
void TestMeshVtu::claims() {
    QFETCH(int, megabytes);
    QFETCH(int, fields);
    QFETCH(int, components);
    QFETCH(QString, reason);
    const samples::Folder folder;
    const std::string path = folder.put("a.vtu", fileWith(fields, components, zeros(megabytes)));
    const double before = mostMemory();
    try {
        readMeshFile(path);
        QFAIL("was read");
    } catch (const InputError& error) {
        QVERIFY2(QString::fromStdString(error.reason()).contains(reason), error.what());
    }
    QVERIFY2(mostMemory() - before < 128, qPrintable(QString::number(mostMemory() - before)));
}

QTEST_APPLESS_MAIN(TestMeshVtu)
#include "test_mesh_vtu.moc"
