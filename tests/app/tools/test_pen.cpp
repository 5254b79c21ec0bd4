#include <QSignalSpy>
#include <QStatusBar>
#include <QUndoStack>

#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/pins/pin_shapes.h"
#include "app/tools/tool.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The pen of the step Animate, with the mouse in a window that shows a picture or a solid.
class TestPen : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void pointsBecomeThePath_data() { pictureAndSolid(); }
    void pointsBecomeThePath();
    void partsOfAPathAreTakenBack_data() { pictureAndSolid(); }
    void partsOfAPathAreTakenBack();
    void doubleClicksEnd_data() { pictureAndSolid(); }
    void doubleClicksEnd();
    void otherPathsGoOnBeside();
    void selectedPinsGoTogether();
    void noPathIsDrawnForFixedPins();
    void otherChangesGiveUp();
    void turnedViewsLeadIntoDepth();
    void shiftKeepsToSteps_data() { pictureAndSolid(); }
    void shiftKeepsToSteps();
    void altBreaksAPoint_data() { pictureAndSolid(); }
    void altBreaksAPoint();

  private:
    static void pictureAndSolid();
    template <int Dim>
    const Pin& handle(int h) {
        return m_f->session().document().design().handles.at(h);
    }
    bool isSolid() { return m_f->session().document().dimension() == 3; }
    bool open(int dimension);
    QPoint pin(int h);
    void press(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
    void moveTo(const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void isPath(const std::vector<QPointF>& expected);
    void click(const QPoint& at);
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&m_f->view(), key, modifiers);
    }
    int steps() { return m_f->session().document().undoStack()->index(); }
    int motions(int h);
    std::vector<QPointF> path(int h);

    std::unique_ptr<SolidFixture> m_f;
};

void TestPen::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestPen::pictureAndSolid() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

/// Opens the file with a pin at either end, the pen chosen and nothing selected.
bool TestPen::open(int dimension) {
    if (!m_f->openProject(dimension, 400)) return false;
    ShapeSession& session = m_f->session();
    if (dimension == 3) {
        if (!m_f->holdEnds()) return false;
    } else {
        session.addPin({40, 80, 0});
        session.addPin({200, 80, 0});
        m_f->window().canvas().zoomTo(2);
    }
    session.selection().clear();
    if (!settle(session)) return false;
    m_f->window().tools().setMode(Mode::Animate);
    settleLayout(m_f->view());  // the tracks take their room
    key(Qt::Key_P);
    return m_f->window().tools().isChosen("pen");
}

QPoint TestPen::pin(int h) {
    if (isSolid()) return m_f->at(m_f->pin(h));
    for (const auto& view : m_f->session().gestures().pins())
        if (view.handle == h) return m_f->window().canvas().onScreen(view.centre).toPoint();
    return {};
}

void TestPen::press(const QPoint& at, Qt::KeyboardModifiers modifiers) {
    QTest::mouseMove(&m_f->view(), at);
    QTest::mousePress(&m_f->view(), Qt::LeftButton, modifiers, at);
}

void TestPen::moveTo(const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QMouseEvent move(QEvent::MouseMove, to, m_f->view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     modifiers);
    QCoreApplication::sendEvent(&m_f->view(), &move);
}

void TestPen::click(const QPoint& at) {
    press(at);
    QTest::mouseRelease(&m_f->view(), Qt::LeftButton, {}, at);
}

int TestPen::motions(int h) {
    return static_cast<int>(isSolid() ? handle<3>(h).motions.size() : handle<2>(h).motions.size());
}

/// Returns the control points of the last curve on the screen.
std::vector<QPointF> TestPen::path(int h) {
    std::vector<QPointF> seen;
    if (isSolid()) {
        if (const auto* curve = std::get_if<CurveMotion<3>>(&handle<3>(h).motions.back().kind))
            for (const Vec3& p : curve->points) seen.push_back(m_f->canvas().toWidget(p));
    } else if (const auto* curve = std::get_if<CurveMotion<3>>(&handle<2>(h).motions.back().kind)) {
        for (const Vec3& p : curve->points) seen.push_back(m_f->window().canvas().toWidget(inPlane(p)));
    }
    return seen;
}

