#include <QToolButton>

#include "app/engine/motion/places.h"
#include "app/panels/layer_panel.h"
#include "app/panels/paint_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/material_edits.h"
#include "app/session/opening.h"
#include "app/tools/paint/layer_lines.h"
#include "tests/support/paint_test.h"

using namespace wend;
using namespace wend::test;

/// Paint as layers: gradients, fills, their order, names and display.
class TestPaintLayers : public PaintTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { m_f.reset(); }
    void paintColoursThePicture();
    void gradientsAreBlends_data() { dimensions(); }
    void gradientsAreBlends();
    void fillsAndEyedropper_data() { dimensions(); }
    void fillsAndEyedropper();
    void fillsEndWithTheirPart();
    void layersHaveAnOrderAndNames_data() { dimensions(); }
    void layersHaveAnOrderAndNames();
    void marksLieAlongWhatIsStiff();
    void linesOfLayersAreTheirBorders();
    void lineOfTheChosenLayerIsSeen();

  private:
    template <int Dim>
    void blends();
    template <int Dim>
    void fills();
    template <int Dim>
    void orderAndNames();
};

/// The energy's colour is over the picture with the intended opacity; beside the stroke the picture is
/// unchanged.
void TestPaintLayers::paintColoursThePicture() {
    QVERIFY(m_f->openPicture());
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto settled = [&] { return QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000); };
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf, b.radius = 50, b.hardness = 0.9; });
    QVERIFY(settled());
    const auto colourAt = [&](double u) {
        const QPointF at = canvas.toWidget(Bar<2>::place(u, 0)) * canvas.devicePixelRatioF();
        return QColor(canvas.shape().drawn()->image.pixel(at.toPoint()));
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

void TestPaintLayers::gradientsAreBlends() {
    BOTH(blends);
}

template <int Dim>
void TestPaintLayers::blends() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    m_f->tool("gradient")->trigger();
    set([](BrushSettings& b) { b.phi = phi::conformal(Dim); });
    stroke<Dim>({-1, 0}, {1, 0.2}, {}, false);
    const auto shown = posed<Dim>(Bar<Dim>::canvas(*m_f).shownFrame())->material->phi;
    auto& canvas = Bar<Dim>::canvas(*m_f);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, canvas.toWidget(Bar<Dim>::place(1, 0.2)).toPoint());
    QVERIFY(settle(session));
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    const auto blendOf = [&](std::size_t i) {
        return std::get<Blend<Dim>>(regionIn<Dim>(regions<Dim>()[i].shape));
    };
    auto blend = blendOf(0);
    const double pixel = canvas.pixelSize(inSpace(Bar<Dim>::place(0, 0)));
    QVERIFY((blend.from - Bar<Dim>::place(-1, 0)).norm() < 2 * pixel &&
            (blend.to - Bar<Dim>::place(1, 0.2)).norm() < 2 * pixel);
    const auto frame = session.motion().frame<Dim>();
    QVERIFY(frame->material->phi == shown);
    for (int c = 0; c < frame->cells; ++c) {
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (const int v : frame->rest->cells[c]) centre += frame->rest->points.col(v) / (Dim + 1);
        const Vec<Dim> way = blend.to - blend.from;
        const double t = std::clamp((centre - blend.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const double expected = phi::kMetr + t * (phi::conformal(Dim) - phi::kMetr);
        QVERIFY(std::abs(frame->material->phi[c] - expected) < 1e-12);
    }
    // Its ends are handles.
    stroke<Dim>({1, 0.2}, {0.2, -0.2});
    QVERIFY(settle(session));
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    blend = blendOf(0);
    QVERIFY((blend.from - Bar<Dim>::place(-1, 0)).norm() < 2 * pixel);
    QVERIFY((blend.to - Bar<Dim>::place(0.2, -0.2)).norm() < 2 * pixel);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(session));
    QVERIFY(session.motion().frame<Dim>()->material->phi == shown);
    // Esc cancels, and a click is not a drag.
    stroke<Dim>({-0.5, 0}, {1, 0}, {}, false);
    QTest::keyClick(&canvas, Qt::Key_Escape);
    QTest::mouseRelease(&canvas, Qt::LeftButton);
    stroke<Dim>({-1, 0}, {-1, 0});
    QCOMPARE(regions<Dim>().size(), std::size_t(1));
    QVERIFY(posed<Dim>(canvas.shownFrame())->material->phi == shown);
    // It may begin and end beside a picture's shape.
    stroke<Dim>({-1, 1.6}, {1, 1.6});
    QVERIFY(settle(session));
    QCOMPARE(regions<Dim>().size(), std::size_t(Dim == 2 ? 2 : 1));
    if (Dim == 3) return;
    blend = blendOf(1);
    QVERIFY((blend.from - Bar<Dim>::place(-1, 1.6)).norm() < 2 * pixel);
    QVERIFY((blend.to - Bar<Dim>::place(1, 1.6)).norm() < 2 * pixel);
}

