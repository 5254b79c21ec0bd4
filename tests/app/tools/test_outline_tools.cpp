// The outline of a picture drawn by hand, on the real canvas with mouse and keys: areas in closed form, one
// undo step per gesture, and the data that a new mesh keeps.

#include <QPainter>
#include <QUndoStack>
#include <QtTest>
#include <cmath>
#include <numbers>

#include "app/panels/fields/option_field.h"
#include "app/panels/mesh_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/part_edits.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/session/pins/pin_traits.h"
#include "app/tools/mesh/outline_tool.h"
#include "app/tools/mesh/size_tool.h"
#include "app/tools/pins/pin_picking.h"
#include "app/views/canvas/canvas.h"
#include "core/meshing/outline_combination.h"
#include "core/solver/components.h"
#include "tests/support/layers.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"
#include "warp/convert.h"
#include "warp/warp.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr int kWidth = 300, kHeight = 200;
constexpr int kVertices = 400;

/// A disc on a ground.
QImage photograph() {
    QImage image(kWidth, kHeight, QImage::Format_RGB888);
    image.fill(QColor(40, 90, 60));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(230, 140, 30));
    painter.drawEllipse(QPointF(200, 100), 60, 60);
    painter.fillRect(20, 20, 30, 30, QColor(230, 140, 30));  // of the same colour, but not connected
    return image;
}

double meshedArea(const SimplicialMesh<2>& mesh) {
    double sum = 0;
    for (const auto& cell : mesh.cells) sum += cellMeasure<2>(mesh.points, cell);
    return sum;
}

}  // namespace

class TestOutlineTools : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void init();
    void lassoOfAPhotographBecomesTheOutline();
    void polygonTakesAway();
    void polygonsGoStraightWithShift();
    void brushAddsAndMakesHoles();
    void cutParts();
    void wandTakesAColour();
    void toleranceChangesTheLastClick();
    void newOutlinesKeepPinsAndMaterial();
    void theFirstStrokeReportsTheLostMargin();
    void pinsBesideItGo();
    void pinsOnTheLineStay();
    void noiseIsLeftOut();
    void linesAreNoParts();
    void drawnLinesAreKept();
    void gesturesAreGivenUp();
    void drawnAtRest();
    void limbsBecomeParts();
    void finerWhereItIsBrushed();

  private:
    void use(OutlineTool::Shape shape, bool takesAway = false);
    QPoint at(double x, double y) const { return m_canvas->toWidget({x, y}).toPoint(); }
    void draw(const std::vector<QPointF>& way, Qt::KeyboardModifiers modifiers = {});
    void click(double x, double y, Qt::KeyboardModifiers modifiers = {});
    const Domain& domain() const { return m_session->document().domain(); }
    int steps() { return m_session->document().undoStack()->index(); }
    void verify(double area, double tolerance, int parts = 1);

    QTemporaryDir m_folder;
    std::unique_ptr<ShapeSession> m_session;
    std::unique_ptr<ShapeCanvas> m_canvas;
    OutlinePen m_pen;
    std::unique_ptr<OutlineTool> m_tool;
};

void TestOutlineTools::initTestCase() {
    QVERIFY(photograph().save(m_folder.filePath(QStringLiteral("photograph.png"))));
}

void TestOutlineTools::init() {
    m_canvas.reset();
    m_tool.reset();
    m_session = std::make_unique<ShapeSession>();
    m_canvas = std::make_unique<ShapeCanvas>(*m_session);
    m_pen.set({});
    m_canvas->resize(700, 500);
    m_canvas->show();
    OpenedFile file = openFile(m_folder.filePath(QStringLiteral("photograph.png")));
    auto project = copyOf(*file.project);
    domainOf(*project).vertices = kVertices;
    file.project = project;
    m_session->document().open(std::move(file));
    QVERIFY(settle(*m_session));
    m_canvas->zoomTo(2);
}

void TestOutlineTools::use(OutlineTool::Shape shape, bool takesAway) {
    m_canvas->viewport().setTool(nullptr);
    m_pen.set({takesAway ? OutlineUse::TakeAway : OutlineUse::Add});
    m_tool = std::make_unique<OutlineTool>(*m_canvas, shape, m_pen);
    m_canvas->viewport().setTool(m_tool.get());
}

