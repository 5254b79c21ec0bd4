// The order of parts where a shape covers itself: the export, the output of `wend run` on every back end, the
// canvas and the ST map are compared with an independent composition, which tests at every pixel's place
// which cells contain it.
#include <OpenImageIO/imageio.h>

#include <QPainter>
#include <QPolygonF>
#include <cmath>

#include "app/engine/motion/fields.h"
#include "app/engine/motion/places.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/frame_export.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/value_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "app/tools/paint/depth_tool.h"
#include "app/tools/pins/pin_tool.h"
#include "app/views/canvas/canvas.h"
#include "app/views/canvas/ground.h"
#include "core/integration/deformer.h"
#include "kernels/opencl_devices.h"
#include "tests/support/layers.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"
#include "warp/warped_picture.h"

using namespace wend;
using namespace wend::test;

using Colour = Eigen::Array4d;

namespace {

constexpr int kWidth = 361, kHeight = 227;

/// An arm that is not quite opaque, and a body.
QImage drawing() {
    QImage image(kWidth, kHeight, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(200, 90, 60, 190), 26, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({{40, 180}, {40, 60}, {130, 40}}));
    painter.setPen(QPen(QColor(60, 110, 200), 80, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(90, 180), QPointF(300, 180));
    return image;
}

const QPolygonF kArm({{20, 10}, {160, 10}, {160, 70}, {70, 90}, {66, 131}, {15, 133}});
const QPointF kHand(126, 41);
constexpr double kHandRadius = 31;
constexpr double kLimb = 0.5;  // where nothing else is said, the arm lies over the body

std::vector<Vec2> pointsOf(const QPolygonF& polygon) {
    std::vector<Vec2> points;
    for (const QPointF& p : polygon) points.emplace_back(p.x(), p.y());
    return points;
}

/// An independent drawing of a bent shape. `orderOf` returns the order of a place at rest.
class Composition {
  public:
    using OrderOf = std::function<double(const QPointF&)>;

    Composition(const QImage& source, const PosedFrame<2>& frame, const OrderOf& orderOf)
        : m_source(source.convertToFormat(QImage::Format_RGBA8888)), m_frame(frame) {
        for (const Cell<2>& cell : frame.rest->cells) {
            QPointF centre;
            for (const int v : cell)
                centre += QPointF(frame.rest->points(0, v), frame.rest->points(1, v)) / 3;
            m_orders.push_back(orderOf(centre));
        }
    }

    /// Returns the associated colour, or nothing where the source is not of one colour around.
    std::optional<Colour> at(int x, int y) const {
        const std::vector<int> near = cellsNear(x, y);
        Colour sum = Colour::Zero();
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i) {
                double through = 1;
                for (const int cell : near) {
                    if (!covers(cell, {x + (i + 0.5) / 8, y + (j + 0.5) / 8})) continue;
                    const auto colour = plainColour(sourceOf(cell, {x + 0.5, y + 0.5}));
                    if (!colour) return {};
                    sum += through * *colour / 64;
                    through *= 1 - (*colour)[3];
                }
            }
        return sum;
    }
    /// Returns the source place of the pixel's centre in the frontmost cell.
    std::optional<Vec2> nearestSource(int x, int y) const {
        for (const int cell : cellsNear(x, y))
            if (covers(cell, {x + 0.5, y + 0.5})) return sourceOf(cell, {x + 0.5, y + 0.5});
        return {};
    }

  private:
    Vec2 corner(const Points2& points, int cell, int k) const {
        return points.col(m_frame.rest->cells[static_cast<std::size_t>(cell)][static_cast<std::size_t>(k)]);
    }
    /// Returns the cells near the pixel from the front to the back: by order, then by number, the greater
    /// first.
    std::vector<int> cellsNear(int x, int y) const {
        std::vector<int> near;
        for (int cell = m_frame.rest->cellCount(); cell-- > 0;) {
            Vec2 low = corner(m_frame.pose, cell, 0), high = low;
            for (int k = 1; k < 3; ++k) {
                low = low.cwiseMin(corner(m_frame.pose, cell, k));
                high = high.cwiseMax(corner(m_frame.pose, cell, k));
            }
            if (low.x() < x + 1 && high.x() > x && low.y() < y + 1 && high.y() > y) near.push_back(cell);
        }
        std::stable_sort(near.begin(), near.end(), [this](int a, int b) {
            return m_orders[static_cast<std::size_t>(a)] > m_orders[static_cast<std::size_t>(b)];
        });
        return near;
    }
    Vec2 weights(int cell, const Vec2& p) const {
        const Vec2 a = corner(m_frame.pose, cell, 0), u = corner(m_frame.pose, cell, 1) - a,
                   v = corner(m_frame.pose, cell, 2) - a, w = p - a;
        const double area = u.x() * v.y() - u.y() * v.x();
        return {(w.x() * v.y() - w.y() * v.x()) / area, (u.x() * w.y() - u.y() * w.x()) / area};
    }
    bool covers(int cell, const Vec2& p) const {
        const Vec2 w = weights(cell, p);
        return w.x() >= 0 && w.y() >= 0 && w.x() + w.y() <= 1;
    }
    Vec2 sourceOf(int cell, const Vec2& p) const {
        const Points2& rest = m_frame.rest->points;
        const Vec2 w = weights(cell, p), a = corner(rest, cell, 0);
        return a + w.x() * (corner(rest, cell, 1) - a) + w.y() * (corner(rest, cell, 2) - a);
    }
    std::optional<Colour> plainColour(const Vec2& p) const {
        const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
        std::optional<QRgb> all;
        for (int j = y - 4; j <= y + 4; ++j)
            for (int i = x - 4; i <= x + 4; ++i) {
                const QRgb one = m_source.valid(i, j) ? m_source.pixel(i, j) : 0;
                if (all && *all != one) return {};
                all = one;
            }
        const double alpha = qAlpha(*all) / 255.0;
        return Colour(alpha * qRed(*all), alpha * qGreen(*all), alpha * qBlue(*all), 255 * alpha) / 255;
    }

    QImage m_source;
    const PosedFrame<2>& m_frame;
    std::vector<double> m_orders;
};

/// Returns all cells of the pose that contain the point.
std::vector<int> cellsAt(const PosedFrame<2>& frame, const Vec2& p) {
    std::vector<int> cells;
    for (int c = 0; c < frame.rest->cellCount(); ++c) {
        const Cell<2>& cell = frame.rest->cells[c];
        const auto side = [&](int k) {
            const Vec2 a = frame.pose.col(cell[k]), b = frame.pose.col(cell[(k + 1) % 3]);
            return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
        };
        if ((side(0) > 0) == (side(1) > 0) && (side(1) > 0) == (side(2) > 0)) cells.push_back(c);
    }
    return cells;
}

int distance(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

}  // namespace

class TestDepth : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void crossingLimb_data();
    void crossingLimb();
    void orderIsUndone();
    void brushed();
    void clicksPickTheVisiblePart();
    void pinsInFrontArePicked();
    void strokesKeepLargerLayers();
    void anotherMeshHasItsOwnOrder();
    void mapsShowTheFrontCells();
    void pinsBringTheirPart();

