// The OpenCL back end against the CPU's, on every working device, one body for 2D and 3D.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/mesh/child_process.h"
#include "kernels/opencl_back_end.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestOpenCl : public QObject {
    Q_OBJECT
  private slots:
    void aDeviceWorksHere();
    void withoutDriverNothingBreaks();
    void unknownDeviceIsNamed();
    void backEndsAgree_data();
    void backEndsAgree();
    void firstInvertedCellIsFound();
    void runsRepeat();
};

namespace {

/// Agreement asked for: both sum the same few hundred terms per entry, in orders and with formulas of their
/// own.
constexpr double kTolerance = 1e-10;

OpenClDeviceInfo device() {
    std::string why;
    const auto info = chooseOpenClDevice({}, why);
    if (!info) throw std::runtime_error(why);
    return *info;
}

template <int Dim>
struct Pair {
    SimplicialMesh<Dim> rest;
    Points<Dim> shape;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> cpu, opencl;

    Pair(bool anisotropic, SmoothingKind kind, int n) {
        std::mt19937 random(7);
        rest = unitGrid<Dim>(n, 0.2, random);
        shape = rest.points + 0.1 / n * randomField<Dim>(random, rest.vertexCount());
        shape = (Mat<Dim>::Identity() + 0.5 * randomSkew<Dim>(random)) * shape;
        Smoothing smoothing;
        smoothing.kind = kind;
        Material<Dim> material = randomMaterial<Dim>(random, rest.cellCount(), smoothing);
        if (!anisotropic) material.anisotropy.clear();
        plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(rest, kind != SmoothingKind::None));
        cpu = makeCpuBackEnd<Dim>(plan, rest, material, 1);
        opencl = makeOpenClBackEnd<Dim>(device(), plan, rest, material);
        std::vector<double> inertia(static_cast<std::size_t>(rest.cellCount()), 0.0);
        inertia[0] = 1e-4;
        cpu->setInertia(inertia);
        opencl->setInertia(inertia);
    }
};

template <int Dim>
void compare(bool anisotropic, SmoothingKind kind) {
    Pair<Dim> pair(anisotropic, kind, Dim == 2 ? 17 : 6);
    QCOMPARE(pair.cpu->setShape(pair.shape), -1);
    QCOMPARE(pair.opencl->setShape(pair.shape), -1);
    std::vector<double> a(static_cast<std::size_t>(pair.plan->blockCount()) * Dim * Dim), b(a.size());
    pair.cpu->assemble(a);
    pair.opencl->assemble(b);
    const Eigen::Map<Eigen::VectorXd> A(a.data(), static_cast<Eigen::Index>(a.size())), B(b.data(), A.size());
    QVERIFY2((A - B).cwiseAbs().maxCoeff() <= kTolerance * A.cwiseAbs().maxCoeff(),
             qPrintable(QString::number((A - B).cwiseAbs().maxCoeff() / A.cwiseAbs().maxCoeff())));
    std::mt19937 random(9);
    const Points<Dim> v = randomField<Dim>(random, pair.rest.vertexCount());
    Points<Dim> x(Dim, v.cols()), y(Dim, v.cols());
    pair.cpu->apply(v, x);
    pair.opencl->apply(v, y);
    QVERIFY((x - y).cwiseAbs().maxCoeff() <= kTolerance * x.cwiseAbs().maxCoeff());
    QVERIFY(std::abs(pair.cpu->energy(v) / pair.opencl->energy(v) - 1) <= kTolerance);
}

}  // namespace

void TestOpenCl::aDeviceWorksHere() {
    std::string why;
    QVERIFY2(chooseOpenClDevice({}, why).has_value(), why.c_str());
    QVERIFY(!openClDevices().devices.empty());
}

void TestOpenCl::withoutDriverNothingBreaks() {
    qputenv("OCL_ICD_VENDORS", "/nonexistent");
    const ChildResult child = runChild(siblingProgram("wend-clprobe"), {}, 30, 0, {});
    qunsetenv("OCL_ICD_VENDORS");
    QVERIFY(child.end == ChildResult::End::Exited && child.code == 0);
    QCOMPARE(QString::fromStdString(child.output), QString("none\tno OpenCL driver is installed\n"));
}

void TestOpenCl::unknownDeviceIsNamed() {
    std::string why;
    QVERIFY(!chooseOpenClDevice("no such thing", why).has_value());
    QVERIFY(QString::fromStdString(why).contains("no such thing"));
}

void TestOpenCl::backEndsAgree_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<bool>("anisotropic");
    QTest::addColumn<int>("smoothing");
    for (int dimension : {2, 3})
        for (bool anisotropic : {false, true})
            for (int smoothing : {0, 1, 2})
                QTest::addRow("%dD %s smoothing %d", dimension, anisotropic ? "anisotropic" : "isotropic",
                              smoothing)
                    << dimension << anisotropic << smoothing;
}

void TestOpenCl::backEndsAgree() {
    QFETCH(int, dimension);
    QFETCH(bool, anisotropic);
    QFETCH(int, smoothing);
    if (dimension == 2)
        compare<2>(anisotropic, static_cast<SmoothingKind>(smoothing));
    else
        compare<3>(anisotropic, static_cast<SmoothingKind>(smoothing));
}

void TestOpenCl::firstInvertedCellIsFound() {
    Pair<2> pair(false, SmoothingKind::Invariant, 40);
    Points<2> shape = pair.rest.points;
    const auto& cell = pair.rest.cells[2500];
    shape.col(cell[0]) += 3 * (shape.col(cell[1]) - shape.col(cell[0]));
    const int found = pair.cpu->setShape(shape);
    QVERIFY(found >= 0);
    QCOMPARE(pair.opencl->setShape(shape), found);
    shape(0, cell[0]) = std::nan("");
    QCOMPARE(pair.opencl->setShape(shape), pair.cpu->setShape(shape));
}

void TestOpenCl::runsRepeat() {
    Pair<3> pair(true, SmoothingKind::Invariant, 5);
    std::vector<double> a(static_cast<std::size_t>(pair.plan->blockCount()) * 9), b(a.size());
    pair.opencl->setShape(pair.shape);
    pair.opencl->assemble(a);
    pair.opencl->setShape(pair.shape);
    pair.opencl->assemble(b);
    QVERIFY(a == b);
}

QTEST_GUILESS_MAIN(TestOpenCl)
#include "test_opencl.moc"
