// Warnings about meshes that would bend badly, and the results of meshes whose vertices are doubled.

#include <QtTest>
#include <nlohmann/json.hpp>

#include "app/engine/shape/inspection.h"
#include "app/engine/shape/solid.h"
#include "app/output/report.h"
#include "app/output/run.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/volume_mesher.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/mesh_files.h"
#include "tests/support/surfaces.h"

using namespace wend;

namespace {

const Surface kBar = test::box({0, 0, 0}, {3, 1, 1}, 4);

/// Gives every cell its own vertices.
template <std::size_t N>
void tearApart(Eigen::Matrix3Xd& points, std::vector<std::array<int, N>>& cells) {
    Eigen::Matrix3Xd torn(3, static_cast<Eigen::Index>(cells.size() * N));
    int next = 0;
    for (auto& cell : cells)
        for (int& v : cell) {
            torn.col(next) = points.col(v);
            v = next++;
        }
    points = torn;
}

bool anyContains(const std::vector<std::string>& texts, const std::string& part) {
    return std::ranges::any_of(texts,
                               [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

}  // namespace

class TestMeshTrust : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { m_base = m_folder.path().toStdString(); }
    void looselyAttachedPartsAreReported();
    void looselyAttachedSolidsAreReported();
    void sizesBeyondNumbersAreReported();
    void oneSpareVertexIsReportedAsOne();
    void missedQualityIsReported();
    void goodQualityIsNot();
    void largerHolesAreReported();
    void tornSurfaceMovesAsOne();
    void tornMeshMovesAsOne();
    void spareVerticesOfMeshesAreReported();
    void errorAtTheEndIsReported();

  private:
    std::string file(const std::string& name) const { return m_base + "/" + name; }
    std::shared_ptr<Project> project(const std::string& rest) const {
        return parseProject(json("{'format': 'wend', 'version': 1, " + rest + "}"), file("p.wend")).project;
    }
    Shape<3> solid(const std::string& domain) const {
        const auto read = project("'domain': {" + domain + "}");
        return loadSolid(domainOf(*read), designOf(*read), m_base);
    }
    /// Runs the project and keeps the notices in m_notices.
    void run(const std::shared_ptr<Project>& project, const RunOutputs& outputs,
             MeshWriteOptions meshes = {}) {
        RunOptions options;
        options.outputs = outputs;
        options.meshes = meshes;
        options.backEnd = BackEndKind::Cpu;
        m_notices.clear();
        RunWatch watch;
        watch.notice = [this](const std::string& text) { m_notices.push_back(text); };
        watch.summary = [this](const std::string& text) { m_summary = text; };
        QCOMPARE(runProject(*project, file("p.wend"), options, watch).outcome, Outcome::Done);
    }

    QTemporaryDir m_folder;
    std::string m_base;
    std::vector<std::string> m_notices;
    std::string m_summary;
};

namespace {

/// A strip, and two more triangles that share its corner 8 only.
Surface hangingStrip() {
    Surface strip = test::surfaceOf(stripMesh(2, 2));
    strip.points.conservativeResize(Eigen::NoChange, 11);
    strip.points.rightCols(2) << 3, 2, 2, 3, 0, 0;
    strip.triangles.push_back({8, 9, 10});
    return strip;
}

}  // namespace

void TestMeshTrust::looselyAttachedPartsAreReported() {
    test::writeSurface(file("hang.obj"), hangingStrip());
    const auto inspection = inspectFile(file("hang.obj"));
    QCOMPARE(inspection.problems.size(), std::size_t(1));
    QCOMPARE(inspection.problems[0].where, std::vector<int>{8});
    QVERIFY(!inspection.problems[0].fatal);
    RunOutputs outputs;
    outputs.mesh = {file("out.obj")};
    run(project("'domain': {'mesh': 'hang.obj'}, 'handles': [{'at': {'vertices': [0, 1]}}, "
                "{'at': {'vertices': [2]}, 'motion': [{'kind': 'translate', 'by': [0.1, 0]}]}]"),
        outputs);
    QVERIFY(anyContains(m_notices, "a part of 1 cell hangs only on vertex 8 near (2, 2)"));
}

void TestMeshTrust::looselyAttachedSolidsAreReported() {
    const Surface corner = test::joined(kBar, test::box({3, 1, 1}, {4, 2, 2}, 2));
    test::writeSurface(file("corner.obj"), corner);
    QVERIFY(anyContains(textsOf(solid("'surface': 'corner.obj', 'vertices': 300").notices),
                        " near (3, 1, 1): what turns freely there"));
    const auto inspection = inspectFile(file("corner.obj"));
    QVERIFY(std::ranges::any_of(inspection.problems, [](const MeshProblem& problem) {
        return problem.what == "vertices that a part hangs on alone" && problem.where.size() == 1;
    }));
    const Surface edge = test::joined(kBar, test::box({3, 1, 0}, {4, 2, 1}, 4));
    test::writeSurface(file("edge.obj"), edge);
    QVERIFY(anyContains(textsOf(solid("'surface': 'edge.obj', 'vertices': 300").notices),
                        "hangs only on the edge "));
}

/// The facts about a box hold for any size whose squares and volumes are representable; beyond that no
/// numbers are given.
void TestMeshTrust::sizesBeyondNumbersAreReported() {
    const auto inspected = [this](double size) {
        Surface scaled = kBar;
        scaled.points *= size;
        test::writeSurface(file("scaled.obj"), scaled);
        return inspectFile(file("scaled.obj"));
    };
    for (const double size : {1e-60, 1e-9, 1e9, 1e60}) {
        const auto found = inspected(size);
        QVERIFY(found.problems.empty());
        QVERIFY(std::abs(found.facts->volume.value() / (3 * size * size * size) - 1) < 1e-9);
    }
    for (const double size : {1e-300, 1e300}) {
        const auto found = inspected(size);
        QCOMPARE(found.problems.size(), std::size_t(1));
        QCOMPARE(found.problems[0].what, std::string("too large or too small to compute with"));
        QVERIFY(found.problems[0].fatal && !found.facts && found.dimension == 0);
    }
}

void TestMeshTrust::oneSpareVertexIsReportedAsOne() {
    Surface spare = kBar;
    spare.points.conservativeResize(Eigen::NoChange, spare.vertexCount() + 1);
    spare.points.rightCols(1) << 1, 0.5, 0.5;
    test::writeSurface(file("one.obj"), spare);
    QVERIFY(anyContains(textsOf(solid("'surface': 'one.obj', 'vertices': 300").notices),
                        "1 vertex of the surface belongs to no tetrahedron"));
}

/// A plate a hundredth thick, whose faces may not be split, has no round cells.
void TestMeshTrust::missedQualityIsReported() {
    test::writeSurface(file("plate.obj"), test::box({0, 0, 0}, {1, 1, 0.01}, 1));
    const Shape<3> plate = solid("'surface': 'plate.obj', 'maxVolume': 1, 'quality': 2");
    const MeshVerdict& verdict = plate.verdict.value();
    double worst = 0;  // of the edges' lengths alone: R is at least half the longest edge
    for (const auto& cell : plate.rest->cells) {
        double shortest = 1e9, longest = 0;
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < j; ++k) {
                const double length =
                    (plate.rest->points.col(cell[j]) - plate.rest->points.col(cell[k])).norm();
                shortest = std::min(shortest, length);
                longest = std::max(longest, length);
            }
        worst = std::max(worst, longest / shortest / 2);
    }
    QVERIFY(worst > 20 && verdict.got >= worst);
    QCOMPARE(verdict.asked, 2.0);
    QVERIFY(verdict.cellsAbove > 0 && verdict.cellsAbove <= plate.rest->cellCount());
    QVERIFY(!verdict.facets.empty());
    for (const int facet : verdict.facets) QVERIFY(facet >= 0 && facet < 12);
    QVERIFY(anyContains(textsOf(plate.notices), "where 2 was asked for"));
    QVERIFY(anyContains(textsOf(plate.notices), "at its triangles "));
    const auto report = nlohmann::json::parse(verdictJson(verdict));
    QCOMPARE(report["facets"].size(), verdict.facets.size());
    QCOMPARE(report["got"].get<double>(), verdict.got);
}

void TestMeshTrust::goodQualityIsNot() {
    test::writeSurface(file("cube.obj"), test::box({0, 0, 0}, {1, 1, 1}, 5));
    const Shape<3> bar = solid("'surface': 'cube.obj', 'vertices': 300");
    QVERIFY(!anyContains(textsOf(bar.notices), "was asked for"));
    QVERIFY(bar.verdict->got > 0.6 && !bar.verdict->missed());  // a regular tetrahedron's is 0.61
}

void TestMeshTrust::largerHolesAreReported() {
    Surface holed = kBar;
    holed.triangles.pop_back();
    test::writeSurface(file("holed.obj"), holed);
    try {
        solid("'surface': 'holed.obj', 'cage': false, 'repair': {'largestHole': 2}");
        QFAIL("accepted");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what())
                     .contains("1 hole of 3 edges stayed open, larger than the limit of 2: `largestHole` or "
                               "--largest-hole 3 fills it"),
                 error.what());
    }
    QVERIFY(solid("'surface': 'holed.obj', 'vertices': 300, 'repair': {'largestHole': 3}").rest->cellCount() >
            0);
}

