#pragma once

#include <QAbstractScrollArea>
#include <functional>

#include "app/window/film/time_strip.h"
#include "app/window/film/track_choice.h"
#include "app/window/film/track_layout.h"

class QMenu;

namespace wend {

class KeyPoseStrip;
class SoundTrack;
class TimeRuler;

/// A row per pin with a bar per motion over time, and a diamond per key pose, below a ruler. Keys, bars and
/// the ends of a pin's hold can be dragged, also several at once. Menus on them ease, hold, mirror, simplify.
class TrackView : public QAbstractScrollArea {
    Q_OBJECT

  public:
    explicit TrackView(ShapeSession& session, QWidget* parent = nullptr);

    static constexpr int kHold = TrackLayout::kHold;
    /// Returns the rectangle of a bar or hold in viewport coordinates; empty if there is none.
    QRectF barOf(int handle, int motion) const;
    /// Returns where a key pose is drawn.
    QPointF keySpot(const KeyId& key) const { return m_layout.spotOf(key); }
    TrackChoice& choice() const { return *m_choice; }
    TimeScale& scale() const { return *m_scale; }
    TimeRuler& ruler() const { return *m_ruler; }
    KeyPoseStrip& poses() const { return *m_poses; }
    SoundTrack& sound() const { return *m_sound; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, 80}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent*) override { arrange(); }
    void scrollContentsBy(int dx, int dy) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    /// A frame is drawn around keys or bars.
    struct Band {
        QPointF from, to;
        std::vector<MotionId> bars;  // that were chosen before
        std::vector<KeyId> keys;
    };

    void takeProject();
    void arrange();
    void showSelection();
    void showFirstMotion();
    void bringIntoView(int row);

    std::optional<TrackLayout::Hit> hitAt(const QPointF& at) const;
    void grab(const TrackLayout::Hit& hit, double at, bool alone);
    void drop(const TrackLayout::Drag& drag);
    void stretchBand(const QPointF& to);
    void paste(bool mirrored);
    void fillMenu(QMenu& menu, const TrackLayout::Bar& bar);
    void fillMenu(QMenu& menu, const KeyId& key);
    void addPasting(QMenu& menu);
    void editEase();
    std::function<void()> commandOf(const QKeyEvent& event);

    void paintRow(QPainter& painter, const TrackLayout::Row& row) const;
    void paintHold(QPainter& painter, const TrackLayout::Bar& hold) const;
    void paintBar(QPainter& painter, const TrackLayout::Bar& bar, const QColor& colour) const;
    void paintKey(QPainter& painter, const KeyId& key) const;

    ShapeSession& m_session;
    TrackChoice* m_choice;
    TimeScale* m_scale;
    SoundTrack* m_sound;
    TimeRuler* m_ruler;
    KeyPoseStrip* m_poses;
    TrackLayout m_layout;
    std::optional<Band> m_band;
    int m_generation = -1;  // of the document that was scrolled to its first motion
};

}  // namespace wend
