// The stages of a step on an OpenCL device: compared with the processor's, with the amount of copied data,
// and in whole deformations.
#include <QDateTime>
#include <QDir>
#include <QMap>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/assembly/cpu_back_end.h"
#include "kernels/back_end_choice.h"
#include "kernels/opencl_back_end.h"
#include "kernels/opencl_stages.h"
#include "tests/core/test_energy_samples.h"
#include "tests/core/test_strip.h"

using namespace wend;
using namespace wend::test;

class TestOpenClStages : public QObject {
    Q_OBJECT
  private slots:
    void sumsAreTheProcessors_data();
    void sumsAreTheProcessors();
    void notANumberIsSeen();
    void vectorsGoToTheDeviceOnce();
    void oldVectorsMakePlace();
    void directStepsCopyWhatTheSolverNeeds_data();
    void directStepsCopyWhatTheSolverNeeds();
    void iterationsCopyWhatTheSolverNeeds_data();
    void iterationsCopyWhatTheSolverNeeds();
    void deformationsAgree_data();
    void deformationsAgree();
    void aDeviceIsLostAnywhere_data();
    void aDeviceIsLostAnywhere();
    void workersOutliveTheirDevice();
    void programsAreKeptPerOptions();
};

namespace {

constexpr int kVertices = 1000;  // several chunks of the norm, the last one not full
constexpr std::size_t kVector = 2 * kVertices * sizeof(double);

OpenClDeviceInfo device() {
    std::string why;
    const auto info = chooseOpenClDevice({}, why);
    if (!info) throw std::runtime_error(why);
    return *info;
}

template <int Dim>
Nodal<Dim> vectorOf(std::mt19937& random) {
    return std::make_shared<const Points<Dim>>(randomField<Dim>(random, kVertices));
}

/// y and four slopes with weights.
template <int Dim>
struct Sum {
    explicit Sum(unsigned seed = 3) {
        std::mt19937 random(seed);
        y = vectorOf<Dim>(random);
        for (double weight : {0.3, -1.2, 0.0, 2.5}) terms.push_back({weight, vectorOf<Dim>(random)});
    }
    Nodal<Dim> y;
    std::vector<WeightedField<Dim>> terms;
};

template <int Dim>
void compare() {
    OpenClContext cl(device());
    OpenClStages<Dim> onDevice(cl, kVertices);
    const auto host = makeHostStages<Dim>();
    const Sum<Dim> sum, other(5);
    for (std::size_t count = 0; count <= sum.terms.size(); ++count) {
        const std::span<const WeightedField<Dim>> terms(sum.terms.data(), count);
        for (StageVectors<Dim>* stages : {host.get(), static_cast<StageVectors<Dim>*>(&onDevice)})
            stages->combine(sum.y, terms);
        // The same sums in the same order, none contracted.
        QVERIFY(*host->shape() == *onDevice.shape());
        QCOMPARE(onDevice.distance(other.y), host->distance(other.y));
        // Squares may be added in another order: a few roundings.
        QVERIFY(std::abs(host->maximum(terms) - onDevice.maximum(terms)) < 1e-14);
    }
}

struct Calls {
    std::size_t products = 0, shapes = 0, stages = 0;
};

/// A back end whose calls are counted.
template <int Dim>
class Counted final : public BackEnd<Dim> {
  public:
    Counted(std::unique_ptr<BackEnd<Dim>> backEnd, Calls& calls)
        : m_backEnd(std::move(backEnd)), m_calls(calls) {}
    std::string name() const override { return m_backEnd->name(); }
    std::string device() const override { return m_backEnd->device(); }
    WorkerPool& workers() override { return m_backEnd->workers(); }
    CopiedBytes copied() const override { return m_backEnd->copied(); }
    void setMassRegularization(std::vector<double> epsilon) override {
        m_backEnd->setMassRegularization(std::move(epsilon));
    }
    int setShape(const Points<Dim>& shape) override {
        ++m_calls.shapes;
        return m_backEnd->setShape(shape);
    }
    StageVectors<Dim>& stages() override { return m_backEnd->stages(); }
    int setStage() override {
        ++m_calls.stages;
        return m_backEnd->setStage();
    }
    void assemble(std::span<double> values) override { m_backEnd->assemble(values); }
    void apply(const Points<Dim>& v, Points<Dim>& Av) override {
        ++m_calls.products;
        m_backEnd->apply(v, Av);
    }
    double energy(const Points<Dim>& v) override { return m_backEnd->energy(v); }

