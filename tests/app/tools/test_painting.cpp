#include <QPointingDevice>
#include <QSignalSpy>
#include <QSlider>
#include <QTabletEvent>
#include <QToolBar>
#include <QToolButton>

#include "app/engine/motion/places.h"
#include "app/panels/layer_panel.h"
#include "app/panels/paint_panel.h"
#include "app/project/design.h"
#include "app/project/edits/material_edits.h"
#include "app/style/colours.h"
#include "app/style/smooth_map.h"
#include "app/tools/paint/layer_lines.h"
#include "tests/support/layers.h"
#include "tests/support/paint_test.h"

using namespace wend;
using namespace wend::test;

namespace {

double smooth(double t) {
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

}  // namespace

/// Painting the material by mouse and keys: pictures and solids share one test body.
class TestPainting : public PaintTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { m_f.reset(); }
    void strokesAreSoftRegions_data() { dimensions(); }
    void strokesAreSoftRegions();
    void paintIsSeenAtOnce_data() { dimensions(); }
    void paintIsSeenAtOnce();
    void softPaintIsSeenSoft_data() { dimensions(); }
    void softPaintIsSeenSoft();
    void hardEdgesAreSharp_data() { dimensions(); }
    void hardEdgesAreSharp();
    void unpaintedPartsOfSolidsStayAsTheyAre();
    void combedPartsStretchLess_data() { dimensions(); }
    void combedPartsStretchLess();
    void modifiersEraseSmoothAndPick_data() { dimensions(); }
    void modifiersEraseSmoothAndPick();
    void penPressureScalesTheAmount_data() { dimensions(); }
    void penPressureScalesTheAmount();
    void shiftClicksDrawLines_data() { dimensions(); }
    void shiftClicksDrawLines();
    void linesFromAfarEnd();
    void keysChangeTheTip_data() { dimensions(); }
    void keysChangeTheTip();
    void keysChooseAStop_data() { dimensions(); }
    void keysChooseAStop();
    void altRightDragChangesTheTip_data() { dimensions(); }
    void altRightDragChangesTheTip();
    void eraserTakesPaintAway_data() { dimensions(); }
    void eraserTakesPaintAway();
    void directionsOfStiffness_data() { dimensions(); }
    void directionsOfStiffness();
    void directionsAreCarriedBackToRest_data() { dimensions(); }
    void directionsAreCarriedBackToRest();

  private:
    template <int Dim>
    void paintHalf(double feather);
    template <int Dim>
    std::vector<Vec3> coloursAlong(double v);
    template <int Dim>
    void seeSoft();
    template <int Dim>
    void seeSharp();
    template <int Dim>
    void softRegions();
    template <int Dim>
    void seenAtOnce();
    template <int Dim>
    double middleMoves();
    template <int Dim>
    void stretchLess();
    template <int Dim>
    void eraseSmoothAndPick();
    template <int Dim>
    void pressPen();
    template <int Dim>
    void drawLines();
    template <int Dim>
    void changeTip();
    template <int Dim>
    void chooseStops();
    template <int Dim>
    void dragTip();
    template <int Dim>
    void erase();
    template <int Dim>
    void chooseDirections();
    template <int Dim>
    void carryDirections();
};

void TestPainting::strokesAreSoftRegions() {
    BOTH(softRegions);
}

/// The amount depends on the distance to the stroke's line: full within the hard part, none beyond the brush,
/// and in between that of the file's balls, each applied over the ones before.
template <int Dim>
void TestPainting::softRegions() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    const auto plain = session.motion().frame<Dim>()->material->phi;
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 40, b.hardness = 0.5; });
    stroke<Dim>({-1, 0}, {0.5, 0.1});
    QVERIFY(settle(session));
    const auto frame = session.motion().frame<Dim>();
    QCOMPARE(m_f->session().document().design().material.layers.size(), std::size_t(1));
    QVERIFY(regions<Dim>().size() > 5);
    QVERIFY(m_f->window().actions().undo->text().contains(QStringLiteral("Rigid")));
    const Vec<Dim> a = Bar<Dim>::place(-1, 0), b = Bar<Dim>::place(0.5, 0.1);
    const double R = 40 * Bar<Dim>::canvas(*m_f).pixelSize(inSpace(a)), pixel = R / 40;
    const auto toLine = [&](const Vec<Dim>& p) {
        const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        return (p - a - t * (b - a)).norm();
    };
    int whole = 0, soft = 0, none = 0;
    for (int c = 0; c < frame->cells; ++c) {
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (const int v : frame->rest->cells[c]) centre += frame->rest->points.col(v) / (Dim + 1);
        double expected = plain[c];
        for (const auto& region : regions<Dim>()) {
            const auto ball = std::get<Ball<Dim>>(regionIn<Dim>(region.shape));
            const double m = smooth(0.5 - ((centre - ball.centre).norm() - ball.radius) / region.feather);
            expected += m * (phi::kAkvf - expected);
        }
        const double is = frame->material->phi[c], far = toLine(centre);
        QVERIFY2(std::abs(is - expected) < 1e-12, qPrintable(QString::number(is - expected)));
        // Balls are up to 0.45 R apart: between two the hard part reaches √(½² − 0.225²) R = 0.446 R.
        const bool inside = far<0.43 * R - pixel, beyond = far> R + pixel;
        QVERIFY(!inside || is == phi::kAkvf);
        QVERIFY(!beyond || is == plain[c]);
        whole += inside;
        none += beyond;
        if (is != plain[c] && is != phi::kAkvf) ++soft;
    }
    QVERIFY2(whole > 3 && soft > 3 && none > 20,
             qPrintable(QString("%1 %2 %3").arg(whole).arg(soft).arg(none)));
    // Undo, redo, save, open again.
    const auto painted = frame->material->phi;
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(session) && regions<Dim>().empty());
    QVERIFY(session.motion().frame<Dim>()->material->phi == plain);
    m_f->window().actions().redo->trigger();
    QVERIFY(settle(session));
    QVERIFY(session.motion().frame<Dim>()->material->phi == painted);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("painted.wend"));
    session.document().save(path);
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session.document().source() == path; }, 20000) && settle(session));
    QVERIFY(session.motion().frame<Dim>()->material->phi == painted);
}

