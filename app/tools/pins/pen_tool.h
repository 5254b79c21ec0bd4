#pragma once

#include <memory>

#include "app/project/edits/bezier_edits.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Draws the path of the selected pins, or of a clicked pin: a click adds a corner, a drag a smooth point.
/// Shift constrains both to steps of 45°; with Ctrl or Alt a drag changes only the direction after the point.
/// In space every point has the depth of the one before. The path is one undo step; other changes cancel it.
class PenTool : public ShapeTool<> {
  public:
    explicit PenTool(ShapeView& view) : ShapeTool<>(view) {}

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const QMouseEvent& event) override;
    void move(const QMouseEvent& event) override;
    void release(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    bool ownsKey(const QKeyEvent& event) const override;
    MenuPlace menuAt(const QPointF& at) override;
    void cancel() override;
    void leave() override { m_over = false; }
    void paint(QPainter& painter) const override;

    bool isDrawing() const;

  private:
    int pinAt(const QPointF& widget) const;
    bool begin(const QPointF& at);
    bool beginAt(const std::vector<int>& handles);
    Vec3 placeAt(const QPointF& widget) const;
    Vec3 nextPlace() const;
    QPointF last() const { return view().onScreen(m_joints.back().at); }
    void takePointer(const QMouseEvent& event);
    void pullDirections(bool oneOnly);
    bool isOnLast(const QPointF& widget) const;
    void finish();
    void removeLast();
    void paintJoints(QPainter& painter) const;

    std::vector<DrawnJoint> m_joints;     // the first one is where the pins are
    std::shared_ptr<const Project> m_of;  // the project of these pins …
    double m_time = 0;                    // … at that time
    bool m_pressed = false;               // the last joint's direction follows the pointer
    bool m_over = false;
    bool m_steps = false;  // constrains to 45°
    QPointF m_from, m_at;
};

ToolKind penTool();

}  // namespace wend
