#include <QComboBox>
#include <QListWidget>
#include <QSignalSpy>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/handle_panel.h"
#include "app/panels/layer_panel.h"
#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/material_edits.h"
#include "app/window/actions/pin_actions.h"
#include "tests/support/projects.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Interruptions of gestures in the 3D window: another mesh, undo, frames while a number is typed, ambiguous
/// presses.
class TestSpaceUpsets : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void anotherMeshEndsTheGesture_data();
    void anotherMeshEndsTheGesture();
    void surfacesWithoutAFrameAreNotHeld();
    void pinsOnTheCurveAreTaken_data();
    void pinsOnTheCurveAreTaken();
    void undoEndsTheDragOfACurvePoint();
    void chosenPointsStayWithTheirCurve();
    void closedLassoSelectsItsInside();
    void takingAwayFromNothingIsReported();
    void framesKeepTypedText();
    void untouchedNumbersKeepTheirDigits();
    void untouchedAxesKeepTheirDigits();

  private:
    bool makeCurve();
    std::vector<Vec3> curve() { return lastCurve(m_f->session().document().design(), 1)->points; }
    template <class Panel>
    ExactBox* box(int index);
    std::unique_ptr<SolidFixture> m_f;
};

void TestSpaceUpsets::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->open());
}

/// Moves the right end up and sideways along a curve.
bool TestSpaceUpsets::makeCurve() {
    if (!m_f->holdEnds()) return false;
    m_f->session().gestures().moveAtOnce(Grip{}, {-0.4, 0, 1});
    if (!settle(m_f->session())) return false;
    m_f->window().curves().make->trigger();
    return settle(m_f->session()) && curve().size() == 4;
}

/// Returns the visible ones of the panel, in the order of the screen.
template <class Panel>
ExactBox* TestSpaceUpsets::box(int index) {
    std::vector<ExactBox*> seen;
    for (Panel* panel : m_f->window().template findChildren<Panel*>())
        for (QDoubleSpinBox* one : panel->template findChildren<QDoubleSpinBox*>())
            if (one->isVisible()) seen.push_back(static_cast<ExactBox*>(one));
    const auto place = [](const QWidget* w) { return w->mapToGlobal(QPoint()); };
    std::sort(seen.begin(), seen.end(), [&](const QWidget* a, const QWidget* b) {
        return std::pair(place(a).y(), place(a).x()) < std::pair(place(b).y(), place(b).x());
    });
    return seen.at(static_cast<std::size_t>(index));
}

void TestSpaceUpsets::anotherMeshEndsTheGesture_data() {
    QTest::addColumn<QString>("tool");
    for (const char* tool : {"rectangle", "lasso", "brush", "paint", "ball"}) QTest::newRow(tool) << tool;
}

/// The gathered vertices have numbers of the finer mesh.
void TestSpaceUpsets::anotherMeshEndsTheGesture() {
    QFETCH(QString, tool);
    const auto coarse = m_f->session().document().project();
    setVertices(m_f->session().document(), 1200);
    QVERIFY(settle(m_f->session()));
    m_f->actions().through->setChecked(true);
    m_f->tool(tool == "brush" ? "grabBrush" : qPrintable(tool))->trigger();
    const QPoint from = m_f->at({1.9, -0.5, 0.4}), to = m_f->at({0.5, -0.5, -0.4});
    m_f->press(from);
    m_f->moveTo(from, to);
    m_f->session().document().change(QStringLiteral("Coarse"), coarse);
    QVERIFY(settle(m_f->session()));
    m_f->canvas().grab();  // paints what the tool holds
    QTest::mouseMove(&m_f->canvas(), to + QPoint(3, 3));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, to);
    QVERIFY(m_f->handles().empty());
    QVERIFY(m_f->session().document().design().material.layers.empty());
    settleLayout(m_f->canvas());  // what is told of the mesh changes the size of the view
    m_f->drag(m_f->at({1.9, -0.5, 0.4}),
              m_f->at({0.5, -0.5, -0.4}));  // the next one is whole; a lasso needs more than a line
    QVERIFY(tool == "lasso" ||
            m_f->handles().size() + m_f->session().document().design().material.layers.size() == 1);
    QVERIFY(settle(m_f->session()));
}

