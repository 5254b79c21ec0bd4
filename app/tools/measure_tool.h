#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

/// Measures the length between two clicked points, and with a third one the angle at the second, for the pose
/// and for the rest shape. The points follow the shape.
template <int Dim>
class MeasureTool : public ShapeTool<Dim> {
  public:
    explicit MeasureTool(SurfaceOf<Dim>& view) : ShapeTool<Dim>(view) {}

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
    using ShapeTool<Dim>::surface;
    using ShapeTool<Dim>::session;
    std::vector<Vec<Dim>> pointsIn(const PosedFrame<Dim>& frame, const Points<Dim>& points) const;

    std::vector<Location<Dim>> m_points;  // at most three
    std::shared_ptr<const void> m_shape;
};

extern template class MeasureTool<2>;
extern template class MeasureTool<3>;

ToolKind measureTool();

}  // namespace wend
