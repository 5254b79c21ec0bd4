// Handles that hold their vertices in some directions only.

#include <Eigen/Geometry>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "app/project/design.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

namespace {

constexpr const char* kFoot =
    "{'name': 'foot', 'at': {'region': {'box': {'min': [-9, -9, -0.5], 'max': [9, 9, 0.5]}}}}";
constexpr const char* kHead = "'region': {'box': {'min': [-9, -9, 5.5], 'max': [9, 9, 6.5]}}";

/// Returns the distance of a point from a triangle: that of its projection if it is inside, else that of the
/// edges.
double distanceTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto toEdge = [&](const Vec3& from, const Vec3& to) {
        const double s = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
        return (from + s * (to - from) - p).norm();
    };
    const Vec3 n = (b - a).cross(c - a).normalized(), foot = p - n * n.dot(p - a);
    const auto isLeft = [&](const Vec3& from, const Vec3& to) {
        return (to - from).cross(foot - from).dot(n) >= 0;
    };
    const double edges = std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
    return isLeft(a, b) && isLeft(b, c) && isLeft(c, a) ? std::min(edges, std::abs(n.dot(p - a))) : edges;
}

/// A round bar of radius 1 along z from 0 to 4: squares of the section become rings.
SimplicialMesh<3> roundBar() {
    SimplicialMesh<3> mesh = blockMesh(6, 6, 10);
    for (auto p : mesh.points.colwise()) {
        const Eigen::Vector2d q = p.head<2>() / 3 - Eigen::Vector2d::Ones();
        const double largest = q.cwiseAbs().maxCoeff();
        p.head<2>() = largest > 0 ? Eigen::Vector2d(q * largest / q.norm()) : q;
        p.z() *= 0.4;
    }
    return mesh;
}

/// A tube around z, of flat sides.
std::string tube(double radius, int sides, double low, double high) {
    std::ostringstream out;
    out.precision(17);
    for (int k = 0; k < sides; ++k)
        for (const double z : {low, high})
            out << "v " << radius * std::cos(2 * M_PI * k / sides) << ' '
                << radius * std::sin(2 * M_PI * k / sides) << ' ' << z << '\n';
    for (int k = 0; k < sides; ++k) {
        const int a = 2 * k + 1, b = 2 * ((k + 1) % sides) + 1;
        out << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
    return out.str();
}

/// Returns the mesh with its mirror image in the plane x = 0, sharing the vertices in that plane.
SimplicialMesh<3> withImage(const SimplicialMesh<3>& half) {
    SimplicialMesh<3> whole = half;
    std::vector<int> image(static_cast<std::size_t>(half.vertexCount()));
    int count = half.vertexCount();
    for (int v = 0; v < half.vertexCount(); ++v) image[v] = half.points(0, v) == 0 ? v : count++;
    whole.points.conservativeResize(Eigen::NoChange, count);
    for (int v = 0; v < half.vertexCount(); ++v) {
        whole.points.col(image[v]) = half.points.col(v);
        whole.points(0, image[v]) = -half.points(0, v);
        if (image[v] == v) whole.points(0, v) = 0;
    }
    for (Cell<3> cell : half.cells) {
        for (int& v : cell) v = image[v];
        std::swap(cell[2], cell[3]);
        whole.cells.push_back(cell);
    }
    return whole;
}

}  // namespace

class TestHoldCli : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void axes();
    void normals_data();
    void normals();
    void halfAndWhole();
    void quarterAndWhole();
    void inThePlane();
    void motionsFollowEachOther();
    void slidingOnAFlatFace();
    void slidingAlongAnEdge();
    void slidingOnACylinder_data();
    void slidingOnACylinder();
    void slidingAlongAPath();
    void surfacesThatMove();
    void runsGoOn();
    void surfacesThatAreRefused_data();
    void surfacesThatAreRefused();
    void normalsOfGroups_data();
    void normalsOfGroups();
    void normalsOfLines();
    void groupsWithoutNormal_data();
    void groupsWithoutNormal();
    void savedAsRead();
    void bad_data();
    void bad();

  private:
    QString path() const { return m_folder.path(); }
    std::string file(const std::string& name) const { return path().toStdString() + "/" + name; }
    CliResult run(const QStringList& arguments) const { return runCli(path(), arguments); }
    /// Returns the deformed points of a project with these handles, and fills the report.
    Points3 bent(const std::string& domain, const std::string& handles, const std::string& more = "") {
        putProject(path(), "bend.wend",
                   "'domain': {'mesh': '" + domain + "'}, 'handles': [" + handles + "]" + more);
        const CliResult result = run({"run", "bend.wend", "--mesh", "bent.vtu", "--report", "bent.json"});
        if (result.code != 0) qWarning("%s", qPrintable(result.error));
        const auto report =
            QJsonDocument::fromJson(QByteArray::fromStdString(readTextFile(file("bent.json"))));
        m_error = report["constraintError"].toDouble(1);
        return pointsOf(*sharedMeshFile(file("bent.vtu")));
    }
    static std::string head(const std::string& motion, const std::string& hold) {
        return std::string("{'name': 'head', 'at': {") + kHead + "}, 'motion': [" + motion +
               "], 'hold': " + hold + "}";
    }

    QTemporaryDir m_folder;
    SimplicialMesh<3> m_bar = barMesh(6);
    double m_error = 1;
};