/// A file's surface may be shown while the frame is still that of the mesh before.
void TestSpaceUpsets::surfacesWithoutAFrameAreNotHeld() {
    const QPoint where = m_f->at({1, -0.5, 0.1});
    QVERIFY(m_f->canvas().pick(where).cell >= 0);
    const Surface ball = test::box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 40);
    VolumePicture picture;
    picture.rest = std::make_shared<const SimplicialMesh<3>>();
    picture.pose = ball.points;
    std::vector<Facet<3>> facets;
    facets.reserve(ball.triangles.size());
    for (const auto& t : ball.triangles) facets.push_back({t, {static_cast<int>(facets.size()), -1}});
    picture.facets = std::make_shared<const std::vector<Facet<3>>>(facets);
    m_f->canvas().setPicture(picture, true);
    QCOMPARE(m_f->canvas().pick(where).cell, -1);
    QVERIFY(m_f->canvas().verticesWhere([](const QPointF&) { return true; }, false).empty());
    m_f->window().actions().pinTool->trigger();
    m_f->click(where);
    QVERIFY(m_f->handles().empty());
}

void TestSpaceUpsets::pinsOnTheCurveAreTaken_data() {
    QTest::addColumn<double>("time");
    QTest::newRow("at its start") << 0.0;
    QTest::newRow("on the way") << 0.5;
}

/// The click that selects and the press that drags may arrive as a double click.
void TestSpaceUpsets::pinsOnTheCurveAreTaken() {
    QFETCH(double, time);
    QVERIFY(makeCurve());
    m_f->session().playback().setTime(time);
    QVERIFY(settle(m_f->session()));
    const int before = m_f->session().document().undoStack()->index();
    QTest::mouseDClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(m_f->pin(1)));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(4));
    QCOMPARE(m_f->session().document().undoStack()->index(), before);
}

void TestSpaceUpsets::undoEndsTheDragOfACurvePoint() {
    QVERIFY(makeCurve());
    m_f->window().curves().insert->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(7));
    const QPoint from = m_f->at(curve()[2]);
    m_f->press(from);
    m_f->moveTo(from, from + QPoint(-30, 10));
    m_f->window().actions().undo->trigger();
    const auto undone = curve();
    QCOMPARE(undone.size(), std::size_t(4));
    QTest::mouseMove(&m_f->canvas(), from + QPoint(-40, 10));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, {}, from + QPoint(-40, 10));
    QVERIFY(settle(m_f->session()));
    QVERIFY(curve() == undone);
    QVERIFY(m_f->session().document().undoStack()->canRedo());  // no step of its own
}

/// Two handles have curves of as many points; the first handle is removed.
void TestSpaceUpsets::chosenPointsStayWithTheirCurve() {
    QVERIFY(m_f->holdEnds());
    for (const int handle : {0, 1}) {
        m_f->session().selection().set({handle});
        m_f->session().gestures().moveAtOnce(Grip{}, {handle == 0 ? 0.4 : -0.4, 0, 1});
        QVERIFY(settle(m_f->session()));
        m_f->window().curves().make->trigger();
        QVERIFY(settle(m_f->session()));
    }
    m_f->session().selection().set({0});
    m_f->click(m_f->at(lastCurve(m_f->session().document().design(), 0)->points[2]));
    const QKeyEvent key(QEvent::KeyPress, Qt::Key_Delete, Qt::NoModifier);
    QVERIFY(m_f->canvas().viewport().tool()->ownsKey(key));  // a point is chosen
    const auto without = copyOf(m_f->project());
    auto& handles = designOf(*without).handles;
    handles.erase(handles.begin());
    m_f->session().document().change(QStringLiteral("Without"), without);
    m_f->session().selection().set({0});
    QVERIFY(settle(m_f->session()));
    QVERIFY(!m_f->canvas().viewport().tool()->ownsKey(key));
}

void TestSpaceUpsets::closedLassoSelectsItsInside() {
    QVERIFY(m_f->holdEnds());
    const std::size_t before = m_f->session().pins().verticesOf(1).size();
    m_f->tool("lasso")->trigger();
    m_f->actions().through->setChecked(true);
    const QPoint c = m_f->at({0, -0.5, 0});
    const auto around = [&](int i) {
        return c + QPointF(90 * std::cos(i * M_PI / 6), 90 * std::sin(i * M_PI / 6)).toPoint();
    };
    m_f->press(around(0), Qt::ShiftModifier);
    for (int i = 1; i <= 12; ++i) QTest::mouseMove(&m_f->canvas(), around(i));
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, Qt::ShiftModifier, around(0));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().pins().verticesOf(1).size() > before + 5);
}

void TestSpaceUpsets::takingAwayFromNothingIsReported() {
    QSignalSpy notices(&m_f->session().document(), &Document::notice);
    m_f->tool("ball")->trigger();
    m_f->drag(m_f->at({1.5, -0.5, 0}), m_f->at({1.5, -0.5, 0}) + QPoint(60, 0), Qt::ControlModifier);
    QCOMPARE(notices.count(), 1);
    QVERIFY(m_f->handles().empty());
}

