// The vectors of a Runge–Kutta step on an OpenCL device against the processor's; programs kept in the cache.
#include <QDateTime>
#include <QDir>
#include <QMap>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "kernels/opencl_stages.h"
#include "tests/core/test_energy_samples.h"

using namespace wend;
using namespace wend::test;

class TestOpenClStages : public QObject {
    Q_OBJECT
  private slots:
    void agreeWithTheProcessor_data();
    void agreeWithTheProcessor();
    void notANumberIsSeen();
    void vectorsGoToTheDeviceOnce();
    void failingDeviceIsReplaced();
    void programsAreKeptPerOptions();
};

namespace {

constexpr int kVertices = 1000;  // several chunks of the norm, the last one not full
const std::vector<double> kWeights{0.3, -1.2, 0.0, 2.5};

OpenClDeviceInfo device() {
    std::string why;
    const auto info = chooseOpenClDevice({}, why);
    if (!info) throw std::runtime_error(why);
    return *info;
}

template <int Dim>
void fill(StageVectors<Dim>& stages) {
    std::mt19937 random(3);
    stages.begin(randomField<Dim>(random, kVertices), 4);
    for (int i = 0; i < 4; ++i) stages.setSlope(i, randomField<Dim>(random, kVertices));
}

template <int Dim>
void compare() {
    const auto host = makeHostStages<Dim>(), onDevice = makeOpenClStages<Dim>(device());
    fill(*host);
    fill(*onDevice);
    for (std::size_t count = 0; count <= kWeights.size(); ++count) {
        const std::span<const double> weights(kWeights.data(), count);
        const Points<Dim> a = host->combined(0.1, weights), b = onDevice->combined(0.1, weights);
        // A few roundings of numbers below 10.
        QVERIFY((a - b).cwiseAbs().maxCoeff() < 1e-14);
        QVERIFY(std::abs(host->greatestError(0.1, weights) - onDevice->greatestError(0.1, weights)) < 1e-14);
    }
}

}  // namespace

void TestOpenClStages::agreeWithTheProcessor_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("2D") << 2;
    QTest::newRow("3D") << 3;
}

void TestOpenClStages::agreeWithTheProcessor() {
    QFETCH(int, dimension);
    dimension == 2 ? compare<2>() : compare<3>();
}

void TestOpenClStages::notANumberIsSeen() {
    for (int where : {0, 700, kVertices - 1}) {
        const auto host = makeHostStages<2>(), onDevice = makeOpenClStages<2>(device());
        for (auto* stages : {host.get(), onDevice.get()}) {
            fill(*stages);
            Points<2> k = Points<2>::Zero(2, kVertices);
            k(1, where) = std::nan("");
            stages->setSlope(0, k);
            QVERIFY(std::isnan(stages->greatestError(1, kWeights)));
        }
    }
}

/// A step of four stages: y and four slopes up, three shapes and a norm's chunks down.
void TestOpenClStages::vectorsGoToTheDeviceOnce() {
    StageCopies copied;
    const auto stages = makeOpenClStages<2>(device(), &copied);
    fill(*stages);
    const std::size_t vector = 2 * kVertices * sizeof(double);
    QCOMPARE(copied.toDevice, 5 * vector);
    QCOMPARE(copied.fromDevice, std::size_t(0));
    stages->combined(0.5, std::span(kWeights).first(1));
    stages->combined(0.5, std::span(kWeights).first(2));
    stages->combined(1, std::span(kWeights).first(3));
    stages->greatestError(1, kWeights);
    QCOMPARE(copied.toDevice, 5 * vector + (1 + 2 + 3 + 4) * sizeof(double));
    QVERIFY(copied.fromDevice < 3 * vector + 100);
}

void TestOpenClStages::failingDeviceIsReplaced() {
    class Lost final : public StageVectors<2> {
      public:
        explicit Lost(int calls) : m_calls(calls) {}
        void begin(const Points<2>&, int) override { use(); }
        void setSlope(int, const Points<2>&) override { use(); }
        Points<2> combined(double, std::span<const double>) override { return use(); }
        double greatestError(double, std::span<const double>) override { return use()(0, 0); }

      private:
        Points<2> use() {
            if (m_calls-- <= 0) throw DeviceFailure("device lost");
            return Points<2>::Zero(2, 1);
        }
        int m_calls;
    };
    const auto host = makeHostStages<2>();
    fill(*host);
    for (int calls = 0; calls <= 5; ++calls) {  // begin and four slopes, then the sum
        int notices = 0;
        const auto stages =
            makeFailsafeStages<2>(std::make_unique<Lost>(calls), [&](const std::string&) { ++notices; });
        fill(*stages);
        QVERIFY(stages->combined(0.1, kWeights) == host->combined(0.1, kWeights));
        QCOMPARE(stages->greatestError(0.1, kWeights), host->greatestError(0.1, kWeights));
        QCOMPARE(notices, 1);
    }
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
    makeOpenClStages<2>(device());
    const auto one = times();
    makeOpenClStages<2>(device());
    const auto same = times();
    makeOpenClStages<3>(device());
    const auto two = times();
    before.isNull() ? qunsetenv("XDG_CACHE_HOME") : qputenv("XDG_CACHE_HOME", before);
    QCOMPARE(one.size(), 1);
    QVERIFY(one == same);  // neither a second file nor the first written again
    QCOMPARE(two.size(), 2);
}

QTEST_GUILESS_MAIN(TestOpenClStages)
#include "test_opencl_stages.moc"
