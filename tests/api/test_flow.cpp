#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <thread>

#include "wend/flow.h"
#include "wend/version.h"
#include "wend/warp.h"

using namespace wend;

/// The library as other programs use it: only installed headers are included.
class TestFlow : public QObject {
    Q_OBJECT
  private slots:
    void rigidMotionIsExact();
    void stretchedSquareIsAClosedForm();
    void runsDoNotDependOnThoseBefore();
    void runGoesOn();
    void equalsTheProgram();
    void rotationInSpace();
    void stopsAndGoesOn();
    void twoFlowsInTwoThreads();
    void elasticLoopCloses();
    void foldIsAValue();
    void inputIsChecked();
    void placesAndMovements();
    void surfaceIsFilled();
    void pictureIsWarped();
    void versionIsTheProgram();
};

namespace {

/// Returns a rectangle of nx × ny squares, each cut into two triangles.
Mesh<2> grid(int nx, int ny, double width, double height) {
    Mesh<2> mesh;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) mesh.points.push_back({width * i / nx, height * j / ny});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + nx + 1;
            mesh.cells.push_back({a, a + 1, b + 1});
            mesh.cells.push_back({a, b + 1, b});
        }
    return mesh;
}

/// Returns a bar of nx × ny × nz cubes, each of six tetrahedra (Kuhn's subdivision).
Mesh<3> bar(int nx, int ny, int nz) {
    Mesh<3> mesh;
    const auto at = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) mesh.points.push_back({0.5 * i, 0.5 * j, 0.5 * k});
    const std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                for (std::size_t o = 0; o < orders.size(); ++o) {
                    std::array<int, 3> p{i, j, k};
                    CellVertices<3> cell{at(p[0], p[1], p[2])};
                    for (std::size_t s = 0; s < 3; ++s) {
                        ++p[orders[o][s]];
                        cell[s + 1] = at(p[0], p[1], p[2]);
                    }
                    if (o >= 3) std::swap(cell[1], cell[2]);
                    mesh.cells.push_back(cell);
                }
    return mesh;
}

