#pragma once

#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/style/theme.h"
#include "app/tools/shape_view.h"
#include "app/tools/tool.h"
#include "app/views/shape/looks.h"

namespace wend {

class LegendLock;
class ShapePainter;

/// The common part of the views of pictures and solids: events of the active tool, and overlays. It filters
/// the events of the view's widget.
class Viewport : public QObject {
    Q_OBJECT

  public:
    /// Operations of the view itself.
    class View {
      public:
        virtual ~View() = default;
        /// Draws the shape again, with other looks.
        virtual void showLooks() = 0;
        /// Returns whether a press of this button navigates.
        virtual bool navigatesBy(const QMouseEvent& event) const = 0;
        virtual bool isNavigating() const = 0;
        virtual bool isPanning() const = 0;
        /// Navigates by a press, move or release; `pans`: whatever the button means.
        virtual void navigate(QMouseEvent& event, bool pans) = 0;
        virtual void endNavigation() = 0;
        /// Brings a place into the middle.
        virtual void showPlace(const Vec3& at) = 0;
        /// Describes the place under the pointer.
        virtual QString pointerText(const QPointF& at) = 0;
    };
    /// `overlay` is the widget with the marks; `over` is a tool that takes precedence over the active one for
    /// the events that it accepts.
    Viewport(View& view, ShapeView& shape, QWidget& widget, QWidget& overlay, Tool* over = nullptr);

    void setTool(Tool* tool);
    Tool* tool() const { return m_tool; }
    int hovered() const { return m_tool ? m_tool->hovered() : -1; }
    /// Cancels a gesture whose mesh no longer exists.
    void cancelGesture();
    /// Updates hint, pointer and marks after a change of what is under the pointer.
    void lookAgain();
    const Looks& looks() const { return m_looks; }
    template <class T>
    void set(T Looks::*look, const std::type_identity_t<T>& value) {
        if (std::exchange(m_looks.*look, value) == value) return;
        // Colours of a hidden map need no drawing.
        if constexpr (std::is_same_v<T, MapLook>)
            if (!m_looks.map) return wantField();
        takeLooks();
    }
    /// Sets the action that freezes the map's range, for the lock on the legend.
    void setRangeKeeper(QAction& keep);
    bool showsMap() const { return m_looks.map && !m_looks.hidden; }
    /// Returns whether the shown frame has been stale for a while.
    bool isDimmed() const { return m_dimmed; }
    /// Returns the pin whose name is shown because the pointer has stayed on it; −1 for none.
    int named() const { return m_named; }

    /// Repaints marks, but during a drag no more often than this, because it would take time from the shape.
    void redraw(int milliseconds);
    void marksPainted() { m_marksDue.stop(); }
    void takeFrame();
    /// Paints the legend of the map at the lower right of the view, or of a picture of that size.
    void paintLegend(QPainter& painter, const QSize& size) const;
    void showLegendLock();
    /// Paints the groups, paths and pins, which are hidden during playback.
    void paintPins(ShapePainter& painter) const;
    /// Brings the worst place of the map's measure, or a place of a shape of this dimension, into the middle.
    void showWorst();
    void showPlace(const Vec3& at);
    /// Returns the view as tools see it, and its widget.
    ShapeView& shape() const { return m_shape; }
    QWidget& widget() const { return m_widget; }
    Theme theme() const { return Theme::of(m_widget.palette()); }

  signals:
    void hintChanged(QString hint);
    /// Emitted to request a context menu for the item under the pointer.
    void menuWanted(QPoint global, wend::MenuPlace place);
    /// Emits a description of the place under the pointer; empty when it has left.
    void pointed(QString text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    Tool* toolAt(const QPointF& at) const;
    bool isForTool(const QMouseEvent& event, const Tool& tool) const;
    bool pansBy(const QMouseEvent& event, const Tool* tool) const;
    void give(Tool* tool, const QMouseEvent& event, void (Tool::*what)(const QMouseEvent&));
    void press(QMouseEvent& event);
    void doubleClick(QMouseEvent& event);
    void move(QMouseEvent& event);
    void release(QMouseEvent& event);
    bool pressKey(QKeyEvent& event);
    bool ownsKey(const QKeyEvent& event) const;
    void leave();
    void nameHovered();
    void useTool(Tool* tool);
    void tellHint(const Tool& tool);
    void setSpaceDown(bool down);
    void updateCursor();
    void takeLooks();
    void wantField();

    View& m_view;
    ShapeView& m_shape;
    QWidget &m_widget, &m_overlay;
    Tool *m_over, *m_tool = nullptr;
    Tool* m_active = nullptr;                         // the one that has the pointer …
    Qt::MouseButton m_activeButton = Qt::LeftButton;  // … as long as this is down
    bool m_spaceDown = false;                         // the left button moves the view
    bool m_asksMenu = false;                          // the right button, which no tool has taken
    QPointF m_pressedAt;
    std::optional<QPointF> m_pointer;  // where it is
    Looks m_looks;
    LegendLock* m_lock = nullptr;
    QTimer m_dim, m_marksDue, m_nameDue;
    int m_pointedAt = -1, m_named = -1;  // handles
    bool m_dimmed = false, m_hasShape = false;
};

}  // namespace wend
