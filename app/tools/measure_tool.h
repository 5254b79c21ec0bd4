#pragma once

#include "app/tools/solid_surface.h"

namespace wend {

/// Two clicked points of what is seen give a length, a third one the angle at the second; all values are told
/// for the pose and for the rest shape. The points are carried along by the solid.
class MeasureTool : public SolidTool {
  public:
    using SolidTool::SolidTool;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent&) override {}
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override;
    void cancel() override { m_points.clear(); }
    void paint(QPainter& painter) const override;

    /// What is measured, in words; empty before the second point.
    QString text() const;

  private:
    std::vector<Vec<3>> pointsIn(const PosedFrame<3>& frame, const Points<3>& points) const;

    std::vector<Location<3>> m_points;  // at most three
    std::shared_ptr<const void> m_shape;
};

}  // namespace wend
