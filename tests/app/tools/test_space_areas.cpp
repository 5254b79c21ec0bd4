#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>

#include "app/engine/motion/places.h"
#include "app/panels/handle_panel.h"
#include "app/panels/measure_panel.h"
#include "app/panels/paint_panel.h"
#include "app/project/design.h"
#include "app/project/edits/material_edits.h"
#include "app/tools/measure_tool.h"
#include "app/window/actions/pin_actions.h"
#include "core/motion/trajectory.h"
#include "tests/support/layers.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Manipulator, regions, measures and material of the 3D window, by real mouse and keys.
class TestSpaceAreas : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void ringsTurn();
    void ringsScale();
    void squaresMoveInAPlane();
    void keysLockAxes();
    void halfSpacesAreHeld();
    void regionsAreEditedByNumbers();
    void regionsChangeTheSelectedHandle();
    void controlClickTakesOneVertexAway();
    void measuresAtAnyPoint();
    void sizesAndValuesAreReported();
    void velocityIsTheFieldItself();
    void stiffAlongStrokeViewAndNumbers();

  private:
    QPoint centre() { return m_f->at(m_f->pin(1)); }
    Vec3 heldAt(int vertex) { return m_f->session().motion().frame<3>()->pose.col(vertex); }
    std::unique_ptr<SolidFixture> m_f;
};

void TestSpaceAreas::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->open());
}

void TestSpaceAreas::ringsTurn() {
    QVERIFY(m_f->holdEnds());
    QTest::keyClick(&m_f->canvas(), Qt::Key_R);
    QVERIFY(m_f->window().findChild<PinActions*>()->turn->isChecked());
    const auto held = m_f->session().pins().verticesOf(1);
    const Vec3 middle = m_f->pin(1);
    const auto angle = [&] {  // around y, of the corner that is farthest from the middle
        double most = 0;
        for (const int v : held) {
            const Vec3 rest = m_f->session().motion().frame<3>()->rest->points.col(v) - middle,
                       now = heldAt(v) - middle;
            if (std::hypot(rest.x(), rest.z()) < 0.1) continue;
            if (std::abs(rest.norm() - now.norm()) > 1e-6) return -1.0;
            most = std::max(
                most, std::acos(std::clamp(
                          Vec2(rest.x(), rest.z()).normalized().dot(Vec2(now.x(), now.z()).normalized()),
                          -1.0, 1.0)));
        }
        return most * 180 / M_PI;
    };
    // The ring around y faces the viewer: 68 pixels. The others cross it at its right and upper end.
    const QPoint c = centre();
    const auto onRing = [&](double degrees) {
        const double a = degrees * M_PI / 180;
        return c + QPointF(68 * std::cos(a), -68 * std::sin(a)).toPoint();
    };
    m_f->press(onRing(20));
    for (int a = 25; a <= 65; a += 5) QTest::mouseMove(&m_f->canvas(), onRing(a));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, onRing(65));
    QVERIFY(settle(m_f->session()));
    QVERIFY2(std::abs(angle() - 45) < 3, qPrintable(QString::number(angle())));
    m_f->picture(QStringLiteral("turned"));
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    m_f->press(onRing(30));
    m_f->moveTo(onRing(30), onRing(40));
    QTest::keyClicks(&m_f->canvas(), QStringLiteral("30"));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Return);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, onRing(40));
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::abs(angle() - 30) < 1e-6);
}

void TestSpaceAreas::ringsScale() {
    QVERIFY(m_f->holdEnds());
    QTest::keyClick(&m_f->canvas(), Qt::Key_S);
    QVERIFY(m_f->window().findChild<PinActions*>()->grow->isChecked());
    const auto held = m_f->session().pins().verticesOf(1);
    const Vec3 middle = m_f->pin(1);
    const auto& rest = m_f->session().motion().frame<3>()->rest->points;
    const Vec3 corner = rest.col(held.front());
    const auto factor = [&] { return (heldAt(held.front()) - middle).norm() / (corner - middle).norm(); };
    const QPoint c = centre();
    m_f->drag(c + QPoint(68, 0), c + QPoint(85, 0));
    QVERIFY(settle(m_f->session()));
    QVERIFY2(std::abs(factor() - 1.25) < 0.03, qPrintable(QString::number(factor())));
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    m_f->press(c + QPoint(0, 68));
    m_f->moveTo(c + QPoint(0, 68), c + QPoint(0, 74));
    QTest::keyClicks(&m_f->canvas(), QStringLiteral("1.5"));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Return);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, c + QPoint(0, 74));
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::abs(factor() - 1.5) < 1e-9);
}

