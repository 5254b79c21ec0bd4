#include "app/document/material_edits.h"
#include "app/panels/paint_panel.h"
#include "app/session/opening.h"
#include "app/session/solid_places.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

/// The same bar as a cut-out and as a solid, 4 long and 1 high in numbers of its own: u from −2 to 2, v from
/// −½ to ½, over what is seen of it.
template <int Dim>
struct Bar;

template <>
struct Bar<2> {
    static constexpr double kUnit = 50;  // pixels of the picture
    static bool open(SolidFixture& f) { return f.openPicture(); }
    static ShapeCanvas& canvas(SolidFixture& f) { return f.window().canvas(); }
    static Vec<2> place(double u, double v) { return {120 + kUnit * u, 80 + 40 * v}; }
};

template <>
struct Bar<3> {
    static constexpr double kUnit = 1;
    static bool open(SolidFixture& f) { return f.open(600); }
    static SolidCanvas& canvas(SolidFixture& f) { return f.canvas(); }
    static Vec<3> place(double u, double v) { return {u, -0.5, v}; }
};

double smooth(double t) {
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

}  // namespace

/// Painting the material by mouse and keys, on pictures and on solids from one body.
class TestPainting : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void strokesAreSoftRegions_data() { dimensions(); }
    void strokesAreSoftRegions();
    void paintIsSeenAtOnce_data() { dimensions(); }
    void paintIsSeenAtOnce();
    void combedPartsStretchLess_data() { dimensions(); }
    void combedPartsStretchLess();
    void modifiersEraseSmoothAndPick_data() { dimensions(); }
    void modifiersEraseSmoothAndPick();
    void keysChangeTheTip_data() { dimensions(); }
    void keysChangeTheTip();
    void directionsOfStiffness_data() { dimensions(); }
    void directionsOfStiffness();
    void paintColoursThePicture();

  private:
    static void dimensions();
    Brush& brush() { return m_f->window().properties().brush(); }
    template <class Change>
    void set(const Change& change);
    template <int Dim>
    void stroke(const Vec<2>& from, const Vec<2>& to, Qt::KeyboardModifiers modifiers = {},
                bool release = true);
    template <int Dim>
    const std::vector<MaterialRegion<Dim>>& regions() {
        return m_f->session().document().design<Dim>().material.regions;
    }
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
    void changeTip();
    template <int Dim>
    void chooseDirections();
    std::unique_ptr<SolidFixture> m_f;
};

#define BOTH(body)          \
    QFETCH(int, dimension); \
    if (dimension == 2)     \
        body<2>();          \
    else                    \
        body<3>()

void TestPainting::dimensions() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

void TestPainting::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

template <class Change>
void TestPainting::set(const Change& change) {
    BrushSettings next = brush().now();
    change(next);
    brush().set(next);
}

template <int Dim>
void TestPainting::stroke(const Vec<2>& from, const Vec<2>& to, Qt::KeyboardModifiers modifiers,
                          bool release) {
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const QPoint a = canvas.toWidget(Bar<Dim>::place(from.x(), from.y())).toPoint();
    const QPoint b = canvas.toWidget(Bar<Dim>::place(to.x(), to.y())).toPoint();
    QTest::mouseMove(&canvas, a);
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, a);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas, a + (b - a) * i / 8);
    if (release) QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, b);
}

void TestPainting::strokesAreSoftRegions() {
    BOTH(softRegions);
}

