// A bar is twisted and bent by half a turn: no cell is inverted, and each energy preserves the quantity that
// it is named for.

#include <QtTest>
#include <map>

#include "app/engine/shape/held_border.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/design.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/integration/integration_options.h"
#include "tests/app/cli/cli_harness.h"

using namespace wend;

class TestSolidBend : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void keepsItsName_data();
    void keepsItsName();
    void samples_data();
    void samples();

  private:
    QTemporaryDir m_folder;
};

namespace {

/// Returns a box of 6 × 1 × 1 with squares of 1 / n, as an OBJ file of quads.
std::string barText(int n) {
    std::map<std::array<int, 3>, int> ids;
    std::string vertices, faces;
    const std::array<int, 3> counts{6 * n, n, n};
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [entry, isNew] = ids.try_emplace(at, static_cast<int>(ids.size()) + 1);
        if (isNew) {
            vertices += "v";
            for (int x : at) vertices += " " + std::to_string(static_cast<double>(x) / n);
            vertices += "\n";
        }
        return " " + std::to_string(entry->second);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < counts[(axis + 1) % 3]; ++i)
                for (int j = 0; j < counts[(axis + 2) % 3]; ++j) {
                    const auto corner = [&](int u, int v) {
                        std::array<int, 3> at{};
                        at[axis] = side * counts[axis];
                        at[(axis + 1) % 3] = i + u;
                        at[(axis + 2) % 3] = j + v;
                        return vertex(at);
                    };
                    const std::string a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    faces += "f" + (side == 1 ? a + b + c + d : d + c + b + a) + "\n";
                }
    return vertices + faces;
}

const std::string kLeft = "{'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [0.1, 2, 2]}}}";
const std::string kRight = "{'at': {'region': {'box': {'min': [5.9, -1, -1], 'max': [7, 2, 2]}}}";

std::string turning(const std::string& centre, const std::string& axis, double angle) {
    return ", 'motion': [{'kind': 'rotate', 'centre': " + centre + ", 'axis': " + axis +
           ", 'angle': " + std::to_string(angle) + "}]}";
}

Distortion deformed(const Project& project, const std::string& folder) {
    const Shape<3> shape = std::get<Shape<3>>(loadShape(project, folder));
    Deformer<3> deformer(shape.rest, shape.material, heldHandles(project, shape), integrationOf(project),
                         BackEndKind::Cpu);
    const AdvanceResult result = deformer.advance(endOf(project));
    if (result.outcome != Outcome::Done) throw InputError(result.message);
    if (deformer.statistics().constraintError > 1e-12) throw InputError("a handle is off its way");
    return distortion(*shape.rest, deformer.state().points);
}

std::array<Distortion, 4> ofNamedEnergies(Project& project, const std::string& folder) {
    std::array<Distortion, 4> errors;
    int at = 0;
    for (double phi : {phi::kEquia, phi::kMetr, phi::kAkvf, phi::conformal(3)}) {
        designOf(project).material.phi = phi;
        errors[at++] = deformed(project, folder);
    }
    return errors;
}

/// Checks the order found in the paper (section 5): of the four, EQUIA has the least error of volume, METR of
/// length (up to the factor `slack`), CONF of angle.
void requireOrder(const std::array<Distortion, 4>& errors, double slack) {
    for (const Distortion& error : errors) {
        QCOMPARE(error.flips, 0);
        QVERIFY(error.minDet > 0);
    }
    const auto minimum = [&](double Distortion::*total) {
        int best = 0;
        for (int k = 1; k < 4; ++k)
            if (errors[k].*total < errors[best].*total) best = k;
        return best;
    };
    QCOMPARE(minimum(&Distortion::totalVolume), 0);
    const double minMetric = errors[minimum(&Distortion::totalMetric)].totalMetric;
    QVERIFY2(errors[1].totalMetric <= slack * minMetric,
             qPrintable(QString::number(errors[1].totalMetric / minMetric)));
    QVERIFY(errors[0].totalMetric > errors[1].totalMetric);
    QCOMPARE(minimum(&Distortion::totalAngle), 3);
}

}  // namespace

void TestSolidBend::initTestCase() {
    put(m_folder.path(), "bar.obj", barText(3));
}

void TestSolidBend::keepsItsName_data() {
    QTest::addColumn<QString>("handles");
    QTest::addColumn<double>("slack");
    const double pi = 3.14159265358979;
    const std::string along = "[1, 0, 0]", across = "[0, 1, 0]";
    // Torsion is shear without change of volume whatever the energy: three of them hardly differ in length.
    QTest::newRow("twist") << QString::fromStdString(kLeft + "}, " + kRight +
                                                     turning("[6, 0.5, 0.5]", along, pi))
                           << 1.06;
    // Each end rotates about the point that takes it to the end of half a circle.
    QTest::newRow("bend") << QString::fromStdString(kLeft + turning("[1.5, 0.5, 0.91]", across, pi / 2) +
                                                    ", " + kRight +
                                                    turning("[4.5, 0.5, 0.91]", across, -pi / 2))
                          << 1.0;
}
void TestSolidBend::keepsItsName() {
    QFETCH(QString, handles);
    QFETCH(double, slack);
    const std::string folder = m_folder.path().toStdString();
    const std::string text =
        "{'format': 'wend', 'version': 1, 'domain': {'surface': 'bar.obj', 'vertices': 400}, "
        "'handles': [" +
        handles.toStdString() + "]}";
    requireOrder(ofNamedEnergies(*parseProject(json(text), folder + "/p.wend").project, folder), slack);
}

void TestSolidBend::samples_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"bar", "eagle"}) QTest::newRow(name) << name;
}
/// The samples have 1500 to 5000 vertices, handles in the right places, and a motion that arrives.
void TestSolidBend::samples() {
    QFETCH(QString, name);
    const std::string folder = WEND_SOURCE_DIR "/resources/samples";
    const LoadedProject loaded = readProject(folder + "/" + name.toStdString() + ".wend");
    QVERIFY(loaded.warnings.empty());
    const Shape<3> shape = std::get<Shape<3>>(loadShape(*loaded.project, folder));
    QVERIFY(shape.notices.empty());
    QVERIFY(shape.rest->vertexCount() >= 1500 && shape.rest->vertexCount() <= 5000);
    const Distortion error = deformed(*loaded.project, folder);
    QCOMPARE(error.flips, 0);
    QVERIFY(error.minDet > 0.5);
}

QTEST_GUILESS_MAIN(TestSolidBend)
#include "test_solid_bend.moc"
