// The distortion on an OpenCL device against the processor's, one body for 2D and 3D.
#include <Eigen/LU>
#include <QTest>

#include "kernels/back_end_choice.h"
#include "kernels/opencl_distortion.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestOpenClDistortion : public QObject {
    Q_OBJECT
  private slots:
    void agreesWithTheProcessor_data();
    void agreesWithTheProcessor();
    void rigidMotionsHaveNone_data() { agreesWithTheProcessor_data(); }
    void rigidMotionsHaveNone();
    void repeats();
    void failingDeviceIsReplaced();
};

namespace {

OpenClDeviceInfo device() {
    std::string why;
    const auto info = chooseOpenClDevice({}, why);
    if (!info) throw std::runtime_error(why);
    return *info;
}

template <int Dim>
SimplicialMesh<Dim> sample() {
    std::mt19937 random(7);
    return unitGrid<Dim>(Dim == 2 ? 40 : 8, 0.2, random);  // more than one chunk of cells
}

/// 1e-10 of the largest value: single cells differ by the rounding of their singular values, some 1e-16.
void compare(const std::vector<double>& a, const std::vector<double>& b) {
    QCOMPARE(a.size(), b.size());
    double most = 0;
    for (double v : a) most = std::max(most, std::abs(v));
    for (std::size_t k = 0; k < a.size(); ++k) QVERIFY(std::abs(a[k] - b[k]) <= 1e-10 * most);
}

template <int Dim>
void compare() {
    const SimplicialMesh<Dim> rest = sample<Dim>();
    std::mt19937 random(11);
    Points<Dim> pose = rest.points + 0.02 * randomField<Dim>(random, rest.vertexCount());
    pose = (Mat<Dim>::Identity() + 0.6 * randomSkew<Dim>(random)) * pose;
    pose.col(3) *= 3;  // some cells fold
    const Distortion a = distortion<Dim>(rest, pose), b = OpenClDistortion<Dim>(device(), rest).of(pose);
    QVERIFY(a.flips > 0);
    compare(a.angle, b.angle);
    compare(a.volume, b.volume);
    compare(a.metric, b.metric);
    compare(a.ratio, b.ratio);
    QCOMPARE(a.flips, b.flips);
    QCOMPARE(a.worstCell, b.worstCell);
    for (const auto& [x, y] : {std::pair(a.totalAngle, b.totalAngle), std::pair(a.totalVolume, b.totalVolume),
                               std::pair(a.totalMetric, b.totalMetric), std::pair(a.minDet, b.minDet)})
        QVERIFY(std::abs(x - y) <= 1e-10 * std::abs(x));
}

template <int Dim>
void rigid() {
    const SimplicialMesh<Dim> rest = sample<Dim>();
    std::mt19937 random(5);
    const Mat<Dim> skew = randomSkew<Dim>(random), one = Mat<Dim>::Identity();
    const Mat<Dim> turn = (one - skew).inverse() * (one + skew);  // Cayley
    const Distortion none = OpenClDistortion<Dim>(device(), rest).of(turn * rest.points);
    // Squares of roundings.
    QVERIFY(none.totalAngle < 1e-20 && none.totalVolume < 1e-20 && none.totalMetric < 1e-20);
}

}  // namespace

void TestOpenClDistortion::agreesWithTheProcessor_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("2D") << 2;
    QTest::newRow("3D") << 3;
}

void TestOpenClDistortion::agreesWithTheProcessor() {
    QFETCH(int, dimension);
    dimension == 2 ? compare<2>() : compare<3>();
}

void TestOpenClDistortion::rigidMotionsHaveNone() {
    QFETCH(int, dimension);
    dimension == 2 ? rigid<2>() : rigid<3>();
}

void TestOpenClDistortion::repeats() {
    const SimplicialMesh<3> rest = sample<3>();
    std::mt19937 random(3);
    const Points3 pose = rest.points + 0.02 * randomField<3>(random, rest.vertexCount());
    OpenClDistortion<3> once(device(), rest), again(device(), rest);
    const Distortion a = once.of(pose), b = again.of(pose);
    QVERIFY(a.angle == b.angle && a.metric == b.metric && a.totalAngle == b.totalAngle);
}

void TestOpenClDistortion::failingDeviceIsReplaced() {
    const SimplicialMesh<2> rest = sample<2>();
    OpenClDeviceInfo nowhere;
    nowhere.platform = 99;
    QVERIFY_THROWS_EXCEPTION(DeviceFailure, OpenClDistortion<2>(nowhere, rest));
    const Distortion expected = distortion<2>(rest, rest.points);
    for (BackEndKind kind : {BackEndKind::Cpu, BackEndKind::Automatic})
        QVERIFY(distortionOf<2>(kind, rest)(rest.points).angle == expected.angle);
}

QTEST_GUILESS_MAIN(TestOpenClDistortion)
#include "test_opencl_distortion.moc"