  private:
    void setDepth(ValueLayers layers);
    void fileShows(const QString& path, const Composition& expected, const char* what);
    void canvasIsTheExport();
    void mapTells(const QString& path, const Composition& expected);
    QString run(BackEndKind backEnd);
    QString exported(ExportKind kind, const QString& name);

    QTemporaryDir m_folder;
    QImage m_drawing = drawing();
    ShapeSession m_session;
    ShapeCanvas m_canvas{m_session};
};

void TestDepth::initTestCase() {
    m_canvas.resize(420, 333);
    m_canvas.viewport().set(&Looks::hidden, true);
    m_canvas.show();
    const QString path = m_folder.filePath(QStringLiteral("drawing.png"));
    QVERIFY(m_drawing.save(path));
    OpenedFile file = openFile(path);
    auto project = std::make_shared<Project>(*file.project);
    project->domain.vertices = 500;
    project->design.material.memory = 0;  // the arm lies farther over the body
    file.project = project;
    m_session.document().open(std::move(file));
    QVERIFY(settle(m_session));
    const int hand = m_session.addPin({126, 41, 0});
    QVERIFY(hand >= 0 && m_session.addPin({250, 180, 0}) >= 0 && m_session.addPin({120, 180, 0}) >= 0);
    m_session.selection().set({hand});
    m_session.gestures().begin();
    m_session.gestures().moveBy({60, 130, 0});
    m_session.gestures().end(0.2);
    QVERIFY(settle(m_session));
}

