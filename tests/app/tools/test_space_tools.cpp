#include <QDoubleSpinBox>

#include "app/panels/handle_panel.h"
#include "app/project/design.h"
#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/curve_edits.h"
#include "app/session/pins/pin_shapes.h"
#include "app/window/actions/pin_actions.h"
#include "core/motion/curve.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The tools of the 3D window, by real mouse and keys.
class TestSpaceTools : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void doubleClickInsertsACurvePoint();
    void curvePointsAreDeletedByKey();
    void curveKindsByMenuAndShortcut();
    void rightClickOpensTheCurvesMenu();
    void twistAndScaleByThePanel();
    void oneManipulatorIsShown();
    void outlinesSelectByAnyPoint_data();
    void outlinesSelectByAnyPoint();
    void outlinesShowTheirMode();
    void hiddenPinsAreSelectedThrough();

  private:
    bool makeCurve();
    std::vector<Vec3> curve() { return lastCurve(m_f->session().document().design(), 1)->points; }
    QPoint onCurve(double v);
    std::unique_ptr<SolidFixture> m_f;
};

void TestSpaceTools::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->open());
}

/// Moves the right end up and sideways along a curve.
bool TestSpaceTools::makeCurve() {
    if (!m_f->holdEnds()) return false;
    m_f->session().gestures().moveAtOnce(Grip{}, {-0.4, 0, 1});
    if (!settle(m_f->session())) return false;
    m_f->window().curves().make->trigger();
    return settle(m_f->session()) && curve().size() == 4;
}

QPoint TestSpaceTools::onCurve(double v) {
    return m_f->at(bezierCurve<3>(curve()).pieces[0].value(v));
}

void TestSpaceTools::doubleClickInsertsACurvePoint() {
    QVERIFY(makeCurve());
    const auto before = bezierCurve<3>(curve()).pieces[0];
    const Points3 shape = m_f->session().motion().frame<3>()->pose;
    const std::size_t handles = m_f->handles().size();
    const QPoint where = onCurve(0.5);
    m_f->window().actions().pinTool->trigger();
    m_f->click(where);  // on the curve: no pin
    QCOMPARE(m_f->handles().size(), handles);
    QTest::mouseDClick(&m_f->canvas(), Qt::LeftButton, {}, where);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(7));
    // The new joint is on the old curve, which is straight here: at half of it within a pixel.
    QVERIFY((curve()[3] - before.value(0.5)).norm() < 2 * m_f->canvas().pixelSize(curve()[3]));
    QCOMPARE(m_f->handles().size(), handles);
    QVERIFY((m_f->session().motion().frame<3>()->pose - shape).norm() < 0.01 * shape.norm());
    m_f->picture(QStringLiteral("curve-point"));
    m_f->window().actions().undo->trigger();
    QCOMPARE(curve().size(), std::size_t(4));
}

void TestSpaceTools::curvePointsAreDeletedByKey() {
    QVERIFY(makeCurve());
    QTest::keyClick(&m_f->canvas(), Qt::Key_I);  // behind the first point: in the middle
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(7));
    m_f->click(m_f->at(curve()[3]));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Delete);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(4));
    QCOMPARE(m_f->handles().size(), std::size_t(2));
    QVERIFY(m_f->session().selection().contains(1));
    QTest::keyClick(&m_f->canvas(), Qt::Key_Delete);  // no point is chosen any more: the handle
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().selection().isEmpty());
}

void TestSpaceTools::curveKindsByMenuAndShortcut() {
    QVERIFY(makeCurve());
    CurveActions& actions = m_f->window().curves();
    actions.insert->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(actions.automatic->isChecked() || actions.aligned->isChecked());
    // The direction behind the joint is dragged across the curve: the other one rotates with it.
    m_f->drag(m_f->at(curve()[4]), m_f->at(curve()[4]) + QPoint(40, 0));
    QVERIFY(settle(m_f->session()));
    const auto opposite = [&] {
        const auto p = curve();
        return ((p[3] - p[2]).normalized() - (p[4] - p[3]).normalized()).norm();
    };
    QVERIFY(opposite() < 1e-9);
    QVERIFY(actions.aligned->isChecked());
    const auto aligned = curve();
    actions.free->trigger();
    m_f->drag(m_f->at(curve()[4]), m_f->at(curve()[4]) + QPoint(0, 40));
    QVERIFY(settle(m_f->session()));
    QVERIFY(curve()[2] == aligned[2] && curve()[4] != aligned[4]);
    QVERIFY(opposite() > 0.1);
    QTest::keyClick(&m_f->canvas(), Qt::Key_2, Qt::AltModifier);
    QVERIFY(settle(m_f->session()));
    QVERIFY(opposite() < 1e-9);
    // With Ctrl a drag moves one direction alone.
    const auto before = curve();
    m_f->press(m_f->at(curve()[2]), Qt::ControlModifier);
    for (int i = 1; i <= 5; ++i) {
        QMouseEvent move(QEvent::MouseMove, m_f->at(before[2]) + QPoint(-10 * i, 0),
                         m_f->canvas().mapToGlobal(m_f->at(before[2]) + QPoint(-10 * i, 0)), Qt::NoButton,
                         Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&m_f->canvas(), &move);
    }
    QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, Qt::ControlModifier,
                        m_f->at(before[2]) + QPoint(-50, 0));
    QVERIFY(settle(m_f->session()));
    QVERIFY(curve()[4] == before[4] && curve()[2] != before[2]);
    actions.automatic->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(jointKinds(curve())[1], JointKind::Automatic);
}

