#pragma once

#include "app/tools/gizmos.h"
#include "app/tools/shape_tool.h"
#include "core/mesh/cut_plane.h"

namespace wend {

/// The cutting plane of a solid: an arrow moves it, two rings tilt it. It is shown over the active tool,
/// unless that shows its own manipulator; in the step *Mesh* the plane takes precedence.
class CutTool : public ShapeTool<SolidShapeView> {
  public:
    using Changed = std::function<void(const CutPlane&)>;
    /// `isBeside`: whether the tool that is chosen has a manipulator.
    CutTool(SolidShapeView& view, Changed changed, std::function<bool()> isBeside)
        : ShapeTool<SolidShapeView>(view), m_changed(std::move(changed)), m_isBeside(std::move(isBeside)) {}

    void setActive(bool active) { m_active = active; }
    void setFirst(bool first) { m_first = first; }
    bool isShown() const { return m_active && (m_dragging || m_first || !m_isBeside()); }
    bool comesFirst() const { return m_active && m_first; }
    bool isDragging() const { return m_dragging; }
    void setPlane(const CutPlane& plane);
    /// Sets the plane that the user has chosen: its normal is kept in this document.
    void choosePlane(const CutPlane& plane);
    /// Puts the plane through the middle of the shape, so that it cuts away the near half: along the normal
    /// that was chosen in this document, or along the world axis closest to the viewing direction.
    void placeInMiddle();
    const CutPlane& plane() const { return m_plane; }

    QString hint() const override;
    QCursor cursor() const override;
    bool wants(const QPointF& at) const override;
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void paint(QPainter& painter) const override;

  private:
    void place();

    Changed m_changed;
    std::function<bool()> m_isBeside;
    Manipulator m_manipulator;
    CutPlane m_plane, m_start;
    std::optional<Manipulator::Part> m_part;
    int m_chosenIn = -1;  // the generation of the document in which the user chose the plane
    bool m_active = false, m_dragging = false, m_first = false;
};

}  // namespace wend
