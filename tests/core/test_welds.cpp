// Welds: two parts of a shape that share points. Closed forms show that the points stay together, that a part
// that rotates about its joint moves rigidly and pulls nothing, that parts welded at two points are one, and
// that handles which contradict a weld are reported.
#include <Eigen/Geometry>
#include <QTest>
#include <numbers>

#include "core/base/error.h"
#include "core/solver/components.h"
#include "core/solver/velocity_solver.h"
#include "tests/core/test_strip.h"

using namespace wend;

namespace {

using Mesh = SimplicialMesh<2>;

/// A body, [0, 3] × [0, 1], and over its right end a limb of the same size from `at` on, as two parts.
Mesh bodyAndLimb(const Vec2& at, int along = 12, int across = 4) {
    const Mesh body = samples::strip<2>(9, 3, 3), limb = samples::strip<2>(along, across, 3);
    Mesh mesh;
    const int n = body.vertexCount(), m = limb.vertexCount();
    mesh.points.resize(2, n + m);
    mesh.points.leftCols(n) = body.points;
    mesh.points.rightCols(m) = limb.points.colwise() + at;
    mesh.cells = body.cells;
    for (Cell<2> cell : limb.cells) {
        for (int& v : cell) v += n;
        mesh.cells.push_back(cell);
    }
    mesh.parts = {{"body", 0, n, 0, body.cellCount()},
                  {"limb", n, n + m, body.cellCount(), body.cellCount() + limb.cellCount()}};
    return mesh;
}

Handle<2> handleAt(const char* name, const char* part, std::vector<Vec2> points) {
    Handle<2> handle;
    handle.name = name;
    handle.part = part;
    handle.at = std::move(points);
    return handle;
}

/// A weld of both parts at a place, which is in both.
Weld weldAt(const Mesh& mesh, const Vec2& place) {
    Handle<2> at = handleAt("", "body", {place});
    Weld weld{Constraints<2>(mesh, {at}).points().front().terms};
    at.part = "limb";
    const Constraints<2> other(mesh, {at});
    for (const auto& [v, weight] : other.points().front().terms) weld.terms.emplace_back(v, -weight);
    return weld;
}

double gapOf(const Mesh& mesh, const Points2& pose) {
    double gap = 0;
    for (const Weld& weld : mesh.welds) {
        Vec2 difference = Vec2::Zero();
        for (const auto& [v, weight] : weld.terms) difference += weight * pose.col(v);
        gap = std::max(gap, difference.norm());
    }
    return gap;
}

std::shared_ptr<const Material<2>> materialOf(const Mesh& mesh, double phi) {
    return std::make_shared<const Material<2>>(Material<2>::uniform(mesh.cellCount(), phi));
}

const Vec2 kAt(2.45, 0.1), kJoint(2.7, 0.55), kHand(5.3, 0.7);

Motion<2> turnedBy(double angle) {
    Rotate<2> rotate;
    rotate.centre = kJoint;
    rotate.angle = angle;
    return {rotate};
}

/// Returns handles that hold the body and rotate the limb about its joint by one point.
std::vector<Handle<2>> handlesOf(double angle) {
    std::vector<Handle<2>> handles{handleAt("body", "body", {{0.2, 0.3}, {0.3, 0.8}}),
                                   handleAt("hand", "limb", {kHand})};
    handles[1].motions = {turnedBy(angle)};
    return handles;
}

IntegrationOptions tight(SolverKind solver) {
    IntegrationOptions options;
    options.tolerance = 1e-8;
    options.solver = solver;
    return options;
}

}  // namespace