  private:
    std::unique_ptr<BackEnd<Dim>> m_backEnd;
    Calls& m_calls;
};

/// A bend of a strip or bar on a back end that the test can look at.
template <int Dim>
struct Bending {
    explicit Bending(const IntegrationOptions& options) : bend(8, 2, 3, 1.2, phi::kMetr) {
        deformer.emplace(
            bend.mesh, bend.material, bend.handles, options,
            BackEndFactory<Dim>([this](std::shared_ptr<const AssemblyPlan<Dim>> used,
                                       const SimplicialMesh<Dim>& rest, const Material<Dim>& material,
                                       int threads) -> std::unique_ptr<BackEnd<Dim>> {
                plan = used;
                return std::make_unique<Counted<Dim>>(
                    makeOpenClBackEnd<Dim>(device(), used, rest, material, threads), calls);
            }));
    }
    Bending(const Bending&) = delete;  // the back end counts here
    Bending& operator=(const Bending&) = delete;
    std::size_t vector() const { return static_cast<std::size_t>(plan->vertexCount) * Dim * sizeof(double); }
    std::size_t values() const {
        return static_cast<std::size_t>(plan->blockCount()) * Dim * Dim * sizeof(double);
    }
    std::size_t foldedCells() const { return (plan->cellCount() + 1023) / 1024 * sizeof(int); }
    std::size_t norm() const {
        return (plan->vertexCount + OpenClStages<Dim>::kChunk - 1) / OpenClStages<Dim>::kChunk *
               sizeof(double);
    }
    /// The mass regularization is copied with the constraints.
    std::size_t massRegularization() const { return plan->cellCount() * sizeof(double); }
    /// The energy of the last field is copied for the report.
    std::size_t energies() const { return plan->cellCount() * sizeof(double); }

