#pragma once

#include <optional>

#include "app/session/crop.h"
#include "app/tools/tool_kind.h"

namespace wend {

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
    Vec<2> toPixels(const QPointF& widget) const;
    QPointF toWidget(const Vec<2>& pixel) const;
    Grip gripAt(const QPointF& widget) const;
    QPolygonF outline(const PixelRect& part) const;
    void drawTo(const Vec<2>& pixel, bool proportional);

    Crop& m_crop;
    Grip m_grip, m_under;  // dragged; under the pointer
    bool m_active = false;
    std::optional<PixelRect> m_before;
    Vec<2> m_from = Vec<2>::Zero();  // where it was pressed, in pixels of the picture
    QPointF m_at;
};

ToolKind cropTool();

}  // namespace wend