void TestPainting::paintIsSeenAtOnce() {
    BOTH(seenAtOnce);
}

/// The painted value is shown before the button is released and until the motion is computed.
template <int Dim>
void TestPainting::seenAtOnce() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const auto plain = session.motion().frame<Dim>()->material->phi;
    m_f->tool("paint")->trigger();
    QVERIFY(m_f->window().actions().showMap->isChecked());
    stroke<Dim>({-1, 0}, {1, 0}, {}, false);
    QVERIFY(regions<Dim>().empty());
    QVERIFY(session.motion().frame<Dim>()->material->phi == plain);
    QVERIFY(posed<Dim>(canvas.shownFrame())->material->phi != plain);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QVERIFY(posed<Dim>(canvas.shownFrame())->material->phi == plain);
    QTest::mouseRelease(&canvas, Qt::LeftButton);
    QVERIFY(regions<Dim>().empty());
    stroke<Dim>({-1, 0}, {1, 0});
    const auto shown = posed<Dim>(canvas.shownFrame())->material->phi;
    QVERIFY(shown != plain && session.motion().isStale());
    QVERIFY(settle(session));
    QVERIFY(session.motion().frame<Dim>()->material->phi == shown);
    m_f->picture(QStringLiteral("painted-%1").arg(Dim));
    // Of two strokes in quick succession the first is kept.
    stroke<Dim>({-1, 0.3}, {-0.5, 0.3});
    m_f->window().actions().undo->trigger();
    QVERIFY(posed<Dim>(canvas.shownFrame())->material->phi != plain || session.motion().isStale());
    QVERIFY(settle(session));
    QVERIFY(session.motion().frame<Dim>()->material->phi == shown);
}

/// The left half of the bar has another energy, and the view shows the paint.
template <int Dim>
void TestPainting::paintHalf(double feather) {
    constexpr double kUnit = Bar<Dim>::kUnit;
    Design next = m_f->session().document().design();
    auto& material = next.material;
    material.phi = phi::kEquia;
    const Vec<Dim> centre = Bar<Dim>::place(0, 0) - 3 * kUnit * Vec<Dim>::UnitX();
    const Region<3> half(Ball<3>{inSpace(centre), 3 * kUnit});
    material.layers.push_back(layerWith("half", {{half, feather * kUnit}, phi::conformal(Dim)}));
    m_f->session().document().changeDesign(QStringLiteral("Half"), next);
    QVERIFY(settle(m_f->session()));
    m_f->tool("paint")->trigger();
    QTRY_VERIFY(Bar<Dim>::canvas(*m_f).isSettled());
}

/// Returns the visible colours along the bar from the left to the right.
template <int Dim>
std::vector<Vec3> TestPainting::coloursAlong(double v) {
    auto& canvas = Bar<Dim>::canvas(*m_f);
    QImage seen;
    if constexpr (Dim == 2)
        seen = canvas.grab().toImage();
    else
        seen = canvas.picture(canvas.size(), false);
    const QPointF left = canvas.toWidget(Bar<Dim>::place(-1, v)),
                  right = canvas.toWidget(Bar<Dim>::place(1, v));
    std::vector<Vec3> colours;
    for (double x = left.x(); x <= right.x(); ++x) {
        const QColor colour = seen.pixelColor(qRound(x), qRound(left.y()));
        colours.emplace_back(colour.red(), colour.green(), colour.blue());
    }
    return colours;
}

/// At a soft edge of the paint the colours mix without jumps between tetrahedra.
void TestPainting::softPaintIsSeenSoft() {
    BOTH(seeSoft);
}