    samples::Bend<Dim> bend;
    Calls calls;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::optional<Deformer<Dim>> deformer;
};

/// Every field has a factor of its own. Every evaluation copies a field up for every product with the matrix,
/// one product down (the right-hand side, and the residual after each solve), the matrix down, the places of
/// folded cells down, and the velocity up as a slope. Every step copies its start up, its end down, and the
/// norms of its errors, up to three for Adams.
template <int Dim>
void checkDirect(Method method) {
    IntegrationOptions options;
    options.method = method;
    options.steps = method == Method::Adams ? 0 : 3;
    options.velocityTolerance = 0;
    Bending<Dim> bending(options);
    const CopiedBytes before = bending.deformer->statistics().copied;
    QCOMPARE(bending.deformer->advance(1).outcome, Outcome::Done);
    const Statistics& counts = bending.deformer->statistics();
    const std::size_t evaluations = counts.evaluations, products = counts.solverIterations + evaluations,
                      steps = counts.steps, attempts = steps + counts.rejected;
    // Dormand–Prince's last stage is the next step's first: no sum needs that of the last step.
    const std::size_t slopes = evaluations - (method == Method::DormandPrince ? 1 : 0);
    const std::size_t up = bending.vector() * (products + slopes + steps + 1);  // 1: for the energy
    QCOMPARE(counts.copied.toDevice - before.toDevice, up + bending.massRegularization());
    const std::size_t down = bending.vector() * (products + attempts) + bending.values() * evaluations +
                             bending.foldedCells() * evaluations + bending.energies();
    const std::size_t norms = counts.copied.fromDevice - before.fromDevice - down;
    QCOMPARE(norms % bending.norm(), std::size_t(0));
    QVERIFY(norms / bending.norm() <= (method == Method::Adams ? 3 * attempts : 0));
}

/// With reused factors the matrix and the factor's shape come down for new factors only, and with every other
/// field the distance from that shape and the one from the shape whose rotations may serve, or the shape
/// itself where they do not. Shapes ahead, for factors, are copied up.
template <int Dim>
void checkIterations() {
    IntegrationOptions options;
    options.method = Method::RungeKutta4;
    options.steps = 4;
    Bending<Dim> bending(options);
    const CopiedBytes before = bending.deformer->statistics().copied;
    QCOMPARE(bending.deformer->advance(1).outcome, Outcome::Done);
    const Statistics& counts = bending.deformer->statistics();
    const std::size_t evaluations = counts.evaluations, factors = counts.factorizations, steps = counts.steps,
                      vector = bending.vector(), products = bending.calls.products;
    QVERIFY(factors < evaluations);
    // Of a run of iterations the last one needs no product, as a rule.
    QVERIFY(products < static_cast<std::size_t>(counts.solverIterations) + evaluations);
    const std::size_t up = counts.copied.toDevice - before.toDevice - bending.massRegularization();
    // A shape ahead is set, and is copied up again for the distances from it.
    const std::size_t ahead = 2 * bending.calls.shapes;
    QCOMPARE(up, vector * (products + 4 * steps + steps + 1 + ahead));
    const std::size_t down = counts.copied.fromDevice - before.fromDevice;
    const std::size_t more = down - vector * (products + steps) - bending.values() * factors -
                             bending.foldedCells() * (bending.calls.shapes + bending.calls.stages) -
                             bending.energies();
    // That of a step's first stage is known already.
    const std::size_t shapes = more / vector, norms = more % vector;
    QVERIFY2(shapes <= evaluations, qPrintable(QString("%1 shapes down").arg(shapes)));
    QCOMPARE(norms % bending.norm(), std::size_t(0));
    QVERIFY2(norms / bending.norm() <= 2 * evaluations + factors,
             qPrintable(QString("%1 distances down").arg(norms / bending.norm())));
}

template <int Dim>
Points<Dim> bent(const IntegrationOptions& options, const BackEndFactory<Dim>& backEnd) {
    const samples::Bend<Dim> bend(8, 2, 3, 1.2, phi::kMetr);
    Deformer<Dim> deformer(bend.mesh, bend.material, bend.handles, options, backEnd);
    const AdvanceResult result = deformer.advance(1);
    if (result.outcome != Outcome::Done) throw std::runtime_error(result.message);
    return deformer.state().points;
}

template <int Dim>
void checkAgreement(Method method) {
    IntegrationOptions options;
    options.method = method;
    if (!isAdaptive(method)) options.steps = 4;
    const Points<Dim> cpu = bent<Dim>(options, makeCpuBackEnd<Dim>);
    const Points<Dim> opencl = bent<Dim>(options, backEndFactory<Dim>(BackEndKind::OpenCl));
    // The back ends' rounding (1e-10 relative), carried along a path about as long as the shape.
    QVERIFY2(samples::distance(cpu, opencl) < 1e-9 * boundingBoxDiagonal<Dim>(cpu),
             qPrintable(QString::number(samples::distance(cpu, opencl))));
    QVERIFY(opencl == bent<Dim>(options, backEndFactory<Dim>(BackEndKind::OpenCl)));
}

/// A device that is lost after some calls of the back end or of its stages.
template <int Dim>
class LostDevice final : public BackEnd<Dim> {
    class Stages final : public StageVectors<Dim> {
        using typename StageVectors<Dim>::Terms;

      public:
        explicit Stages(LostDevice& owner) : m_owner(owner) {}
        void combine(const Nodal<Dim>& y, Terms terms) override { m_owner.use().stages().combine(y, terms); }
        Nodal<Dim> shape() override { return m_owner.use().stages().shape(); }
        double distance(const Nodal<Dim>& other) override { return m_owner.use().stages().distance(other); }
        double maximum(Terms terms) override { return m_owner.use().stages().maximum(terms); }

