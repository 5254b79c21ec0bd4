// The OpenCL back end against the CPU's, on every working device, one body for 2D and 3D.
#include <QTest>

#include "core/assembly/cpu_back_end.h"
#include "core/base/child_process.h"
#include "core/base/error.h"
#include "kernels/back_end_choice.h"
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
    void failingDeviceIsReplaced();
    void threadsAreAsWished();
    void missingDeviceIsAnErrorOnlyByName();
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
        opencl = makeOpenClBackEnd<Dim>(device(), plan, rest, material, 1);
        std::vector<double> massRegularization(static_cast<std::size_t>(rest.cellCount()), 0.0);
        massRegularization[0] = 1e-4;
        cpu->setMassRegularization(massRegularization);
        opencl->setMassRegularization(massRegularization);
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
    Points2 shape = pair.rest.points;
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

/// A real device is lost after some calls, as when its driver is reset.
template <int Dim>
class LostDevice final : public BackEnd<Dim> {
  public:
    LostDevice(std::unique_ptr<BackEnd<Dim>> device, int calls)
        : m_device(std::move(device)), m_calls(calls) {}
    std::string name() const override { return m_device->name(); }
    std::string device() const override { return m_device->device(); }
    WorkerPool& workers() override { return m_device->workers(); }
    void setMassRegularization(std::vector<double> epsilon) override {
        use().setMassRegularization(std::move(epsilon));
    }
    int setShape(const Points<Dim>& shape) override { return use().setShape(shape); }
    void assemble(std::span<double> values) override { use().assemble(values); }
    void apply(const Points<Dim>& v, Points<Dim>& Av) override { use().apply(v, Av); }
    double energy(const Points<Dim>& v) override { return use().energy(v); }

  private:
    BackEnd<Dim>& use() {
        if (m_calls-- <= 0) throw DeviceFailure("device lost");
        return *m_device;
    }
    std::unique_ptr<BackEnd<Dim>> m_device;
    int m_calls;
};

/// The processor's share of the work, the factor, keeps to the requested number of threads.
void TestOpenCl::threadsAreAsWished() {
    std::mt19937 random(3);
    const auto mesh = unitGrid<2>(75, 0.1, random);
    const auto plan = std::make_shared<const AssemblyPlan<2>>(makeAssemblyPlan(mesh, true));
    const auto material = Material<2>::uniform(mesh.cellCount(), phi::kMetr);
    for (int threads : {1, 3})
        QCOMPARE(makeOpenClBackEnd<2>(device(), plan, mesh, material, threads)->workers().threads(), threads);
}

void TestOpenCl::failingDeviceIsReplaced() {
    for (int calls = 0; calls <= 4; ++calls) {
        Pair<2> pair(false, SmoothingKind::Invariant, 9);
        std::vector<std::string> notices;
        const Material<2> material = Material<2>::uniform(pair.rest.cellCount(), phi::kMetr);
        const auto makeCpu = [&] { return makeCpuBackEnd<2>(pair.plan, pair.rest, material, 1); };
        auto lost = std::make_unique<LostDevice<2>>(
            makeOpenClBackEnd<2>(device(), pair.plan, pair.rest, material, 1), calls);
        const auto failsafe = makeFailsafe<2>(std::move(lost), makeCpu,
                                              [&](const std::string& text) { notices.push_back(text); });
        const auto reference = makeCpu();
        const std::vector<double> massRegularization(static_cast<std::size_t>(pair.rest.cellCount()), 1e-3);
        for (auto* backEnd : {failsafe.get(), reference.get()}) {
            backEnd->setMassRegularization(massRegularization);
            QCOMPARE(backEnd->setShape(pair.shape), -1);
        }
        std::vector<double> a(static_cast<std::size_t>(pair.plan->blockCount()) * 4), b(a.size());
        failsafe->assemble(a);
        reference->assemble(b);
        Points2 x, y;
        failsafe->apply(pair.shape, x);
        reference->apply(pair.shape, y);
        const double scale = *std::max_element(b.begin(), b.end());
        for (std::size_t k = 0; k < a.size(); ++k) QVERIFY(std::abs(a[k] - b[k]) <= kTolerance * scale);
        QVERIFY((x - y).cwiseAbs().maxCoeff() <= kTolerance * y.cwiseAbs().maxCoeff());
        QCOMPARE(notices.size(), std::size_t(calls < 4 ? 1 : 0));
        QCOMPARE(failsafe->name(), std::string(calls < 4 ? "cpu" : "opencl"));
    }
}

void TestOpenCl::missingDeviceIsAnErrorOnlyByName() {
    const Pair<2> pair(false, SmoothingKind::Invariant, 5);
    const Material<2> material = Material<2>::uniform(pair.rest.cellCount(), phi::kMetr);
    const auto make = [&](BackEndKind kind) {
        return backEndFactory<2>(kind, "no such thing")(pair.plan, pair.rest, material, 1);
    };
    QVERIFY_THROWS_EXCEPTION(InputError, make(BackEndKind::OpenCl));
    QCOMPARE(make(BackEndKind::Automatic)->name(), std::string("cpu"));
    QCOMPARE(make(BackEndKind::Cpu)->name(), std::string("cpu"));
}

QTEST_GUILESS_MAIN(TestOpenCl)
#include "test_opencl.moc"