template <int Dim>
double distance(const Coordinates<Dim>& a, const Coordinates<Dim>& b) {
    double sum = 0;
    for (int k = 0; k < Dim; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

template <int Dim>
bool sameBits(std::span<const Coordinates<Dim>> a, std::span<const Coordinates<Dim>> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

template <int Dim>
std::vector<Coordinates<Dim>> copyOf(const Flow<Dim>& flow) {
    return {flow.points().begin(), flow.points().end()};
}

Place<2> left() {
    return Place<2>::halfSpace({0, 0}, {-1, 0});
}
Place<2> right(double width) {
    return Place<2>::halfSpace({width, 0}, {1, 0});
}

/// Returns a strip whose right end rotates.
Flow<2> bentStrip(const FlowOptions& options = {}) {
    Flow<2> flow(grid(24, 6, 4, 1), {}, options);
    flow.hold(left());
    flow.move(right(4), Movement<2>().rotate({2, 0.5}, 1.2));
    return flow;
}

QString messageOf(const std::function<void()>& f) {
    try {
        f();
    } catch (const InvalidInput& error) {
        return QString::fromUtf8(error.what());
    }
    return {};
}

}  // namespace

/// A single handle with three corners moves the whole shape rigidly, whatever the material.
void TestFlow::rigidMotionIsExact() {
    for (const Keep keep : {Keep::Length, Keep::Rigidity}) {
        Flow<2> flow(grid(8, 8, 1, 1), {.phi = phiOf(keep, 2)}, {.tolerance = 1e-9});
        flow.move(Place<2>::vertices({0, 8, 80}), Movement<2>().rotate({0.25, 0.5}, 2));
        QVERIFY(flow.run().done());
        double worst = 0;
        for (std::size_t k = 0; k < flow.points().size(); ++k) {
            const double x = flow.restPoints()[k][0] - 0.25, y = flow.restPoints()[k][1] - 0.5;
            const Coordinates<2> there = {0.25 + x * std::cos(2.0) - y * std::sin(2.0),
                                          0.5 + x * std::sin(2.0) + y * std::cos(2.0)};
            worst = std::max(worst, distance<2>(there, flow.points()[k]));
        }
        // Each step errs by 1e-9 of the size at most, and there are hundreds of them.
        QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
        QVERIFY(flow.distortion().totalMetric < 1e-12);
    }
}

/// The two sides move apart and are free along y. At AKVF, e = ‖S‖², so a field without shear costs the
/// least: v = (x ẇ/w, 0), heights stay, and cells grow by the factor of the width.
void TestFlow::stretchedSquareIsAClosedForm() {
    Flow<2> flow(grid(6, 6, 1, 1), {.phi = phiOf(Keep::Rigidity, 2)}, {.tolerance = 1e-8});
    flow.hold(Place<2>::halfSpace({0, 0}, {-1, 0}).free({false, true}));
    flow.move(right(1).free({false, true}), Movement<2>().translate({1, 0}));
    flow.hold(Place<2>::vertices({0}));
    QVERIFY(flow.run().done());
    for (std::size_t k = 0; k < flow.points().size(); ++k) {
        const Coordinates<2> there = {2 * flow.restPoints()[k][0], flow.restPoints()[k][1]};
        QVERIFY(distance<2>(there, flow.points()[k]) < 1e-6);
    }
    const FlowDistortion distortion = flow.distortion();
    // σ = (2, 1): (2 − 1)² / 2, and (2 − 1)² / 2.
    QVERIFY(std::abs(distortion.totalAngle - 0.5) < 1e-5);
    QVERIFY(std::abs(distortion.totalVolume - 0.5) < 1e-5);
    QVERIFY(std::abs(flow.minDet() - 2) < 1e-5);
    QCOMPARE(distortion.inverted, 0);
}

void TestFlow::runsDoNotDependOnThoseBefore() {
    Flow<2> flow = bentStrip();
    QVERIFY(flow.run().done());
    const auto first = copyOf(flow);
    flow.setMovement(1, Movement<2>().translate({0.5, 0.3}));
    QVERIFY(flow.run(2).done());
    flow.reset();
    QCOMPARE(flow.time(), 0.0);
    QVERIFY(sameBits<2>(flow.points(), flow.restPoints()));
    QVERIFY(flow.run().done());
    Flow<2> other(grid(24, 6, 4, 1));
    other.hold(left());
    other.move(right(4), Movement<2>().translate({0.5, 0.3}));
    QVERIFY(other.run().done());
    QVERIFY(sameBits<2>(flow.points(), other.points()));
    QVERIFY(!sameBits<2>(flow.points(), first));
    flow.setMovement(1, Movement<2>().rotate({2, 0.5}, 1.2));
    flow.reset();
    QVERIFY(flow.run().done());
    QVERIFY(sameBits<2>(flow.points(), first));
}

/// A run in two parts, whose second half is set in between, equals a single run.
void TestFlow::runGoesOn() {
    Flow<2> once(grid(24, 6, 4, 1)), twice(grid(24, 6, 4, 1));
    const TimeWindow second{1, 2};
    once.hold(left());
    once.move(right(4), Movement<2>().translate({0.2, 0}).rotate({2, 0.5}, 0.7, second));
    QVERIFY(once.run().done());
    QCOMPARE(once.time(), 2.0);
    twice.hold(left());
    const int end = twice.move(right(4), Movement<2>().translate({0.2, 0}));
    QVERIFY(twice.run().done());
    twice.setMovement(end, Movement<2>().translate({0.2, 0}).rotate({2, 0.5}, 0.7, second));
    QVERIFY(twice.run().done());
    QVERIFY(sameBits<2>(once.points(), twice.points()));
}

/// `wend run` of the same mesh, handles and material writes the same numbers.
void TestFlow::equalsTheProgram() {
    QTemporaryDir folder;
    const QString mesh = folder.filePath("strip.obj"), project = folder.filePath("strip.wend"),
                  out = folder.filePath("out.obj");
    saveMesh<2>(mesh.toStdString(), grid(24, 6, 4, 1));
    QFile file(project);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        R"({"format": "wend", "version": 1, "domain": {"mesh": "strip.obj"}, "material": {"phi": "metr"},
        "handles": [{"at": {"region": {"halfspace": {"point": [0, 0], "normal": [-1, 0]}}}},
                    {"at": {"region": {"halfspace": {"point": [4, 0], "normal": [1, 0]}}},
                     "motion": [{"kind": "rotate", "centre": [2, 0.5], "angle": 1.2, "time": [0, 1]}]}]})");
    file.close();
    QProcess wend;
    wend.start(WEND_BINARY, {"run", project, "--mesh", out, "--backend", "cpu", "--quiet"});
    QVERIFY(wend.waitForFinished(600000));
    QVERIFY2(wend.exitCode() == 0, wend.readAllStandardError().constData());
    Flow<2> flow = bentStrip();
    QVERIFY(flow.run().done());
    QVERIFY(sameBits<2>(flow.points(), loadMesh<2>(out.toStdString()).points));
}

