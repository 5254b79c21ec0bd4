#include <Eigen/LU>
#include <QCoreApplication>
#include <QLocale>
#include <QPainterPath>
#include <cmath>
#include <optional>

#include "app/engine/shape/shape.h"
#include "app/session/crop.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/tools/drag_label.h"
#include "app/tools/tool_kinds.h"

namespace wend {

namespace {

/// Draws the crop of exports: a rectangle of pixels that is moved by its inside and resized by its sides and
/// corners. Shift keeps the picture's proportions.
class CropTool : public ShapeTool<PictureShapeView> {
  public:
    CropTool(PictureShapeView& view, Crop& crop) : ShapeTool<PictureShapeView>(view), m_crop(crop) {}

    QString hint() const override;
    QCursor cursor() const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    void doubleClick(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    bool ownsKey(const QKeyEvent& event) const override;
    void cancel() override;
    void leave() override { m_under = {}; }
    void paint(QPainter& painter) const override;

  private:
    /// The part that follows the pointer: a side per axis (−1 low, 1 high, 0 none), or all.
    struct Grip {
        int x = 0, y = 0;
        bool all = false;
        bool any() const { return x != 0 || y != 0 || all; }
    };
    /// Returns the picture of the document or of a file's mesh; null if there is nothing to crop.
    std::shared_ptr<const Image> picture() const;
    Vec2 toPixels(const QPointF& widget) const;
    QPointF toWidget(const Vec2& pixel) const;
    Grip gripAt(const QPointF& widget) const;
    QPolygonF outline(const PixelRect& part) const;
    void drawTo(const Vec2& pixel, bool proportional);

    Crop& m_crop;
    Grip m_grip, m_under;  // dragged; under the pointer
    bool m_active = false;
    std::optional<PixelRect> m_before;
    Vec2 m_from = Vec2::Zero();  // where it was pressed, in pixels of the picture
    QPointF m_at;
};

constexpr double kSideReach = 8;  // of a side, in pixels of the screen
constexpr double kHandle = 7;     // the size of a corner's square
constexpr double kLargest = 1e5;  // pixels of the picture

/// Returns the rectangle between two corners, on whole pixels and at least one pixel large.
PixelRect between(const Vec2& a, const Vec2& b) {
    const Vec2 low = a.cwiseMin(b).array().round().cwiseMax(-kLargest).cwiseMin(kLargest);
    const Vec2 high = a.cwiseMax(b).array().round().cwiseMax(-kLargest).cwiseMin(kLargest);
    const Vec2 size = (high - low).cwiseMax(1);
    return {static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(size.x()),
            static_cast<int>(size.y())};
}

Vec2 lowOf(const PixelRect& part) {
    return {part.x, part.y};
}

Vec2 highOf(const PixelRect& part) {
    return {part.x + part.width, part.y + part.height};
}

QString CropTool::hint() const {
    return QCoreApplication::translate(
        "CropTool",
        "Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the "
        "proportions, Delete or a double-click removes it");
}

QCursor CropTool::cursor() const {
    const Grip& grip = m_active ? m_grip : m_under;
    if (grip.all) return Qt::SizeAllCursor;
    if (grip.x != 0 && grip.y != 0) return grip.x == grip.y ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
    if (grip.any()) return grip.x != 0 ? Qt::SizeHorCursor : Qt::SizeVerCursor;
    return Qt::CrossCursor;
}

std::shared_ptr<const Image> CropTool::picture() const {
    const auto frame = session().motion().frame<2>();
    return frame ? frame->built->picture : nullptr;
}

/// Returns a point in pixels of the picture, in which a 2D mesh may have any placement.
Vec2 CropTool::toPixels(const QPointF& widget) const {
    const auto frame = session().motion().frame<2>();
    const Vec2 at = view().toShape(widget);
    return frame && frame->built->texture ? Vec2(frame->built->texture->toPixels(at)) : at;
}

QPointF CropTool::toWidget(const Vec2& pixel) const {
    const auto frame = session().motion().frame<2>();
    if (!frame || !frame->built->texture) return view().toWidget(pixel);
    const PictureMap& map = frame->built->texture->toPixels;
    return view().toWidget(map.A.inverse() * (pixel - map.b));
}

QPolygonF CropTool::outline(const PixelRect& part) const {
    const Vec2 a = lowOf(part), b = highOf(part);
    return {{toWidget(a), toWidget({b.x(), a.y()}), toWidget(b), toWidget({a.x(), b.y()})}};
}

CropTool::Grip CropTool::gripAt(const QPointF& widget) const {
    const auto& part = m_crop.now();
    if (!part) return {};
    const Vec2 at = toPixels(widget), a = lowOf(*part), b = highOf(*part);
    const double reach = marked(kSideReach) * (toPixels(widget + QPointF(1, 0)) - at).norm();
    if (((a - at).array() > reach).any() || ((at - b).array() > reach).any()) return {};
    Grip grip;
    grip.x = std::abs(at.x() - b.x()) <= reach ? 1 : std::abs(at.x() - a.x()) <= reach ? -1 : 0;
    grip.y = std::abs(at.y() - b.y()) <= reach ? 1 : std::abs(at.y() - a.y()) <= reach ? -1 : 0;
    grip.all = grip.x == 0 && grip.y == 0;
    return grip;
}

void CropTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !picture()) return;
    m_at = event.position();
    m_from = toPixels(m_at);
    m_before = m_crop.now();
    m_grip = gripAt(m_at);
    m_active = true;
}

void CropTool::move(const QMouseEvent& event) {
    m_at = event.position();
    if (m_active)
        drawTo(toPixels(m_at), event.modifiers().testFlag(Qt::ShiftModifier));
    else
        m_under = gripAt(m_at);
    view().redraw();
}

void CropTool::drawTo(const Vec2& pixel, bool proportional) {
    const Vec2 by = pixel - m_from;
    Vec2 a = m_from, b = pixel;
    if (m_before && m_grip.all) {
        const Vec2 moved = lowOf(*m_before) + by;
        return m_crop.set(between(moved, moved + Vec2(m_before->width, m_before->height)));
    }
    if (m_before && m_grip.any()) {
        a = lowOf(*m_before), b = highOf(*m_before);
        if (m_grip.x < 0) std::swap(a.x(), b.x());  // b is the corner that follows the pointer
        if (m_grip.y < 0) std::swap(a.y(), b.y());
        if (m_grip.x != 0) b.x() += by.x();
        if (m_grip.y != 0) b.y() += by.y();
    }
    if (const auto frame = session().motion().frame<2>(); proportional && frame && frame->built->picture) {
        const auto [wide, high] = canvasSize(*frame->built);
        const double aspect = static_cast<double>(high) / wide;
        const Vec2 size = b - a;
        const double width = std::max(std::abs(size.x()), std::abs(size.y()) / aspect);
        b = a + Vec2(std::copysign(width, size.x()), std::copysign(width * aspect, size.y()));
    }
    m_crop.set(between(a, b));
}

/// Ends a drag; a click outside the rectangle leaves it unchanged.
void CropTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !m_active) return;
    m_active = false;
    m_under = gripAt(event.position());
    view().redraw();
}

