#pragma once

#include <functional>

#include "app/tools/tool_kind.h"
#include "core/mesh/region.h"

namespace wend {

/// Makes a handle of a region of a solid: a ball or block around a point of the surface, or the half-space
/// behind it. Shift adds its contents to the selected handle, Ctrl subtracts them.
class RegionTool : public ShapeTool<SolidShapeView> {
  public:
    enum class Shape { Ball, Block, Side };
    /// `done`: a region was taken hold of, and is there to be moved.
    RegionTool(SolidShapeView& view, Shape shape, std::function<void()> done)
        : ShapeTool<SolidShapeView>(view), m_shape(shape), m_done(std::move(done)) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override { m_active = false; }
    void paint(QPainter& painter) const override;

  private:
    bool isClick() const { return QLineF(m_from, m_at).length() < 4; }
    Region<3> region() const;
    void take(Qt::KeyboardModifiers with);

    Shape m_shape;
    std::function<void()> m_done;
    bool m_active = false;
    QPointF m_from, m_at;
    // centre in the pose and at rest, and the solid's rotation there
    Vec<3> m_centre = Vec<3>::Zero(), m_restCentre = Vec<3>::Zero();
    Mat<3> m_turn = Mat<3>::Identity();
};

ToolKind grabBallTool();
ToolKind grabBlockTool();
ToolKind grabSideTool();

}  // namespace wend
