// Projects in space: from a surface or tetrahedra to the input of deformer and window.

#include <QtTest>

#include "app/engine/shape/shape_builder.h"
#include "app/engine/shape/solid.h"
#include "app/engine/shape/stated_units.h"
#include "app/output/report.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_reader.h"
#include "app/session/opening.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"
#include "core/meshing/volume_mesher.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestSolid : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void surfaceBecomesSolid();
    void tetrahedraKeepOrder();
    void aimThatCannotBeMetIsReported();
    void coarseSurfaceIsReported();
    void repairIsAsked_data();
    void repairIsAsked();
    void singleFaultsArePutRight_data();
    void singleFaultsArePutRight();
    void cageIsChosenByItself_data();
    void cageIsChosenByItself();
    void cageCarriesTheSurface();
    void partsThatShareACageAreReported();
    void gapsThatACageClosesAreReported();
    void unitsAreThoseThatTheFileTells_data();
    void unitsAreThoseThatTheFileTells();
    void cageIsMadeAgainWhenItChanges();
    void handlesByNumberKeepTheSurface();
    void sizesFollowRegionsAndPaint();
    void wrongPaintIsRefused();
    void detailFollows();
    void detailFarOffIsReported();
    void builderKeepsWhatHolds();
    void filesOpen_data();
    void filesOpen();

  private:
    std::shared_ptr<Project> project(const std::string& domain) const {
        const std::string text = "{'format': 'wend', 'version': 1, 'domain': {" + domain + "}}";
        return parseProject(json(text), m_base + "/p.wend").project;
    }
    Shape<3> solid(const std::string& domain) const {
        const auto read = project(domain);
        return loadSolid(domainOf(*read), designOf(*read), m_base);
    }

    QTemporaryDir m_folder;
    std::string m_base;
};

namespace {

const Surface kBar = test::box({0, 0, 0}, {3, 1, 1}, 7);

int countNear(const SimplicialMesh<3>& mesh, const Vec3& p, double radius) {
    return static_cast<int>(((mesh.points.colwise() - p).colwise().norm().array() < radius).count());
}

}  // namespace

void TestSolid::initTestCase() {
    m_base = m_folder.path().toStdString();
    test::writeSurface(m_base + "/bar.obj", kBar);
    writeMesh<3>(m_base + "/bar.mesh", barMesh(4));
    Surface holed = kBar;
    holed.triangles.pop_back();
    test::writeSurface(m_base + "/holed.obj", holed);
    test::writeSurface(m_base + "/crossing.obj", test::joined(kBar, test::box({2, 0.2, 0.2}, {5, 0.8, 0.8})));
    test::writeSurface(m_base + "/fine.ply", test::box({-0.01, -0.01, -0.01}, {3.01, 1.01, 1.01}, 20));
    test::writeSurface(m_base + "/far.ply", test::box({40, 0, 0}, {44, 1, 1}, 2));
    writeMesh<2>(m_base + "/flat.obj", stripMesh(3, 3));
}

void TestSolid::surfaceBecomesSolid() {
    const Shape<3> bar = solid("'surface': 'bar.obj', 'vertices': 700");
    QVERIFY(std::abs(bar.rest->vertexCount() - 700) <= 105);
    QVERIFY(bar.rest->points.leftCols(kBar.vertexCount()) == kBar.points);
    QVERIFY(bar.skin->triangles == kBar.triangles);
    // the surface's vertices are the solid's, in every pose and to the last bit
    const Points3 pose = 1.7 * bar.rest->points;
    QVERIFY(bar.embedding->carry(*bar.rest, pose) == pose.leftCols(kBar.vertexCount()));
    QVERIFY(bar.notices.empty());
    const auto any = loadShape(*project("'surface': 'bar.obj', 'vertices': 700"), m_base);
    QVERIFY(std::get<Shape<3>>(any).rest->points == bar.rest->points);
}

void TestSolid::tetrahedraKeepOrder() {
    const Shape<3> bar = solid("'mesh': 'bar.mesh'");
    QVERIFY(bar.rest->cells == barMesh(4).cells);
    QCOMPARE(bar.skin->triangles.size(), std::size_t(2 * (2 * 4 + 4 * 8)));
    QCOMPARE(bar.skin->vertexCount(), 9 * 5 - 3);  // three lie inside
    QVERIFY(checkSurface(surfaceOf(*bar.skin)).boundsVolume());
    QVERIFY((bar.embedding->carry(*bar.rest, bar.rest->points) == bar.skin->points));
}