void TestPaintLayers::fillsAndEyedropper() {
    BOTH(fills);
}

template <int Dim>
void TestPaintLayers::fills() {
    constexpr double kEverywhere = 1.1;  // other than a new project's
    QVERIFY(Bar<Dim>::open(*m_f) && setEverywhere<Dim>(kEverywhere));
    auto& session = m_f->session();
    const auto allAre = [&](double phi) {
        const auto& is = session.motion().frame<Dim>()->material->phi;
        return std::all_of(is.begin(), is.end(), [phi](double one) { return std::abs(one - phi) < 1e-12; });
    };
    QTest::keyClick(&Bar<Dim>::canvas(*m_f), Qt::Key_2, Qt::ControlModifier);
    m_f->tool("fill")->trigger();
    set([](BrushSettings& b) { b.phi = phi::kAkvf; });
    stroke<Dim>({-1, 0}, {-1, 0});
    QVERIFY(settle(session) && regions<Dim>().size() == 1 && allAre(phi::kAkvf));
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    stroke<Dim>({-1, 0}, {-1, 0}, Qt::ShiftModifier);
    QVERIFY(settle(session) && regions<Dim>().size() == 2 && allAre(phi::kEquia));
    stroke<Dim>({-1, 0}, {-1, 0}, Qt::ControlModifier);
    QVERIFY(settle(session) && allAre(kEverywhere) && regions<Dim>().empty());
    m_f->tool("eyedropper")->trigger();
    stroke<Dim>({1, 0}, {1, 0});
    QVERIFY(std::abs(brush().now().phi - kEverywhere) < 1e-12);
    QVERIFY(undo() && regions<Dim>().size() == 2 && allAre(phi::kEquia));
    // After saving and reading it is the same.
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("filled.wend"));
    session.document().save(path);
    const auto saved = openFile(path).project;
    QCOMPARE(designOf(*saved).material.layers.size(), std::size_t(2));
}

/// The bar is cut in two: a click fills the half at the pointer, with Shift both.
void TestPaintLayers::fillsEndWithTheirPart() {
    QVERIFY(m_f->openPicture());
    auto& session = m_f->session();
    const auto halves = copyOf(m_f->project());
    domainOf(*halves).outline = OutlineKind::Polygons;
    domainOf(*halves).polygons.loops = {{{24, 64}, {110, 64}, {110, 96}, {24, 96}},
                                        {{130, 64}, {216, 64}, {216, 96}, {130, 96}}};
    session.document().change(QStringLiteral("Halves"), halves);
    QVERIFY(settle(session));
    m_f->tool("fill")->trigger();
    const auto halfIs = [&](int side, double phi) {
        const auto frame = session.motion().frame<2>();
        for (int c = 0; c < frame->cells; ++c) {
            const bool isRight = frame->rest->points(0, frame->rest->cells[c][0]) > 120;
            if (isRight == (side > 0) && std::abs(frame->material->phi[c] - phi) > 1e-12) return false;
        }
        return true;
    };
    set([](BrushSettings& b) { b.phi = phi::kAkvf; });
    stroke<2>({-1, 0}, {-1, 0});
    QVERIFY(settle(session) && halfIs(-1, phi::kAkvf) && halfIs(1, phi::kMetr));
    set([](BrushSettings& b) { b.phi = phi::kEquia; });
    stroke<2>({-1, 0}, {-1, 0}, Qt::ShiftModifier);
    QVERIFY(settle(session) && halfIs(-1, phi::kEquia) && halfIs(1, phi::kEquia));
}

