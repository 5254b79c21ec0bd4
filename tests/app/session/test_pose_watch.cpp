// Faults of the shown pose are reported, marked and found, in solids and in the plane.
#include <QToolButton>

#include "app/panels/distortion_panel.h"
#include "app/style/marks.h"
#include "core/mesh/mesh_of_file.h"
#include "tests/app/cli/cli_harness.h"
#include "tests/support/bar.h"

using namespace wend;
using namespace wend::test;

class TestPoseWatch : public QObject {
    Q_OBJECT
  private slots:
    void init() { m_f = std::make_unique<SolidFixture>(); }
    void cleanup() { m_f.reset(); }
    void placesAreReportedAndMarked_data() { dimensions(); }
    void placesAreReportedAndMarked() { BOTH(placesAreReportedAndMarked); }
    void blownUpCellsAreReported_data() { dimensions(); }
    void blownUpCellsAreReported() { BOTH(blownUpCellsAreReported); }
    void movingShapesAreNotChecked();

  private:
    template <int Dim>
    bool open(const std::string& motion);
    template <int Dim>
    void placesAreReportedAndMarked();
    template <int Dim>
    void blownUpCellsAreReported();
    QToolButton& chip(const char* name) {
        return *m_f->window().findChild<QToolButton*>(QString::fromLatin1(name));
    }
    bool isKnown(const char* name) {
        return QTest::qWaitFor([&] { return chip(name).text() != QStringLiteral("–"); }, 20000);
    }
    template <int Dim>
    int redPixels();

    QTemporaryDir m_folder;
    std::unique_ptr<SolidFixture> m_f;
};

namespace {

template <int Dim>
SimplicialMesh<Dim> body() {
    if constexpr (Dim == 2)
        return stripMesh(2, 2);
    else
        return barMesh(2);
}

/// Returns the mesh with a copy of itself, 8 to the right.
template <int Dim>
SimplicialMesh<Dim> pair() {
    SimplicialMesh<Dim> mesh = body<Dim>();
    const int count = mesh.vertexCount();
    mesh.points.conservativeResize(Eigen::NoChange, 2 * count);
    mesh.points.rightCols(count) = mesh.points.leftCols(count).colwise() + 8 * Vec<Dim>::UnitX();
    for (Cell<Dim> cell : body<Dim>().cells) {
        for (int& v : cell) v += count;
        mesh.cells.push_back(cell);
    }
    return mesh;
}

}  // namespace

/// Returns handles of which the first holds still and the second moves.
template <int Dim>
bool TestPoseWatch::open(const std::string& motion) {
    const char* name = Dim == 2 ? "pair.obj" : "pair.mesh";
    writeMesh<Dim>(m_folder.filePath(name).toStdString(), pair<Dim>());
    const auto part = [&](const char* from, const char* to) {
        return Dim == 3 ? std::string("{'at': {'region': {'box': {'min': [") + from + ", -1, -1], 'max': [" +
                              to + ", 3, 3]}}}"
                        : std::string("{'at': {'region': {'polygon': [[") + from + ", -1], [" + to +
                              ", -1], [" + to + ", 3], [" + from + ", 3]]}}";
    };
    putProject(m_folder.path(), "pair.wend",
               std::string("'domain': {'mesh': '") + name + "'}, 'handles': [" + part("-1", "3") + "}, " +
                   part("7", "11") + ", 'motion': [" + motion + "]}]");
    m_f->window().openPath(m_folder.filePath(QStringLiteral("pair.wend")));
    return QTest::qWaitFor([&] { return !m_f->session().document().isEmpty(); }, 20000) &&
           settle(m_f->session());
}

/// Returns how far a pixel is towards the colour of faults, in any light.
template <int Dim>
int TestPoseWatch::redPixels() {
    QImage image;
    if constexpr (Dim == 3) {
        image = m_f->canvas().grabFramebuffer();
    } else {
        ShapeCanvas& canvas = m_f->window().canvas();
        if (!QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000)) return -1;
        image = canvas.grab().toImage();
    }
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += c.red() > 2.2 * c.green() && c.red() > 2 * c.blue() && c.red() > 90;
        }
    return count;
}