/// Both ends of a bar rotate about its axis by the same angle, so the whole bar does.
void TestFlow::rotationInSpace() {
    const Mesh<3> mesh = bar(8, 2, 2);
    Flow<3> flow(mesh, {}, {.tolerance = 1e-8});
    const auto turn = Movement<3>().rotate({0, 0.5, 0.5}, {1, 0, 0}, 1.5);
    flow.move(Place<3>::box({-1, -1, -1}, {0.1, 2, 2}), turn);
    flow.move(Place<3>::ball({4, 0.5, 0.5}, 1), turn);
    QVERIFY(flow.run().done());
    for (std::size_t k = 0; k < flow.points().size(); ++k) {
        const auto [x, y, z] = mesh.points[k];
        const double c = std::cos(1.5), s = std::sin(1.5);
        const Coordinates<3> there = {x, 0.5 + (y - 0.5) * c - (z - 0.5) * s,
                                      0.5 + (y - 0.5) * s + (z - 0.5) * c};
        QVERIFY(distance<3>(there, flow.points()[k]) < 1e-5);
    }
    QVERIFY(std::abs(flow.minDet() - 1) < 1e-5);
    QVERIFY(flow.worst() >= 0);
}

void TestFlow::stopsAndGoesOn() {
    Flow<2> whole = bentStrip(), stopped = bentStrip();
    QVERIFY(whole.run().done());
    std::stop_source source;
    int steps = 0;
    RunResult result =
        stopped.run({[&](double) { steps += source.request_stop() ? 1 : 0; }, source.get_token()});
    QCOMPARE(result.ending, Ending::Cancelled);
    QCOMPARE(steps, 1);
    QVERIFY(stopped.time() > 0 && stopped.time() < 1);
    QCOMPARE(result.time, stopped.time());
    QVERIFY(stopped.run(1).done());
    QVERIFY(sameBits<2>(whole.points(), stopped.points()));
}

void TestFlow::twoFlowsInTwoThreads() {
    Flow<2> alone = bentStrip();
    QVERIFY(alone.run().done());
    Flow<2> a = bentStrip(), b = bentStrip();
    {
        const std::jthread first([&] { a.run(); }), second([&] { b.run(); });
    }
    QVERIFY(sameBits<2>(a.points(), alone.points()) && sameBits<2>(b.points(), alone.points()));
}

/// With the elastic energy a closed path of the handle restores the shape; without a memory of the rest shape
/// it does not.
void TestFlow::elasticLoopCloses() {
    for (const bool isElastic : {true, false}) {
        FlowMaterial<2> material;
        if (isElastic) material.memory = std::numeric_limits<double>::infinity();
        Flow<2> flow(grid(12, 4, 3, 1), material);
        flow.hold(left());
        flow.move(
            {{12, 38, 64}},
            Movement<2>().translate({-0.4, 0.8}).translate({0.4, 0}, {1, 2}).translate({0, -0.8}, {2, 3}));
        QVERIFY(flow.run().done());
        QCOMPARE(flow.time(), 3.0);
        double farthest = 0;
        for (std::size_t k = 0; k < flow.points().size(); ++k)
            farthest = std::max(farthest, distance<2>(flow.points()[k], flow.restPoints()[k]));
        // Newton's method ends within 1e-7 of the size.
        QVERIFY2(isElastic ? farthest < 1e-6 : farthest > 1e-3, qPrintable(QString::number(farthest)));
        QVERIFY(flow.statistics().snaps.empty());
    }
}