template <int Dim>
void TestPainting::seeSoft() {
    QVERIFY(Bar<Dim>::open(*m_f));
    paintHalf<Dim>(1.5);
    for (const double v : {-0.3, -0.1, 0.1, 0.3}) {
        const auto colours = coloursAlong<Dim>(v);
        const Vec3 &first = colours.front(), &last = colours.back();
        const double whole = (last - first).norm();
        QVERIFY(whole > 60);
        double largest = 0;
        for (std::size_t i = 1; i < colours.size(); ++i)
            largest = std::max(largest, (colours[i] - colours[i - 1]).norm());
        QVERIFY2(largest < 0.12 * whole, qPrintable(QString("%1 of %2").arg(largest).arg(whole)));
    }
}

/// Unpainted parts look the same as with another tool, on the surface and on the face of a cut: all of the
/// solid before painting, and the parts far from the paint afterwards.
void TestPainting::unpaintedPartsOfSolidsStayAsTheyAre() {
    QVERIFY(Bar<3>::open(*m_f));
    SolidCanvas& canvas = m_f->canvas();
    const auto seenWith = [&](const char* tool) {
        m_f->tool(tool)->trigger();
        canvas.setCutKind(CutKind::Exact);
        return canvas.picture(canvas.size(), false);
    };
    canvas.setCutPlane({Vec3::Zero(), Vec3(0.3, 0.2, 1).normalized()});
    const QImage plain = seenWith("pin");
    QVERIFY(seenWith("paint") == plain);
    paintHalf<3>(0);
    canvas.setCutPlane({Vec3::Zero(), Vec3(0.3, 0.2, 1).normalized()});
    const QImage without = seenWith("pin"), with = seenWith("paint");
    const int edge = qRound(canvas.toWidget(Bar<3>::place(0.6, 0)).x());
    const QRect right(QPoint(edge, 0), QPoint(canvas.width() - 1, canvas.height() - 1));
    QVERIFY(with != without);
    QVERIFY(with.copy(right) == without.copy(right));
}

/// Each cell is inside or outside of a region without feather: there are only the two colours and the
/// smoothed pixels of the edge, and no third colour from between them in the row of energies.
void TestPainting::hardEdgesAreSharp() {
    BOTH(seeSharp);
}

template <int Dim>
void TestPainting::seeSharp() {
    QVERIFY(Bar<Dim>::open(*m_f));
    m_f->window().findChild<QSlider*>(QStringLiteral("mapOpacity"))->setValue(100);
    m_f->tool("pin")->trigger();
    QTRY_VERIFY(Bar<Dim>::canvas(*m_f).isSettled());
    const double veil = Dim == 2 ? 1 - paintOpacity(1) : 0;  // of the picture, seen through the paint
    constexpr std::array kLines{-0.3, -0.1, 0.1, 0.3};
    std::vector<std::vector<Vec3>> plain;
    for (const double v : kLines) plain.push_back(coloursAlong<Dim>(v));
    paintHalf<Dim>(0);
    for (std::size_t line = 0; line < kLines.size(); ++line) {
        const auto colours = coloursAlong<Dim>(kLines[line]);
        int between = 0;
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const Vec3 own = plain[line][i], way = colours.front() - own + veil * (own - plain[line].front());
            const double whole = way.norm(), part = (colours[i] - own).dot(way) / (whole * whole);
            QVERIFY(whole > 60);
            between += part > 0.1 && part < 0.9;
            QVERIFY((colours[i] - own - std::clamp(part, 0.0, 1.0) * way).norm() < 0.06 * whole);
        }
        QVERIFY2(between <= 6, qPrintable(QString::number(between)));
    }
}

void TestPainting::combedPartsStretchLess() {
    BOTH(stretchLess);
}

/// Returns the displacement of the middle when the right end is pulled by a unit and the left one is held.
template <int Dim>
double TestPainting::middleMoves() {
    const auto frame = m_f->session().motion().frame<Dim>();
    double moved = 0;
    int count = 0;
    for (int v = 0; v < frame->vertices; ++v) {
        if (std::abs(frame->rest->points(0, v) - Bar<Dim>::place(0, 0).x()) > 0.3 * Bar<Dim>::kUnit) continue;
        moved += (frame->pose(0, v) - frame->rest->points(0, v)) / Bar<Dim>::kUnit;
        ++count;
    }
    return moved / count;
}