void TestDepth::setDepth(ValueLayers layers) {
    Project project = *m_session.document().project();
    project.depth = std::move(layers);
    m_session.document().change(QStringLiteral("Depth"), std::move(project));
    QVERIFY(settle(m_session));
}

QString TestDepth::exported(ExportKind kind, const QString& name) {
    const QString path = m_folder.filePath(name);
    std::string remark;
    FrameExport(m_session.document(), m_session.motion().frame(), {}, 1)
        .write(kind, path.toStdString(), {}, {}, remark);
    return path;
}

/// Runs the saved project by the command line's own function.
QString TestDepth::run(BackEndKind backEnd) {
    const QString file = m_folder.filePath(QStringLiteral("saved.wend")),
                  picture = m_folder.filePath(QStringLiteral("run.png"));
    m_session.document().save(file);
    RunOptions options;
    options.backEnd = backEnd;
    options.outputs.image = {picture.toStdString()};
    const Project project = *readProject(file.toStdString()).project;
    if (runProject(project, file.toStdString(), options).outcome != Outcome::Done) return {};
    return picture;
}

void TestDepth::fileShows(const QString& path, const Composition& expected, const char* what) {
    const QImage file = QImage(path).convertToFormat(QImage::Format_RGBA8888);
    QCOMPARE(file.size(), QSize(kWidth, kHeight));
    int compared = 0, off = 0;
    double most = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto colour = expected.at(x, y);
            if (!colour) continue;
            ++compared;
            const QRgb c = file.pixel(x, y);
            const double alpha = qAlpha(c) / 255.0;
            const Colour found =
                Colour(alpha * qRed(c), alpha * qGreen(c), alpha * qBlue(c), 255 * alpha) / 255;
            const double one = 255 * (found - *colour).abs().maxCoeff();
            most = std::max(most, one);
            // The tolerance is two levels of rounding; a place on an edge up to rounding may count otherwise.
            off += one > 2 ? 1 : 0;
        }
    QVERIFY2(compared > 60000, what);
    QVERIFY2(
        off <= 5 && most <= 6,
        qPrintable(
            QString("%1: %2 of %3 pixels are off, by up to %4").arg(what).arg(off).arg(compared).arg(most)));
}