void TestOutlineTools::draw(const std::vector<QPointF>& way, Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(m_canvas.get(), Qt::LeftButton, modifiers, at(way[0].x(), way[0].y()));
    for (const QPointF& p : way) {
        QMouseEvent move(QEvent::MouseMove, at(p.x(), p.y()), m_canvas->mapToGlobal(at(p.x(), p.y())),
                         Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(m_canvas.get(), &move);
    }
    QTest::mouseRelease(m_canvas.get(), Qt::LeftButton, modifiers, at(way.back().x(), way.back().y()));
    QVERIFY(settle(*m_session));
}

void TestOutlineTools::click(double x, double y, Qt::KeyboardModifiers modifiers) {
    QTest::mouseClick(m_canvas.get(), Qt::LeftButton, modifiers, at(x, y));
}

/// Checks the area of the document's polygons and of the mesh, which has about the number of vertices aimed
/// at.
void TestOutlineTools::verify(double area, double tolerance, int parts) {
    QCOMPARE(domain().outline, OutlineKind::Polygons);
    const double drawn = areaOf(domain().polygons);
    QVERIFY2(std::abs(drawn - area) <= tolerance, qPrintable(QString("%1, not %2").arg(drawn).arg(area)));
    const auto frame = m_session->motion().frame<2>();
    QVERIFY(std::abs(meshedArea(*frame->rest) - drawn) < 1e-6 * drawn);
    QVERIFY2(std::abs(frame->vertices - kVertices) <= 0.15 * kVertices,
             qPrintable(QString::number(frame->vertices)));
    const auto components = cellComponents<2>(*frame->rest);
    QCOMPARE(*std::max_element(components.begin(), components.end()) + 1, parts);
}

/// A photograph stays where it is behind its new part, which a second one is cut from; each is a step of its
/// own that is undone.
void TestOutlineTools::limbsBecomeParts() {
    use(OutlineTool::Shape::Lasso);
    m_pen.set({OutlineUse::MakePart});
    draw({{50, 40}, {150, 40}, {150, 120}, {50, 120}});
    QCOMPARE(domain().parts.size(), std::size_t(2));
    QCOMPARE(domain().parts[0].cutFrom, std::string("photograph"));
    QVERIFY(domain().parts[0].fill && domain().parts[0].joints.empty());
    QVERIFY(std::abs(areaOf(domain().parts[0].cut) - 100 * 80) < 30);
    const auto& handles = designOf(*m_session->document().project()).handles;
    QCOMPARE(handles.size(), std::size_t(1));
    QCOMPARE(handles[0].part, std::string("photograph"));
    QCOMPARE(partUnder(*m_canvas, m_canvas->toWidget({30, 100}), false), 0);
    QCOMPARE(partUnder(*m_canvas, m_canvas->toWidget({100, 80}), false), -1);  // what is in front of it
    m_session->selection().set({0});
    QVERIFY(!m_session->gestures().mayChange(0));  // a drag beside the part does not take the ground along …
    m_session->gestures().begin();
    QVERIFY(!m_session->motion().isDragging());
    setLocked(m_session->document(), m_session->pins(), {0}, false);  // … until it is unlocked
    QVERIFY(m_session->gestures().mayChange(0));
    m_session->document().undoStack()->undo();
    QVERIFY(m_session->motion().frame<2>() && m_session->motion().frame<2>()->rest->parts.size() == 2);
    draw({{70, 60}, {100, 60}, {100, 90}, {70, 90}});
    QCOMPARE(domain().parts.size(), std::size_t(3));
    QCOMPARE(domain().parts[0].cutFrom, domain().parts[1].name);  // the part in front of the photograph
    QCOMPARE(steps(), 2);
    m_session->document().undoStack()->setIndex(0);
    QVERIFY(domain().parts.empty() && !domain().path.empty());
}

void TestOutlineTools::lassoOfAPhotographBecomesTheOutline() {
    use(OutlineTool::Shape::Lasso);
    const QString first = m_tool->hint();
    QVERIFY2(!first.contains(QStringLiteral("too")), qPrintable(first));  // all bends still
    draw({{50, 40}, {150, 40}, {150, 120}, {50, 120}});
    QVERIFY(m_tool->hint().contains(QStringLiteral("bend, too")));
    verify(100 * 80, 30);
    QCOMPARE(steps(), 1);
    // The next drawing is added, up to the borders of the picture.
    draw({{140, 60}, {400, 60}, {400, 100}, {140, 100}});
    verify(100 * 80 + 150 * 40, 60);
    QCOMPARE(steps(), 2);
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    verify(100 * 80, 30);
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    QCOMPARE(domain().outline, OutlineKind::Frame);
}

/// With Shift the next side follows one of eight directions, even if the pointer is unsteady.
void TestOutlineTools::polygonsGoStraightWithShift() {
    use(OutlineTool::Shape::Polygon);
    click(50, 50);
    click(150, 55, Qt::ShiftModifier);
    click(146, 150, Qt::ShiftModifier);
    QTest::keyClick(m_canvas.get(), Qt::Key_Return);
    QVERIFY(settle(*m_session));
    verify(100 * 100 / 2.0, 60);
}

void TestOutlineTools::polygonTakesAway() {
    use(OutlineTool::Shape::Polygon, true);
    click(100, 50);
    click(200, 50);
    click(260, 170);  // taken back
    QTest::keyClick(m_canvas.get(), Qt::Key_Backspace);
    click(200, 150);
    QCOMPARE(steps(), 0);
    QTest::keyClick(m_canvas.get(), Qt::Key_Return);
    QVERIFY(settle(*m_session));
    verify(kWidth * kHeight - 100 * 100 / 2.0, 30);
    QCOMPARE(domain().polygons.loops.size(), std::size_t(2));
    // A click on the first corner closes the polygon; Ctrl inverts its use.
    for (const QPointF& p : {QPointF(90, 40), QPointF(210, 40), QPointF(210, 160), QPointF(90, 40)})
        click(p.x(), p.y(), Qt::ControlModifier);
    QVERIFY(settle(*m_session));
    verify(kWidth * kHeight, 30);
}

void TestOutlineTools::brushAddsAndMakesHoles() {
    use(OutlineTool::Shape::Brush, true);
    m_pen.set({OutlineUse::TakeAway, 20});  // 10 pixels of the picture
    draw({{100, 100}, {150, 100}, {200, 100}});
    const double capsule = 20 * 100 + std::numbers::pi * 100;
    verify(kWidth * kHeight - capsule, 0.02 * capsule);
    QTest::keyClick(m_canvas.get(), ']');
    QVERIFY(m_pen.now().radius > 20);
    m_pen.set({OutlineUse::TakeAway, 10});
    draw({{100, 100}, {150, 100}}, Qt::ControlModifier);  // an island in the hole
    const double island = 10 * 50 + std::numbers::pi * 25;
    verify(kWidth * kHeight - capsule + island, 0.02 * capsule, 2);
    QCOMPARE(domain().polygons.loops.size(), std::size_t(3));
}

void TestOutlineTools::cutParts() {
    use(OutlineTool::Shape::Cut);
    draw({{140.3, -10}, {152.7, 100}, {150, 210}});
    verify(kWidth * kHeight, 0.01 * kHeight, 2);
    // No part of the picture is lost at the cut.
    const Image& source = *m_session->document().picture();
    const auto frame = m_session->motion().frame<2>();
    const Image whole = converted(warpImage(source, *frame->rest, frame->pose, {source.width, source.height}),
                                  {PixelType::Float, 4, true, true});
    double least = 1;
    std::vector<float> row(static_cast<std::size_t>(whole.width) * 4);
    for (int y = 0; y < whole.height; ++y) {
        loadRow(whole, y, row.data());
        for (int x = 0; x < whole.width; ++x) least = std::min(least, double(row[4 * x + 3]));
    }
    // The share of a pixel that either side covers is rounded.
    QVERIFY2(least > 1 - 5.0 / 255, qPrintable(QString::number(least)));
    QCOMPARE(m_session->document().undoStack()->undoText(), QStringLiteral("Cut"));
}

void TestOutlineTools::wandTakesAColour() {
    use(OutlineTool::Shape::Wand);
    click(200, 100);
    QVERIFY(settle(*m_session));
    const double disc = std::numbers::pi * 60 * 60;
    const double edge = 0.7 * 2 * std::numbers::pi * 60;  // where in its soft edge says the tolerance
    verify(disc, edge);
    QVERIFY(!isInside(domain().polygons, {35, 35}));
    m_session->document().undoStack()->undo();
    m_pen.set({OutlineUse::Add, 20, 1});  // of all colours
    click(200, 100);
    QVERIFY(settle(*m_session));
    verify(kWidth * kHeight, 1);
    m_session->document().undoStack()->undo();
    m_pen.set({});
    click(30, 180, Qt::ControlModifier);  // the ground goes, both that were on it stay
    QVERIFY(settle(*m_session));
    verify(disc + 900, edge + 0.7 * 120, 2);
}

/// The tolerance changes the last click until something else is done; the step stays one, and undo restores
/// the state before it.
void TestOutlineTools::toleranceChangesTheLastClick() {
    use(OutlineTool::Shape::Wand);
    const double disc = std::numbers::pi * 60 * 60, edge = 0.7 * 2 * std::numbers::pi * 60;
    m_pen.set({OutlineUse::Add, 20, 1});  // all colours
    QCOMPARE(steps(), 0);
    click(200, 100);
    QCOMPARE(areaOf(domain().polygons), double(kWidth * kHeight));
    m_pen.set({OutlineUse::Add, 20, 0.12});
    QVERIFY(std::abs(areaOf(domain().polygons) - disc) <= edge);
    QCOMPARE(steps(), 1);
    const double fewer = areaOf(domain().polygons);
    for (int i = 0; i < 4; ++i) QTest::keyClick(m_canvas.get(), Qt::Key_BracketLeft);
    QVERIFY(areaOf(domain().polygons) < fewer && areaOf(domain().polygons) > fewer - edge);
    QCOMPARE(steps(), 1);
    QVERIFY(settle(*m_session));
    verify(disc, edge);
    // Another click is another step, and the result of the earlier click stays as it is.
    m_pen.set({OutlineUse::Add, 20, 0.12});
    const double kept = areaOf(domain().polygons);
    click(35, 35);
    QCOMPARE(steps(), 2);
    QVERIFY(std::abs(areaOf(domain().polygons) - kept - 900) < 0.7 * 120);
    m_session->document().undoStack()->undo();
    m_pen.set({OutlineUse::Add, 20, 1});  // the click is undone
    QCOMPARE(areaOf(domain().polygons), kept);
    QCOMPARE(steps(), 1);
    QCOMPARE(m_session->document().undoStack()->count(), 2);
    m_session->document().undoStack()->undo();
    QCOMPARE(domain().outline, OutlineKind::Frame);
    click(200, 100);
    use(OutlineTool::Shape::Brush);
    m_pen.set({OutlineUse::Add, 20, 0.12});
    QCOMPARE(areaOf(domain().polygons), double(kWidth * kHeight));
    QCOMPARE(steps(), 1);
}

/// Pins, their motion and the material are given at rest: a new outline leaves them as they are.
void TestOutlineTools::newOutlinesKeepPinsAndMaterial() {
    const int pin = m_session->addPin({200, 100, 0});
    QVERIFY(pin >= 0 && m_session->addPin({60, 100, 0}) >= 0);
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({20, 10, 0});
    m_session->gestures().end(0.2);
    const auto painted = copyOf(*m_session->document().project());
    designOf(*painted).material.layers.push_back(layerWith("stiff", {{Ball<3>{{100, 100, 0}, 30}, 4}, 1.5}));
    depthOf(*painted).push_back(layerWith("front", 2, Ball<3>{{100, 100, 0}, 30}));
    m_session->document().change(QStringLiteral("Paint"), painted);
    QVERIFY(settle(*m_session));
    const auto before = m_session->document().project();
    use(OutlineTool::Shape::Brush, true);
    draw({{150, 20}, {150, 60}});
    const auto after = m_session->document().project();
    QVERIFY(after != before);
    const auto same = copyOf(*after);
    domainOf(*same) = domainOf(*before);
    QCOMPARE(toJson(*same), toJson(*before));
    m_session->playback().setTime(m_session->playback().end());
    const auto pins = m_session->gestures().pins();
    QCOMPARE(pins.size(), std::size_t(2));
    QVERIFY((pins[pin].centre - Vec3(220, 110, 0)).norm() < 0.5);
    m_session->document().undoStack()->undo();
    QCOMPARE(m_session->document().project(), before);
}

/// The outline of a cut-out has a margin, a drawn one has none: the notice says so, and the tooltip begins
/// with it.
void TestOutlineTools::theFirstStrokeReportsTheLostMargin() {
    m_session->document().open(openFile(writeCutOut(m_folder)));
    QVERIFY(settle(*m_session));
    m_canvas->zoomTo(2);
    MeshPanel panel(m_session->document(), m_session->motion());
    const auto* margin = panel.findChild<OptionField*>(QStringLiteral("domain.outline.margin"));
    const QString usual = margin->focusProxy()->toolTip();
    QVERIFY(margin->isEnabled() && usual.startsWith("<p><b>Margin"));
    QStringList told;
    connect(&m_session->document(), &Document::notice, this, [&told](const QString& text) { told << text; });
    use(OutlineTool::Shape::Lasso, true);
    for (const double x : {60.0, 120.0}) draw({{x, 50}, {x + 20, 50}, {x + 20, 70}, {x, 70}});
    QCOMPARE(domain().outline, OutlineKind::Polygons);
    QCOMPARE(told.size(), 1);
    QVERIFY(told[0].contains("no margin"));
    QVERIFY(!margin->isEnabled());
    QVERIFY(margin->focusProxy()->toolTip().startsWith("<p><i>Only a cut-out has this."));
    QVERIFY(margin->toolTip() == margin->focusProxy()->toolTip() && margin->toolTip().endsWith(usual));
    QVERIFY(margin->focusProxy()->statusTip().startsWith("Only a cut-out has this."));
    m_session->document().undoStack()->setIndex(0);
    QVERIFY(margin->isEnabled() && margin->focusProxy()->toolTip() == usual);
}

void TestOutlineTools::pinsBesideItGo() {
    QVERIFY(m_session->addPin({60, 60, 0}) >= 0 && m_session->addPin({250, 150, 0}) >= 0);
    QVERIFY(settle(*m_session));
    QSignalSpy notices(&m_session->document(), &Document::notice);
    QSignalSpy problems(&m_session->motion(), &ShapeMotion::problem);
    use(OutlineTool::Shape::Lasso);
    draw({{30, 30}, {120, 30}, {120, 120}, {30, 120}});
    const auto& handles = m_session->document().design().handles;
    QCOMPARE(handles.size(), std::size_t(1));
    QCOMPARE(std::get<std::vector<Vec3>>(handles[0].at)[0], Vec3(60, 60, 0));
    QVERIFY(notices.count() > 0);
    for (const auto& problem : problems) QVERIFY(problem[0].toString().isEmpty());
    m_session->document().undoStack()->undo();
    QCOMPARE(m_session->document().design().handles.size(), std::size_t(2));
}

void TestOutlineTools::pinsOnTheLineStay() {
    Document document;
    OpenedFile file;
    file.project = m_session->document().project();
    document.open(file);
    for (const Vec2& p : {Vec2(30, 60), Vec2(120, 60), Vec2(60, 30), Vec2(60, 120), Vec2(30, 30),
                          Vec2(70, 70), Vec2(29.9, 60)})
        addPin(document, p, "Pin");
    const auto project = copyOf(*document.project());
    QCOMPARE(setOutline(*project, {{{{30, 30}, {120, 30}, {120, 120}, {30, 120}}}}), 1);
    QCOMPARE(designOf(*project).handles.size(), std::size_t(6));
}

/// Parts of less than nine pixels of the picture are ignored.
void TestOutlineTools::noiseIsLeftOut() {
    use(OutlineTool::Shape::Lasso);
    draw({{50, 40}, {150, 40}, {150, 120}, {50, 120}});
    draw({{200, 150}, {202, 150}, {202, 152}, {200, 152}});
    verify(100 * 80, 30);
    QCOMPARE(domain().polygons.loops.size(), std::size_t(1));
    draw({{200, 150}, {206, 150}, {206, 156}, {200, 156}});
    QCOMPARE(domain().polygons.loops.size(), std::size_t(2));
    // The piece cut off is a corner of two pixels.
    draw({{130, 30}, {148, 30}, {148, 42}, {160, 42}, {160, 60}, {130, 60}}, Qt::ControlModifier);
    QCOMPARE(domain().polygons.loops.size(), std::size_t(2));
    draw({{60, 130}, {60, 100}, {40, 100}, {40, 90}, {70, 90}, {70, 130}}, Qt::ControlModifier);
    QCOMPARE(domain().polygons.loops.size(), std::size_t(3));
}

/// A straight stroke of a lasso is ignored; a narrow band is not.
void TestOutlineTools::linesAreNoParts() {
    use(OutlineTool::Shape::Lasso);
    QSignalSpy notices(&m_session->document(), &Document::notice);
    draw({{50, 40}, {150, 41}, {250, 40}});
    QCOMPARE(steps(), 0);
    QCOMPARE(notices.count(), 1);
    draw({{50, 40}, {250, 40}, {250, 44}, {50, 44}});
    QCOMPARE(steps(), 1);
    QCOMPARE(notices.count(), 1);
}

/// Every corner of a star is where it was drawn, to a pixel of the screen.
void TestOutlineTools::drawnLinesAreKept() {
    std::vector<QPointF> star;
    for (int i = 0; i < 24; ++i) {
        const double angle = i * std::numbers::pi / 12, radius = i % 2 == 0 ? 62 : 58;
        star.emplace_back(150 + radius * std::cos(angle), 100 + radius * std::sin(angle));
    }
    use(OutlineTool::Shape::Lasso);
    draw(star);
    for (const QPointF& p : star) {
        double nearest = INFINITY;
        for (const Vec2& q : domain().polygons.loops.at(0))
            nearest = std::min(nearest, (q - Vec2(p.x(), p.y())).norm());
        QVERIFY2(nearest < 0.75, qPrintable(QString::number(nearest)));
    }
}

void TestOutlineTools::gesturesAreGivenUp() {
    use(OutlineTool::Shape::Lasso);
    QTest::mousePress(m_canvas.get(), Qt::LeftButton, {}, at(50, 50));
    QTest::mouseMove(m_canvas.get(), at(100, 50));
    QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_canvas.get(), Qt::LeftButton, {}, at(100, 100));
    QCOMPARE(steps(), 0);
    use(OutlineTool::Shape::Lasso, true);
    QSignalSpy notices(&m_session->document(), &Document::notice);
    draw({{-20, -20}, {320, -20}, {320, 220}, {-20, 220}});  // all of it
    QCOMPARE(steps(), 0);
    QCOMPARE(notices.count(), 1);
    click(100, 100);  // a lasso without an inside
    QCOMPARE(steps(), 0);
}

