// Vertices that no cell has: a file may hold them, the shape does not.

#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "core/integration/drag_flow.h"
#include "core/mesh/embedding.h"
#include "core/mesh/used_vertices.h"
#include "core/motion/normalization.h"
#include "tests/core/test_strip.h"

using namespace wend;

namespace {

/// The mesh with a spare copy of `corner` in front of all vertices and a stray one far away behind them.
template <int Dim>
SimplicialMesh<Dim> withSpares(const SimplicialMesh<Dim>& mesh, int corner) {
    SimplicialMesh<Dim> result;
    result.points.resize(Dim, mesh.vertexCount() + 2);
    result.points << mesh.points.col(corner), mesh.points, Vec<Dim>::Constant(1e4);
    result.cells = mesh.cells;
    for (auto& cell : result.cells)
        for (int& v : cell) ++v;
    return result;
}

template <int Dim>
Handle<Dim> pinAt(const Vec<Dim>& p, double by) {
    Handle<Dim> handle;
    handle.name = "pin";
    handle.at = std::vector<Vec<Dim>>{p};
    if (by != 0) handle.motions.push_back({Translate<Dim>{Vec<Dim>::Constant(by)}});
    return handle;
}

template <int Dim>
Deformer<Dim> deformerOf(const SimplicialMesh<Dim>& mesh, const std::vector<Handle<Dim>>& handles) {
    return {std::make_shared<SimplicialMesh<Dim>>(mesh),
            std::make_shared<Material<Dim>>(Material<Dim>::uniform(mesh.cellCount(), phi::kMetr)), handles,
            IntegrationOptions{}};
}

template <int Dim>
Points<Dim> deformed(const SimplicialMesh<Dim>& mesh, const std::vector<Handle<Dim>>& handles) {
    Deformer<Dim> deformer = deformerOf<Dim>(mesh, handles);
    const AdvanceResult result = deformer.advance(1);
    return result.outcome == Outcome::Done ? deformer.state().points : Points<Dim>();
}

/// Spare vertices affect neither the pins nor the unit of length. The tolerance allows for another order of
/// unknowns, which rounds otherwise.
template <int Dim>
void theShapeIsTheSame() {
    const SimplicialMesh<Dim> mesh = samples::strip<Dim>(4, 2, 2);
    const int held = 0, pulled = mesh.vertexCount() - 1;
    const std::vector<Handle<Dim>> pins{pinAt<Dim>(mesh.points.col(held), 0),
                                        pinAt<Dim>(mesh.points.col(pulled), 0.3)};
    const Points<Dim> expected = deformed<Dim>(mesh, pins);
    for (int corner : {held, pulled}) {
        const Points<Dim> pose = deformed<Dim>(withSpares<Dim>(mesh, corner), pins);
        QCOMPARE(pose.cols(), expected.cols() + 2);
        QVERIFY((pose.middleCols(1, mesh.vertexCount()) - expected).cwiseAbs().maxCoeff() < 1e-10);
    }
}

/// A spare copy follows its corner: in the end, in frames between, as a velocity, and by hand.
template <int Dim>
void twinsMove() {
    const SimplicialMesh<Dim> mesh = samples::strip<Dim>(4, 2, 2);
    const int pulled = mesh.vertexCount() - 1;
    const SimplicialMesh<Dim> spared = withSpares<Dim>(mesh, pulled);
    const std::vector<Handle<Dim>> pins{pinAt<Dim>(mesh.points.col(0), 0),
                                        pinAt<Dim>(mesh.points.col(pulled), 0.3)};
    const auto goesAlong = [&](const Points<Dim>& points) {
        return points.col(0) == points.col(pulled + 1) && points.cols() == spared.vertexCount();
    };
    Deformer<Dim> deformer = deformerOf<Dim>(spared, pins);
    int frames = 0;
    typename Deformer<Dim>::Watch watch;
    watch.frames = {0.3, 0.6};
    watch.onFrame = [&](const State<Dim>& state) { frames += goesAlong(state.points); };
    QCOMPARE(deformer.advance(1, watch).outcome, Outcome::Done);
    QCOMPARE(frames, 2);
    const Points<Dim>& pose = deformer.state().points;
    QVERIFY(goesAlong(pose) && (pose.col(0) - spared.points.col(0)).norm() > 0.1);
    QVERIFY(pose.rightCols(1) == spared.points.rightCols(1));  // the stray one stays
    const Points<Dim> velocity = deformer.velocity();
    QVERIFY(goesAlong(velocity) && velocity.col(0).norm() > 0.1);

    DragFlow<Dim> drag(std::make_shared<SimplicialMesh<Dim>>(spared),
                       std::make_shared<Material<Dim>>(Material<Dim>::uniform(mesh.cellCount(), phi::kMetr)),
                       pins, makeCpuBackEnd<Dim>);
    drag.lead({1}, Motion<Dim>{Translate<Dim>{Vec<Dim>::Constant(0.02)}});
    QVERIFY(goesAlong(drag.pose()) && drag.pose().col(0) != spared.points.col(0));
}

template <int Dim>
QString refusal(const SimplicialMesh<Dim>& mesh, const Placement<Dim>& at) try {
    Handle<Dim> handle = pinAt<Dim>(mesh.points.col(1), 0);
    handle.at = at;
    deformerOf<Dim>(mesh, {handle});
    return {};
} catch (const InputError& error) {
    return error.what();
}

template <int Dim>
void handlesNeedVerticesOfCells() {
    const auto mesh = withSpares<Dim>(samples::strip<Dim>(2, 1, 2), 0);
    QVERIFY(refusal<Dim>(mesh, std::vector<int>{1, 0}).isEmpty());  // 0 stands for 1
    const int stray = mesh.vertexCount() - 1;
    const QString byNumber = refusal<Dim>(mesh, std::vector<int>{1, stray});
    QVERIFY2(byNumber.contains("pin") &&
                 byNumber.contains("vertex " + QString::number(stray) + " belongs to no cell"),
             qPrintable(byNumber));
    const QString byRegion = refusal<Dim>(mesh, Region<Dim>(Ball<Dim>{Vec<Dim>::Constant(1e4), 1}));
    QVERIFY2(byRegion.contains("holds no vertex"), qPrintable(byRegion));
}

template <int Dim>
void theyAreNowhereNear() {
    const auto plain = samples::strip<Dim>(2, 1, 2);
    const auto mesh = withSpares<Dim>(plain, 0);
    const PointLocator<Dim> locator(mesh.points, mesh.cells);
    QCOMPARE(locator.nearestVertex(plain.points.col(0)), 1);
    QCOMPARE(locator.nearestVertex(Vec<Dim>::Constant(1e4)),
             PointLocator<Dim>(plain.points, plain.cells).nearestVertex(Vec<Dim>::Constant(1e4)) + 1);
    const PointLocator<Dim> points(mesh.points, {});  // without cells every vertex counts
    QCOMPARE(points.nearestVertex(Vec<Dim>::Constant(1e4)), mesh.vertexCount() - 1);
    const auto extent = extentOf<Dim>(mesh.points, mesh.cells);
    QCOMPARE(extent.diagonal(), boundingBoxDiagonal<Dim>(plain.points));
    QVERIFY(Normalization<Dim>::of(mesh).centre == Normalization<Dim>::of(plain).centre);
}

/// A surface is embedded in the cells, also where its own points coincide with spare vertices.
void surfacesRideOnCells() {
    const auto mesh = withSpares<3>(samples::strip<3>(2, 1, 2), 0);
    const Embedding<3> embedding(mesh, mesh.points);
    Points3 pose = 2 * mesh.points;
    pose.col(0).setConstant(77);  // nothing moves a spare vertex with the shape
    const Points3 carried = embedding.carry(mesh, pose);
    QVERIFY(carried.col(0) == pose.col(1));
    QCOMPARE(embedding.outside(), 1);
    Points3 nowhere = mesh.points;
    nowhere(0, 0) = std::nan("");
    QVERIFY_THROWS_EXCEPTION(InputError, Embedding<3>(mesh, nowhere));
    const SimplicialMesh<3> empty;
    QVERIFY_THROWS_EXCEPTION(InputError, Embedding<3>(empty, mesh.points));
}

}  // namespace

class TestUnusedVertices : public QObject {
    Q_OBJECT
  private slots:
    void theShapeIsTheSame2D() { theShapeIsTheSame<2>(); }
    void theShapeIsTheSame3D() { theShapeIsTheSame<3>(); }
    void twinsMove2D() { twinsMove<2>(); }
    void twinsMove3D() { twinsMove<3>(); }
    void handlesNeedVerticesOfCells2D() { handlesNeedVerticesOfCells<2>(); }
    void handlesNeedVerticesOfCells3D() { handlesNeedVerticesOfCells<3>(); }
    void theyAreNowhereNear2D() { theyAreNowhereNear<2>(); }
    void theyAreNowhereNear3D() { theyAreNowhereNear<3>(); }
    void surfacesRideOnCells3D() { surfacesRideOnCells(); }
};

QTEST_APPLESS_MAIN(TestUnusedVertices)
#include "test_unused_vertices.moc"
