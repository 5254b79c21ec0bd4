#include "warp/svg/drawn_text.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <algorithm>

namespace wend {
namespace {

Vec2 pointOf(const QPainterPath::Element& element) {
    return {element.x, element.y};
}

/// Returns the outline of filled shapes: every curve of it is closed.
SvgPath closedPath(const QPainterPath& path) {
    using Kind = PathPiece::Kind;
    SvgPath pieces;
    for (int k = 0; k < path.elementCount(); ++k) {
        const QPainterPath::Element element = path.elementAt(k);
        if (element.isMoveTo()) {
            if (!pieces.empty()) pieces.push_back({Kind::Close, {}});
            pieces.push_back({Kind::Move, {pointOf(element)}});
        } else if (element.isLineTo()) {
            pieces.push_back({Kind::Line, {pointOf(element)}});
        } else if (k + 2 < path.elementCount()) {
            pieces.push_back(
                {Kind::Cubic,
                 {pointOf(element), pointOf(path.elementAt(k + 1)), pointOf(path.elementAt(k + 2))}});
            k += 2;
        }
    }
    if (!pieces.empty()) pieces.push_back({Kind::Close, {}});
    return pieces;
}

/// Keeps what is painted on it, in place of drawing it.
class OutlineEngine final : public QPaintEngine {
  public:
    OutlineEngine() : QPaintEngine(AllFeatures) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& changed) override {
        if (changed.state() & DirtyTransform) m_transform = changed.transform();
        if (changed.state() & DirtyBrush) m_brush = changed.brush();
        if (changed.state() & DirtyOpacity) m_opacity = changed.opacity();
    }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath& path) override {
        SvgPath outline = closedPath(m_transform.map(path));
        if (outline.empty() || m_brush.style() == Qt::NoBrush) return;
        const QColor colour = m_brush.color();
        const std::string name = colour.name().toStdString();
        const double opacity = m_opacity * colour.alphaF();
        const bool continues =
            !outlines.empty() && outlines.back().colour == name && outlines.back().opacity == opacity;
        if (!continues) outlines.push_back({{}, name, opacity});
        SvgPath& all = outlines.back().path;
        all.insert(all.end(), outline.begin(), outline.end());
    }

    std::vector<TextOutlines> outlines;

  private:
    QTransform m_transform;
    QBrush m_brush;
    double m_opacity = 1;
};

class OutlineDevice final : public QPaintDevice {
  public:
    QPaintEngine* paintEngine() const override { return &m_engine; }
    std::vector<TextOutlines> take() { return std::move(m_engine.outlines); }

  protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
            case PdmHeight:
                return 1 << 14;
            case PdmDepth:
                return 32;
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return 96;
            case PdmDevicePixelRatio:
                return 1;
            default:
                return QPaintDevice::metric(metric);
        }
    }

  private:
    mutable OutlineEngine m_engine;
};

}  // namespace

std::vector<TextOutlines> textOutlines(const std::string& svg, const QRectF& viewBox) {
    QSvgRenderer renderer(QByteArray(svg.data(), static_cast<qsizetype>(svg.size())));
    if (!renderer.isValid()) return {};
    OutlineDevice device;
    QPainter painter(&device);
    renderer.render(&painter, viewBox);
    painter.end();
    return device.take();
}

}  // namespace wend