void TestPaintLayers::layersHaveAnOrderAndNames() {
    BOTH(orderAndNames);
}

template <int Dim>
void TestPaintLayers::orderAndNames() {
    QVERIFY(Bar<Dim>::open(*m_f));
    auto& session = m_f->session();
    auto& panel = m_f->window().properties().layers();
    m_f->tool("fill")->trigger();
    for (const double phi : {phi::kAkvf, phi::kEquia}) {
        set([phi](BrushSettings& b) { b.phi = phi; });
        stroke<Dim>({0, 0}, {0, 0});
        QVERIFY(settle(session));
    }
    const auto is = [&](double phi) {
        return std::abs(session.motion().frame<Dim>()->material->phi.front() - phi) < 1e-12;
    };
    QCOMPARE(panel.list()->count(), 2);
    QVERIFY(is(phi::kEquia));
    const auto press = [&](const char* id) {
        panel.findChild<QToolButton*>(QLatin1String(id))->click();
        return settle(session);
    };
    panel.list()->setCurrentRow(1);  // the lower one
    QVERIFY(press("layerUp"));
    QVERIFY(is(phi::kAkvf));
    QCOMPARE(panel.list()->currentRow(), 0);
    panel.list()->currentItem()->setText(QStringLiteral("Neck"));
    QVERIFY(settle(session));
    QCOMPARE(layers().back(), std::string("Neck"));
    // An existing name does not join the two layers.
    panel.list()->currentItem()->setText(panel.list()->item(1)->text());
    QVERIFY(settle(session));
    QCOMPARE(m_f->session().document().design().material.layers.size(), std::size_t(2));
    QVERIFY(press("layerRemove"));
    QVERIFY(is(phi::kEquia));
    for (int i = 0; i < 4; ++i) m_f->window().actions().undo->trigger();
    QVERIFY(settle(session));
    QVERIFY(is(phi::kEquia));
    QCOMPARE(panel.list()->count(), 2);
}

/// The marks are long in the combed direction, also when the shape has rotated.
void TestPaintLayers::marksLieAlongWhatIsStiff() {
    QVERIFY(m_f->openPicture());
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto project = copyOf(m_f->project());
    designOf(*project).material.layers.push_back(
        layerWith("all", {{Box<3>{{0, 0, 0}, {240, 160, 0}}}, {}, Stiffness{{1, 0, 0}, 20}}));
    m_f->session().document().change(QStringLiteral("Stiff"), project);
    QVERIFY(settle(m_f->session()));
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QImage bare = canvas.grab().toImage();
    m_f->window().actions().showMarks->setChecked(true);
    const QImage marked = canvas.grab().toImage();
    const QPointF middle = canvas.toWidget({120, 80});
    const QPoint mark(20 + 40 * static_cast<int>(middle.x() / 40),
                      20 + 40 * static_cast<int>(middle.y() / 40));
    const auto differs = [&](const QPoint& by) { return bare.pixel(mark + by) != marked.pixel(mark + by); };
    QVERIFY(differs({0, 0}) && differs({10, 0}) && differs({-10, 0}));
    QVERIFY(!differs({0, 8}) && !differs({0, -8}));
    m_f->picture(QStringLiteral("marks"));
}