void TestHoldCli::initTestCase() {
    writeMesh<3>(file("bar.mesh"), m_bar);
    writeMesh<2>(file("strip.obj"), stripMesh(10, 2));
    const SimplicialMesh<3> half = blockMesh(1, 2, 6);
    writeMesh<3>(file("half.mesh"), half);
    writeMesh<3>(file("whole.mesh"), withImage(half));
}

/// Held coordinates follow the motion up to rounding, and the others are free.
void TestHoldCli::axes() {
    const std::string motion = "{'kind': 'translate', 'by': [3, 0, 0.5], 'time': [0, 1]}";
    const Points3 end = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "['z']"));
    QVERIFY(m_error <= 1e-12);
    double across = 0;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(2, v) < 5.5) continue;
        QVERIFY(std::abs(end(2, v) - 6.5) <= 1e-12 * 7);
        across = std::max(across, (end.col(v) - m_bar.points.col(v)).head<2>().norm());
    }
    QVERIFY2(across > 1e-3 && across < 0.5, qPrintable(QString::number(across)));  // the bar gets thinner
    const Points3 two = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "['z', 'x']"));
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(two(0, v) - m_bar.points(0, v) - 3) <= 1e-12 * 7);
    const Points3 all = bent("bar.mesh", kFoot + std::string(", ") + head(motion, "'all'"));
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5)
            QVERIFY((all.col(v) - m_bar.points.col(v) - Vec3(3, 0, 0.5)).norm() <= 1e-12 * 7);
}

void TestHoldCli::normals_data() {
    QTest::addColumn<QString>("motion");
    QTest::newRow("straight")
        << "{'kind': 'translate', 'by': [0.2, -0.1, 0.6], 'time': [0, 1], 'ease': 'inOut'}";
    QTest::newRow("curve")
        << "{'kind': 'curve', 'interpolation': 'bezier', 'points': [[0, 0, 0], [0, 0.3, 0.1], [0, "
           "0.4, 0.4], [0.2, -0.1, 0.6]], 'frame': 'none', 'time': [0, 1]}";
}

/// Only the displacement along the normal is prescribed.
void TestHoldCli::normals() {
    QFETCH(QString, motion);
    const std::string text = motion.toStdString();
    const Points3 along = bent("bar.mesh", kFoot + std::string(", ") + head(text, "{'normal': [0, 0, -3]}"));
    const Points3 axis = bent("bar.mesh", kFoot + std::string(", ") + head(text, "['z']"));
    QCOMPARE(along, axis);
    const Points3 end = bent("bar.mesh", kFoot + std::string(", ") + head(text, "{'normal': [1, 2, 2]}"));
    QVERIFY(m_error <= 1e-12);
    const Vec3 normal = Vec3(1, 2, 2) / 3, by(0.2, -0.1, 0.6);
    double across = 0;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(2, v) < 5.5) continue;
        const Vec3 moved = end.col(v) - m_bar.points.col(v);
        QVERIFY(std::abs(normal.dot(moved - by)) <= 1e-12 * 7);
        across = std::max(across, (moved - by).norm());
    }
    QVERIFY(across > 0.05);
}

/// Half of a shape, held in the direction across its plane of symmetry, bends as the whole does. Smoothness
/// is off, because only the whole has its terms at the plane.
void TestHoldCli::halfAndWhole() {
    const std::string
        turn = "{'kind': 'rotate', 'centre': [0, 1, 6], 'axis': [1, 0, 0], 'angle': 0.9, 'time': [0, 1]}",
        settings =
            ", 'material': {'phi': 'metr', 'smoothing': {'kind': 'none'}}, 'integration': "
            "{'tolerance': 1e-6}";
    const std::string both = kFoot + std::string(", ") + head(turn, "'all'");
    const Points3 whole = bent("whole.mesh", both, settings);
    for (const char* hold : {"['x']", "{'normal': [2, 0, 0]}"}) {
        const std::string plane =
            "{'name': 'plane', 'at': {'region': {'box': {'min': [-0.1, -9, -9], 'max': [0.1, 9, 9]}}}, "
            "'hold': " +
            std::string(hold) + "}";
        const Points3 half = bent("half.mesh", both + ", " + plane, settings);
        const double off = (half - whole.leftCols(half.cols())).colwise().norm().maxCoeff();
        QVERIFY2(off < 1e-5 * 7, qPrintable(QString::number(off)));
        for (int v = 0; v < half.cols(); ++v)
            if (whole(0, v) == 0) QCOMPARE(half(0, v), 0.0);
    }
    // Without the symmetry plane the half would bend differently.
    const Points3 loose = bent("half.mesh", both, settings);
    QVERIFY((loose - whole.leftCols(loose.cols())).colwise().norm().maxCoeff() > 1e-3);
}