/// Surface formats keep all vertices, and coincident ones stay coincident; files of tetrahedra have only the
/// vertices that cells use.
void TestMeshTrust::tornSurfaceMovesAsOne() {
    Surface torn = kBar;
    tearApart(torn.points, torn.triangles);
    test::writeSurface(file("torn.obj"), torn);
    const auto bend = project(
        "'domain': {'surface': 'torn.obj', 'vertices': 300}, 'handles': ["
        "{'at': {'region': {'halfspace': {'point': [0.1, 0, 0], 'normal': [-1, 0, 0]}}}}, "
        "{'at': {'region': {'halfspace': {'point': [2.9, 0, 0], 'normal': [1, 0, 0]}}}, "
        " 'motion': [{'kind': 'translate', 'by': [0, 0.8, 0.4]}]}]");
    RunOutputs outputs;
    outputs.mesh = {file("bent.obj")};
    run(bend, outputs);
    QVERIFY(anyContains(m_notices, "vertices of the surface belong to no tetrahedron"));
    const auto bent = sharedMeshFile(file("bent.obj"));
    QCOMPARE(pointsOf(*bent).cols(), torn.points.cols());
    QVERIFY(trianglesOf(*bent) == torn.triangles);
    const auto before = firstAtPlace<3>(torn.points), after = firstAtPlace<3>(pointsOf(*bent));
    QVERIFY(before == after);
    for (Eigen::Index v = 0; v < torn.points.cols(); ++v)
        if (torn.points(0, v) > 2.9)
            QVERIFY((pointsOf(*bent).col(v) - torn.points.col(v) - Vec3(0, 0.8, 0.4)).norm() < 1e-9);
    outputs.mesh = {file("bent.msh")};
    outputs.velocity = {file("bent.csv")};
    outputs.report = {file("bent.json")};
    run(bend, outputs);
    const auto cells = sharedMeshFile(file("bent.msh"));
    const auto used = usedVertices<3>(pointsOf(*cells).cols(), tetrahedraOf(*cells));
    QCOMPARE(std::ranges::count(used, false), std::ptrdiff_t(0));
    QVERIFY(pointsOf(*cells).cols() < torn.points.cols());
    const std::string table = readTextFile(file("bent.csv"));
    QCOMPARE(std::ranges::count(table, '\n') - 1, pointsOf(*cells).cols());
    const auto report = nlohmann::json::parse(readTextFile(file("bent.json")));
    QCOMPARE(report["vertices"].get<Eigen::Index>(), pointsOf(*cells).cols());
}