void TestSpaceTools::rightClickOpensTheCurvesMenu() {
    QVERIFY(makeCurve());
    QMenu* menu = m_f->window().curves().menu();
    QTest::mouseClick(&m_f->canvas(), Qt::RightButton, {}, onCurve(0.5));
    QVERIFY(QTest::qWaitFor([&] { return menu->isVisible(); }, 20000));
    QVERIFY(m_f->window().curves().insert->isEnabled());
    QVERIFY(!m_f->window().curves().remove->isEnabled());
    menu->close();
    m_f->window().curves().insert->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(curve().size(), std::size_t(7));
    QTest::mouseClick(&m_f->canvas(), Qt::RightButton, {}, QPoint(5, 5));
    QVERIFY(!menu->isVisible());
}

/// A frame rotates the end with the curve; twist and scale are applied on top, and the frames are drawn.
void TestSpaceTools::twistAndScaleByThePanel() {
    QVERIFY(makeCurve());
    auto* panel = m_f->window().findChild<HandlePanel*>();
    const auto boxes = panel->findChildren<QDoubleSpinBox*>();
    const auto type = [&](const QString& suffix, const QString& prefix, const QString& text) {
        for (QDoubleSpinBox* box : boxes) {
            if (!box->isVisible() || box->suffix() != suffix || box->prefix() != prefix) continue;
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Return);
        }
    };
    const double size = 0.5;  // half of the end's side
    type(QStringLiteral(" °"), QString(), QStringLiteral("60"));
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::abs(lastCurve(m_f->session().document().design(), 1)->twist - M_PI / 3) < 1e-9);
    QVERIFY(lastCurve(m_f->session().document().design(), 1)->frame ==
            FrameKind::Minimal);  // without one nothing twists
    type(QString(), QStringLiteral("×"), QStringLiteral("0.8"));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(lastCurve(m_f->session().document().design(), 1)->scale, 0.8);
    const Vec3 middle = m_f->pin(1);
    double reach = 0;
    for (const int v : m_f->session().pins().verticesOf(1))
        reach = std::max(reach, (m_f->session().motion().frame<3>()->pose.col(v) - middle).norm());
    QVERIFY(std::abs(reach - 0.8 * std::sqrt(2.0) * size) < 1e-6);
    m_f->actions().oblique->trigger();
    m_f->picture(QStringLiteral("frames"));
}

/// One manipulator is shown, that of the cut or of the selection: in the step in which solids are cut the
/// cut's, elsewhere that of the tool, or the cut's if the tool has none.
void TestSpaceTools::oneManipulatorIsShown() {
    QVERIFY(m_f->holdEnds());
    Toolbox& tools = *m_f->window().findChild<Toolbox*>();
    SolidCanvas& canvas = m_f->canvas();
    const auto shown = [&] {
        const Tool* tool = canvas.viewport().tool();
        return std::pair(canvas.cutTool().isShown(), tool && tool->hasManipulator());
    };
    tools.setMode(Mode::Pins);
    m_f->session().selection().set({1});
    QCOMPARE(shown(), std::pair(false, true));
    m_f->actions().cut->trigger();
    QTRY_VERIFY(canvas.solid().cut() != CutKind::None);
    QCOMPARE(shown(), std::pair(false, true));
    tools.setMode(Mode::Mesh);
    m_f->window().actions().selectTool->trigger();
    tools.setMode(Mode::Mesh);
    QCOMPARE(shown(), std::pair(true, false));
    tools.setMode(Mode::Pins);
    QCOMPARE(shown(), std::pair(false, true));
    m_f->session().selection().clear();
    QCOMPARE(shown(), std::pair(true, false));
    m_f->actions().cut->trigger();
    QTRY_VERIFY(canvas.solid().cut() == CutKind::None);
    QCOMPARE(shown(), std::pair(false, false));
}

