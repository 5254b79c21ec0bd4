#pragma once

#include <QAbstractScrollArea>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/timing_edits.h"
#include "app/session/shape_session.h"

namespace wend {

/// A row for each pin, with a bar for each of its motions along the time: what happens when, and what happens
/// together. Bars and their ends are dragged to other times, the ruler is scrubbed; a menu on a bar tells how
/// it begins and ends.
class TrackView : public QAbstractScrollArea {
    Q_OBJECT

  public:
    explicit TrackView(ShapeSession& session, QWidget* parent = nullptr);

    /// Where a motion's bar is, in coordinates of the viewport; empty if it has none.
    QRectF barOf(int handle, int motion) const;
    QSize sizeHint() const override { return {400, 128}; }
    QSize minimumSizeHint() const override { return {200, 80}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    static constexpr double kNames = 132, kMargin = 16, kRuler = 22, kRowHeight = 24,
                            kBarHeight = 16;  // pixels
    enum class Part { Body, Start, End };
    struct Bar {
        int handle = -1, motion = -1;
        MotionTime time;
        Ease ease = Ease::Linear;
        QString kind;
        bool operator==(const Bar& other) const { return handle == other.handle && motion == other.motion; }
    };
    struct Row {
        QString name;
        QColor colour;
        double from = 0, to = 0;  // it holds meanwhile
        std::vector<Bar> bars;
    };
    struct Grabbed {
        Bar bar;
        Part part;
        double at;        // the time that was pressed
        MotionTime time;  // where it would be
    };

    void takeProject();
    void arrange();
    void showSelection();
    double end() const;
    double xOf(double time) const;
    double timeAt(double x) const;
    QRectF rowRect(int row) const;
    QRectF barRect(const Bar& bar) const;
    std::optional<std::pair<Bar, Part>> barAt(const QPointF& at) const;
    int rowAt(const QPointF& at) const;
    MotionTime dragged(const Grabbed& grabbed, double time) const;
    double snapped(double time, const Bar& own) const;
    void scrub(double x);
    void move(const Bar& bar, const MotionTime& time, const QString& what, const QString& key = {});
    void change(const QString& what, const std::function<Project(const Project&)>& edit,
                const QString& key = {});
    void showMenu(const Bar& bar, const QPoint& global);
    void remove(const Bar& bar);
    void paintRuler(QPainter& painter) const;
    void paintRow(QPainter& painter, int row) const;
    void paintBar(QPainter& painter, const Bar& bar, const QColor& colour) const;
    bool nudge(const QKeyEvent& event);

    ShapeSession& m_session;
    std::vector<Row> m_rows;
    std::optional<Bar> m_chosen;  // by the last click
    std::optional<Grabbed> m_grabbed;
    bool m_scrubbing = false;
};

}  // namespace wend