/// Two planes meet in an edge, and one of them is oblique to the coordinate axes: the edge has both normals.
void TestHoldCli::quarterAndWhole() {
    const std::string
        pull = "{'kind': 'translate', 'by': [0, 0, 1.5], 'time': [0, 1]}",
        foot = "{'at': {'region': {'box': {'min': [-9, -9, -0.5], 'max': [9, 9, 0.5]}}}, 'hold': ['z']}",
        settings = ", 'material': {'phi': 'metr', 'smoothing': {'kind': 'none'}}";
    const auto plane = [](const char* box, const char* hold) {
        return std::string(", {'at': {'region': {'box': {") + box + "}}}, 'hold': " + hold + "}";
    };
    const Points3 axes =
        bent("bar.mesh",
             foot + ", " + head(pull, "['z']") + plane("'min': [-0.1, -9, -9], 'max': [0.1, 9, 9]", "['x']") +
                 plane("'min': [-9, -0.1, -9], 'max': [9, 0.1, 9]", "['y']"),
             settings);
    // The same geometry, rotated by 30° about z.
    SimplicialMesh<3> turned = m_bar;
    const Mat3 R = Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
    turned.points = R * m_bar.points;
    writeMesh<3>(file("turned.mesh"), turned);
    std::string x, y;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(0, v) == 0) x += (x.empty() ? "" : ", ") + std::to_string(v);
        if (m_bar.points(1, v) == 0) y += (y.empty() ? "" : ", ") + std::to_string(v);
    }
    std::ostringstream nx, ny;
    nx.precision(17), ny.precision(17);
    nx << '[' << R(0, 0) << ", " << R(1, 0) << ", 0]";
    ny << '[' << R(0, 1) << ", " << R(1, 1) << ", 0]";
    const Points3 tilted = bent("turned.mesh",
                                foot + ", " + head(pull, "['z']") + ", {'at': {'vertices': [" + x +
                                    "]}, 'hold': {'normal': " + nx.str() + "}}, {'at': {'vertices': [" + y +
                                    "]}, 'hold': {'normal': " + ny.str() + "}}",
                                settings);
    const double off = (R.transpose() * tilted - axes).colwise().norm().maxCoeff();
    QVERIFY2(off < 1e-4 * 7, qPrintable(QString::number(off)));  // the tolerance of the steps
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec3 moved = R.transpose() * (tilted.col(v) - turned.points.col(v));
        if (m_bar.points(0, v) == 0) QVERIFY(std::abs(moved.x()) < 1e-11);
        if (m_bar.points(1, v) == 0) QVERIFY(std::abs(moved.y()) < 1e-11);
    }
}

void TestHoldCli::inThePlane() {
    putProject(
        path(), "flat.wend",
        "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'vertices': [0, 11, 22]}}, {'at': {'vertices': "
        "[10, 21, 32]}, 'hold': {'normal': [1, 1]}, 'motion': [{'kind': 'translate', 'by': [1, 1]}]}]");
    QCOMPARE(run({"run", "flat.wend", "--mesh", "flat.obj"}).error, QString());
    const Points3 rest = pointsOf(*sharedMeshFile(file("strip.obj"))),
                  end = pointsOf(*sharedMeshFile(file("flat.obj")));
    for (const int v : {10, 21, 32})
        QVERIFY(std::abs((end.col(v) - rest.col(v)).dot(Vec3(1, 1, 0)) - 2) < 1e-11);
    QVERIFY((end.col(21) - rest.col(21) - Vec3(1, 1, 0)).norm() > 0.01);
}