void CropTool::doubleClick(const QMouseEvent&) {
    m_active = false;
    m_crop.set({});
    view().redraw();
}

bool CropTool::ownsKey(const QKeyEvent& event) const {
    return m_crop.now() && (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace);
}

bool CropTool::key(const QKeyEvent& event) {
    if (m_active && event.key() == Qt::Key_Escape) {
        cancel();
        return true;
    }
    auto part = m_crop.now();
    if (!part) return false;
    const int step = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    if (ownsKey(event))
        part.reset();
    else if (event.key() == Qt::Key_Left)
        part->x -= step;
    else if (event.key() == Qt::Key_Right)
        part->x += step;
    else if (event.key() == Qt::Key_Up)
        part->y -= step;
    else if (event.key() == Qt::Key_Down)
        part->y += step;
    else
        return false;
    m_crop.set(part);
    view().redraw();
    return true;
}

void CropTool::cancel() {
    if (!m_active) return;
    m_active = false;
    m_crop.set(m_before);
    view().redraw();
}

/// Dims the discarded area and draws thirds.
void CropTool::paint(QPainter& painter) const {
    const auto& part = m_crop.now();
    if (!part) return;
    const QPolygonF frame = outline(*part);
    QPainterPath beside;
    beside.addRect(painter.viewport());
    beside.addPolygon(frame);
    beside.closeSubpath();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(beside, QColor(0x14, 0x16, 0x1e, 120));
    painter.setBrush(Qt::NoBrush);
    for (const auto& [pen, lines] : {std::pair{QPen(QColor(0x14, 0x16, 0x1e, 90), marked(3)), false},
                                     std::pair{QPen(Qt::white, marked(1.25)), true}}) {
        painter.setPen(pen);
        painter.drawPolygon(frame);
        if (!lines || !m_active) continue;
        painter.setPen(QPen(QColor(255, 255, 255, 130), marked(1)));
        for (const double third : {1 / 3.0, 2 / 3.0}) {
            painter.drawLine(frame[0] + third * (frame[1] - frame[0]),
                             frame[3] + third * (frame[2] - frame[3]));
            painter.drawLine(frame[0] + third * (frame[3] - frame[0]),
                             frame[1] + third * (frame[2] - frame[1]));
        }
    }
    painter.setPen(QPen(QColor(0x14, 0x16, 0x1e), marked(1)));
    painter.setBrush(Qt::white);
    const double side = marked(kHandle);
    for (const QPointF& corner : frame)
        painter.drawRect(QRectF(corner.x() - side / 2, corner.y() - side / 2, side, side));
    painter.restore();
    if (!m_active) return;
    const QLocale locale;
    paintLabel(painter, m_at + QPointF(16, 16),
               QStringLiteral("%1 × %2").arg(locale.toString(part->width), locale.toString(part->height)));
}

}  // namespace

ToolKind cropTool() {
    return toolKind(
        "crop", "crop", QT_TRANSLATE_NOOP("Tools", "&Crop"),
        QT_TRANSLATE_NOOP("Tools", "Draw a rectangle around the part of the picture that exports keep"), "C",
        Mode::Export, picturesOnly<CropTool>(&Workbench::crop));
}

}  // namespace wend