void TestSpaceTools::outlinesSelectByAnyPoint_data() {
    QTest::addColumn<QString>("outline");
    for (const char* outline : {"rectangle", "lasso", "brush"}) QTest::newRow(outline) << outline;
}

/// The ends' marks are in their middle; their front edges are selected all the same.
void TestSpaceTools::outlinesSelectByAnyPoint() {
    QFETCH(QString, outline);
    QVERIFY(m_f->holdEnds());
    PinActions& a = *m_f->window().findChild<PinActions*>();
    (outline == "lasso" ? a.selectLasso : outline == "brush" ? a.selectBrush : a.selectRectangle)->trigger();
    m_f->session().selection().clear();
    const auto around = [&](double x, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint c = m_f->at({x, -0.5, 0.5});
        QList<QPoint> way = {QPoint(20, -24), QPoint(20, 12), QPoint(-20, 12), QPoint(-20, -24)};
        if (outline == "rectangle") way = {QPoint(20, -24), QPoint(-20, 12)};
        m_f->press(c + way[0], modifiers);
        for (int i = 1; i < way.size(); ++i) m_f->moveTo(c + way[i - 1], c + way[i]);
        QTest::mouseRelease(&m_f->canvas(), Qt::LeftButton, modifiers, c + way.last());
    };
    around(-2);
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>({0}));
    around(2, Qt::ShiftModifier);
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>({0, 1}));
    around(-2, Qt::ControlModifier);
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>({1}));
}

/// The modes are chosen by shortcuts, from another tool.
void TestSpaceTools::outlinesShowTheirMode() {
    QAction* select = m_f->window().actions().selectTool;
    const QPoint over = m_f->at({0, -0.5, 0});
    const auto choose = [&](Qt::Key key) {
        m_f->tool("ball")->trigger();
        QTest::keyClick(&m_f->canvas(), key, Qt::ShiftModifier);
        QTest::mouseMove(&m_f->canvas(), over + QPoint(3, 0));
        QTest::mouseMove(&m_f->canvas(), over);
        return m_f->canvas().viewport().tool()->hint();
    };
    const auto painted = [this] {
        QImage image(m_f->canvas().size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        m_f->canvas().viewport().tool()->paint(painter);
        return image;
    };
    QStringList hints;
    for (const Qt::Key key : {Qt::Key_R, Qt::Key_O, Qt::Key_U}) {
        hints << choose(key);
        QVERIFY(select->isChecked());
    }
    hints.removeDuplicates();
    QCOMPARE(hints.size(), 3);
    QVERIFY(hints.last().contains('[') && hints.last().contains(']'));
    const QImage ring = painted();
    QVERIFY(qAlpha(ring.pixel(over + QPoint(18, 0))) > 0 && qAlpha(ring.pixel(over)) == 0);
    QTest::keyClick(&m_f->canvas(), Qt::Key_BracketRight);
    QVERIFY(painted() != ring);
    m_f->canvas().viewport().tool()->leave();
    QCOMPARE(qAlpha(painted().pixel(over + QPoint(22, 0))), 0);
}

void TestSpaceTools::hiddenPinsAreSelectedThrough() {
    const auto frame = m_f->session().motion().frame<3>();
    int back = -1;  // in the middle of the far side
    for (int v = 0; v < frame->vertices; ++v) {
        const Vec3 p = frame->pose.col(v);
        if (std::abs(p.y() - 0.5) < 1e-9 && (back < 0 || p.norm() < frame->pose.col(back).norm())) back = v;
    }
    m_f->session().addHandle(m_f->session().pins().placementOf({back}), "Pin");
    QVERIFY(settle(m_f->session()));
    m_f->session().selection().clear();
    m_f->window().actions().selectTool->trigger();
    const QPoint c = m_f->at(frame->pose.col(back));
    m_f->drag(c - QPoint(30, 30), c + QPoint(30, 30));
    QVERIFY(m_f->session().selection().isEmpty());
    m_f->actions().through->setChecked(true);
    m_f->drag(c - QPoint(30, 30), c + QPoint(30, 30));
    QCOMPARE(m_f->session().selection().handles(), std::vector<int>({0}));
}

QTEST_MAIN(TestSpaceTools)
#include "test_space_tools.moc"