template <int Dim>
void TestPainting::stretchLess() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    for (const double side : {-1.0, 1.0}) {
        const Region<Dim> end = HalfSpace<Dim>{Bar<Dim>::place(1.8 * side, 0), side * Vec<Dim>::UnitX()};
        session.addHandle(inSpace(end), "End");
    }
    session.selection().set({1});
    session.gestures().moveAtOnce(Grip{}, {Bar<Dim>::kUnit, 0, 0});
    QVERIFY(settle(session));
    const double plain = middleMoves<Dim>();
    QVERIFY(std::abs(plain - 0.5) < 0.03);  // by symmetry
    session.playback().setTime(0);
    QVERIFY(settle(session));
    m_f->tool("comb")->trigger();
    set([](BrushSettings& b) { b.ratio = 20, b.radius = 60, b.hardness = 0.8; });
    for (const double v : {-0.3, 0.0, 0.3}) stroke<Dim>({-1.8, v}, {-0.2, v});
    QVERIFY(settle(session));
    // The axis is that of the stroke at rest.
    for (const auto& region : regions<Dim>()) {
        QVERIFY(region.stiffness && std::abs(region.stiffness->ratio - 20) < 1e-9);
        QVERIFY(std::abs(region.stiffness->axis.x()) > 0.98);
    }
    session.playback().setTime(session.playback().end());
    QVERIFY(settle(session));
    const double combed = middleMoves<Dim>();
    QVERIFY2(combed < plain - 0.1, qPrintable(QString("%1 %2").arg(plain).arg(combed)));
    m_f->picture(QStringLiteral("combed-%1").arg(Dim));
}

void TestPainting::modifiersEraseSmoothAndPick() {
    BOTH(eraseSmoothAndPick);
}

template <int Dim>
void TestPainting::eraseSmoothAndPick() {
    constexpr double kEverywhere = 1.1;  // other than a new project's
    QVERIFY(Bar<Dim>::open(*m_f) && setEverywhere<Dim>(kEverywhere));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::conformal(Dim), b.radius = 60, b.hardness = 0.8; });
    stroke<Dim>({-1.5, 0}, {1.5, 0});
    QVERIFY(settle(session));
    const auto cellAt = [&](double u) {
        return canvas.touch(canvas.toWidget(Bar<Dim>::place(u, 0)))->place.cell;
    };
    const auto phiAt = [&](double u) { return session.motion().frame<Dim>()->material->phi[cellAt(u)]; };
    QCOMPARE(phiAt(0), phi::conformal(Dim));
    // Alt picks up and paints nothing.
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    const QPoint middle = canvas.toWidget(Bar<Dim>::place(0, 0)).toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, Qt::AltModifier, middle);
    QCOMPARE(brush().now().phi, phi::conformal(Dim));
    QCOMPARE(m_f->session().document().design().material.layers.size(), std::size_t(1));
    // Ctrl paints the value of the whole shape.
    constexpr double kDeep = Dim == 3 ? 2.2 : 1;  // the middle of a tetrahedron lies below the surface
    set([](BrushSettings& b) { b.radius = 40 * kDeep; });
    stroke<Dim>({0, 0}, {0.1, 0}, Qt::ControlModifier);
    QVERIFY(settle(session));
    QVERIFY(std::abs(phiAt(0) - kEverywhere) < 1e-9);
    QCOMPARE(phiAt(-1.2), phi::conformal(Dim));
    // Shift smooths: the result is between the two values.
    set([](BrushSettings& b) { b.radius = 80 * kDeep; });
    stroke<Dim>({0, 0}, {0.1, 0}, Qt::ShiftModifier);
    QVERIFY(settle(session));
    QVERIFY(phiAt(0.05) > kEverywhere + 0.02 && phiAt(0.05) < phi::conformal(Dim) - 0.02);
    // Half of the amount is half way on the slider, so from Angle to Length at Rigid.
    const double before = phiAt(-1.2);
    set([](BrushSettings& b) { b.phi = phi::kMetr, b.amount = 0.5, b.radius = 30 * kDeep; });
    stroke<Dim>({-1.2, 0}, {-1.2, 0});
    QVERIFY(settle(session));
    QVERIFY(phiAt(-1.2) < before - 0.01 && phiAt(-1.2) > phi::kMetr + 0.01);
    if (Dim == 2) QVERIFY(before == phi::conformal(2) && std::abs(phiAt(-1.2) - phi::kAkvf) < 1e-9);
}

namespace {

/// A pen as Qt reports it: its own event and, if the widget ignores that, the pointer event made from it.
class Pen {
  public:
    explicit Pen(QWidget& widget) : m_widget(widget) {}
    void press(const QPoint& at, double pressure) {
        send(QEvent::TabletPress, QEvent::MouseButtonPress, at, pressure, Qt::LeftButton, Qt::LeftButton);
    }
    void move(const QPoint& at, double pressure) {
        send(QEvent::TabletMove, QEvent::MouseMove, at, pressure, Qt::NoButton, Qt::LeftButton);
    }
    void release(const QPoint& at) {
        send(QEvent::TabletRelease, QEvent::MouseButtonRelease, at, 0, Qt::LeftButton, Qt::NoButton);
    }

  private:
    void send(QEvent::Type own, QEvent::Type pointers, const QPointF& at, double pressure,
              Qt::MouseButton button, Qt::MouseButtons buttons) {
        const QPointF global = m_widget.mapToGlobal(at);
        QTabletEvent event(own, &m_device, at, global, pressure, 0, 0, 0, 0, 0, {}, button, buttons);
        QApplication::sendEvent(&m_widget, &event);
        if (event.isAccepted()) return;
        QMouseEvent made(pointers, at, global, button, buttons, {}, &m_device);
        QApplication::sendEvent(&m_widget, &made);
    }