      private:
        LostDevice& m_owner;
    };

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
    StageVectors<Dim>& stages() override { return m_stages; }
    int setStage() override { return use().setStage(); }
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
    Stages m_stages{*this};

  public:
    std::shared_ptr<int> life = std::make_shared<int>();
};

void addMethods() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("method");
    for (int dimension : {2, 3})
        for (Method method : {Method::RungeKutta4, Method::DormandPrince, Method::Adams})
            QTest::addRow("%dD method %d", dimension, static_cast<int>(method))
                << dimension << static_cast<int>(method);
}

}  // namespace

void TestOpenClStages::sumsAreTheProcessors_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("2D") << 2;
    QTest::newRow("3D") << 3;
}

void TestOpenClStages::sumsAreTheProcessors() {
    QFETCH(int, dimension);
    dimension == 2 ? compare<2>() : compare<3>();
}

void TestOpenClStages::notANumberIsSeen() {
    OpenClContext cl(device());
    OpenClStages<2> onDevice(cl, kVertices);
    const auto host = makeHostStages<2>();
    for (int where : {0, 700, kVertices - 1}) {
        Points2 k = Points2::Zero(2, kVertices);
        k(1, where) = std::nan("");
        const std::vector<WeightedField<2>> terms{{1, std::make_shared<const Points2>(k)}};
        QVERIFY(std::isnan(host->maximum(terms)));
        QVERIFY(std::isnan(onDevice.maximum(terms)));
    }
}

/// A step of four stages copies y and the slopes up once, whatever is computed from them, and the results
/// down once.
void TestOpenClStages::vectorsGoToTheDeviceOnce() {
    OpenClContext cl(device());
    OpenClStages<2> stages(cl, kVertices);
    const Sum<2> sum;
    for (std::size_t count = 0; count <= 4; ++count) stages.combine(sum.y, std::span(sum.terms).first(count));
    stages.maximum(sum.terms);
    QCOMPARE(cl.copied().toDevice, 5 * kVector);
    QCOMPARE(cl.copied().fromDevice, 4 * sizeof(double));
    const Nodal<2> shape = stages.shape();
    QVERIFY(stages.shape() == shape);
    QCOMPARE(cl.copied().fromDevice, 4 * sizeof(double) + kVector);
    stages.combine(shape, sum.terms);  // what came from there is there
    const auto host = makeHostStages<2>();
    host->combine(shape, sum.terms);
    QVERIFY(*stages.shape() == *host->shape());
    QCOMPARE(cl.copied().toDevice, 5 * kVector);
}

void TestOpenClStages::oldVectorsMakePlace() {
    OpenClContext cl(device());
    OpenClStages<2> stages(cl, kVertices);
    const auto host = makeHostStages<2>();
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Sum<2> sum(seed);
        stages.combine(sum.y, sum.terms);
        host->combine(sum.y, sum.terms);
        QVERIFY(*stages.shape() == *host->shape());
    }
    const Sum<2> again(1);
    stages.combine(again.y, again.terms);
    host->combine(again.y, again.terms);
    QVERIFY(*stages.shape() == *host->shape());
}

void TestOpenClStages::directStepsCopyWhatTheSolverNeeds_data() {
    addMethods();
}

void TestOpenClStages::directStepsCopyWhatTheSolverNeeds() {
    QFETCH(int, dimension);
    QFETCH(int, method);
    dimension == 2 ? checkDirect<2>(Method(method)) : checkDirect<3>(Method(method));
}

void TestOpenClStages::iterationsCopyWhatTheSolverNeeds_data() {
    sumsAreTheProcessors_data();
}

void TestOpenClStages::iterationsCopyWhatTheSolverNeeds() {
    QFETCH(int, dimension);
    dimension == 2 ? checkIterations<2>() : checkIterations<3>();
}

void TestOpenClStages::deformationsAgree_data() {
    addMethods();
}

