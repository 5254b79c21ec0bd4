// domain.shells and --shells: the space inside nested shells.

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>
#include <map>

#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestShellsCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void choices_data();
    void choices();
    void groupsHaveTheNamesOfShells_data();
    void groupsHaveTheNamesOfShells();
    void projectsChoose();
    void sharedWalls();
    void infoTells();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    QTemporaryDir m_folder;
};

namespace {

double volumeOf(const MeshFile& file) {
    double sum = 0;
    for (const auto& cell : file.tetrahedra) sum += cellMeasure<3>(Points3(file.points), cell);
    return sum;
}

std::string objOf(const std::vector<std::pair<std::string, Surface>>& parts) {
    std::string text;
    int first = 1;
    for (const auto& [name, surface] : parts) {
        text += "g " + name + "\n";
        for (int v = 0; v < surface.vertexCount(); ++v)
            text += "v " + std::to_string(surface.points(0, v)) + " " + std::to_string(surface.points(1, v)) +
                    " " + std::to_string(surface.points(2, v)) + "\n";
        for (const auto& t : surface.triangles)
            text += "f " + std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
                    std::to_string(t[2] + first) + "\n";
        first += surface.vertexCount();
    }
    return text;
}

Surface cube(double half) {
    return test::box(Vec3::Constant(-half), Vec3::Constant(half));
}

const double kVolumes[] = {8 * (27 - 8), 8 * (8 - 1), 8};  // skin, bone, marrow

}  // namespace

void TestShellsCli::initTestCase() {
    put(path(), "nested.obj", objOf({{"skin", cube(3)}, {"bone", cube(2)}, {"marrow", cube(1)}}));
    put(path(), "touching.obj",
        objOf({{"left", test::box({0, 0, 0}, {1, 1, 1})}, {"right", test::box({1, 0, 0}, {3, 1, 1})}}));
}

void TestShellsCli::choices_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<double>("volume");
    QTest::addColumn<bool>("isReported");
    QTest::newRow("auto") << QStringList() << kVolumes[0] + kVolumes[2] << true;
    QTest::newRow("holes") << QStringList{"--shells", "holes"} << kVolumes[0] + kVolumes[2] << false;
    QTest::newRow("regions") << QStringList{"--shells", "regions"} << 216.0 << false;
}

void TestShellsCli::choices() {
    QFETCH(QStringList, options);
    QFETCH(double, volume);
    QFETCH(bool, isReported);
    const CliResult result =
        run(QStringList{"mesh", "nested.obj", "-o", "n.vtu", "--vertices", "400"} + options);
    QCOMPARE(result.code, 0);
    QCOMPARE(result.error.contains("nested.obj: shells lie one in the other, up to 3 deep; spaces filled: 2, "
                                   "hollow: 1; `shells`: \"regions\" fills all"),
             isReported);
    QVERIFY(std::abs(volumeOf(readMeshFile(file("n.vtu"))) - volume) < 1e-9);
}

void TestShellsCli::groupsHaveTheNamesOfShells_data() {
    QTest::addColumn<QString>("format");
    for (const char* format : {"msh", "inp"}) QTest::newRow(format) << QString(format);
}

void TestShellsCli::groupsHaveTheNamesOfShells() {
    QFETCH(QString, format);
    const QString name = "r." + format;
    QCOMPARE(run({"mesh", "nested.obj", "-o", name, "--shells", "regions"}).code, 0);
    const MeshFile read = readMeshFile(file(name.toStdString()));
    std::map<std::string, double> volumes;
    for (const MeshGroup& group : read.groups) {
        if (group.dimension != 3) continue;
        for (const int c : group.cells) {
            const auto nodes = read.cells[c];
            volumes[group.name] +=
                cellMeasure<3>(Points3(read.points), {nodes[0], nodes[1], nodes[2], nodes[3]});
        }
    }
    int k = 0;
    for (const char* shell : {"skin", "bone", "marrow"})
        QVERIFY2(std::abs(volumes[shell] - kVolumes[k++]) < 1e-9, shell);
}

void TestShellsCli::projectsChoose() {
    const std::string rest =
        "'vertices': 300}, 'handles': [{'at': {'region': {'box': {'min': [-4, -4, -4], 'max': "
        "[4, 4, -2.9]}}}}]";
    putProject(path(), "p.wend", "'domain': {'surface': 'nested.obj', 'shells': 'regions', " + rest);
    const CliResult regions = run({"run", "p.wend", "--mesh", "p.vtu"});
    QCOMPARE(regions.code, 0);
    QVERIFY2(!regions.error.contains("shells"), qPrintable(regions.error));
    QVERIFY(std::abs(volumeOf(readMeshFile(file("p.vtu"))) - 216) < 1e-9);
    QCOMPARE(run({"run", "p.wend", "--mesh", "p.vtu", "--shells", "holes"}).code, 0);
    QVERIFY(std::abs(volumeOf(readMeshFile(file("p.vtu"))) - kVolumes[0] - kVolumes[2]) < 1e-9);
    putProject(path(), "q.wend", "'domain': {'surface': 'nested.obj', 'shells': 'filled', " + rest);
    const CliResult wrong = run({"run", "q.wend", "--mesh", "p.vtu"});
    QCOMPARE(wrong.code, 3);
    QVERIFY2(wrong.error.contains("domain.shells"), qPrintable(wrong.error));
}

/// Two bodies share a wall that each of them has: they are filled and labelled, and the wall is reported.
void TestShellsCli::sharedWalls() {
    const CliResult result = run({"mesh", "touching.obj", "-o", "t.msh"});
    QCOMPARE(result.code, 0);
    QVERIFY2(result.error.contains("bodies touch along shared walls; spaces filled: 2, hollow: 0"),
             qPrintable(result.error));
    const MeshFile read = readMeshFile(file("t.msh"));
    QVERIFY(std::abs(volumeOf(read) - 3) < 1e-12);
    QStringList names;
    for (const MeshGroup& group : read.groups)
        if (group.dimension == 3) names << QString::fromStdString(group.name);
    names.sort();
    QCOMPARE(names, QStringList({"left", "right"}));
}

void TestShellsCli::infoTells() {
    const auto info = [&](const char* name) {
        return QJsonDocument::fromJson(run({"info", name, "--json"}).out.toUtf8()).object();
    };
    QCOMPARE(info("nested.obj")["shellsDeep"].toInt(), 3);
    QVERIFY(!info("touching.obj").contains("shellsDeep"));
    QCOMPARE(info("touching.obj")["fit"].toString(), QString("exact surface"));
    QStringList problems;
    for (const auto& one : info("touching.obj")["problems"].toArray())
        problems << one.toObject()["what"].toString();
    QVERIFY(problems.contains("triangles that bodies share as a wall"));
    QVERIFY(!problems.contains("duplicate triangles"));
}

QTEST_GUILESS_MAIN(TestShellsCli)
#include "test_shells_cli.moc"