    QWidget& m_widget;
    QPointingDevice m_device{QStringLiteral("pen"),
                             1,
                             QInputDevice::DeviceType::Stylus,
                             QPointingDevice::PointerType::Pen,
                             QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                             1,
                             3};
};

}  // namespace

void TestPainting::penPressureScalesTheAmount() {
    BOTH(pressPen);
}

/// A stroke pressed with 0.2 at its beginning and 0.8 at its end: φ is at that fraction between the old and
/// the painted value, on the slider's scale. Without the switch, and by mouse, it is painted fully.
template <int Dim>
void TestPainting::pressPen() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    auto* pressure = m_f->window().template findChild<QAction*>(QStringLiteral("pressure"));
    QVERIFY(pressure && pressure->isChecked());
    QVERIFY(m_f->window()
                .template findChild<QToolBar*>(QStringLiteral("optionRow"))
                ->actions()
                .contains(pressure));
    const double before = stopOfPhi(session.motion().frame<Dim>()->material->phi[0], Dim);
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 20, b.hardness = 1; });
    const double aim = stopOfPhi(phi::kAkvf, Dim);
    const auto on = [&](double u) { return canvas.toWidget(Bar<Dim>::place(u, 0)).toPoint(); };
    const auto amountAt = [&](std::size_t i) {
        return (stopOfPhi(*regions<Dim>().at(i).phi, Dim) - before) / (aim - before);
    };
    Pen pen(canvas);
    pen.press(on(-1.5), 0.2);
    for (int i = 1; i <= 12; ++i) pen.move(on(-1.5 + 0.25 * i), 0.2 + 0.05 * i);
    pen.release(on(1.5));
    QVERIFY(settle(session));
    const std::size_t count = regions<Dim>().size();
    QVERIFY(count > 8);
    // A ball takes the largest pressure until the next one, 0.3 of the radius on: here less than 0.01 more.
    QVERIFY2(amountAt(0) >= 0.2 && amountAt(0) < 0.21, qPrintable(QString::number(amountAt(0))));
    QVERIFY2(std::abs(amountAt(count - 1) - 0.8) < 0.05, qPrintable(QString::number(amountAt(count - 1))));
    for (std::size_t i = 1; i < count; ++i) QVERIFY(amountAt(i) > amountAt(i - 1));
    session.document().undoStack()->undo();
    QVERIFY(settle(session));
    pen.press(on(0), 0.1);  // harder and harder in one place
    for (int i = 2; i <= 5; ++i) pen.move(on(0), 0.1 * i);
    pen.release(on(0));
    QVERIFY(settle(session));
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    QVERIFY(std::abs(amountAt(0) - 0.5) < 1e-6);
    session.document().undoStack()->undo();
    QVERIFY(settle(session));
    pressure->trigger();
    QVERIFY(!brush().now().pressure);
    pen.press(on(0), 0.3);
    pen.release(on(0));
    QVERIFY(settle(session));
    QCOMPARE(*regions<Dim>().at(0).phi, phi::kAkvf);
    session.document().undoStack()->undo();
    pressure->trigger();
    QVERIFY(settle(session));
    stroke<Dim>({0, 0}, {0.1, 0});  // the mouse after the pen
    QVERIFY(settle(session));
    QCOMPARE(*regions<Dim>().at(0).phi, phi::kAkvf);
}

void TestPainting::shiftClicksDrawLines() {
    BOTH(drawLines);
}