void TestSpaceAreas::squaresMoveInAPlane() {
    QVERIFY(m_f->holdEnds());
    const Vec3 before = m_f->pin(1);
    const QPoint from = centre() + QPoint(31, -31);  // the square between x and z
    const double pixel = m_f->canvas().pixelSize(before);
    m_f->drag(from, from + QPoint(-30, -40));
    QVERIFY(settle(m_f->session()));
    const Vec3 way = m_f->pin(1) - before;
    QVERIFY(std::abs(way.y()) < 1e-9);
    QVERIFY(std::abs(way.x() + 30 * pixel) < 2 * pixel && std::abs(way.z() - 40 * pixel) < 2 * pixel);
}

void TestSpaceAreas::keysLockAxes() {
    QVERIFY(m_f->holdEnds());
    const Vec3 before = m_f->pin(1);
    const QPoint c = centre();
    m_f->press(c);
    m_f->moveTo(c, c + QPoint(-30, -30));
    QTest::keyClick(&m_f->canvas(), Qt::Key_X);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, c + QPoint(-30, -30));
    QVERIFY(settle(m_f->session()));
    const Vec3 way = m_f->pin(1) - before;
    QVERIFY(way.x() < -20 * m_f->canvas().pixelSize(before));
    QVERIFY(std::abs(way.y()) < 1e-9 && std::abs(way.z()) < 1e-9);
    // A rotation begun around y continues around x.
    QTest::keyClick(&m_f->canvas(), Qt::Key_R);
    const auto held = m_f->session().pins().verticesOf(1);
    const Vec3 middle = m_f->pin(1), corner = heldAt(held.front());
    const QPoint now = centre();
    m_f->press(now + QPoint(68, 0));
    m_f->moveTo(now + QPoint(68, 0), now + QPoint(66, -16));
    QTest::keyClicks(&m_f->canvas(), QStringLiteral("x90"));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Return);
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, now + QPoint(66, -16));
    QVERIFY(settle(m_f->session()));
    const Vec3 arm = corner - middle, turned(arm.x(), -arm.z(), arm.y());
    QVERIFY((heldAt(held.front()) - middle - turned).norm() < 1e-9);
}

void TestSpaceAreas::halfSpacesAreHeld() {
    QTest::keyClick(&m_f->canvas(), Qt::Key_P, Qt::ShiftModifier);
    QVERIFY(m_f->tool("side")->isChecked());
    const QPoint from = m_f->at({1.2, -0.5, 0});
    m_f->press(from);
    m_f->moveTo(from, from + QPoint(60, 0));
    m_f->picture(QStringLiteral("half-space"));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, from + QPoint(60, 0));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles().size(), std::size_t(1));
    const auto& half = std::get<HalfSpace<3>>(std::get<Region<3>>(m_f->handles()[0].at));
    QVERIFY((half.normal - Vec3::UnitX()).norm() < 0.05);  // as exactly as one drags
    QVERIFY(std::abs(half.point.x() - 1.2) < 2 * m_f->canvas().pixelSize(half.point));
    const auto frame = m_f->session().motion().frame<3>();
    const auto held = m_f->session().pins().verticesOf(0);
    QVERIFY(held.size() > 20 && static_cast<int>(held.size()) < frame->vertices / 2);
    for (const int v : held) QVERIFY(frame->rest->points(0, v) > 1.1);
}

void TestSpaceAreas::regionsAreEditedByNumbers() {
    const Region<3> ball = Ball<3>{{2, 0, 0}, 0.6};
    m_f->session().addHandle(ball, "Region");
    QVERIFY(settle(m_f->session()));
    auto* panel = m_f->window().findChild<RegionPanel*>();
    QVERIFY(panel && panel->isVisible());
    const auto count = [&] { return panel->findChild<QLabel*>(QStringLiteral("regionCount"))->text(); };
    const auto held = [&] { return m_f->session().pins().verticesOf(0).size(); };
    const std::size_t few = held();
    QVERIFY(few > 0 && count().endsWith(QStringLiteral(" ") + QString::number(few)));
    auto* kind = panel->findChild<QComboBox*>();
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Down);  // a box at the same place
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::holds_alternative<Box<3>>(std::get<Region<3>>(m_f->handles()[0].at)));
    const auto boxes = panel->findChildren<QDoubleSpinBox*>();  // the two rows, then the radius
    const auto type = [&](int which, const QString& text) {
        boxes[which]->setFocus();
        boxes[which]->selectAll();
        QTest::keyClicks(boxes[which], text);
        QTest::keyClick(boxes[which], Qt::Key_Return);
    };
    const int steps = m_f->session().document().undoStack()->count();
    type(0, QStringLiteral("1"));
    type(1, QStringLiteral("-1"));
    type(2, QStringLiteral("-1"));
    QVERIFY(settle(m_f->session()));
    const auto& box = std::get<Box<3>>(std::get<Region<3>>(m_f->handles()[0].at));
    QVERIFY(box.min == Vec3(1, -1, -1));
    QVERIFY(held() > few && count().endsWith(QStringLiteral(" ") + QString::number(held())));
    QVERIFY(m_f->session().document().undoStack()->count() <= steps + 1);  // one step for all
    m_f->actions().oblique->trigger();
    m_f->session().gestures().moveAtOnce(Grip{Grip::Kind::Turn, m_f->pin(0), Vec3::UnitX()}, {0.6, 0, 0});
    QVERIFY(settle(m_f->session()));
    m_f->picture(QStringLiteral("region"));
    type(0, QStringLiteral("50"));  // from 50 to 2.6: nothing is in it
    QVERIFY(count().contains(QStringLiteral("nothing")));
    QVERIFY(std::get<Box<3>>(std::get<Region<3>>(m_f->handles()[0].at)).min == Vec3(1, -1, -1));
}