/// A vertex that slid begins the next motion at its present place, and is free outside its active time.
void TestHoldCli::motionsFollowEachOther() {
    const std::string twice =
        "{'kind': 'translate', 'by': [0, 0, 0.5], 'time': [0, 1]}, {'kind': 'translate', 'by': [0, 0, 0.25], "
        "'time': "
        "[2, 3]}";
    const Points3 end = bent("bar.mesh", kFoot + std::string(", ") + head(twice, "['z']"));
    QVERIFY(m_error <= 1e-12);
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(end(2, v) - 6.75) <= 1e-12 * 7);
    std::string brief = head("{'kind': 'translate', 'by': [0, 0, 1], 'time': [0, 1]}", "['z']");
    brief.insert(brief.size() - 1, ", 'active': [0.25, 0.5]");
    const Points3 part = bent("bar.mesh", kFoot + std::string(", ") + brief, ", 'time': {'end': 1}");
    for (int v = 0; v < m_bar.vertexCount(); ++v)
        if (m_bar.points(2, v) > 5.5) QVERIFY(std::abs(part(2, v) - 6.25) <= 1e-11);
}

/// A flat face that slides on itself is held across itself.
void TestHoldCli::slidingOnAFlatFace() {
    const std::string both = kFoot + std::string(", ") +
                             head(
                                 "{'kind': 'rotate', 'centre': [0, 1, 6], 'axis': [1, 0, 0], 'angle': 0.6, "
                                 "'time': [0, 1]}",
                                 "'all'"),
                      face =
                          ", {'at': {'region': {'box': {'min': [-0.1, -9, -9], 'max': [0.1, 9, 9]}}}, "
                          "'hold': ";
    const Points3 axis = bent("bar.mesh", both + face + "['x']}");
    const Points3 slid = bent("bar.mesh", both + face + "{'slide': 'rest'}}");
    QVERIFY(m_error <= 1e-12);
    int compared = 0;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        if (m_bar.points(0, v) != 0) continue;
        QVERIFY(std::abs(slid(0, v)) <= 1e-14);
        compared += (slid.col(v) - m_bar.points.col(v)).norm() > 0.05;
    }
    QVERIFY(compared > 3);
    const double off = (slid - axis).cwiseAbs().maxCoeff();
    QVERIFY2(off <= 1e-9, qPrintable(QString::number(off)));
}

/// The vertices of a sharp edge stay on it: along z they are free.
void TestHoldCli::slidingAlongAnEdge() {
    const std::string both = kFoot + std::string(", ") +
                             head("{'kind': 'translate', 'by': [0, 0, 0.5], 'time': [0, 1]}", "'all'"),
                      edge =
                          ", {'at': {'region': {'box': {'min': [-0.1, -0.1, 0.5], 'max': [0.1, 0.1, "
                          "5.5]}}}, 'hold': ";
    const Points3 axes = bent("bar.mesh", both + edge + "['x', 'y']}");
    for (const char* at : {"'max': [0.1, 0.1, 9]", "'max': [0.1, 9, 9]"}) {
        // The edge by itself, and as the edge between two faces.
        const bool alone = std::string(at).find("0.1, 9]") != std::string::npos;
        const std::string held =
            ", {'at': {'region': {'box': {'min': [-0.1, -0.1, -9], " + std::string(at) + "}}}, 'hold': ";
        const Points3 slid = bent("bar.mesh", both + held + "{'slide': 'rest'}}");
        QVERIFY(m_error <= 1e-12);
        for (int v = 0; v < m_bar.vertexCount(); ++v)
            if (m_bar.points.col(v).head<2>().isZero(0) && alone)
                QVERIFY((slid.col(v) - axes.col(v)).norm() <= 1e-9);
    }
}

void TestHoldCli::slidingOnACylinder_data() {
    QTest::addColumn<QString>("surface");
    QTest::addColumn<QString>("solver");
    QTest::newRow("its own") << "rest"
                             << "direct";
    QTest::newRow("file") << "tube.obj"
                          << "direct";
    QTest::newRow("multigrid") << "tube.obj"
                               << "multigrid";
}