/// A click and another one with Shift: the balls fill the segment between the two without gaps, as one step.
/// With Shift and a drag, the brush smooths as before.
template <int Dim>
void TestPainting::drawLines() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 20, b.hardness = 1; });
    const Vec<Dim> a = Bar<Dim>::place(-1.5, -0.1), b = Bar<Dim>::place(1.5, 0.2);
    const auto click = [&](const Vec<Dim>& p, Qt::KeyboardModifiers modifiers) {
        QTest::mouseMove(&canvas, canvas.toWidget(p).toPoint());
        QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, canvas.toWidget(p).toPoint());
        return settle(session);
    };
    QVERIFY(click(a, {}));
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    const int steps = session.document().undoStack()->count();
    QVERIFY(click(b, Qt::ShiftModifier));
    QCOMPARE(session.document().undoStack()->count(), steps + 1);
    const double pixel = canvas.pixelSize(inSpace(a)), R = 20 * pixel;
    std::vector<double> along;
    for (std::size_t i = 1; i < regions<Dim>().size(); ++i) {
        QCOMPARE(*regions<Dim>()[i].phi, phi::kAkvf);
        const Vec<Dim> centre = std::get<Ball<Dim>>(regionIn<Dim>(regions<Dim>()[i].shape)).centre;
        const double t = (centre - a).dot(b - a) / (b - a).squaredNorm();
        QVERIFY((centre - a - t * (b - a)).norm() < 2 * pixel);
        along.push_back(t * (b - a).norm());
    }
    QVERIFY(along.size() > 5);
    QVERIFY(along.front() < 2 * pixel && along.back() > (b - a).norm() - 0.5 * R);
    for (std::size_t i = 1; i < along.size(); ++i)
        QVERIFY(along[i] > along[i - 1] && along[i] - along[i - 1] < R);
    const std::size_t before = regions<Dim>().size();
    stroke<Dim>({-1, 0}, {0, 0}, Qt::ShiftModifier);
    QVERIFY(settle(session));
    QVERIFY(m_f->window().actions().undo->text().contains(QStringLiteral("Smooth")));
    QVERIFY(regions<Dim>().size() > before);
    QVERIFY(click(b, Qt::ShiftModifier | Qt::ControlModifier));  // from the end of that, and takes away
    QVERIFY(m_f->window().actions().undo->text().contains(QStringLiteral("Erase paint")));
    QVERIFY(std::ranges::any_of(regions<Dim>(), [&](const auto& region) {
        return region.erases() && std::get<Ball<Dim>>(regionIn<Dim>(region.shape)).centre.isApprox(b, 0.1);
    }));
}

/// In a greatly enlarged view the end of the last stroke is far beyond any screen: a line from there
/// ends within this function's time limit.
void TestPainting::linesFromAfarEnd() {
    QVERIFY(Bar<2>::open(*m_f));
    auto& canvas = Bar<2>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.radius = Brush::kSmallest; });
    const QPoint middle = canvas.toWidget(Bar<2>::place(0, 0)).toPoint();
    QTest::mouseMove(&canvas, middle);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, middle);
    const QPointF far = middle + QPointF(1e8, 1e8);
    QMouseEvent move(QEvent::MouseMove, far, canvas.mapToGlobal(far), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, middle);
    QVERIFY(settle(m_f->session()));
    QVERIFY(!regions<2>().empty());
}

void TestPainting::keysChangeTheTip() {
    BOTH(changeTip);
}

template <int Dim>
void TestPainting::changeTip() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_3, Qt::ControlModifier);  // elsewhere its key is that of another brush
    QTest::keyClick(&canvas, Dim == 2 ? Qt::Key_B : Qt::Key_A);
    QVERIFY(m_f->tool("paint")->isChecked());
    const double radius = brush().now().radius, hardness = brush().now().hardness;
    QTest::keyClick(&canvas, Qt::Key_BracketRight);
    QVERIFY(std::abs(brush().now().radius - 1.25 * radius) < 1e-9);
    QTest::keyClick(&canvas, Qt::Key_BracketLeft);
    QVERIFY(std::abs(brush().now().radius - radius) < 1e-9);
    QTest::keyClick(&canvas, Qt::Key_BraceLeft, Qt::ShiftModifier);
    QVERIFY(std::abs(brush().now().hardness - hardness + 0.1) < 1e-9);
    QTest::keyClick(&canvas, Qt::Key_N);
    QCOMPARE(brush().now().target, BrushTarget::Direction);
    QVERIFY(m_f->window().findChild<PaintPanel*>()->isVisible());
    auto* row = m_f->window().findChild<QToolBar*>(QStringLiteral("optionRow"));
    for (QToolButton* button : row->findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Keep")) QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(m_f->tool("paint")->isChecked());
    QCOMPARE(brush().now().target, BrushTarget::Keep);
}

void TestPainting::keysChooseAStop() {
    BOTH(chooseStops);
}

/// In the step Paint a tool that cannot paint the kept value is replaced by the brush; one that can stays.
template <int Dim>
void TestPainting::chooseStops() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
    const auto press = [&](int stop) {
        QTest::keyClick(&canvas, static_cast<Qt::Key>(Qt::Key_1 + stop), Qt::ShiftModifier);
    };
    const double before = brush().now().phi;
    press(stopOfPhi(before, Dim) == 0 ? 3 : 0);
    QCOMPARE(brush().now().phi, before);  // not while pins are set
    const std::array<double, 4> phis = {phi::kEquia, phi::kMetr, phi::kAkvf, phi::conformal(Dim)};
    for (const char* tool : {"comb", "eraser", "eyedropper", "paint"})
        for (int stop = 0; stop < 4; ++stop) {
            m_f->tool(tool)->trigger();
            press(stop);
            QCOMPARE(brush().now().phi, phis[static_cast<std::size_t>(stop)]);
            QCOMPARE(brush().now().target, BrushTarget::Keep);
            QVERIFY2(m_f->tool("paint")->isChecked(), tool);
        }
    m_f->tool("gradient")->trigger();
    press(2);
    QVERIFY(m_f->tool("gradient")->isChecked() && brush().now().phi == phi::kAkvf);
}