void TestOpenClStages::deformationsAgree() {
    QFETCH(int, dimension);
    QFETCH(int, method);
    dimension == 2 ? checkAgreement<2>(Method(method)) : checkAgreement<3>(Method(method));
}

void TestOpenClStages::aDeviceIsLostAnywhere_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("Runge-Kutta 4") << int(Method::RungeKutta4);
    QTest::newRow("Adams") << int(Method::Adams);
}

/// The device is lost after any number of calls, in any of them: the run continues from the same numbers to
/// the same result.
void TestOpenClStages::aDeviceIsLostAnywhere() {
    QFETCH(int, method);
    IntegrationOptions options;
    options.method = Method(method);
    if (!isAdaptive(options.method)) options.steps = 4;
    const Points2 expected = bent<2>(options, makeCpuBackEnd<2>);
    for (int calls = 0; calls < 100; calls += calls < 40 ? 1 : 7) {
        int notices = 0;
        const auto factory = [&](std::shared_ptr<const AssemblyPlan<2>> plan, const SimplicialMesh<2>& rest,
                                 const Material<2>& material, int threads) {
            const auto makeCpu = [=] { return makeCpuBackEnd<2>(plan, rest, material, threads); };
            return makeFailsafe<2>(std::make_unique<LostDevice<2>>(
                                       makeOpenClBackEnd<2>(device(), plan, rest, material, threads), calls),
                                   makeCpu, [&](const std::string&) { ++notices; });
        };
        const Points2 result = bent<2>(options, factory);
        QVERIFY2(samples::distance(result, expected) < 1e-9 * boundingBoxDiagonal<2>(expected),
                 qPrintable(QString("%1 calls: %2").arg(calls).arg(samples::distance(result, expected))));
        QCOMPARE(notices, 1);
    }
}

/// An owner of the workers at the moment of the loss may still use them.
void TestOpenClStages::workersOutliveTheirDevice() {
    const SimplicialMesh<2> rest = samples::strip<2>(4, 2, 4);
    const auto material = Material<2>::uniform(rest.cellCount(), phi::kMetr);
    const auto plan = std::make_shared<const AssemblyPlan<2>>(makeAssemblyPlan(rest, false));
    auto device = std::make_unique<LostDevice<2>>(makeCpuBackEnd<2>(plan, rest, material, 2), 0);
    const std::weak_ptr<int> life = device->life;
    int notices = 0;
    const auto backEnd = makeFailsafe<2>(
        std::move(device), [&] { return makeCpuBackEnd<2>(plan, rest, material, 2); },
        [&](const std::string&) { ++notices; });
    const WorkerPool& before = backEnd->workers();
    backEnd->setShape(rest.points);
    QCOMPARE(notices, 1);
    QVERIFY(&backEnd->workers() != &before);
    QVERIFY(!life.expired());
}

void TestOpenClStages::programsAreKeptPerOptions() {
    const QByteArray before = qgetenv("XDG_CACHE_HOME");
    QTemporaryDir folder;
    device();  // the drivers' own caches stay where they are
    qputenv("XDG_CACHE_HOME", folder.path().toUtf8());
    const QDir kept(folder.filePath("wend/kernels"));
    const auto times = [&] {
        QMap<QString, QDateTime> all;
        for (const QFileInfo& file : kept.entryInfoList(QDir::Files))
            all[file.fileName()] = file.lastModified();
        return all;
    };
    const auto make = [](auto dimension) {
        OpenClContext cl(device());
        OpenClStages<dimension()>(cl, 1);
    };
    make(std::integral_constant<int, 2>());
    const auto one = times();
    make(std::integral_constant<int, 2>());
    const auto same = times();
    make(std::integral_constant<int, 3>());
    const auto two = times();
    before.isNull() ? qunsetenv("XDG_CACHE_HOME") : qputenv("XDG_CACHE_HOME", before);
    QCOMPARE(one.size(), 1);
    QVERIFY(one == same);  // neither a second file nor the first written again
    QCOMPARE(two.size(), 2);
}

QTEST_GUILESS_MAIN(TestOpenClStages)
#include "test_opencl_stages.moc"