/// A round bar is pressed and twisted in a tube: its sides stay on the tube and move along it.
void TestHoldCli::slidingOnACylinder() {
    QFETCH(QString, surface);
    QFETCH(QString, solver);
    const SimplicialMesh<3> bar = roundBar();
    writeMesh<3>(file("round.mesh"), bar);
    put(path(), "tube.obj", tube(1, 40, -1, 5));
    std::string sides;
    std::vector<int> held;
    for (int v = 0; v < bar.vertexCount(); ++v)
        if (bar.points.col(v).head<2>().norm() > 1 - 1e-9 && bar.points(2, v) > 0.1 &&
            bar.points(2, v) < 3.9) {
            sides += (sides.empty() ? "" : ", ") + std::to_string(v);
            held.push_back(v);
        }
    putProject(path(), "round.wend",
               "'domain': {'mesh': 'round.mesh'}, 'integration': {'solver': '" + solver.toStdString() +
                   "'}, 'handles': [{'at': {'vertices': [" + sides + "]}, 'hold': {'slide': '" +
                   surface.toStdString() +
                   "'}}, {'at': {'region': {'box': {'min': [-9, -9, 3.9], 'max': [9, 9, 9]}}}, 'motion': "
                   "[{'kind': 'curve', 'interpolation': 'polyline', 'points': [[0, 0, 4], [0, 0, 3.6]], "
                   "'frame': 'minimal', 'twist': 0.8, 'time': [0, 1]}]}]");
    const CliResult result = run({"run", "round.wend", "--mesh", "round.vtu", "--report", "round.json"});
    QVERIFY2(result.code == 0, qPrintable(result.error));
    const Points3 end = pointsOf(*sharedMeshFile(file("round.vtu")));
    // The tube's triangles, or those of the bar's own side at rest, which continues straight at its rim.
    Points3 corners = bar.points;
    corners.row(2) = 3 * (bar.points.row(2).array() - 2) + 2;
    std::vector<std::array<int, 3>> triangles;
    if (surface == "rest") {
        const std::set<int> isHeld(held.begin(), held.end());
        for (const Facet<3>& facet : facetsOf(bar))
            if (!facet.interior() &&
                std::ranges::all_of(facet.vertices, [&](int v) { return isHeld.contains(v); }))
                triangles.push_back(facet.vertices);
    } else {
        const auto mesh = sharedMeshFile(file("tube.obj"));
        corners = pointsOf(*mesh);
        triangles = trianglesOf(*mesh);
    }
    double farthest = 0, moved = 0;
    for (const int v : held) {
        double distance = 1e9;
        for (const auto& t : triangles)
            distance = std::min(
                distance, distanceTo(end.col(v), corners.col(t[0]), corners.col(t[1]), corners.col(t[2])));
        farthest = std::max(farthest, distance);
        moved = std::max(moved, (end.col(v) - bar.points.col(v)).norm());
    }
    QVERIFY2(farthest <= 4e-12, qPrintable(QString::number(farthest)));
    QVERIFY2(moved > 0.3, qPrintable(QString::number(moved)));
}

/// A handle in the plane slides along a straight path just as if held across it, and exactly on a bent path.
void TestHoldCli::slidingAlongAPath() {
    put(path(), "straight.obj", "v -5 0 0\nv 20 0 0\nl 1 2\n");
    put(path(), "bent.obj", "v -5 0.02 0\nv 4 0.01 0\nv 8 0 0\nv 20 -0.5 0\nl 1 2 3 4\n");
    const auto end = [&](const std::string& hold) {
        putProject(path(), "path.wend",
                   "'domain': {'mesh': 'strip.obj'}, 'handles': [{'at': {'vertices': [0, 11, 22]}}, {'at': "
                   "{'vertices': [5, 6, 7, 8, 9, 10]}, 'hold': " +
                       hold +
                       "}, {'at': {'vertices': [32]}, 'motion': [{'kind': 'translate', 'by': [1, 0.2]}]}]");
        const CliResult result = run({"run", "path.wend", "--mesh", "path.obj"});
        if (result.code != 0) qWarning("%s", qPrintable(result.error));
        return Points2(pointsOf(*sharedMeshFile(file("path.obj"))).topRows<2>());
    };
    const Points2 axis = end("['y']"), straight = end("{'slide': 'straight.obj'}");
    QVERIFY((straight - axis).cwiseAbs().maxCoeff() <= 1e-9);
    const Points2 bent = end("{'slide': 'bent.obj'}");
    for (int v = 5; v <= 10; ++v) {
        const Eigen::Vector2d p = bent.col(v);
        const Eigen::Vector2d a = p.x() < 8 ? Eigen::Vector2d(4, 0.01) : Eigen::Vector2d(8, 0),
                              b = p.x() < 8 ? Eigen::Vector2d(8, 0) : Eigen::Vector2d(20, -0.5),
                              d = (b - a).normalized();
        QVERIFY(std::abs((p - a).x() * d.y() - (p - a).y() * d.x()) <= 1e-11);
    }
}

/// A box whose faces slide on themselves rotates with them as a rigid body, and its corners do so exactly.
void TestHoldCli::surfacesThatMove() {
    std::string border;
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec3 p = m_bar.points.col(v);
        if (p.x() == 1 && p.y() == 1 && p.z() > 0 && p.z() < 6) continue;
        border += (border.empty() ? "" : ", ") + std::to_string(v);
    }
    const Points3 turned =
        bent("bar.mesh",
             "{'at': {'vertices': [" + border +
                 "]}, 'hold': {'slide': 'rest'}, 'motion': [{'kind': 'rotate', 'centre': [1, 1, 3], 'axis': "
                 "[1, 0, 0], 'angle': 1.2, 'time': [0, 1]}, {'kind': 'translate', 'by': [1, 2, 3], 'time': "
                 "[1, 2]}]}",
             ", 'integration': {'tolerance': 1e-7}, 'time': {'end': 2}");
    QVERIFY(m_error <= 1e-12);
    const Mat3 R = Eigen::AngleAxisd(1.2, Vec3::UnitX()).toRotationMatrix();
    const Vec3 centre(1, 1, 3), by(1, 2, 3);
    for (int v = 0; v < m_bar.vertexCount(); ++v) {
        const Vec3 p = m_bar.points.col(v), place = centre + by + R * (p - centre);
        const bool isCorner =
            (p.x() == 0 || p.x() == 2) && (p.y() == 0 || p.y() == 2) && (p.z() == 0 || p.z() == 6);
        const double off = (turned.col(v) - place).norm();
        QVERIFY2(off <= (isCorner ? 1e-12 : 1e-5), qPrintable(QString::number(off)));
    }
}