class TestWelds : public QObject {
    Q_OBJECT
  private slots:
    void limbTurnsAboutItsJoint_data() {
        QTest::addColumn<int>("solver");
        QTest::addColumn<double>("phi");
        QTest::newRow("direct, METR") << int(SolverKind::Direct) << double(phi::kMetr);
        QTest::newRow("direct, AKVF") << int(SolverKind::Direct) << double(phi::kAkvf);
        QTest::newRow("multigrid") << int(SolverKind::Multigrid) << double(phi::kMetr);
    }
    /// The limb's motion is the rotation itself, the body does not move, and no energy is spent.
    void limbTurnsAboutItsJoint() {
        QFETCH(int, solver);
        QFETCH(double, phi);
        Mesh mesh = bodyAndLimb(kAt);
        mesh.welds = {weldAt(mesh, kJoint)};
        const auto rest = std::make_shared<const Mesh>(mesh);
        Deformer<2> deformer(rest, materialOf(mesh, phi), handlesOf(2.5),
                             tight(static_cast<SolverKind>(solver)));
        typename Deformer<2>::Watch watch;
        double gap = 0;
        for (int k = 1; k < 10; ++k) watch.frames.push_back(0.1 * k);
        watch.onFrame = [&](const State<2>& state) { gap = std::max(gap, gapOf(mesh, state.points)); };
        const Points2 pose = samples::runTo(deformer, 1, watch);
        QVERIFY(gap <= 1e-12 * 5);  // of a shape that is five wide, at frames between the steps, too
        QVERIFY(gapOf(mesh, pose) <= 1e-12 * 5);
        const MeshPart& limb = mesh.parts[1];
        const Eigen::Rotation2Dd turn(2.5);
        for (int v = 0; v < limb.firstVertex; ++v) QVERIFY((pose.col(v) - mesh.points.col(v)).norm() < 1e-6);
        for (int v = limb.firstVertex; v < limb.endVertex; ++v)
            QVERIFY((pose.col(v) - kJoint - turn * (mesh.points.col(v) - kJoint)).norm() < 1e-6);
        QVERIFY(std::abs(deformer.statistics().energy) < 1e-12);
    }

    /// Without a pin of its own the limb is carried by the body: it follows its translation.
    void freeLimbGoesAlong() {
        Mesh mesh = bodyAndLimb(kAt);
        mesh.welds = {weldAt(mesh, kJoint)};
        auto body = handleAt("body", "body", {{0.2, 0.3}, {0.3, 0.8}});
        body.motions = {Motion<2>{Translate<2>{{0, 2}}}};
        Deformer<2> deformer(std::make_shared<const Mesh>(mesh), materialOf(mesh, phi::kMetr), {body},
                             tight(SolverKind::Direct));
        const Points2 pose = samples::runTo(deformer, 1);
        QVERIFY(gapOf(mesh, pose) <= 1e-12 * 5);
        const Vec2 joint = kJoint + Vec2(0, 2);
        const auto nearest = [&](const Points2& points) {
            return (points.rightCols(mesh.parts[1].endVertex - mesh.parts[1].firstVertex).colwise() -
                    (&points == &pose ? joint : kJoint))
                .colwise()
                .norm()
                .minCoeff();
        };
        QVERIFY(std::abs(nearest(pose) - nearest(mesh.points)) < 0.02);
    }

    /// Two welds at two places prevent a rotation: both parts together have no motion left, though neither
    /// has two pins. With one weld the limb can rotate.
    void countsWhatWeldsHold() {
        Mesh mesh = bodyAndLimb(kAt);
        const auto components = cellComponents(mesh);
        const std::vector<ConstraintRow> pins{{{{0, 1.0}}}, {{{mesh.vertexCount() - 1, 1.0}}}};
        QCOMPARE(wellConstrained(mesh, components, pins), (std::vector<bool>{false, false}));
        mesh.welds = {weldAt(mesh, kJoint)};  // a hinge with two pins: it can still fold up by scaling
        QCOMPARE(wellConstrained(mesh, components, pins), (std::vector<bool>{false, false}));
        mesh.welds.push_back(weldAt(mesh, {2.9, 0.3}));
        QCOMPARE(wellConstrained(mesh, components, pins), (std::vector<bool>{true, true}));
        const std::vector<ConstraintRow> ofBody{{{{0, 1.0}}}, {{{5, 1.0}}}};
        mesh.welds.pop_back();
        QCOMPARE(wellConstrained(mesh, components, ofBody), (std::vector<bool>{true, false}));
        const std::vector<ConstraintRow> withHand{
            {{{0, 1.0}}}, {{{5, 1.0}}}, {{{mesh.vertexCount() - 1, 1.0}}}};
        QCOMPARE(wellConstrained(mesh, components, withHand), (std::vector<bool>{true, true}));
    }

