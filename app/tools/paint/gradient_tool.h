#pragma once

#include "app/project/edits/material_edits.h"
#include "app/project/project_fwd.h"
#include "app/tools/key_cross.h"
#include "app/tools/tool_kind.h"

namespace wend {

class Brush;

/// Draws a gradient from the existing material at the start of a drag to the paint of the brush at its end
/// and beyond. It is one layer and one undo step. The ends of all gradients are handles that can be dragged.
class GradientTool : public ShapeTool<> {
  public:
    GradientTool(ShapeView& view, Brush& brush) : ShapeTool<>(view), m_brush(brush) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void cancel() override;
    void leave() override { m_cross.hide(); }
    void paint(QPainter& painter) const override;

  private:
    struct End {
        Vec3 rest, seen;
    };
    /// An end of a gradient that is there, by its layer and the place of its region in it.
    struct Handle {
        Id layer;
        std::size_t region;
        bool isTo;
        Vec3 seen;
    };
    std::vector<Handle> handles() const;
    std::optional<Handle> handleAt(const QPointF& at) const;
    const std::string& part() const;
    const MaterialRegion& gradientOf(const Handle& handle) const;
    bool findPart(const QPointF& at);
    std::optional<Design> moved() const;
    bool isCurrent() const;
    std::optional<End> endAt(const QPointF& at) const;
    QPointF otherEnd() const;
    std::optional<MaterialRegion> region() const;
    std::optional<Design> next() const;
    bool preview(bool lasts);

    Brush& m_brush;
    KeyCross m_cross;
    bool m_byKeys = false;                     // of the current drag
    FramePtr m_frame;                          // when the drag began, with its material; null without a drag
    std::shared_ptr<const Project> m_project;  // then
    std::optional<End> m_from, m_to;
    PaintedLayer m_layer;            // of a new gradient,
    std::string m_part;              // and the part of the picture
    std::optional<Handle> m_handle;  // that is dragged, in place of a new gradient
};

ToolKind gradientTool();

}  // namespace wend
