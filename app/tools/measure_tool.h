#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

/// Measures the length between two clicked points, and with a third one the angle at the second, for the pose
/// and for the rest shape. The points follow the shape.
class MeasureTool : public ShapeTool<> {
  public:
    explicit MeasureTool(ShapeView& view) : ShapeTool<>(view) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent&) override {}
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override;
    void cancel() override { m_points.clear(); }
    void paint(QPainter& painter) const override;

    /// Returns the measurement in words; empty before the second point.
    QString text() const;

  private:
    std::vector<Vec3> pointsIn(const ShapeFrame& frame, bool atRest = false) const;

    std::vector<Place> m_points;  // at most three
    std::shared_ptr<const void> m_shape;
};

ToolKind measureTool();

}  // namespace wend