void TestFlow::foldIsAValue() {
    Flow<2> flow(grid(4, 4, 1, 1));
    flow.hold(left());
    flow.move(right(1), Movement<2>().translate({-1.5, 0}));
    const RunResult result = flow.run();
    QVERIFY(!result.done());
    QVERIFY(!result.message.empty() && result.message.find('\n') == std::string::npos);
    QVERIFY(result.time < 2.0 / 3);
    QVERIFY(flow.minDet() > 0);
}

void TestFlow::inputIsChecked() {
    Mesh<2> mesh = grid(2, 2, 1, 1);
    QVERIFY(messageOf([&] { Flow<2>(Mesh<2>{mesh.points, {{0, 1, 99}}}); }).contains("99"));
    QVERIFY(messageOf([&] { Flow<2>(mesh, {.phi = 3}); }).contains("phi = 3"));
    QVERIFY(!messageOf([&] { Flow<2>(mesh, {.cellPhi = {1.0}}); }).isEmpty());
    QVERIFY(messageOf([&] { Flow<2>(mesh, {}, {.tolerance = 1}); }).contains("tolerance"));
    QVERIFY(messageOf([&] { Flow<2>(mesh, {.memory = -1}); }).contains("memory"));
    Flow<2> flow(mesh);
    flow.hold(Place<2>::vertices({77}));
    QVERIFY(messageOf([&] { flow.run(); }).contains("77"));
    flow.clear();
    QVERIFY(messageOf([&] { flow.setMovement(0, {}); }).contains("handle 0"));
    QVERIFY(!messageOf([&] { flow.run(-1); }).isEmpty());
    QVERIFY(!messageOf([&] { flow.run(std::nan("")); }).isEmpty());
    flow.hold(left());
    flow.move(Place<2>::vertices({0}), Movement<2>().translate({1, 0}));
    QVERIFY(messageOf([&] { flow.run(); }).contains("handle 0"));
    QVERIFY(messageOf([&] { phiOf(Keep::Angles, 4); }).contains("dimension"));
    QVERIFY(messageOf([&] { loadMesh<2>("/nowhere/mesh.obj"); }).contains("/nowhere/mesh.obj"));
}

/// Every motion ends where its definition says.
void TestFlow::placesAndMovements() {
    const Mesh<2> mesh = grid(10, 10, 1, 1);
    struct Case {
        Place<2> place;
        Movement<2> movement;
        Coordinates<2> from, to;
    };
    const double half = std::numbers::sqrt2 / 2;
    const std::vector<Case> cases = {
        {Place<2>::points({{0.53, 0.47}, {0.6, 0.4}, {0.41, 0.44}}),
         Movement<2>().translate({0.1, 0.2}),
         {0.6, 0.4},
         {0.7, 0.6}},
        {Place<2>::ball({0.5, 0.5}, 0.11),
         Movement<2>().rotate({0.5, 0.5}, std::numbers::pi / 4),
         {0.6, 0.5},
         {0.5 + 0.1 * half, 0.5 + 0.1 * half}},
        {Place<2>::box({0.45, 0.45}, {0.65, 0.65}),
         Movement<2>().follow({{0, 0}, {0.1, 0}, {0.1, 0.1}}, {.joining = Joining::Lines}),
         {0.5, 0.5},
         {0.6, 0.6}},
        {Place<2>::polygon({{0.45, 0.45}, {0.65, 0.45}, {0.65, 0.65}, {0.45, 0.65}}),
         Movement<2>().follow({{0, 0}, {0.1, 0}, {0.2, 0.1}, {0.2, 0.2}}),
         {0.5, 0.5},
         {0.7, 0.7}},
        {Place<2>::vertices({60, 61, 71}),
         Movement<2>().record({0, 1, 2}, {{5, 5}, {5, 5.1}, {5.1, 5.2}}),
         {0.5, 0.5},
         {0.6, 0.7}},
        {Place<2>::vertices({60, 61, 71}),
         Movement<2>().displace({{60, {0.05, 0}}, {61, {0.05, 0}}, {71, {0.05, 0.02}}}),
         {0.5, 0.5},
         {0.55, 0.5}},
    };
    for (std::size_t k = 0; k < cases.size(); ++k) {
        Flow<2> flow(mesh);
        flow.move(cases[k].place, cases[k].movement);
        QVERIFY2(flow.run().done(), qPrintable(QString::number(k)));
        bool found = false;
        for (std::size_t v = 0; v < mesh.points.size(); ++v)
            if (distance<2>(mesh.points[v], cases[k].from) < 1e-12) {
                found = true;
                QVERIFY2(distance<2>(flow.points()[v], cases[k].to) < 1e-9, qPrintable(QString::number(k)));
            }
        QVERIFY(found);
    }
    Flow<2> flow(mesh);
    flow.move(Place<2>::vertices({60, 61, 71}), Movement<2>().translate({0.1, 0.2}));
    const auto velocity = flow.velocity();
    for (const Coordinates<2>& v : velocity) QVERIFY(distance<2>(v, {0.1, 0.2}) < 1e-9);
}