/// A run from states gives the same bytes, even after it was killed at any point.
void TestHoldCli::runsGoOn() {
    put(path(), "tube.obj", tube(1, 40, -1, 5));
    writeMesh<3>(file("round.mesh"), roundBar());
    putProject(path(), "on.wend",
               "'domain': {'mesh': 'round.mesh'}, 'handles': [{'at': {'vertices': [0, 6, 42, 48, 49, 55, 91, "
               "97]}, 'hold': {'slide': 'tube.obj'}}, {'at': {'region': {'box': {'min': [-9, -9, 3.9], "
               "'max': [9, 9, 9]}}}, 'motion': [{'kind': 'rotate', 'centre': [0, 0, 4], 'axis': [1, 0, 0], "
               "'angle': 0.6, 'time': [0, 1]}]}]");
    const auto bytes = [&](const char* name) { return readTextFile(file(name)); };
    QCOMPARE(run({"run", "on.wend", "--states", "on.states", "--mesh", "on.vtu"}).error, QString());
    QCOMPARE(run({"run", "on.wend", "--from", "on.states", "--mesh", "again.vtu"}).error, QString());
    QVERIFY(bytes("again.vtu") == bytes("on.vtu"));
    // Another tube makes the states those of another run.
    put(path(), "tube.obj", tube(1.001, 40, -1, 5));
    const CliResult other = run({"run", "on.wend", "--from", "on.states", "--mesh", "again.vtu"});
    QVERIFY2(other.code == 3 && other.error.contains("its handles differ"), qPrintable(other.error));
}

void TestHoldCli::surfacesThatAreRefused_data() {
    QTest::addColumn<QString>("handle");
    QTest::addColumn<QString>("message");
    const QString at = "{'name': 'side', 'at': {'vertices': [0, 1, 2]}, ";
    QTest::newRow("missing") << at + "'hold': {'slide': 'none.stl'}}"
                             << "handles[0].hold.slide: ";
    QTest::newRow("empty") << at + "'hold': {'slide': ''}}"
                           << "handles[0].hold.slide: names no file";
    QTest::newRow("no surface") << at + "'hold': {'slide': 'points.obj'}}"
                                << "points.obj: has no surface or line to slide on";
    QTest::newRow("far away") << at + "'hold': {'slide': 'far.obj'}}"
                              << "handle \"side\": vertex 0 is not on the surface on which it is to slide";
    QTest::newRow("no facet") << "{'name': 'side', 'at': {'vertices': [0, 62]}, 'hold': {'slide': 'rest'}}"
                              << "handle \"side\": no triangle of the boundary is between the points";
    QTest::newRow("late") << at + "'active': [0.5, 1], 'hold': {'slide': 'rest'}}"
                          << "has to be active from the start";
    QTest::newRow("field") << at + "'hold': {'slide': 'rest'}, 'motion': [{'kind': 'field', 'vertices': [0, "
                                   "1, 2], 'by': [[1, 0, 0], [1, 0, 0], [1, 0, 0]]}]}"
                           << "which a field does not move";
}