void TestSolid::aimThatCannotBeMetIsReported() {
    const Shape<3> bar = solid("'surface': 'bar.obj', 'vertices': 20, 'cage': false");  // it has more
    QCOMPARE(bar.notices.size(), std::size_t(1));
    QVERIFY(QString::fromStdString(bar.notices[0]).contains("where 20 were aimed at"));
}

void TestSolid::coarseSurfaceIsReported() {
    test::writeSurface(m_base + "/cube.obj", test::box({0, 0, 0}, {1, 1, 1}));
    const Shape<3> kept = solid("'surface': 'cube.obj', 'vertices': 700");
    QVERIFY(QString::fromStdString(kept.notices.at(0))
                .contains("the surface is kept as it is (see `refineSurface`)"));
    test::writeSurface(m_base + "/coarse.obj", test::box({0, 0, 0}, {4, 1, 1}, 4));
    const Shape<3> coarse = solid("'surface': 'coarse.obj', 'vertices': 1500");
    QVERIFY(QString::fromStdString(coarse.notices.at(0)).contains("`refineSurface` splits them"));
    const Shape<3> refined = solid("'surface': 'cube.obj', 'vertices': 1000, 'refineSurface': true");
    QVERIFY(refined.notices.empty());
    QVERIFY(std::abs(refined.rest->vertexCount() - 1000) <= 150);
    QVERIFY((refined.embedding->carry(*refined.rest, refined.rest->points) == refined.skin->points));
}

void TestSolid::repairIsAsked_data() {
    QTest::addColumn<QString>("domain");
    QTest::addColumn<QString>("reason");  // empty: it works
    QTest::newRow("hole") << "'surface': 'holed.obj'"
                          << "holed.obj: the surface bounds no volume: 3 open edges";
    QTest::newRow("hole, repaired") << "'surface': 'holed.obj', 'repair': true"
                                    << "";
    QTest::newRow("hole, too large") << "'surface': 'holed.obj', 'repair': {'largestHole': 2}"
                                     << "the repair found nothing that it could repair";
    QTest::newRow("crossing") << "'surface': 'crossing.obj', 'repair': true"
                              << "pairs of triangles that intersect";
}
void TestSolid::repairIsAsked() {
    QFETCH(QString, domain);
    QFETCH(QString, reason);
    try {
        const Shape<3> bar = solid(domain.toStdString() + ", 'vertices': 300, 'cage': false");
        QVERIFY(reason.isEmpty());
        QCOMPARE(bar.notices[0].text(), std::string("the surface was repaired: 1 hole filled"));
    } catch (const SurfaceError& error) {
        QVERIFY2(!reason.isEmpty() && QString(error.what()).contains(reason), error.what());
        QVERIFY(!error.problems.triangles(kBar).empty());
    }
}

void TestSolid::singleFaultsArePutRight_data() {
    QTest::addColumn<QString>("domain");
    QTest::addColumn<QString>("told");  // if it works, or else why it does not
    QTest::addColumn<bool>("works");
    const auto fill = [](const std::array<int, 3>& t) {
        return QStringLiteral("{'fill': [%1, %2]}").arg(t[0]).arg(t[1]);
    };
    const QString one = fill(kBar.triangles.front()), other = fill(kBar.triangles.back());
    QTest::newRow("one of two") << "'fixes': [" + one + "]"
                                << "two.obj: the surface bounds no volume: 3 open edges" << false;
    QTest::newRow("both") << "'fixes': [" + one + ", " + other + "]"
                          << "the surface was repaired: 2 single steps" << true;
    QTest::newRow("the other with all") << "'repair': true, 'fixes': [" + other + "]"
                                        << "the surface was repaired: 1 single step, 1 hole filled" << true;
    QTest::newRow("twice") << "'fixes': [" + one + ", " + one + "]"
                           << "two.obj: fixes[1]: no hole has the edge" << false;
}