void TestSpaceAreas::regionsChangeTheSelectedHandle() {
    QVERIFY(m_f->holdEnds());
    const auto before = m_f->session().pins().verticesOf(1);
    m_f->tool("ball")->trigger();
    const QPoint from = m_f->at({1.2, -0.5, 0});
    m_f->drag(from, from + QPoint(60, 0), Qt::ShiftModifier);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->handles().size(), std::size_t(2));
    QVERIFY(m_f->session().pins().verticesOf(1).size() > before.size());
    m_f->drag(from, from + QPoint(62, 0), Qt::ControlModifier);
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().pins().verticesOf(1).size() <= before.size());
}

void TestSpaceAreas::controlClickTakesOneVertexAway() {
    QVERIFY(m_f->holdEnds());
    const std::size_t before = m_f->session().pins().verticesOf(1).size();
    m_f->tool("rectangle")->trigger();
    const QPoint corner = m_f->at({1.99, -0.5, 0.49});
    m_f->click(corner, Qt::ControlModifier);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().pins().verticesOf(1).size(), before - 1);
    m_f->click(corner, Qt::ShiftModifier);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().pins().verticesOf(1).size(), before);
}

void TestSpaceAreas::measuresAtAnyPoint() {
    m_f->tool("measure")->trigger();
    const auto& tool = *static_cast<MeasureTool*>(m_f->canvas().viewport().tool());
    const Vec3 a(-1.13, -0.5, 0.11), b(0.71, -0.5, -0.23);  // no vertices
    m_f->click(m_f->at(a));
    m_f->click(m_f->at(b));
    const double told = tool.text().section(' ', 1, 1).remove(',').toDouble();
    const double pixel = m_f->canvas().pixelSize(a);
    QVERIFY2(std::abs(told - (b - a).norm()) < 3 * pixel, qPrintable(tool.text()));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Escape);
    QVERIFY(tool.text().isEmpty());
    m_f->click(m_f->at({-1.97, -0.5, 0.47}), Qt::ControlModifier);  // the corner itself
    m_f->click(m_f->at({1.97, -0.5, 0.47}), Qt::ControlModifier);
    QVERIFY2(tool.text().contains(QStringLiteral("length 4,")), qPrintable(tool.text()));
}

void TestSpaceAreas::sizesAndValuesAreReported() {
    QVERIFY(m_f->holdEnds());
    m_f->session().selection().set({0, 1});
    m_f->tool("measure")->trigger();
    auto* panel = m_f->window().findChild<MeasurePanel*>();
    QVERIFY(panel && panel->isVisible());
    const auto text = [&](const char* name) {
        return panel->findChild<QLabel*>(QString::fromLatin1(name))->text();
    };
    QVERIFY2(text("measureWhole").contains(QStringLiteral("4, at rest 4")), qPrintable(text("measureWhole")));
    QVERIFY(text("measureWhole").contains(QStringLiteral("18, at rest 18")));
    QVERIFY2(text("measurePart").contains(QStringLiteral("2, at rest 2")), qPrintable(text("measurePart")));
    QTest::mouseMove(&m_f->canvas(), m_f->at({0.3, -0.5, 0.1}));
    QVERIFY(
        QTest::qWaitFor([&] { return text("measureCell").contains(QStringLiteral("Stiffness")); }, 20000));
    QVERIFY(text("measurePoint").contains(QStringLiteral("-0.5")));
    m_f->picture(QStringLiteral("measures"));
    QTest::mouseMove(&m_f->canvas(), QPoint(4, 4));
    // The X server determines the pointer's place.
    QVERIFY(QTest::qWaitFor([&] { return text("measureCell").isEmpty(); }, 20000));
}