/// Points of the lines have the distance from the border that they stand for.
void TestPaintLayers::linesOfLayersAreTheirBorders() {
    SimplicialMesh<2> rest;
    rest.points.resize(2, 4);
    rest.points << 0, 100, 100, 0, 0, 0, 100, 100;
    rest.cells = {{0, 1, 2}, {0, 2, 3}};
    std::vector<MaterialRegion> stroke;
    for (int i = 0; i < 6; ++i) stroke.push_back({{Ball<3>{{20.0 + 8 * i, 50, 0}, 12}, 6}, 1.0});
    const auto distance = [](const std::vector<MaterialRegion>& layer, const Vec2& p) {
        double nearest = INFINITY;
        for (const auto& region : layer)
            nearest = std::min(nearest, signedDistance<2>(inPlane(region.shape), p));
        return nearest;
    };
    const auto check = [&](const std::vector<MaterialRegion>& layer, double tolerance) {
        const RestLines lines = linesOf(layer, rest);
        if (lines.border.empty() || lines.soft.empty()) return false;
        for (const auto& line : lines.border)
            for (const Vec2& p : line)
                if (std::abs(distance(layer, p)) > tolerance) return false;
        for (const auto& line : lines.soft)
            for (const Vec2& p : line)
                if (std::abs(std::abs(distance(layer, p)) - layer[0].feather / 2) > tolerance) return false;
        return true;
    };
    QVERIFY(check(stroke, 1e-9));
    QVERIFY(check({{{HalfSpace<3>{{50, 50, 0}, {1, 1, 0}}, 10}, 1.0}}, 1e-9));
    // Corners of the band are rounded outside and sharp inside.
    const RestLines square = linesOf({{{Polygon{{{20, 20}, {80, 20}, {80, 80}, {20, 80}}}, 10}, 1.0}}, rest);
    QCOMPARE(square.border.size(), std::size_t(1));
    QCOMPARE(square.border[0].size(), std::size_t(5));
    QVERIFY(square.soft.size() >= 1);
    // Carried by a shear, each point follows its cell; parts outside the shape are clipped.
    Points2 pose = rest.points;
    pose.row(0) += 0.5 * rest.points.row(1);
    const PointLocator<2> locator(rest.points, rest.cells);
    const auto carried = carriedLine({{-20, 50}, {120, 50}}, rest, locator, pose);
    QCOMPARE(carried.size(), std::size_t(1));
    for (const Vec2& p : carried[0]) QVERIFY(std::abs(p.y() - 50) < 1e-9 && p.x() > 24 && p.x() < 126);
}

void TestPaintLayers::lineOfTheChosenLayerIsSeen() {
    QVERIFY(m_f->openPicture());
    ShapeCanvas& canvas = m_f->window().canvas();
    m_f->tool("paint")->trigger();
    set([](BrushSettings& b) { b.radius = 40, b.hardness = 1; });
    stroke<2>({-0.5, 0}, {0.5, 0});
    QVERIFY(settle(m_f->session()) && QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&canvas, &leave);
    const QImage bare = canvas.grab().toImage();
    // A stroke chooses its layer without showing the lines; a click shows them.
    auto* list = m_f->window().properties().layers().list();
    QCOMPARE(list->currentRow(), 0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
    const QImage lined = canvas.grab().toImage();
    // The place is 40 pixels above the stroke.
    const QPoint edge = canvas.toWidget(Bar<2>::place(0, 0)).toPoint() - QPoint(0, 40);
    bool seen = false;
    for (int y = -3; y <= 3; ++y)
        seen = seen || bare.pixel(edge + QPoint(0, y)) != lined.pixel(edge + QPoint(0, y));
    QVERIFY(seen);
    m_f->picture(QStringLiteral("layer"));
    m_f->tool("pin")->trigger();  // another step
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QRgb posing = canvas.grab().toImage().pixel(edge);
    m_f->window().properties().layers().list()->setCurrentRow(-1);
    QCOMPARE(canvas.grab().toImage().pixel(edge), posing);
}

QTEST_MAIN(TestPaintLayers)
#include "test_paint_layers.moc"
