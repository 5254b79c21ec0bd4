#pragma once

#include "app/tools/solid_surface.h"

namespace wend {

/// Two clicked vertices give a length, a third one the angle at the second; all values are told for the pose
/// and for the rest shape.
class MeasureTool : public SolidTool {
  public:
    using SolidTool::SolidTool;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent&) override {}
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent& event) override;
    void cancel() override { m_vertices.clear(); }
    void paint(QPainter& painter) const override;

    /// What is measured, in words; empty before the second point.
    QString text() const;

  private:
    std::vector<int> m_vertices;  // at most three
    std::shared_ptr<const void> m_shape;
};

}  // namespace wend