/// At 100 %, over the canvas's own ground, the canvas equals the export of the same part of the plane.
void TestDepth::canvasIsTheExport() {
    m_canvas.zoomTo(1);
    QVERIFY(QTest::qWaitFor([&] { return m_canvas.isSettled(); }, 60000));
    const QImage shown = m_canvas.grab().toImage();
    const FrameExport shape(m_session.document(), m_session.motion().frame(), {}, 1);
    WarpOptions options = shape.warpOptions({});
    options.restMargin = 0;
    const View view{shown.width(), shown.height(), m_canvas.toShape({0, 0}), 1 / shown.devicePixelRatio()};
    const QString path = m_folder.filePath(QStringLiteral("view.png"));
    writeWarped(path.toStdString(),
                WarpedPicture(*shape.picture(), shape.restInPixels(), shape.poseInPixels(), view, options));
    const QImage file = QImage(path).convertToFormat(QImage::Format_RGBA8888);
    QImage ground(shown.size(), QImage::Format_RGB32);
    QPainter painter(&ground);
    const Theme theme = Theme::of(m_canvas.palette());
    const QRectF paper(0, 0, kWidth, kHeight);
    Ground().paint(painter, {m_canvas.view(), ground.size(), 1, paper, {}, theme.dark}, theme, false);
    painter.end();
    int off = 0;
    for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) {
            const QRgb c = file.pixel(x, y), below = ground.pixel(x, y);
            const double alpha = qAlpha(c) / 255.0;
            const QRgb s = shown.pixel(x, y);
            const double most =
                std::max({std::abs(alpha * qRed(c) + (1 - alpha) * qRed(below) - qRed(s)),
                          std::abs(alpha * qGreen(c) + (1 - alpha) * qGreen(below) - qGreen(s)),
                          std::abs(alpha * qBlue(c) + (1 - alpha) * qBlue(below) - qBlue(s))});
            off += most > 2 ? 1 : 0;
        }
    QCOMPARE(off, 0);
}

void TestDepth::mapTells(const QString& path, const Composition& expected) {
    const auto input = OIIO::ImageInput::open(path.toStdString());
    QVERIFY(input && input->spec().width == kWidth && input->spec().height == kHeight);
    std::vector<float> map(static_cast<std::size_t>(kWidth) * kHeight * 4);
    QVERIFY(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, map.data()));
    int compared = 0, off = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float* pixel = map.data() + 4 * (y * kWidth + x);
            const auto source = expected.nearestSource(x, y);
            if (!source || pixel[3] < 1) continue;
            ++compared;
            const Vec2 told(kWidth * double(pixel[0]), kHeight * (1 - double(pixel[1])));
            off += (told - *source).norm() > 0.05 ? 1 : 0;
        }
    QVERIFY(compared > 15000);
    // On the borders of parts the map gives the cell that covers most of the pixel, not the one at its
    // centre.
    QVERIFY2(off < 0.01 * compared, qPrintable(QString::number(off)));
}

void TestDepth::crossingLimb_data() {
    QTest::addColumn<int>("arm");   // order of the arm …
    QTest::addColumn<int>("hand");  // … and of the circle at its end, which wins
    QTest::addColumn<int>("all");   // of a half plane that stands before both
    QTest::newRow("in front") << 1 << 1 << 0;
    QTest::newRow("behind") << -1 << -1 << 0;
    QTest::newRow("hand behind, arm in front") << 1 << -2 << 0;
    QTest::newRow("hand in front, arm behind the body") << -3 << 2 << -1;
    QTest::newRow("all of one order but the hand") << 5 << 4 << 5;
    QTest::newRow("nothing said") << 0 << 0 << 0;
}

void TestDepth::crossingLimb() {
    QFETCH(int, arm);
    QFETCH(int, hand);
    QFETCH(int, all);
    setDepth({layerWith("all", double(all), HalfSpace<3>{{0, -50, 0}, {0, 1, 0}}),
              layerWith("arm", double(arm), Polygon{pointsOf(kArm)}),
              layerWith("hand", double(hand), Ball<3>{{kHand.x(), kHand.y(), 0}, kHandRadius})});
    const Composition expected(m_drawing, *m_session.motion().frame<2>(), [&](const QPointF& p) -> double {
        if (std::hypot(p.x() - kHand.x(), p.y() - kHand.y()) < kHandRadius) return hand + kLimb;
        return kArm.containsPoint(p, Qt::OddEvenFill) ? arm + kLimb : all;
    });
    fileShows(exported(ExportKind::Picture, QStringLiteral("exported.png")), expected, "export");
    fileShows(run(BackEndKind::Cpu), expected, "wend run");
    if (openClDevices().problem != "built without OpenCL")
        fileShows(run(BackEndKind::OpenCl), expected, "wend run on OpenCL");
    canvasIsTheExport();
    mapTells(exported(ExportKind::StMap, QStringLiteral("map.exr")), expected);
}