void TestPen::isPath(const std::vector<QPointF>& expected) {
    const auto seen = path(1);
    QCOMPARE(seen.size(), expected.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        QVERIFY2(QLineF(seen[i], expected[i]).length() < 1, qPrintable(QString::number(i)));
}

/// A corner and a smooth end are where the mouse was, and the pin arrives there, in one step.
void TestPen::pointsBecomeThePath() {
    QFETCH(int, dimension);
    QVERIFY(open(dimension));
    const int before = steps();
    const QPoint start = pin(1), corner = start + QPoint(-10, 50), end = start + QPoint(-60, 70),
                 out(-30, -10);
    click(start);
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>{1});
    click(corner);
    press(end);
    moveTo(end + out / 2);
    moveTo(end + out);
    m_f->picture(QStringLiteral("pen-%1").arg(dimension));
    QTest::mouseRelease(&m_f->view(), Qt::LeftButton, {}, end + out);
    QCOMPARE(steps(), before);
    key(Qt::Key_Return);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(steps(), before + 1);
    QCOMPARE(motions(0), 0);
    QCOMPARE(motions(1), 1);
    isPath({start, QPointF(start) + (corner - start) / 3.0, corner - (corner - start) / 3.0, corner,
            corner + (QPointF(end - out) - corner) / 3.0, end - out, end});
    QCOMPARE(m_f->session().playback().time(), 0.0);  // it is seen by playing it
    m_f->session().playback().setTime(m_f->session().playback().end());
    QVERIFY(settle(m_f->session()));
    QVERIFY(QLineF(pin(1), end).length() < 3);
    m_f->session().document().undoStack()->undo();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(motions(1), 0);
}

/// Backspace and Undo remove the last point; Esc removes the whole path.
void TestPen::partsOfAPathAreTakenBack() {
    QFETCH(int, dimension);
    QVERIFY(open(dimension));
    const int before = steps();
    const QPoint start = pin(1);
    click(start);
    for (const QPoint& by : {QPoint(0, 40), QPoint(-30, 60), QPoint(-60, 60)}) click(start + by);
    key(Qt::Key_Backspace);
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(steps(), before);
    QCOMPARE(m_f->session().pins().count(), 2);
    click(start + QPoint(-20, 50));
    key(Qt::Key_Enter);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(path(1).size(), std::size_t(7));
    QVERIFY(QLineF(path(1).back(), start + QPoint(-20, 50)).length() < 1);
    QVERIFY(settle(m_f->session()));
    click(pin(1));
    click(start + QPoint(-20, 20));
    key(Qt::Key_Escape);
    key(Qt::Key_Return);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>{1});
    key(Qt::Key_Escape);
    QVERIFY(m_f->session().selection().isEmpty());
}

/// The second click on a point adds no further one.
void TestPen::doubleClicksEnd() {
    QFETCH(int, dimension);
    QVERIFY(open(dimension));
    const int before = steps();
    const QPoint end = pin(1) + QPoint(-20, 50);
    m_f->session().selection().set({1});
    click(end);  // of the pin that is selected
    QTest::mouseDClick(&m_f->view(), Qt::LeftButton, {}, end);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(path(1).size(), std::size_t(4));
    key(Qt::Key_Return);
    QCOMPARE(steps(), before + 1);
}

/// Paths that begin at the same time move together; at the end of timed motions a path makes the film longer,
/// as any drag does.
void TestPen::otherPathsGoOnBeside() {
    QVERIFY(open(2));
    const auto draw = [this](int h, const QPoint& by) {
        const QPoint start = pin(h);
        click(start);
        click(start + by);
        key(Qt::Key_Return);
        QVERIFY(settle(m_f->session()));
    };
    const double end = m_f->session().document().end();
    draw(1, {-10, 60});
    draw(0, {10, 40});
    for (const int h : {0, 1}) {
        QCOMPARE(motions(h), 1);
        QVERIFY(handle<2>(h).motions[0].start == 0 && handle<2>(h).motions[0].end == end);
    }
    m_f->session().playback().setTime(0.5 * end);
    QVERIFY(settle(m_f->session()));
    draw(1, {-30, 0});  // instead of what it did from then on
    QCOMPARE(motions(1), 2);
    QVERIFY(std::abs(handle<2>(1).motions[1].start - 0.5 * end) < 0.01 * end);
    QCOMPARE(handle<2>(1).motions[1].end, end);
    QCOMPARE(handle<2>(0).motions[0].end, end);
    m_f->session().playback().setTime(end);
    QVERIFY(settle(m_f->session()));
    draw(1, {0, -20});  // the paths have times of their own by now, which stay
    QCOMPARE(motions(1), 3);
    QCOMPARE(handle<2>(1).motions[1].end, end);
    QCOMPARE(handle<2>(0).motions[0].end, end);
    QCOMPARE(handle<2>(1).motions[2].start, end);
    QCOMPARE(handle<2>(1).motions[2].end, m_f->session().document().end());
    QVERIFY(m_f->session().document().end() > end);
}

void TestPen::selectedPinsGoTogether() {
    QVERIFY(open(2));
    m_f->session().selection().set({0, 1});
    const QPoint middle = (pin(0) + pin(1)) / 2;
    click(middle + QPoint(0, 40));
    key(Qt::Key_Return);
    QVERIFY(settle(m_f->session()));
    for (const int h : {0, 1}) {
        const auto seen = path(h);
        QCOMPARE(seen.size(), std::size_t(4));
        QVERIFY(QLineF(seen.front(), pin(h)).length() < 1);
        QVERIFY(QLineF(seen.back(), pin(h) + QPoint(0, 40)).length() < 2);
    }
}