void TestPainting::altRightDragChangesTheTip() {
    BOTH(dragTip);
}

/// A drag to the right and up makes the brush larger and harder, as the circle at the press shows. It paints
/// nothing, opens no menu and does not rotate the view. Esc reverts it.
template <int Dim>
void TestPainting::dragTip() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.radius = 40, b.hardness = 0.5; });
    QSignalSpy menus(&canvas.viewport(), &Viewport::menuWanted);
    QVERIFY(menus.isValid());
    const int steps = m_f->session().document().undoStack()->count();
    const Vec<Dim> place = Bar<Dim>::place(-1, 0);
    const QPoint at = canvas.toWidget(place).toPoint();
    const auto seen = [&] {
        QImage image(canvas.size(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        canvas.viewport().tool()->paint(painter);
        return image;
    };
    const auto drag = [&](const QPoint& by) {
        QTest::mouseMove(&canvas, at);
        QTest::mousePress(&canvas, Qt::RightButton, Qt::AltModifier, at);
        for (int i = 1; i <= 5; ++i) QTest::mouseMove(&canvas, at + by * i / 5);
    };
    drag({25, -40});
    QVERIFY(std::abs(brush().now().radius - 65) < 1e-9 && std::abs(brush().now().hardness - 0.7) < 1e-9);
    const QImage circle = seen();
    QVERIFY(circle.pixel(at + QPoint(65, 0)) != QColor(Qt::white).rgb());
    QVERIFY(circle.pixel(at - QPoint(65, 0)) != QColor(Qt::white).rgb());
    QCOMPARE(circle.pixel(at + QPoint(90, 0)), QColor(Qt::white).rgb());  // the pointer's own place has none
    QVERIFY(canvas.viewport().tool()->hint().contains(QStringLiteral("larger")));
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QVERIFY(brush().now().radius == 40 && brush().now().hardness == 0.5);
    QTest::mouseRelease(&canvas, Qt::RightButton, Qt::AltModifier, at);
    drag({-1000, 1000});  // as far as a brush goes
    QTest::mouseRelease(&canvas, Qt::RightButton, Qt::AltModifier, at);
    QVERIFY(brush().now().radius == Brush::kSmallest && brush().now().hardness == 0);
    QVERIFY(!canvas.viewport().tool()->hint().contains(QStringLiteral("larger")));
    QCOMPARE(menus.count(), 0);
    QCOMPARE(m_f->session().document().undoStack()->count(), steps);
    QCOMPARE(canvas.toWidget(place).toPoint(), at);
}

void TestPainting::eraserTakesPaintAway() {
    BOTH(erase);
}

/// The tool works as the brush with Ctrl; its key means another tool in the other steps.
template <int Dim>
void TestPainting::erase() {
    QVERIFY(Bar<Dim>::open(*m_f) && setEverywhere<Dim>(1.1));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_E);
    QVERIFY(m_f->tool("measure")->isChecked());
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::conformal(Dim), b.radius = 60, b.hardness = 0.8; });
    stroke<Dim>({-1.5, 0}, {1.5, 0});
    QVERIFY(settle(session));
    const auto phiAt = [&](double u) {
        const int cell = canvas.touch(canvas.toWidget(Bar<Dim>::place(u, 0)))->place.cell;
        return session.motion().frame<Dim>()->material->phi[cell];
    };
    QCOMPARE(phiAt(0), phi::conformal(Dim));
    QTest::keyClick(&canvas, Qt::Key_E);
    QVERIFY(m_f->tool("eraser")->isChecked());
    QVERIFY(m_f->window()
                .template findChild<QToolBar*>(QStringLiteral("toolBar"))
                ->actions()
                .contains(m_f->tool("eraser")));
    set([](BrushSettings& b) { b.radius = Dim == 3 ? 88 : 40; });  // a cell's middle lies below the surface
    stroke<Dim>({0, 0}, {0.1, 0});
    QVERIFY(settle(session));
    QVERIFY(std::abs(phiAt(0) - 1.1) < 1e-9);
    QCOMPARE(phiAt(-1.4), phi::conformal(Dim));
    QVERIFY(m_f->window().actions().undo->text().contains(QStringLiteral("Erase paint")));
    QTest::keyClick(&canvas, Qt::Key_E, Qt::ShiftModifier);
    QVERIFY(m_f->tool("measure")->isChecked());
}

void TestPainting::directionsOfStiffness() {
    BOTH(chooseDirections);
}