/// Against the distance to the stroke's line: whole within the hard part, nothing beyond the brush, and in
/// between what the balls of the file say, each laid upon the ones before.
template <int Dim>
void TestPainting::softRegions() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    const auto plain = session.frame<Dim>()->material->phi;
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 40, b.hardness = 0.5; });
    stroke<Dim>({-1, 0}, {0.5, 0.1});
    QVERIFY(settle(session));
    const auto frame = session.frame<Dim>();
    QCOMPARE(regionGroups<Dim>(m_f->project()).size(), std::size_t(1));
    QVERIFY(regions<Dim>().size() > 5);
    QVERIFY(m_f->window().actions().undo->text().contains(QStringLiteral("Rigid")));
    const Vec<Dim> a = Bar<Dim>::place(-1, 0), b = Bar<Dim>::place(0.5, 0.1);
    const double R = 40 * Bar<Dim>::canvas(*m_f).pixelSize(a), pixel = R / 40;
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
            const auto& ball = std::get<Ball<Dim>>(region.shape);
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
    QVERIFY(session.frame<Dim>()->material->phi == plain);
    m_f->window().actions().redo->trigger();
    QVERIFY(settle(session));
    QVERIFY(session.frame<Dim>()->material->phi == painted);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("painted.wend"));
    session.document().save(path);
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return session.document().source() == path; }, 20000) && settle(session));
    QVERIFY(session.frame<Dim>()->material->phi == painted);
}

void TestPainting::paintIsSeenAtOnce() {
    BOTH(seenAtOnce);
}

/// Before the button is released, and until the motion is there, what is shown is what will be.
template <int Dim>
void TestPainting::seenAtOnce() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    const auto plain = session.frame<Dim>()->material->phi;
    m_f->tool("paint")->trigger();
    QVERIFY(m_f->window().actions().showMap->isChecked());
    stroke<Dim>({-1, 0}, {1, 0}, {}, false);
    QVERIFY(regions<Dim>().empty());
    QVERIFY(session.frame<Dim>()->material->phi == plain);
    QVERIFY(canvas.shownFrame()->material->phi != plain);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QVERIFY(canvas.shownFrame()->material->phi == plain);
    QTest::mouseRelease(&canvas, Qt::LeftButton);
    QVERIFY(regions<Dim>().empty());
    stroke<Dim>({-1, 0}, {1, 0});
    const auto shown = canvas.shownFrame()->material->phi;
    QVERIFY(shown != plain && session.isStale());
    QVERIFY(settle(session));
    QVERIFY(session.frame<Dim>()->material->phi == shown);
    m_f->picture(QStringLiteral("painted-%1").arg(Dim));
    // The first of two strokes that follow each other at once stays.
    stroke<Dim>({-1, 0.3}, {-0.5, 0.3});
    m_f->window().actions().undo->trigger();
    QVERIFY(canvas.shownFrame()->material->phi != plain || session.isStale());
    QVERIFY(settle(session));
    QVERIFY(session.frame<Dim>()->material->phi == shown);
}

void TestPainting::combedPartsStretchLess() {
    BOTH(stretchLess);
}