/// Undo restores the picture without computing: the frame stays the same.
void TestDepth::orderIsUndone() {
    setDepth({});
    const auto picture = [&] { return QImage(exported(ExportKind::Picture, QStringLiteral("undo.png"))); };
    const QImage before = picture();
    const FramePtr frame = m_session.motion().frame();
    setDepth({layerWith("arm", 3, Polygon{pointsOf(kArm)})});
    QCOMPARE(m_session.motion().frame(), frame);
    const QImage front = picture();
    setDepth({layerWith("arm", -3, Polygon{pointsOf(kArm)})});
    QVERIFY(front != picture());
    m_session.document().undoStack()->undo();
    QCOMPARE(picture(), front);
    m_session.document().undoStack()->undo();
    QCOMPARE(picture(), before);
    QCOMPARE(m_session.motion().frame(), frame);
}

/// The stroke is over the visible place of the hand on the canvas and brushes the hand at rest.
void TestDepth::brushed() {
    setDepth({layerWith("hand", 1, Ball<3>{{kHand.x(), kHand.y(), 0}, kHandRadius})});  // over the body
    Brush brush;
    brush.order().set(2);
    DepthTool tool(m_canvas, brush);
    m_canvas.zoomTo(1);
    m_canvas.viewport().set(&Looks::hidden, false);
    m_canvas.viewport().setTool(&tool);
    QVERIFY(QTest::qWaitFor([&] { return m_canvas.isSettled(); }, 60000));
    const auto orderAt = [&](const Vec2& p) {
        double found = 0;
        for (const ValueLayer& layer : m_session.document().project()->depth)
            for (const SoftRegion& region : layer.regions)
                if (signedDistance<2>(inPlane(region.shape), p) <= 0) found = layer.value;
        return found;
    };
    const auto stroke = [&](Qt::KeyboardModifiers modifiers) {
        const QPoint hand = m_canvas.onScreen(m_session.gestures().pins()[0].centre).toPoint();
        QTest::mousePress(&m_canvas, Qt::LeftButton, modifiers, hand);
        QTest::mouseMove(&m_canvas, hand + QPoint(4, 2));
        QTest::mouseRelease(&m_canvas, Qt::LeftButton, modifiers, hand + QPoint(4, 2));
        return settle(m_session);
    };
    const QImage before = m_canvas.grab().toImage();
    QVERIFY(stroke({}));
    QCOMPARE(orderAt({126, 41}), 2.0);
    QCOMPARE(orderAt({250, 180}), 0.0);
    QVERIFY(QTest::qWaitFor([&] { return m_canvas.isSettled(); }, 60000));
    QVERIFY(m_canvas.grab().toImage() != before);
    QUndoStack& undo = *m_session.document().undoStack();
    undo.undo();
    QVERIFY(settle(m_session));
    QVERIFY(stroke(Qt::ControlModifier));
    QCOMPARE(orderAt({126, 41}), 0.0);
    undo.undo();
    QVERIFY(settle(m_session));
    QVERIFY(stroke(Qt::ShiftModifier));
    QCOMPARE(orderAt({126, 41}), -2.0);
    undo.undo();
    QCOMPARE(m_session.document().project()->depth.size(), std::size_t(1));
    m_canvas.viewport().setTool(nullptr);
    m_canvas.viewport().set(&Looks::hidden, true);
}

/// Of the hand and the body below, a click picks the one in front, whichever has the greater numbers.
void TestDepth::clicksPickTheVisiblePart() {
    for (const double order : {1.0, -1.0}) {
        setDepth({layerWith("hand", order, Ball<3>{{kHand.x(), kHand.y(), 0}, kHandRadius})});
        const auto touch = m_canvas.touch(m_canvas.onScreen(m_session.gestures().pins()[0].centre));
        QVERIFY(touch);
        const Vec2 rest = inPlane(m_session.motion().frame()->restAt(touch->place));
        QCOMPARE((rest - Vec2(kHand.x(), kHand.y())).norm() < kHandRadius, order > 0);
    }
}

