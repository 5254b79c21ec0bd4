#pragma once

#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/session/shape_session.h"
#include "app/tools/tool.h"
#include "app/view/shape/looks.h"

namespace wend {

class LegendLock;

/// What the views of pictures and of solids have in common: the events of the tool that is chosen, and what
/// is seen of the shape beside itself. It takes the events of the view's widget before that does.
class Viewport : public QObject {
    Q_OBJECT

  public:
    /// What only the view itself can do.
    class View {
      public:
        virtual ~View() = default;
        /// Draws the shape again, with other looks.
        virtual void showLooks() = 0;
        /// True if a press of this button moves the view.
        virtual bool navigatesBy(const QMouseEvent& event) const = 0;
        virtual bool isNavigating() const = 0;
        virtual bool isPanning() const = 0;
        /// A press, move or release that moves the view; by `pans` whatever the button means.
        virtual void navigate(QMouseEvent& event, bool pans) = 0;
        virtual void endNavigation() = 0;
        /// What is under the pointer, in words.
        virtual QString pointerText(const QPointF& at) = 0;
    };
    /// `overlay` is what marks are painted on; `over` a tool that lies over the one that is chosen, where it
    /// wants to.
    Viewport(View& view, QWidget& widget, QWidget& overlay, ShapeSession& session, int dimension,
             Tool* over = nullptr);

    void setTool(Tool* tool);
    Tool* tool() const { return m_tool; }
    int hovered() const { return m_tool ? m_tool->hovered() : -1; }
    /// What a gesture has gathered is of a mesh that is gone.
    void cancelGesture();
    /// What lies under the pointer, or what the tool works with, has changed: hint, pointer and marks follow.
    void lookAgain();
    const Looks& looks() const { return m_looks; }
    template <class T>
    void set(T Looks::*look, const std::type_identity_t<T>& value) {
        if (std::exchange(m_looks.*look, value) == value) return;
        // The colours of a map that is not shown are seen nowhere.
        if constexpr (std::is_same_v<T, MapLook>)
            if (!m_looks.map) return wantField();
        takeLooks();
    }
    /// What keeps the map's range, for the lock on the legend's card.
    void setRangeKeeper(QAction& keep);
    bool showsMap() const { return m_looks.map && !m_looks.hidden; }
    /// True while what is seen has been stale for a while.
    bool isDimmed() const { return m_dimmed; }
    /// The pin whose name is shown because the pointer has stayed on it; −1 for none.
    int named() const { return m_named; }

    /// Marks are painted again: while a shape follows the hand, painting for the pointer alone would take the
    /// time that the shape needs, so no more often than this.
    void redraw(int milliseconds);
    void marksPainted() { m_marksDue.stop(); }
    void takeFrame();
    /// The legend of the map, at the lower right of the view or of a picture of that size.
    void paintLegend(QPainter& painter, const QSize& size) const;
    void showLegendLock();

  signals:
    void hintChanged(QString hint);
    /// A menu for what is under the pointer is asked for.
    void menuWanted(QPoint global, wend::MenuPlace place);
    /// What is under the pointer, in words; empty when it has left.
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
    QWidget &m_widget, &m_overlay;
    ShapeSession& m_session;
    int m_dimension;
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