/// A torn mesh in the plane, in which every vertex has a cell, moves as if the file were whole.
void TestMeshTrust::tornMeshMovesAsOne() {
    const Surface whole = test::surfaceOf(stripMesh(6, 2));
    Surface torn = whole;
    tearApart(torn.points, torn.triangles);
    test::writeSurface(file("whole.obj"), whole);
    test::writeSurface(file("torn2.obj"), torn);
    RunOutputs outputs;
    for (const char* name : {"whole", "torn2"}) {
        outputs.mesh = {file(std::string(name) + "-bent.obj")};
        run(project("'domain': {'mesh': '" + std::string(name) +
                    ".obj'}, 'handles': [{'at': {'region': {'circle': {'centre': [0, 1], 'radius': 1.1}}}}, "
                    "{'at': {'region': {'circle': {'centre': [6, 1], 'radius': 1.1}}}, "
                    "'motion': [{'kind': 'translate', 'by': [-1, 2]}]}]"),
            outputs);
    }
    QVERIFY(anyContains(m_notices, "parts that touch vertex to vertex are connected"));
    const auto expected = sharedMeshFile(file("whole-bent.obj"));
    const auto bent = sharedMeshFile(file("torn2-bent.obj"));
    QVERIFY(trianglesOf(*bent) == torn.triangles);
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)  // tolerance: another order of unknowns rounds otherwise
            QVERIFY((pointsOf(*bent).col(trianglesOf(*bent)[t][k]) -
                     pointsOf(*expected).col(whole.triangles[t][k]))
                        .norm() < 1e-9);
}