/// The body has a pin a few pixels beside that of the hand: a click on either picks the visible one.
void TestDepth::pinsInFrontArePicked() {
    setDepth({});
    const auto before = m_session.motion().frame<2>();
    const Vec2 hand = inPlane(m_session.gestures().pins()[0].centre);
    std::optional<Vec2> below;
    for (const int cell : cellsAt(*before, hand + Vec2(4, 0))) {
        const auto place = locationIn<2>(*before, cell, hand + Vec2(4, 0));
        const Vec2 rest = positionOf<2>(place, *before->rest, before->rest->points);
        if ((rest - Vec2(kHand.x(), kHand.y())).norm() > kHandRadius) below = rest;
    }
    QVERIFY(below);
    const int steps = m_session.document().undoStack()->count();
    const int body = m_session.addHandle(std::vector<Vec3>{inSpace(*below)}, "Body");
    QVERIFY(settle(m_session));
    PinChoice choice;
    PinTool tool(m_canvas, choice, false);
    m_canvas.zoomTo(1);
    for (const double order : {1.0, -1.0}) {
        setDepth({layerWith("hand", order, Ball<3>{{kHand.x(), kHand.y(), 0}, kHandRadius})});
        for (const int pin : {0, body}) {
            Vec3 place;
            for (const auto& view : m_session.gestures().pins())
                if (view.handle == pin) place = view.centre;
            QCOMPARE(tool.handleAt(m_canvas.onScreen(place)), order > 0 ? 0 : body);
        }
        // Beside the visible pin, only the other one is within reach.
        const int other = order > 0 ? body : 0;
        QCOMPARE(tool.handleAt(m_canvas.toWidget(hand + Vec2(order > 0 ? 10 : -6, 0))), other);
    }
    m_session.document().undoStack()->setIndex(steps);
    QVERIFY(settle(m_session));
}

/// Only layers that a stroke hides completely are removed.
void TestDepth::strokesKeepLargerLayers() {
    setDepth({layerWith("body", 2, Ball<3>{{200, 180, 0}, 60})});
    const ValueLayers& depth = m_session.document().depth();
    const auto small =
        withDepthStroke(depth, {{Ball<3>{{200, 180, 0}, 10}}, {Ball<3>{{206, 180, 0}, 10}}}, -1);
    QVERIFY(small.size() == 2 && small[0].value == 2 && small[1].regions.size() == 2);
    QCOMPARE(withDepthStroke(depth, {{Ball<3>{{210, 180, 0}, 80}}}, -1).size(), std::size_t(1));
}

void TestDepth::anotherMeshHasItsOwnOrder() {
    setDepth({layerWith("arm", 1, Polygon{pointsOf(kArm)})});
    canvasIsTheExport();
    for (const int vertices : {350, 500}) {
        setVertices(m_session.document(), vertices);
        QVERIFY(settle(m_session));
        canvasIsTheExport();
    }
}