/// How far the middle goes when the right end is pulled by a unit and the left one is held.
template <int Dim>
double TestPainting::middleMoves() {
    const auto frame = m_f->session().frame<Dim>();
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
        session.addHandle<Dim>(end, "End");
    }
    session.selection().set({1});
    session.moveSelected<Dim>(Grip{}, {Bar<Dim>::kUnit, 0, 0});
    QVERIFY(settle(session));
    const double plain = middleMoves<Dim>();
    QVERIFY(std::abs(plain - 0.5) < 0.03);  // by symmetry
    session.playback().setTime(0);
    QVERIFY(settle(session));
    m_f->tool("comb")->trigger();
    set([](BrushSettings& b) { b.ratio = 20, b.radius = 60, b.hardness = 0.8; });
    for (const double v : {-0.3, 0.0, 0.3}) stroke<Dim>({-1.8, v}, {-0.2, v});
    QVERIFY(settle(session));
    // The axis is the stroke's, at rest.
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
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& canvas = Bar<Dim>::canvas(*m_f);
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::conformal(Dim), b.radius = 60, b.hardness = 0.8; });
    stroke<Dim>({-1.5, 0}, {1.5, 0});
    QVERIFY(settle(session));
    const auto cellAt = [&](double u) {
        return canvas.touch(canvas.toWidget(Bar<Dim>::place(u, 0)))->place.cell;
    };
    const auto phiAt = [&](double u) { return session.frame<Dim>()->material->phi[cellAt(u)]; };
    QCOMPARE(phiAt(0), phi::conformal(Dim));
    // Alt picks up and paints nothing.
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    const QPoint middle = canvas.toWidget(Bar<Dim>::place(0, 0)).toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, Qt::AltModifier, middle);
    QCOMPARE(brush().now().phi, phi::conformal(Dim));
    QCOMPARE(regionGroups<Dim>(m_f->project()).size(), std::size_t(1));
    // Ctrl lays what is everywhere.
    constexpr double kDeep = Dim == 3 ? 2.2 : 1;  // the middle of a tetrahedron lies below the surface
    set([](BrushSettings& b) { b.radius = 40 * kDeep; });
    stroke<Dim>({0, 0}, {0.1, 0}, Qt::ControlModifier);
    QVERIFY(settle(session));
    QCOMPARE(phiAt(0), phi::kMetr);
    QCOMPARE(phiAt(-1.2), phi::conformal(Dim));
    // Shift lays what is around: between the two.
    set([](BrushSettings& b) { b.radius = 80 * kDeep; });
    stroke<Dim>({0.05, 0}, {0.05, 0}, Qt::ShiftModifier);
    QVERIFY(settle(session));
    QVERIFY(phiAt(0.05) > phi::kMetr + 0.02 && phiAt(0.05) < phi::conformal(Dim) - 0.02);
    // Half of the amount: half way on the slider, so from Angle to Length at Rigid.
    const double before = phiAt(-1.2);
    set([](BrushSettings& b) { b.phi = phi::kMetr, b.amount = 0.5, b.radius = 30 * kDeep; });
    stroke<Dim>({-1.2, 0}, {-1.2, 0});
    QVERIFY(settle(session));
    QVERIFY(phiAt(-1.2) < before - 0.01 && phiAt(-1.2) > phi::kMetr + 0.01);
    if (Dim == 2) QVERIFY(before == phi::conformal(2) && std::abs(phiAt(-1.2) - phi::kAkvf) < 1e-9);
}

void TestPainting::keysChangeTheTip() {
    BOTH(changeTip);
}

template <int Dim>
void TestPainting::changeTip() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& canvas = Bar<Dim>::canvas(*m_f);
    canvas.setFocus();
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
    QVERIFY(brush().now().target == BrushTarget::Direction);
    auto* panel = m_f->window().findChild<PaintPanel*>();
    QVERIFY(panel->isVisible());
    for (QToolButton* button : panel->findChildren<QToolButton*>())
        if (button->text() == PaintPanel::tr("Keep")) QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(m_f->tool("paint")->isChecked());
    QVERIFY(brush().now().target == BrushTarget::Keep);
}

void TestPainting::directionsOfStiffness() {
    BOTH(chooseDirections);
}

/// What is stiff already keeps its direction under the brush of stiffness, and its amount under the comb.
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
        return stiffness && std::abs(std::abs(stiffness->axis.dot(axis)) - 1) < 0.01 &&
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
}

/// Over the picture as much of the energy's colour as design asks for; beside the stroke the bare picture.
void TestPainting::paintColoursThePicture() {
    QVERIFY(m_f->openPicture());
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto settled = [&] { return QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000); };
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 50, b.hardness = 0.9; });
    QVERIFY(settled());
    const auto colourAt = [&](double u) {
        const QPointF at = canvas.toWidget(Bar<2>::place(u, 0)) * canvas.devicePixelRatioF();
        return QColor(canvas.drawn()->image.pixel(at.toPoint()));
    };
    const QColor left = colourAt(-1), right = colourAt(1.2);
    stroke<2>({-1.1, 0}, {-0.9, 0});
    QVERIFY(settle(m_f->session()) && settled());
    const QColor rigid(0x2e, 0x77, 0xae);
    const QColor painted = colourAt(-1);
    for (const auto part : {&QColor::red, &QColor::green, &QColor::blue}) {
        const double expected = 0.45 * (left.*part)() + 0.55 * (rigid.*part)();
        QVERIFY2(std::abs((painted.*part)() - expected) < 6, qPrintable(painted.name() + left.name()));
    }
    QCOMPARE(colourAt(1.2), right);
}

QTEST_MAIN(TestPainting)
#include "test_painting.moc"