/// The input stays as it is, and users of solvers are warned.
void TestMeshTrust::spareVerticesOfMeshesAreReported() {
    Surface spare = test::surfaceOf(stripMesh(2, 1));
    spare.points.conservativeResize(Eigen::NoChange, 8);
    spare.points.rightCols(2) << 2, 9, 1, 9, 0, 0;
    test::writeSurface(file("spare.obj"), spare);
    RunOutputs outputs;
    outputs.mesh = {file("spare.vtu")};
    run(project(
            "'domain': {'mesh': 'spare.obj'}, 'handles': [{'at': {'vertices': [0, 3]}}, {'at': {'vertices': "
            "[5]}, 'motion': [{'kind': 'translate', 'by': [0.2, 0.1]}]}]"),
        outputs);
    QVERIFY(anyContains(
        m_notices, "2 vertices belong to no cell; 1 of them lie at the place of another and move with it"));
    const auto out = sharedMeshFile(file("spare.vtu"));
    QCOMPARE(pointsOf(*out).cols(), Eigen::Index(8));
    QVERIFY(pointsOf(*out).col(6) == pointsOf(*out).col(5) && pointsOf(*out).col(7) == spare.points.col(7));
    QVERIFY((pointsOf(*out).col(6) - Vec3(2.2, 1.1, 0)).norm() < 1e-9);
}

void TestMeshTrust::errorAtTheEndIsReported() {
    writeMesh<2>(file("strip.obj"), stripMesh(6, 2));
    RunOutputs outputs;
    outputs.report = {file("report.json")};
    const std::string rest =
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'vertices': [0, 7, 14]}}, {'at': {'vertices': "
        "[6, 13, 20]}, 'motion': [{'kind': 'rotate', 'centre': [3, 1], 'angle': 1.5}]}], 'integration': ";
    outputs.mesh = {file("bent.obj")};
    run(project(rest + "{'method': 'rk4', 'steps': 400}"), outputs);
    const auto exact = sharedMeshFile(outputs.mesh.front());
    const double size = std::hypot(6, 2);
    for (const char* method : {"dopri5", "adams"}) {
        double last = 1;
        for (const char* tolerance : {"1e-3", "1e-5", "1e-7"}) {
            run(project(rest + "{'method': '" + method + "', 'tolerance': " + tolerance + "}"), outputs);
            const auto report = nlohmann::json::parse(readTextFile(outputs.report.front()));
            const double estimate = report["errorEstimate"];
            QVERIFY(estimate > 0 && estimate < last / 5);
            QVERIFY2(m_summary.find("add up to about") != std::string::npos, m_summary.c_str());
            last = estimate;
            // Only the order of magnitude is compared: the error estimate of the steps is that of the lower
            // of two orders.
            const double error = (pointsOf(*sharedMeshFile(outputs.mesh.front())) - pointsOf(*exact))
                                     .colwise()
                                     .norm()
                                     .maxCoeff() /
                                 size;
            QVERIFY2(
                error < 10 * estimate && error > estimate / 1000,
                qPrintable(
                    QStringLiteral("%1: %2 at the end, %3 told").arg(tolerance).arg(error).arg(estimate)));
        }
    }
    run(project(rest + "{'method': 'rk4', 'steps': 12}"), outputs);
    QVERIFY(nlohmann::json::parse(readTextFile(outputs.report.front()))["errorEstimate"].is_null());
    QCOMPARE(m_summary, std::string("12 steps"));
}

QTEST_GUILESS_MAIN(TestMeshTrust)
#include "test_mesh_trust.moc"