void TestSpaceUpsets::framesKeepTypedText() {
    QVERIFY(makeCurve());
    m_f->session().addHandle(Ball<3>{{0, 0, 0}, 0.6}, "Region");
    QVERIFY(settle(m_f->session()));
    const auto keeps = [this](ExactBox* box) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QStringLiteral("1.2"));
        const QString typed = box->text();
        emit m_f->session().motion().frameChanged();
        const bool kept = box->text() == typed;
        QTest::keyClick(box, Qt::Key_Return);
        return kept && std::abs(box->value() - 1.2) < 1e-12;
    };
    QVERIFY(keeps(box<RegionPanel>(3)));  // the radius
    QCOMPARE(std::get<Ball<3>>(std::get<Region<3>>(m_f->handles()[2].at)).radius, 1.2);
    m_f->session().selection().set({1});
    QVERIFY(keeps(box<CurvePanel>(1)));  // the scale
    QCOMPARE(lastCurve(m_f->session().document().design(), 1)->scale, 1.2);
    QVERIFY(settle(m_f->session()));
}

void TestSpaceUpsets::untouchedNumbersKeepTheirDigits() {
    QVERIFY(makeCurve());
    const Ball<3> ball{{0.123456789, 0.1, -0.0123456789}, 0.6123456789};
    m_f->session().addHandle(ball, "Region");
    QVERIFY(settle(m_f->session()));
    box<RegionPanel>(1)->setValue(0.2);
    const auto now = std::get<Ball<3>>(std::get<Region<3>>(m_f->handles()[2].at));
    QVERIFY(now.centre == Vec3(ball.centre.x(), 0.2, ball.centre.z()));
    QCOMPARE(now.radius, ball.radius);
    Design small = m_f->session().document().design();
    lastCurve(small, 1)->scale = 0.0123456;  // less than the box has
    lastCurve(small, 1)->twist = 0.123456789;
    lastCurve(small, 1)->frame = FrameKind::Minimal;
    m_f->session().document().changeDesign(QStringLiteral("Small"), small);
    m_f->session().selection().set({1});
    QVERIFY(settle(m_f->session()));
    auto* frame = m_f->window().findChild<QComboBox*>(QStringLiteral("curveFrame"));
    frame->setFocus();
    QTest::keyClick(frame, Qt::Key_Up);
    QCOMPARE(lastCurve(m_f->session().document().design(), 1)->frame, FrameKind::Frenet);
    QCOMPARE(lastCurve(m_f->session().document().design(), 1)->scale, 0.0123456);
    QCOMPARE(lastCurve(m_f->session().document().design(), 1)->twist, 0.123456789);
    QVERIFY(settle(m_f->session()));
}

void TestSpaceUpsets::untouchedAxesKeepTheirDigits() {
    const Vec3 axis = Vec3(0.31234567, 0.6, -0.2).normalized(), other = Vec3::UnitY();
    const auto regions = [&](const std::vector<std::optional<Stiffness>>& all) {
        Design next = m_f->session().document().design();
        MaterialLayer part{"part", {}};
        for (const auto& one : all) part.regions.push_back({{Ball<3>{{0, 0, 0}, 1}, 0.1}, 1.0, one});
        next.material.layers = {part};
        return next;
    };
    m_f->session().document().changeDesign(QStringLiteral("Part"), regions({Stiffness{axis, 5}}));
    m_f->tool("paint")->trigger();
    auto* panel = m_f->window().findChild<LayerPanel*>();
    panel->list()->setCurrentRow(0);
    box<LayerPanel>(0)->setValue(7);
    const auto stiffness = m_f->session().document().design().material.layers[0].regions[0].stiffness;
    QVERIFY(stiffness && stiffness->ratio == 7);
    QVERIFY(stiffness->axis == axis);
    // Only stiff regions count, in any order.
    const auto values = [&](const auto& all) { return valuesOf(regions(all).material.layers[0]); };
    using All = std::vector<std::optional<Stiffness>>;
    QVERIFY(values(All{{}, Stiffness{axis, 2}, Stiffness{axis, 3}}).oneAxis);
    QVERIFY(!values(All{{}, Stiffness{axis, 2}, Stiffness{other, 2}}).oneAxis);
    QVERIFY(settle(m_f->session()));
}

QTEST_MAIN(TestSpaceUpsets)
#include "test_space_upsets.moc"