/// The bar without its first and its last triangle.
void TestSolid::singleFaultsArePutRight() {
    QFETCH(QString, domain);
    QFETCH(QString, told);
    QFETCH(bool, works);
    Surface two = kBar;
    two.triangles.pop_back();
    two.triangles.erase(two.triangles.begin());
    test::writeSurface(m_base + "/two.obj", two);
    try {
        const Shape<3> bar =
            solid("'surface': 'two.obj', 'vertices': 300, 'cage': false, " + domain.toStdString());
        QVERIFY(works);
        QCOMPARE(QString::fromStdString(bar.notices[0]), told);
        double volume = 0;
        for (const auto& cell : bar.rest->cells) volume += cellMeasure<3>(bar.rest->points, cell);
        QVERIFY(std::abs(volume - 3) < 1e-12);
        QVERIFY(bar.rest->points.leftCols(kBar.vertexCount()) == kBar.points);
    } catch (const InputError& error) {
        QVERIFY2(!works && QString(error.what()).contains(told), error.what());
    }
}

void TestSolid::cageIsChosenByItself_data() {
    QTest::addColumn<QString>("domain");
    QTest::addColumn<QString>("why");  // empty: the exact surface is meshed
    QTest::newRow("sound") << "'surface': 'bar.obj'"
                           << "";
    QTest::newRow("hole") << "'surface': 'holed.obj'"
                          << "3 open edges";
    QTest::newRow("crossing") << "'surface': 'crossing.obj'"
                              << "pairs of triangles that intersect";
    QTest::newRow("hole, repaired") << "'surface': 'holed.obj', 'repair': true"
                                    << "";
    QTest::newRow("far more vertices") << "'surface': 'dense.obj'"
                                       << "where 300 were aimed at";
}
void TestSolid::cageIsChosenByItself() {
    QFETCH(QString, domain);
    QFETCH(QString, why);
    test::writeSurface(m_base + "/dense.obj", test::box({0, 0, 0}, {3, 1, 1}, 24));
    const Shape<3> one = solid(domain.toStdString() + ", 'vertices': 300");
    QCOMPARE(one.cage.has_value(), !why.isEmpty());
    QVERIFY(std::abs(one.rest->vertexCount() - 300) <= 45 || why.isEmpty());
    if (why.isEmpty()) return;
    const QString told = QString::fromStdString(one.notices.at(0));
    QVERIFY2(told.contains("is embedded in a cage of") && told.contains(why), qPrintable(told));
    QVERIFY(QString::fromStdString(one.cage->why).contains(why));
}

/// The surface in the cage is kept bit for bit at rest and up to rounding under affine maps; all of it is
/// inside.
void TestSolid::cageCarriesTheSurface() {
    for (const char* file : {"crossing.obj", "holed.obj", "fine.ply"}) {
        const Shape<3> one =
            solid("'surface': '" + std::string(file) + "', 'vertices': 700, 'cage': {'detail': 2}");
        QVERIFY(one.cage && one.cage->why.isEmpty());
        QCOMPARE(one.embedding->outside(), 0);
        QVERIFY(one.embedding->carry(*one.rest, one.rest->points) == one.skin->points);
        Mat3 A;
        A << 1, 0.2, 0, -0.3, 1.1, 0, 0.1, 0, 0.9;
        const Points3 carried = one.embedding->carry(*one.rest, A * one.rest->points);
        QVERIFY((carried - A * one.skin->points).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY(one.skin->triangles == trianglesOf(*sharedMeshFile(m_base + "/" + file)));
    }
}

void TestSolid::partsThatShareACageAreReported() {
    test::writeSurface(m_base + "/near.obj", test::joined(kBar, test::box({3.01, 0, 0}, {4, 1, 1}, 2)));
    test::writeSurface(m_base + "/apart.obj", test::joined(kBar, test::box({9, 0, 0}, {10, 1, 1}, 2)));
    const auto told = [&](const char* file) {
        std::string all;
        for (const auto& notice :
             solid("'surface': '" + std::string(file) + "', 'vertices': 500, 'cage': true").notices)
            all += notice.text() + "\n";
        return QString::fromStdString(all);
    };
    const QString near = told("near.obj"), apart = told("apart.obj");
    QVERIFY2(near.contains("2 parts share cells of the cage and move together as 1"), qPrintable(near));
    QVERIFY2(!near.contains("bodies"), qPrintable(near));
    QVERIFY2(apart.contains("of 2 bodies that are not connected"), qPrintable(apart));
    QVERIFY2(!apart.contains("share cells"), qPrintable(apart));
}

/// A fork has a slot of a tenth: the report gives its place, its width, and the number of vertices that opens
/// it.
void TestSolid::gapsThatACageClosesAreReported() {
    test::writeSurface(m_base + "/fork.obj", test::fork(0.1));
    const auto caged = [this](int vertices) {
        return solid("'surface': 'fork.obj', 'cage': true, 'vertices': " + std::to_string(vertices));
    };
    const Shape<3> coarse = caged(1000);
    const QString told = QString::fromStdString(coarse.notices.at(0));
    const QRegularExpression form(
        "^the cage closes a gap within one part, 0.1 wide near \\(0.25, ([^,]*), ([^,]*)\\): what "
        "lies on both sides moves together; about (\\d+) vertices open the widest$");
    const auto match = form.match(told);
    QVERIFY2(match.hasMatch(), qPrintable(told));
    for (const int i : {1, 2})
        QCOMPARE(match.captured(i), QString::number(match.captured(i).toDouble(), 'g', 4));  // no more digits
    const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(cageJson(*coarse.cage)));
    QVERIFY(std::abs(json["gaps"][0]["width"].toDouble() - 0.1) < 1e-6);
    const Shape<3> fine = caged(match.captured(3).toInt());
    QVERIFY(fine.notices.empty() && fine.cage->gaps.empty());
}