/// Nothing is drawn beside all pins with none selected, or from a locked pin; a message says so.
void TestPen::noPathIsDrawnForFixedPins() {
    QVERIFY(open(2));
    QSignalSpy told(&m_f->session().document(), &Document::notice);
    click(pin(1) + QPoint(-60, 0));
    QVERIFY(told.size() == 1 && told.last().first().toString().contains(QStringLiteral("Click the pin")));
    Document& document = m_f->session().document();
    document.changeDesign(QStringLiteral("Lock"), withTraits(document.design(), {1}, [](PinTraits& traits) {
                              traits.locked = true;
                          }));
    QVERIFY(settle(m_f->session()));
    const int before = steps();
    click(pin(1));
    QVERIFY(told.size() == 2 && told.last().first().toString().contains(QStringLiteral("locked")));
    click(pin(1) + QPoint(-60, 0));
    key(Qt::Key_Return);
    QCOMPARE(steps(), before);
    click(pin(0));  // what was said holds no more
    QVERIFY(told.last().first().toString().isEmpty());
}

/// Changing the time, the tool or the project removes the unfinished path.
void TestPen::otherChangesGiveUp() {
    QVERIFY(open(2));
    const QPoint start = pin(1);
    const auto begin = [&] {
        click(start);
        click(start + QPoint(-20, 40));
    };
    begin();
    key(Qt::Key_V);
    key(Qt::Key_P);
    key(Qt::Key_Return);
    QCOMPARE(motions(1), 0);
    begin();
    Document& document = m_f->session().document();
    renameHandle(document, QStringLiteral("Name"), 0, "foot");
    QVERIFY(settle(m_f->session()));
    key(Qt::Key_Return);
    QCOMPARE(motions(1), 0);
}

/// The view is rotated between the points of a path in space, each of which is as deep as the one before.
void TestPen::turnedViewsLeadIntoDepth() {
    QVERIFY(open(3));
    const Vec3 start = m_f->pin(1);
    click(pin(1));
    click(pin(1) + QPoint(-20, -50));
    m_f->actions().top->trigger();
    const QPoint above = pin(1);
    click(above + QPoint(-20, -60));
    key(Qt::Key_Return);
    QVERIFY(settle(m_f->session()));
    const auto& points = std::get<CurveMotion<3>>(handle<3>(1).motions.at(0).kind).points;
    QCOMPARE(points.size(), std::size_t(7));
    QVERIFY((points.front() - start).norm() < 1e-9);
    QVERIFY(std::abs(points[3].y() - start.y()) < 1e-6 && points[3].z() > start.z() + 0.1);
    QVERIFY(std::abs(points[6].z() - points[3].z()) < 1e-6 && std::abs(points[6].y() - start.y()) > 0.1);
}

/// 7 pixels beside a vertical line, the point is on the line. Pulling near the diagonal gives the point a
/// direction along the diagonal.
void TestPen::shiftKeepsToSteps() {
    QFETCH(int, dimension);
    QVERIFY(open(dimension));
    const QPoint start = pin(1), end = start + QPoint(0, 60), beside = end + QPoint(7, 0);
    click(start);
    press(beside, Qt::ShiftModifier);
    moveTo(beside + QPoint(-24, 16), Qt::ShiftModifier);
    QTest::mouseRelease(&m_f->view(), Qt::LeftButton, Qt::ShiftModifier, beside + QPoint(-24, 16));
    key(Qt::Key_Return);
    const QPointF in = end + QPointF(20, -20);
    isPath({start, start + (in - start) / 3, in, end});
}

/// From the press of Alt on, the direction behind the point stays.
void TestPen::altBreaksAPoint() {
    QFETCH(int, dimension);
    QVERIFY(open(dimension));
    const QPoint start = pin(1), joint = start + QPoint(-10, 50), end = joint + QPoint(-60, 0);
    click(start);
    press(joint);
    moveTo(joint + QPoint(-18, 30));
    moveTo(joint + QPoint(-24, -30), Qt::AltModifier);
    QTest::mouseRelease(&m_f->view(), Qt::LeftButton, Qt::AltModifier, joint + QPoint(-24, -30));
    click(end);
    key(Qt::Key_Return);
    const QPointF in = joint + QPointF(18, -30), out = joint + QPointF(-24, -30);
    isPath({start, start + (in - start) / 3, in, joint, out, end + (out - end) / 3, end});
}

QTEST_MAIN(TestPen)
#include "test_pen.moc"