/// Where two cells with very different colours overlap, that of the upper one is visible.
void TestDepth::mapsShowTheFrontCells() {
    const auto frame = m_session.motion().frame<2>();
    const std::vector<double> values = cellValues(*frame, Measure::Angle);
    const MeasureRange range{0, rangeOf(values, Measure::Angle).high / 8};
    const auto colourOf = [&](int cell) {
        return QColor(colourAt(Measure::Angle, positionIn(range, Measure::Angle, values[cell])));
    };
    m_canvas.viewport().set(&Looks::hidden, false);
    m_canvas.viewport().set(&Looks::colours, {Measure::Angle, range, 1.0});  // none of the picture
    m_canvas.viewport().set(&Looks::map, true);
    for (const double order : {1.0, -1.0}) {
        setDepth({layerWith("arm", order, Polygon{pointsOf(kArm)})});
        QVERIFY(QTest::qWaitFor([&] { return m_canvas.isSettled(); }, 60000));
        const QImage& seen = m_canvas.shape().drawn()->image;
        const auto isArm = [&](int cell) {
            Vec2 centre = Vec2::Zero();
            for (const int v : frame->rest->cells[cell]) centre += frame->rest->points.col(v) / 3;
            return kArm.containsPoint({centre.x(), centre.y()}, Qt::OddEvenFill);
        };
        const auto lieOver = [&](double x, double y) {
            const auto cells = cellsAt(*frame, m_canvas.toShape(QPointF(x, y) / seen.devicePixelRatio()));
            return cells.size() == 2 && isArm(cells[0]) != isArm(cells[1]);
        };
        int compared = 0, wrong = 0;
        for (int y = 0; y < seen.height(); y += 2)
            for (int x = 0; x < seen.width(); x += 2) {
                // The outline's pixels are a mixture of both.
                if (!lieOver(x, y) || !lieOver(x + 1, y) || !lieOver(x, y + 1) || !lieOver(x + 1, y + 1))
                    continue;
                const Vec2 p = m_canvas.toShape(QPointF(x + 0.5, y + 0.5) / seen.devicePixelRatio());
                const std::vector<int> cells = cellsAt(*frame, p);
                if (cells.size() != 2 || isArm(cells[0]) == isArm(cells[1])) continue;
                const int arm = isArm(cells[0]) ? 0 : 1;
                const QColor upper = colourOf(cells[order > 0 ? arm : 1 - arm]),
                             lower = colourOf(cells[order > 0 ? 1 - arm : arm]);
                if (distance(upper, lower) < 120) continue;
                ++compared;
                const QColor pixel(seen.pixel(x, y));
                wrong += distance(pixel, upper) > distance(pixel, lower) ? 1 : 0;
            }
        QVERIFY2(compared > 20, qPrintable(QString::number(compared)));
        QVERIFY2(wrong <= 0.02 * compared, qPrintable(QString("%1 of %2").arg(wrong).arg(compared)));
    }
    m_canvas.viewport().set(&Looks::map, false);
    m_canvas.viewport().set(&Looks::hidden, true);
}

void TestDepth::pinsBringTheirPart() {
    setDepth({});
    const double size = m_session.motion().frame()->diagonal;
    const auto with = [size](Project project, const std::vector<int>& handles, double order) {
        project.depth = withHandleDepth(project.depth, project.design, handles, order, size);
        return project;
    };
    const auto of = [](const Project& project, std::size_t handle) {
        return depthOfHandle(project.depth, project.design.handles[handle].name);
    };
    Project project = with(*m_session.document().project(), {0}, 3);
    QCOMPARE(project.depth.size(), std::size_t(1));
    QVERIFY(signedDistance<2>(inPlane(project.depth[0].regions[0].shape), {126, 41}) < 0);
    QVERIFY(signedDistance<2>(inPlane(project.depth[0].regions[0].shape), {120, 180}) >
            0);  // where another pin is
    QCOMPARE(of(project, 0), std::optional(3.0));
    QCOMPARE(of(project, 1), std::nullopt);
    project = withHandleName(project, 0, "hand");
    QCOMPARE(of(project, 0), std::optional(3.0));
    project = with(project, {0, 1}, -1);
    QCOMPARE(project.depth.size(), std::size_t(2));
    QCOMPARE(of(project, 0), std::optional(-1.0));
    project = with(project, {0, 1}, 0);
    QVERIFY(project.depth.empty());
    // Each of two pins close to each other takes at most the half between them.
    const Project near = with(withPin(project, Vec2(146, 41), "near"), {0}, 1);
    QVERIFY(signedDistance<2>(inPlane(near.depth[0].regions[0].shape), {134, 41}) < 0);
    QVERIFY(signedDistance<2>(inPlane(near.depth[0].regions[0].shape), {137, 41}) > 0);
}

QTEST_MAIN(TestDepth)
#include "test_depth.moc"