void TestSolid::unitsAreThoseThatTheFileTells_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("units");
    const auto row = [](const char* name, const QByteArray& text, const char* units) {
        QTest::addRow("%s: %s", name, text.left(24).constData()) << name << text << units;
    };
    row("u.obj", "# Units: millimetres\nv 0 0 0\n", "mm");
    row("u.obj", "# scanned\n# UNIT=inch\n", "in");
    row("u.obj", "# made in an hour, 3 m of cable\n", "");
    row("u.obj", "o unit_mm\nv 0 0 0\n", "");
    row("u.obj", QByteArray("# ") + QByteArray(5000, '-') + "\n# unit: m\n", "");
    row("u.off", "OFF # unit: m\n# unit: feet\n", "ft");
    row("u.ply", "ply\ncomment unit micron\n", "µm");
    row("u.ply", "ply\nobj_info units cm\n", "cm");
    row("u.ply", "ply\nelement unit m\n", "");
    row("u.stl", "solid part, units: m\nfacet\n", "m");
    row("u.stl", "solid part\n# unit: m\n", "");
}

void TestSolid::unitsAreThoseThatTheFileTells() {
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    QFETCH(QString, units);
    QFile file(m_folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    QCOMPARE(QString::fromStdString(statedUnits(file.fileName().toStdString())), units);
}

void TestSolid::cageIsMadeAgainWhenItChanges() {
    const auto domain = [&](const std::string& cage) {
        return project("'surface': 'bar.obj', 'vertices': 300" + cage);
    };
    QVERIFY(sameSolid(*domain(", 'cage': true"), *domain(", 'cage': {}")));
    QVERIFY(!sameSolid(*domain(""), *domain(", 'cage': false")));
    QVERIFY(!sameSolid(*domain(", 'cage': true"), *domain(", 'cage': {'detail': 2}")));
    QVERIFY(!sameSolid(*domain(", 'cage': true"), *domain(", 'cage': {'offset': 0.5}")));
}

void TestSolid::handlesByNumberKeepTheSurface() {
    test::writeSurface(m_base + "/dense.obj", test::box({0, 0, 0}, {3, 1, 1}, 24));
    const std::string text =
        "{'format': 'wend', 'version': 1, 'domain': {'surface': 'dense.obj', 'vertices': 300}, "
        "'handles': [{'at': {'vertices': [3000]}}]}";
    const auto read = parseProject(json(text), m_base + "/p.wend").project;
    QVERIFY(!loadSolid(domainOf(*read), designOf(*read), m_base).cage);
}

void TestSolid::sizesFollowRegionsAndPaint() {
    const Vec3 here(0.7, 0.5, 0.5), there(2.3, 0.5, 0.5);
    const std::string region =
        "{'shape': {'sphere': {'centre': [0.7, 0.5, 0.5], 'radius': 0.4}}, 'factor': 0.4, 'feather': 0.1}";
    const Shape<3> byRegion = solid("'surface': 'bar.obj', 'vertices': 1500, 'sizes': [" + region + "]");
    const int fine = countNear(*byRegion.rest, here, 0.35), plain = countNear(*byRegion.rest, there, 0.35);
    QVERIFY2(fine > 4 * plain, qPrintable(QString("%1 %2").arg(fine).arg(plain)));

    std::string paint;
    for (int v = 0; v < kBar.vertexCount(); ++v) paint += kBar.points(0, v) > 1.5 ? "0.4\n" : "1\n";
    put(m_folder.path(), "paint.txt", paint);
    const Shape<3> byPaint =
        solid("'surface': 'bar.obj', 'vertices': 1500, 'sizes': [{'values': 'paint.txt'}]");
    const int painted = countNear(*byPaint.rest, there, 0.45), bare = countNear(*byPaint.rest, here, 0.45);
    QVERIFY2(painted > 4 * bare, qPrintable(QString("%1 %2").arg(painted).arg(bare)));
}

void TestSolid::wrongPaintIsRefused() {
    put(m_folder.path(), "short.txt", "1 1 1\n");
    put(m_folder.path(), "word.txt", "1 1 one\n");
    QVERIFY_THROWS_EXCEPTION(InputError, solid("'surface': 'bar.obj', 'sizes': [{'values': 'short.txt'}]"));
    QVERIFY_THROWS_EXCEPTION(InputError, solid("'surface': 'bar.obj', 'sizes': [{'values': 'word.txt'}]"));
}

void TestSolid::detailFollows() {
    const Shape<3> bar = solid("'surface': 'bar.obj', 'vertices': 400, 'detail': 'fine.ply'");
    QCOMPARE(bar.skin->vertexCount(), test::box({0, 0, 0}, {1, 1, 1}, 20).vertexCount());
    Mat3 A;
    A << 1, 0.2, 0, -0.3, 1.1, 0, 0.1, 0, 0.9;
    const Points3 carried = bar.embedding->carry(*bar.rest, A * bar.rest->points);
    QVERIFY((carried - A * bar.skin->points).cwiseAbs().maxCoeff() < 1e-12);  // inside and outside
    QVERIFY(bar.embedding->outside() > 0);
}

void TestSolid::detailFarOffIsReported() {
    const Shape<3> bar = solid("'mesh': 'bar.mesh', 'detail': 'far.ply'");
    QVERIFY(QString::fromStdString(bar.notices.at(0)).contains("lie outside the solid"));
}

void TestSolid::builderKeepsWhatHolds() {
    ShapeBuilder<3> builder;
    ShapeInputs inputs;
    inputs.project = project("'surface': 'bar.obj', 'vertices': 400");
    inputs.folder = m_base;
    const auto first = builder.build(inputs, {});
    QVERIFY(first.rest && first.material && first.skin && first.embedding);
    const auto stiffer = copyOf(*inputs.project);
    designOf(*stiffer).material.phi = 1;
    inputs.project = copyOf(*stiffer);
    const auto second = builder.build(inputs, {});
    QCOMPARE(second.rest, first.rest);
    QCOMPARE(second.material->phi[0], 1.0);
    domainOf(*stiffer).vertices = 600;
    inputs.project = copyOf(*stiffer);
    QVERIFY(builder.build(inputs, {}).rest != first.rest);
    std::stop_source stopped;
    stopped.request_stop();
    domainOf(*stiffer).vertices = 700;
    inputs.project = copyOf(*stiffer);
    QVERIFY(!builder.build(inputs, stopped.get_token()).rest);
}

void TestSolid::filesOpen_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("kind");
    QTest::newRow("surface") << "bar.obj" << 3 << int(DomainKind::Surface);
    QTest::newRow("tetrahedra") << "bar.mesh" << 3 << int(DomainKind::Mesh);
    QTest::newRow("flat") << "flat.obj" << 2 << int(DomainKind::Mesh);
}
void TestSolid::filesOpen() {
    QFETCH(QString, name);
    QFETCH(int, dimension);
    QFETCH(int, kind);
    const QString path = m_folder.filePath(name);
    const OpenedFile file = openFile(path);
    QCOMPARE(dimensionOf(*file.project), dimension);
    QCOMPARE(int(domainOf(*file.project).kind), kind);
}

QTEST_GUILESS_MAIN(TestSolid)
#include "test_solid.moc"