void TestHoldCli::surfacesThatAreRefused() {
    QFETCH(QString, handle);
    QFETCH(QString, message);
    put(path(), "points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n");
    put(path(), "far.obj", "v 0 0 -1\nv 9 0 -1\nv 0 9 -1\nf 1 2 3\n");
    putProject(path(), "refused.wend",
               "'domain': {'mesh': 'bar.mesh'}, 'handles': [" + handle.toStdString() + "]");
    const CliResult result = run({"run", "refused.wend", "--mesh", "refused.vtu"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.count('\n') == 1 && result.error.contains(message), qPrintable(result.error));
}

namespace {

/// Writes the rotated bar with the groups "top" (z = 6), "roof" (z = 6 and x = 2) and "all" (the whole
/// boundary).
void writeGroupedBar(const std::string& path, const SimplicialMesh<3>& bar, const Eigen::Matrix3d& R) {
    MeshFile file = toMeshFile<3>(bar);
    std::vector<int> top, roof, all;
    for (const Cell<3>& cell : bar.cells) file.cells.add(CellKind::Tetrahedron, cell);
    for (int c = 0; c < bar.cellCount(); ++c) file.cellOfTetrahedron.push_back(c);
    for (const auto& facet : facetsOf(bar)) {
        if (facet.interior()) continue;
        auto vertices = facet.vertices;
        const int number = file.cells.size();
        const auto lies = [&](int axis, double at) {
            return std::ranges::all_of(vertices, [&](int v) { return bar.points(axis, v) == at; });
        };
        if (lies(2, 6)) top.push_back(number), roof.push_back(number);
        if (lies(0, 2)) roof.push_back(number);
        all.push_back(number);
        if (number % 2 == 0) std::swap(vertices[0], vertices[1]);  // the file's order says nothing
        file.cells.add(CellKind::Triangle, vertices);
        file.triangles.push_back(vertices);
        file.cellOfTriangle.push_back(number);
    }
    file.groups = {{"top", 2, 1, top, {}}, {"roof", 2, 2, roof, {}}, {"all", 2, 3, all, {}}};
    file.points = R * file.points;
    writeMeshFile(path, file);
}

std::string listed(const Vec3& p) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << '[' << p.x() << ", " << p.y() << ", " << p.z() << ']';
    return out.str();
}

}  // namespace

void TestHoldCli::normalsOfGroups_data() {
    QTest::addColumn<QString>("group");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::newRow("one face") << "top" << 0.0 << 1.0;
    QTest::newRow("two faces, by area") << "roof" << 12.0 << 4.0;
}