/// A corner of the second body enters the first: one place of a solid, two points of an outline.
template <int Dim>
void TestPoseWatch::placesAreReportedAndMarked() {
    QVERIFY(open<Dim>(Dim == 2 ? "{'kind': 'translate', 'by': [-7.13, 0.71]}"
                               : "{'kind': 'translate', 'by': [-7.13, 0.71, 0.53]}"));
    QVERIFY(isKnown("crossings"));
    QCOMPARE(chip("crossings").text(), Dim == 2 ? QStringLiteral("2 places") : QStringLiteral("1 place"));
    QVERIFY(chip("crossings").isEnabled() && !chip("crossings").toolTip().isEmpty());
    QCOMPARE(chip("blownUp").text(), QStringLiteral("nowhere"));
    QVERIFY(!chip("blownUp").isEnabled());

    m_f->window().actions().showMap->setChecked(false);
    const int plain = redPixels<Dim>();
    chip("crossings").click();
    QVERIFY(m_f->window().actions().showMap->isChecked());
    const int marked = redPixels<Dim>();
    QVERIFY2(plain >= 0 && marked > plain + 100, qPrintable(QStringLiteral("%1, %2").arg(plain).arg(marked)));

    const auto faults = m_f->window().distortionPanel().watch().faults<Dim>();
    const auto& canvas = Bar<Dim>::canvas(*m_f);
    for (const auto& place : faults->crossings) {
        QVERIFY(QLineF(canvas.toWidget(place.at), QRectF(canvas.rect()).center()).length() < 2);
        chip("crossings").click();  // the next, or the first again
    }
    m_f->session().playback().setTime(0);
    QCOMPARE(chip("crossings").text(), QStringLiteral("–"));
    QVERIFY(isKnown("crossings"));
    QCOMPARE(chip("crossings").text(), QStringLiteral("nowhere"));
    QVERIFY(redPixels<Dim>() < marked - 100);
}

template <int Dim>
void TestPoseWatch::blownUpCellsAreReported() {
    QVERIFY(open<Dim>(
        Dim == 2 ? "{'kind': 'curve', 'interpolation': 'polyline', 'points': [[9, 1], [19, 1]], 'scale': 4}"
                 : "{'kind': 'curve', 'interpolation': 'polyline', 'points': [[9, 1, 1], [19, 1, 1]], "
                   "'scale': 4}"));
    QVERIFY(isKnown("blownUp"));
    QCOMPARE(chip("crossings").text(), QStringLiteral("nowhere"));
    QCOMPARE(chip("blownUp").text(), QStringLiteral("%1 cells").arg(body<Dim>().cells.size()));
    const auto faults = m_f->window().distortionPanel().watch().faults<Dim>();
    QVERIFY(std::abs(faults->blown.at(0).ratio - std::pow(4, Dim)) < 1e-6);
    m_f->window().actions().showMap->setChecked(false);
    const int plain = redPixels<Dim>();
    chip("blownUp").click();
    QVERIFY(redPixels<Dim>() > plain + 1000);
}

/// No fault is reported while the shape is dragged or plays.
void TestPoseWatch::movingShapesAreNotChecked() {
    QVERIFY(open<2>("{'kind': 'translate', 'by': [-7.13, 0.71]}"));
    QVERIFY(isKnown("crossings"));
    m_f->session().selection().set({1});
    m_f->session().gestures().begin();
    m_f->session().gestures().moveBy({0.5, 0, 0});
    QTRY_COMPARE(chip("crossings").text(), QStringLiteral("–"));
    QTRY_VERIFY_WITH_TIMEOUT(!m_f->window().distortionPanel().watch().isBusy(), 20000);
    QCoreApplication::sendPostedEvents();
    QCOMPARE(chip("crossings").text(), QStringLiteral("–"));
    m_f->session().gestures().end(0.01);
    QVERIFY(settle(m_f->session()));
    QVERIFY(isKnown("crossings"));
    QCOMPARE(chip("crossings").text(), QStringLiteral("2 places"));
}

QTEST_MAIN(TestPoseWatch)
#include "test_pose_watch.moc"