/// Between the times of frames the difference of poses deviates; the field does not.
void TestSpaceAreas::velocityIsTheFieldItself() {
    QVERIFY(m_f->holdEnds());
    ShapeSession& session = m_f->session();
    session.gestures().moveAtOnce(Grip{Grip::Kind::Turn, m_f->pin(1), Vec3::UnitX()}, {1.2, 0, 0});
    QVERIFY(settle(session));
    m_f->window().actions().showArrows->setChecked(true);
    for (const double time : {0.5, 1.0}) {
        session.playback().setTime(time);
        QVERIFY(QTest::qWaitFor([&] { return session.motion().hasVelocity(); }, 20000));
        const auto frame = session.motion().frame<3>();
        const Points3 v = session.motion().velocity();
        const Trajectory<3> way(m_f->handles()[1].motions.front());
        const auto moving = way.at(frame->time, Side::Before);
        for (const int i : session.pins().verticesOf(1))
            QVERIFY((v.col(i) - moving.velocity(frame->rest->points.col(i))).norm() < 1e-9);
        for (const int i : session.pins().verticesOf(0)) QVERIFY(v.col(i).norm() < 1e-9);
    }
    m_f->actions().oblique->trigger();
    session.playback().setTime(0.5);
    m_f->picture(QStringLiteral("velocity"));
}

void TestSpaceAreas::stiffAlongStrokeViewAndNumbers() {
    m_f->tool("comb")->trigger();
    auto* panel = m_f->window().findChild<PaintPanel*>();
    QVERIFY(panel->isVisible());
    auto* direction = panel->findChild<QComboBox*>();
    auto* stiffness = panel->findChild<QDoubleSpinBox*>(QStringLiteral("brushRatio"));
    stiffness->setValue(10);
    QList<QDoubleSpinBox*> boxes;
    for (auto* box : panel->findChildren<QDoubleSpinBox*>())
        if (box->accessibleName() == PaintPanel::tr("Direction in numbers")) boxes << box;
    std::vector<std::size_t> ends{0};  // of the strokes, which are all in one layer
    const auto regions = [&] { return regionsIn(m_f->session().document().design()); };
    const auto axes = [&](std::size_t stroke) {
        std::vector<Vec3> found;
        for (std::size_t i = ends[stroke]; i < ends[stroke + 1]; ++i)
            found.push_back(regions()[i].stiffness->axis);
        return found;
    };
    const auto stroke = [&](const Vec3& from, const Vec3& to) {
        m_f->drag(m_f->at(from), m_f->at(to));
        ends.push_back(regions().size());
        return settle(m_f->session());
    };
    const auto choose = [&](int index) {
        direction->setFocus();
        QTest::keyClick(direction, Qt::Key_Home);
        for (int i = 0; i < index; ++i) QTest::keyClick(direction, Qt::Key_Down);
        m_f->canvas().setFocus();
    };
    choose(0);  // along the stroke: aslant over the front
    QVERIFY(stroke({-1, -0.5, -0.3}, {1, -0.5, 0.3}));
    for (const Vec3& axis : axes(0)) QVERIFY(std::abs(axis.dot(Vec3(1, 0, 0.3).normalized())) > 0.99);
    choose(6);  // along the view
    QVERIFY(stroke({-1, -0.5, 0.2}, {-0.5, -0.5, 0.2}));
    for (const Vec3& axis : axes(1)) QVERIFY(std::abs(axis.y()) > 0.999);
    choose(5);
    boxes[0]->setValue(0);
    boxes[1]->setValue(3);
    boxes[2]->setValue(4);
    QVERIFY(stroke({0.5, -0.5, -0.2}, {1, -0.5, -0.2}));
    for (const Vec3& axis : axes(2)) QVERIFY((axis - Vec3(0, 0.6, 0.8)).norm() < 1e-9);
    QVERIFY(!m_f->session().motion().frame<3>()->material->anisotropy.empty());
    QCOMPARE(m_f->session().document().design().material.layers.size(), std::size_t(1));
    // Another ratio leaves every direction of a stroke unchanged.
    const auto before = axes(0);
    QVERIFY(before.size() > 1);
    MaterialLayer changed = m_f->session().document().design().material.layers[0];
    setLayerPaint(changed, MaterialPaint{{}, Stiffness{Vec3::UnitZ(), 3}}, true);
    QCOMPARE(valuesOf(changed).paint.stiffness->axis, before[0]);
    QCOMPARE(valuesOf(changed).paint.stiffness->ratio, 3.0);
    m_f->window().actions().showMarks->setChecked(true);
    m_f->actions().oblique->trigger();
    m_f->picture(QStringLiteral("stiff"));
}

QTEST_MAIN(TestSpaceAreas)
#include "test_space_areas.moc"