    /// A field of least energy under welds is that of the mesh in which both points are one vertex, except
    /// for smoothing, which acts over facets.
    void weldedVerticesAreOne() {
        Mesh mesh = bodyAndLimb({3, 0}, 9, 3);
        std::vector<int> of(static_cast<std::size_t>(mesh.vertexCount()));
        std::iota(of.begin(), of.end(), 0);
        for (int v = 0; v < mesh.parts[0].endVertex; ++v)
            for (int w = mesh.parts[1].firstVertex; w < mesh.vertexCount(); ++w)
                if ((mesh.points.col(v) - mesh.points.col(w)).norm() < 1e-9) {
                    of[static_cast<std::size_t>(w)] = v;
                    mesh.welds.push_back({{{v, 1.0}, {w, -1.0}}});
                }
        QCOMPARE(mesh.welds.size(), std::size_t{4});
        mesh.points /= 5;
        Mesh one = mesh;
        one.welds.clear();
        for (Cell<2>& cell : one.cells)
            for (int& v : cell) v = of[static_cast<std::size_t>(v)];
        const std::vector<ConstraintRow> rows{{{{0, 1.0}}}, {{{9, 1.0}}}, {{{mesh.vertexCount() - 1, 1.0}}}};
        Points2 prescribed = Points2::Zero(2, 3), v, w;
        prescribed.col(2) << 0.3, 0.8;
        for (auto [shape, field] : {std::pair{&mesh, &v}, {&one, &w}}) {
            VelocitySolver<2> solver(std::make_shared<const Mesh>(*shape),
                                     std::make_shared<const Material<2>>(Material<2>::uniform(
                                         shape->cellCount(), phi::kMetr, {SmoothingKind::None})),
                                     BackEndKind::Cpu, 1);
            solver.setConstraints(rows);
            QVERIFY(solver.solve(shape->points, prescribed, *field).done());
        }
        for (int k = 0; k < mesh.vertexCount(); ++k)
            QVERIFY((v.col(k) - w.col(of[static_cast<std::size_t>(k)])).norm() < 1e-9);
    }

    void contradictionsAreReported() {
        Mesh mesh = bodyAndLimb(kAt);
        mesh.welds = {weldAt(mesh, kJoint)};
        const auto rest = std::make_shared<const Mesh>(mesh);
        std::vector<Handle<2>> handles{handleAt("hip", "body", {kJoint}), handleAt("leg", "limb", {kJoint})};
        const auto make = [&] { Deformer<2>(rest, materialOf(mesh, phi::kMetr), handles); };
        make();  // both hold still: redundant, and accepted
        handles[1].motions = {Motion<2>{Translate<2>{{1, 0}}}};
        try {
            make();
            QFAIL("accepted");
        } catch (const InputError& error) {
            QVERIFY2(QString(error.what()).startsWith("handle \"hip\" and handle \"leg\" move the"),
                     error.what());
        }
        handles[0].motions = handles[1].motions;  // alike
        make();
    }

    /// A handle takes the frontmost of overlapping parts, or the one that it names.
    void handlesFindTheirPart() {
        const Mesh mesh = bodyAndLimb(kAt);
        const auto vertexOf = [&](const char* part) {
            return Constraints<2>(mesh, {handleAt("", part, {kJoint})}).points().front().terms.front().first;
        };
        QVERIFY(vertexOf("body") < mesh.parts[0].endVertex);
        QVERIFY(vertexOf("limb") >= mesh.parts[1].firstVertex);
        QVERIFY(vertexOf("") >= mesh.parts[1].firstVertex);
        QVERIFY_EXCEPTION_THROWN(vertexOf("tail"), InputError);
        Handle<2> disc = handleAt("", "", {});
        disc.at = Region<2>(Ball<2>{kJoint, 0.3});
        const Constraints<2> frontmost(mesh, {disc});
        QVERIFY(!frontmost.points().empty());
        for (const ConstrainedPoint& point : frontmost.points())
            QVERIFY(point.terms.front().first >= mesh.parts[1].firstVertex);
        disc.part = "body";
        const Constraints<2> ofBody(mesh, {disc});
        QVERIFY(!ofBody.points().empty());
        for (const ConstrainedPoint& point : ofBody.points())
            QVERIFY(point.terms.front().first < mesh.parts[0].endVertex);
    }
};

QTEST_APPLESS_MAIN(TestWelds)
#include "test_welds.moc"