void TestOutlineTools::drawnAtRest() {
    const int pin = m_session->addPin({200, 100, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({20, 10, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    const double time = m_session->playback().time();
    QVERIFY(time > 0);
    use(OutlineTool::Shape::Brush);  // before the pointer comes
    QCOMPARE(m_session->playback().time(), 0.0);
    m_session->playback().setTime(time / 2);
    QTest::mouseMove(m_canvas.get(), at(100, 100));
    QCOMPARE(m_session->playback().time(), 0.0);
    use(OutlineTool::Shape::Lasso);
    QCOMPARE(m_session->playback().time(), 0.0);
    m_canvas->viewport().setTool(nullptr);  // what was shown is shown again,
    QCOMPARE(m_session->playback().time(), time / 2);
    use(OutlineTool::Shape::Brush);
    m_session->document().close();  // of that document
    m_canvas->viewport().setTool(nullptr);
    QCOMPARE(m_session->playback().time(), 0.0);
}

/// The total number of vertices stays; the edges where it was brushed are about half as long as elsewhere.
void TestOutlineTools::finerWhereItIsBrushed() {
    Brush brush;
    brush.set({.radius = 80, .hardness = 1});  // 40 pixels of the picture
    SizeTool tool(*m_canvas, brush);
    m_canvas->viewport().setTool(&tool);
    const auto meanEdge = [&](bool within) {
        const auto& rest = *m_session->motion().frame<2>()->rest;
        double sum = 0;
        int count = 0;
        for (const auto& facet : facetsOf(rest)) {
            const Vec2 a = rest.points.col(facet.vertices[0]), b = rest.points.col(facet.vertices[1]);
            const double far = ((a + b) / 2 - Vec2(80, 100)).norm();
            if (within ? far > 32 : far < 60) continue;
            sum += (b - a).norm();
            ++count;
        }
        return sum / count;
    };
    QVERIFY(std::abs(meanEdge(true) / meanEdge(false) - 1) < 0.15);
    draw({{80, 100}, {81, 100}});
    QVERIFY2(std::abs(meanEdge(true) / meanEdge(false) - 0.5) < 0.1,
             qPrintable(QString::number(meanEdge(true) / meanEdge(false))));
    QVERIFY(std::abs(m_session->motion().frame()->vertices - kVertices) <= 0.15 * kVertices);
    draw({{80, 100}, {81, 100}}, Qt::ControlModifier);
    QVERIFY(domain().sizes.empty());
    QVERIFY(std::abs(meanEdge(true) / meanEdge(false) - 1) < 0.15);
    m_canvas->viewport().setTool(nullptr);
}

QTEST_MAIN(TestOutlineTools)
#include "test_outline_tools.moc"