void TestFlow::surfaceIsFilled() {
    const std::vector<Coordinates<3>> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const std::vector<std::array<int, 3>> triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const Mesh<3> solid = fillSurface(points, triangles, {.maxVolume = 0.05, .keepSurface = false});
    double volume = 0;
    for (const CellVertices<3>& cell : solid.cells) {
        std::array<Coordinates<3>, 3> e;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) e[i][k] = solid.points[cell[i + 1]][k] - solid.points[cell[0]][k];
        volume += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                   e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
                  6;
    }
    QVERIFY(std::abs(std::abs(volume) - 8.0 / 6) < 1e-12);
    QVERIFY(solid.cells.size() > 20);
    const std::vector<std::array<int, 3>> open(triangles.begin(), triangles.end() - 1);
    QVERIFY(messageOf([&] { fillSurface(points, open); }).contains("open"));
}

/// Columns of one brightness each, moved by whole pixels.
void TestFlow::pictureIsWarped() {
    Picture picture{40, 20, 1};
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 40; ++i) picture.pixels.push_back(static_cast<std::byte>(6 * i));
    const Mesh<2> mesh = meshPicture(picture, {.mesh = {.vertices = 100}});
    auto pose = mesh.points;
    for (Coordinates<2>& p : pose) p[0] += 10;
    const Picture warped = warpPicture(picture, mesh, pose, {.lookup = Lookup::Nearest});
    QCOMPARE(warped.width, 40);
    QCOMPARE(warped.channels, 2);  // with alpha: ten columns are not covered
    for (int i = 0; i < 40; ++i) {
        const std::size_t pixel = 2 * (5 * 40 + i);
        QCOMPARE(static_cast<int>(warped.pixels[pixel + 1]), i < 10 ? 0 : 255);
        QCOMPARE(static_cast<int>(warped.pixels[pixel]), i < 10 ? 0 : 6 * (i - 10));
    }
    QTemporaryDir folder;
    const std::string file = folder.filePath("picture.png").toStdString();
    savePicture(file, picture);
    const Picture read = loadPicture(file);
    QVERIFY(read.pixels == picture.pixels && read.width == 40 && read.channels == 1);
    QVERIFY(messageOf([&] { warpPicture({40, 20, 1}, mesh, pose); }).contains("bytes"));
    QVERIFY(messageOf([&] { warpPicture(picture, mesh, {}); }).contains("vertices"));
}

void TestFlow::versionIsTheProgram() {
    QProcess wend;
    wend.start(WEND_BINARY, {"--version"});
    QVERIFY(wend.waitForFinished(600000));
    QVERIFY(wend.readAllStandardOutput().contains(version()));
}

QTEST_APPLESS_MAIN(TestFlow)
#include "test_flow.moc"