/// A stiff part keeps its direction under the brush of stiffness, and its amount under the comb.
template <int Dim>
void TestPainting::chooseDirections() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("comb")->trigger();
    set([](BrushSettings& b) { b.ratio = 8, b.radius = 60, b.hardness = 1; });
    stroke<Dim>({-1, -0.4}, {-1, 0.4});  // across the bar
    QVERIFY(settle(session));
    const auto axisIs = [&](const Vec<Dim>& axis, double ratio) {
        const auto& stiffness = regions<Dim>().back().stiffness;
        return stiffness && std::abs(std::abs(stiffness->axis.dot(inSpace(axis))) - 1) < 0.01 &&
               std::abs(stiffness->ratio - ratio) < 1e-6 * ratio;
    };
    const Vec<Dim> across = (Bar<Dim>::place(0, 1) - Bar<Dim>::place(0, 0)).normalized();
    const Vec<Dim> along = Vec<Dim>::UnitX();
    QVERIFY(axisIs(across, 8));
    set([](BrushSettings& b) {
        b.target = BrushTarget::Stiffness, b.along = StiffAlong::AsItIs, b.ratio = 30, b.radius = 30;
    });
    QVERIFY(m_f->tool("paint")->isChecked());
    stroke<Dim>({-1.05, 0}, {-0.95, 0});
    QVERIFY(settle(session));
    QVERIFY(axisIs(across, 30));
    set([](BrushSettings& b) {
        b.target = BrushTarget::Direction, b.along = StiffAlong::Stroke, b.ratio = 5, b.radius = 20;
    });
    stroke<Dim>({-1.05, 0}, {-0.95, 0});
    QVERIFY(settle(session));
    QVERIFY(axisIs(along, 30));
    set([](BrushSettings& b) { b.along = StiffAlong::Axis, b.axis = {0.6, 0.8, 0}, b.radius = 30; });
    stroke<Dim>({1, 0}, {1.2, 0});
    QVERIFY(settle(session));
    Vec<Dim> slanted = Vec<Dim>::Zero();
    slanted.template head<2>() << 0.6, 0.8;
    QVERIFY(axisIs(slanted, 5));
    // Half of the amount on a part that is not stiff yet: (I + (I + 8 a aᵀ)) / 2.
    set([](BrushSettings& b) { b.ratio = 9, b.amount = 0.5; });
    stroke<Dim>({1.8, 0}, {1.8, 0});
    QVERIFY(settle(session));
    QVERIFY(axisIs(slanted, 5));
    set([](BrushSettings& b) { b.amount = 1; });
    stroke<Dim>({1.8, 0.3}, {1.8, 0.3});
    QVERIFY(settle(session));
    QVERIFY(axisIs(slanted, 9));
}

void TestPainting::directionsAreCarriedBackToRest() {
    BOTH(carryDirections);
}

/// The bar is rotated as a whole by a right angle; the stroke then runs to the right and up. Each place takes
/// the direction of the nearest part of the stroke, in the bar's coordinates at rest.
template <int Dim>
void TestPainting::carryDirections() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    constexpr double kStep = 0.8 * Bar<Dim>::kUnit;
    const Vec<Dim> right = Vec<Dim>::UnitX(), middle = Bar<Dim>::place(0, 0);
    const Vec<Dim> up = (Bar<Dim>::place(0, 1) - middle).normalized();
    const Region<Dim> all = Box<Dim>{Vec<Dim>::Constant(-1000), Vec<Dim>::Constant(1000)};
    session.addHandle(inSpace(all), "All");
    Grip turn{Grip::Kind::Turn};
    turn.centre.template head<Dim>() = middle;
    if (Dim == 3) turn.axis = -Vec3::UnitY();  // towards who looks: from right to up
    session.gestures().moveAtOnce(turn, {std::numbers::pi / 2, 0, 0});
    for (const Vec<Dim>& step : {right, up}) {
        Amount amount = Amount::Zero();
        amount.template head<Dim>() = kStep * step;
        session.gestures().moveAtOnce(Grip{}, amount);
    }
    QVERIFY(settle(session));
    const auto frame = session.motion().frame<Dim>();
    Vec<Dim> now = Vec<Dim>::Zero();  // of the middle
    for (int v = 0; v < frame->vertices; ++v)
        now += (frame->pose.col(v) - frame->rest->points.col(v)) / frame->vertices;
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) {
        b.target = BrushTarget::Stiffness, b.along = StiffAlong::Way, b.ratio = 7, b.radius = 12;
        b.hardness = 1;
    });
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const auto paintedAt = [&](const Vec<Dim>& seen) {
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.toWidget(seen).toPoint());
        const bool done = settle(session);
        const Vec3 axis = done ? regions<Dim>().back().stiffness->axis : Vec3(Vec3::Zero());
        return Vec<Dim>(axis.template head<Dim>());
    };
    // At rest, right was up before the rotation, and up (rotated from right, with either sign) was right.
    const Vec<Dim> corner = middle + kStep * right;
    QVERIFY((now - kStep * (right + up)).norm() < 0.05 * kStep);
    QVERIFY(std::abs(paintedAt(corner - 0.25 * kStep * right + 0.1 * kStep * up).dot(up)) > 0.99);
    QVERIFY(std::abs(paintedAt(corner + 0.6 * kStep * up).dot(right)) > 0.99);
}

QTEST_MAIN(TestPainting)
#include "test_painting.moc"
