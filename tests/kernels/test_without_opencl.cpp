#include <QTest>

#include "core/assembly/assembly_plan.h"
#include "core/base/error.h"
#include "kernels/back_end_choice.h"

using namespace wend;

/// In a build without OpenCL the processor does everything, and a request for a device gets the reason why
/// there is none.
class TestWithoutOpenCl : public QObject {
    Q_OBJECT
  private slots:
    void thereAreNoDevices();
    void theProcessorComputes();
    void openClIsRefused();

  private:
    static std::unique_ptr<BackEnd<2>> make(BackEndKind kind);
};

std::unique_ptr<BackEnd<2>> TestWithoutOpenCl::make(BackEndKind kind) {
    SimplicialMesh<2> mesh;
    mesh.points.resize(2, 3);
    mesh.points << 0, 1, 0, 0, 0, 1;
    mesh.cells = {{0, 1, 2}};
    const auto plan = std::make_shared<const AssemblyPlan<2>>(makeAssemblyPlan(mesh, true));
    return backEndFactory<2>(kind)(plan, mesh, Material<2>::uniform(1, phi::kMetr), 1);
}

void TestWithoutOpenCl::thereAreNoDevices() {
    QVERIFY(openClDevices().devices.empty());
    QCOMPARE(openClDevices().problem, std::string("built without OpenCL"));
}

void TestWithoutOpenCl::theProcessorComputes() {
    for (const BackEndKind kind : {BackEndKind::Automatic, BackEndKind::Cpu})
        QCOMPARE(make(kind)->name(), std::string("cpu"));
    QVERIFY(!cellPainters(BackEndKind::Automatic));
}

void TestWithoutOpenCl::openClIsRefused() {
    try {
        make(BackEndKind::OpenCl);
        QFAIL("not refused");
    } catch (const InputError& error) {
        QVERIFY(std::string(error.what()).ends_with("no OpenCL device: built without OpenCL"));
    }
}

QTEST_APPLESS_MAIN(TestWithoutOpenCl)
#include "test_without_opencl.moc"