/// Normals from groups give the same result as normals in numbers, for a rotation and for held vertices.
void TestHoldCli::normalsOfGroups() {
    QFETCH(QString, group);
    QFETCH(double, x);
    QFETCH(double, z);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.9, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    writeGroupedBar(file("grouped.msh"), m_bar, R);
    const Vec3 normal = R * Vec3(x, 0, z).normalized();
    const auto handles = [&](const std::string& direction) {
        return "{'at': {'vertices': [0, 1, 3, 4]}}, {'at': {'group': 'top'}, 'hold': {'normal': " +
               direction + "}, 'motion': [{'kind': 'translate', 'by': " + listed(R * Vec3(0.3, 0, 0.5)) +
               "}]}, {'at': {'vertices': [27]}, 'motion': [{'kind': 'rotate', 'centre': " +
               listed(R * Vec3(1, 1, 3)) + ", 'axis': " + direction + ", 'angle': 0.4}]}";
    };
    const Points3 named = bent("grouped.msh", handles("'normal of " + group.toStdString() + "'")),
                  expected = bent("grouped.msh", handles(listed(normal)));
    QVERIFY((named - expected).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((named - R * m_bar.points).cwiseAbs().maxCoeff() > 1e-3);
    // The name is saved as it was read.
    const std::string saved = file("named.wend");
    putProject(path(), "bend.wend",
               "'domain': {'mesh': 'grouped.msh'}, 'handles': [" +
                   handles("'normal of " + group.toStdString() + "'") + "]");
    writeProject(saved, *readProject(file("bend.wend")).project);
    const std::string text = readTextFile(saved), name = "\"normal of " + group.toStdString() + "\"";
    QVERIFY2(text.find("\"normal\": " + name) != std::string::npos, text.c_str());
    QVERIFY2(text.find("\"axis\": " + name) != std::string::npos, text.c_str());
}

/// Normals are those of lines of a flat mesh: of the right end of a strip, rotated by 0.3.
void TestHoldCli::normalsOfLines() {
    const SimplicialMesh<2> strip = stripMesh(10, 2);
    MeshFile mesh = toMeshFile<2>(strip);
    for (const Cell<2>& cell : strip.cells) mesh.cells.add(CellKind::Triangle, cell);
    for (int c = 0; c < strip.cellCount(); ++c) mesh.cellOfTriangle.push_back(c);
    MeshGroup end{"end", 1, 1, {}, {}};
    for (const std::array<int, 2> line : {std::array{10, 21}, std::array{32, 21}}) {
        end.cells.push_back(mesh.cells.size());
        mesh.cells.add(CellKind::Line, line);
    }
    mesh.groups = {end};
    mesh.points.topRows<2>() = Eigen::Rotation2Dd(0.3).toRotationMatrix() * mesh.points.topRows<2>();
    writeMeshFile(file("strip.msh"), mesh);
    putProject(path(), "strip.wend",
               "'domain': {'mesh': 'strip.msh'}, 'handles': [{'at': {'group': 'end'}, 'hold': {'normal': "
               "'normal of end'}}]");
    const auto project = readProject(file("strip.wend")).project;
    const Vec2 normal = inPlane(*designOf(*project).handles.at(0).normal);
    QVERIFY((normal - Vec2(std::cos(0.3), std::sin(0.3))).norm() < 1e-14);
}

void TestHoldCli::groupsWithoutNormal_data() {
    QTest::addColumn<QString>("axis");
    QTest::addColumn<QString>("message");
    QTest::newRow("closed") << "normal of all"
                            << "handles[0].motion[0].axis: the normals of the group 'all' cancel out";
    QTest::newRow("unknown") << "normal of tip"
                             << "handles[0].motion[0].axis: there is no group 'tip' in the file; it has";
    QTest::newRow("a word")
        << "top"
        << "handles[0].motion[0].axis: must be a direction, such as [0, 0, 1], or \"normal of GROUP\"";
}

void TestHoldCli::groupsWithoutNormal() {
    QFETCH(QString, axis);
    QFETCH(QString, message);
    writeGroupedBar(file("grouped.msh"), m_bar, Eigen::Matrix3d::Identity());
    putProject(path(), "bad.wend",
               "'domain': {'mesh': 'grouped.msh'}, 'handles': [{'at': {'group': 'top'}, 'motion': [{'kind': "
               "'rotate', 'centre': [0, 0, 0], 'axis': '" +
                   axis.toStdString() + "', 'angle': 1}]}]");
    const CliResult result = run({"run", "bad.wend", "--mesh", "out.vtu"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.contains(message), qPrintable(result.error));
}

void TestHoldCli::savedAsRead() {
    putProject(path(), "saved.wend",
               std::string("'domain': {'mesh': 'bar.mesh'}, 'handles': [") + kFoot + ", " +
                   head("{'kind': 'translate', 'by': [0, 0, 1], 'time': [0, 1]}", "['x', 'z']") + ", " +
                   "{'at': {'vertices': [3]}, 'hold': {'normal': [1, 2, 3]}}, {'at': {'vertices': [4]}, "
                   "'hold': 'all'}, {'at': {'vertices': [0, 1, 3, 4]}, 'hold': {'slide': 'rest'}}, {'at': "
                   "{'vertices': [0, 1, 3, 4]}, 'hold': {'slide': 'tube.obj'}}]");
    put(path(), "tube.obj", tube(1, 40, -1, 5));
    writeProject(file("again.wend"), *readProject(file("saved.wend")).project);
    writeProject(file("third.wend"), *readProject(file("again.wend")).project);
    const std::string again = readTextFile(file("again.wend"));
    QCOMPARE(readTextFile(file("third.wend")), again);
    for (const char* piece : {"\"hold\": [\"x\", \"z\"]", "\"normal\": [1, 2, 3]", "\"slide\": \"rest\"",
                              "\"slide\": \"tube.obj\""})
        QVERIFY2(again.find(piece) != std::string::npos, again.c_str());
}

void TestHoldCli::bad_data() {
    QTest::addColumn<QString>("hold");
    QTest::addColumn<QString>("message");
    QTest::newRow("axis") << "['w']"
                          << "handles[1].hold[0]: \"w\" is not an axis of this project";
    QTest::newRow("none") << "[]"
                          << "handles[1].hold: names no axis";
    QTest::newRow("word") << "'some'"
                          << "handles[1].hold: unknown value \"some\"";
    QTest::newRow("no direction") << "{'normal': [0, 0, 0]}"
                                  << "handles[1].hold.normal: must not be the zero vector";
    QTest::newRow("misspelt") << "{'nromal': [0, 0, 1]}"
                              << "`nromal` is not known; `normal`?";
    QTest::newRow("dimension") << "{'normal': [0, 1]}"
                               << "handles[1].hold.normal: has 2 numbers";
}

void TestHoldCli::bad() {
    QFETCH(QString, hold);
    QFETCH(QString, message);
    putProject(path(), "bad.wend",
               std::string("'domain': {'mesh': 'bar.mesh'}, 'handles': [") + kFoot + ", " +
                   head("{'kind': 'translate', 'by': [0, 0, 1]}", hold.toStdString()) + "]");
    const CliResult result = run({"run", "bad.wend", "--mesh", "bad.vtu"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.error.count('\n') == 1 && result.error.contains(message), qPrintable(result.error));
    putProject(
        path(), "bad.wend",
        "'domain': {'mesh': 'bar.mesh'}, 'handles': [{'name': 'inside', 'at': {'points': [[0.3, 0.4, 0.5]]}, "
        "'hold': ['x']}]");
    QVERIFY(run({"run", "bad.wend", "--mesh", "bad.vtu"})
                .error.contains("handle \"inside\": only vertices can slide"));
}

QTEST_GUILESS_MAIN(TestHoldCli)
#include "test_hold_cli.moc"
