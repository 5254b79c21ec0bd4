#pragma once

#include <QAbstractScrollArea>
#include <functional>
#include <optional>
#include <vector>

#include "app/project/edits/key_edits.h"
#include "app/project/edits/progress.h"
#include "app/session/shape_session.h"

class QMenu;

namespace wend {

class KeyPoseStrip;
class SoundTrack;
class TimeRuler;
class TimeScale;

/// A row per pin with a bar per motion over time, and a diamond per key pose, below a ruler. Keys, bars and
/// the ends of a pin's hold can be dragged, also several at once. Menus on them ease, hold, mirror, simplify.
class TrackView : public QAbstractScrollArea {
    Q_OBJECT

  public:
    explicit TrackView(ShapeSession& session, QWidget* parent = nullptr);

    static constexpr int kHold = -1;  // in the place of a motion: the line along which the pin holds
    /// Returns the rectangle of a motion's bar, or of a hold, in viewport coordinates; empty if there is
    /// none.
    QRectF barOf(int handle, int motion) const;
    /// Returns where a key pose is drawn.
    QPointF keySpot(const KeyId& key) const;
    TimeScale& scale() const { return *m_scale; }
    TimeRuler& ruler() const { return *m_ruler; }
    KeyPoseStrip& poses() const { return *m_poses; }
    SoundTrack& sound() const { return *m_sound; }
    /// Returns the motions whose easing is edited: the chosen bars, or the motions between the chosen keys.
    std::vector<MotionId> easedMotions() const;
    /// Returns the progress of the first of them.
    std::optional<ShownProgress> shownEase() const;
    /// Gives them another progress in one undo step; steps with the same key merge.
    void setProgress(const Progress& progress, const QString& mergeKey = {});
    /// Holds the pins during these motions.
    void holdChosen();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, 80}; }

  signals:
    /// Emitted when other bars or keys are chosen, or these have changed.
    void choiceChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
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
    static constexpr double kRowHeight = 24, kBarHeight = 16;  // pixels
    static constexpr double kGrip = 5;                         // pixels of a bar's end, to both sides
    static constexpr int kRowsAtFirst = 5;
    enum class Part { Body, Start, End };
    struct Bar : MotionId {
        MotionTime time;
        SlowSides slow = {};
        QString kind = {};
        std::optional<Ease> ease = Ease::Linear;  // none: a curve of its own
    };
    struct Row {
        QString name;
        QColor colour;
        Bar hold;
        std::vector<Bar> bars;
    };
    struct Grabbed {
        Bar bar;
        Part part;
        double at;                      // the time that was pressed
        std::vector<MotionId> motions;  // the dragged motions; none for the end of a hold
        MotionTime span, time;          // of them: before and during the drag
        bool alone;                     // a click chooses it alone
    };
    /// The chosen keys are dragged by one of them.
    struct GrabbedKeys {
        KeyId key;
        double at;  // the time that was pressed
        double shift = 0;
        bool alone = false;  // a click chooses it alone
    };
    /// A frame is drawn around keys or bars.
    struct Band {
        QPointF from, to;
        std::vector<MotionId> others;  // that were chosen before
        std::vector<KeyId> otherKeys;
    };

    void takeProject();
    void arrange();
    bool showsPoses() const;
    void showSelection();
    void showFirstMotion();
    void bringIntoView(int row);
    double end() const;
    double xOf(double time) const;
    double timeAt(double x) const;
    double top() const;
    QRectF rowRect(int row) const;
    MotionTime timeOf(const Bar& bar) const;
    QRectF barRect(const Bar& bar) const;
    std::optional<Part> endAt(const Bar& bar, const QPointF& at) const;
    std::optional<std::pair<Bar, Part>> barAt(const QPointF& at) const;
    int rowAt(const QPointF& at) const;
    MotionTime dragged(const Grabbed& grabbed, double time) const;
    MotionTime draggedHold(const Grabbed& grabbed, double time) const;
    void drop(const Grabbed& grabbed);
    double snapped(double time, const std::vector<KeyId>& moving = {}) const;
    std::vector<KeyId> endsOf(const std::vector<MotionId>& motions) const;
    bool isChosen(const MotionId& bar) const { return isAmong(m_chosen, bar); }
    bool isChosen(const KeyId& key) const { return isAmong(m_keys, key); }
    void choose(std::vector<MotionId> bars);
    std::vector<MotionId> changeable() const;
    void grab(const Bar& bar, Part part, double at, bool alone);
    void stretchBand(const QPointF& to);
    void move(const std::vector<MotionId>& motions, const MotionTime& span, const QString& what,
              const QString& key = {});
    void change(const QString& what, Design after);
    void addPasting(QMenu& menu);
    void fillMenu(QMenu& menu, const Bar& bar);
    void fillMenu(QMenu& menu, const KeyId& key);
    void addEasings(QMenu& menu, const KeyId& key);
    void addEaseEditor(QMenu& menu);
    void editEase();
    void removeChosen();
    void removeKeys();
    void changeKeys(const QString& what, Design after);

    std::vector<double> keysIn(int row) const;
    std::optional<KeyId> keyAt(const QPointF& at) const;
    double shownTime(int handle, double time) const;
    void chooseKeys(std::vector<KeyId> keys);
    std::vector<KeyId> changeableKeys() const;
    bool pressKey(const QPointF& at, bool joins);
    void dragKeys(double time);
    void dropKeys(const GrabbedKeys& grabbed);
    void moveKeys(double by, const QString& mergeKey = {});
    void copyChosen();
    void paste(bool mirrored);
    void mirrorKeys();
    bool takesKey(const QKeyEvent& event) const;
    bool keyCommand(const QKeyEvent& event);
    void paintRow(QPainter& painter, int row) const;
    void paintBand(QPainter& painter) const;
    void paintHold(QPainter& painter, const Bar& hold) const;
    void paintBar(QPainter& painter, const Bar& bar, const QColor& colour) const;
    void paintKey(QPainter& painter, const KeyId& key, const QColor& colour) const;
    bool nudge(const QKeyEvent& event);

    ShapeSession& m_session;
    TimeScale* m_scale;
    SoundTrack* m_sound;
    TimeRuler* m_ruler;
    KeyPoseStrip* m_poses;
    std::vector<Row> m_rows;
    std::vector<MotionId> m_chosen;  // by clicks and frames; bars or keys
    std::vector<KeyId> m_keys;
    std::vector<CopiedKey> m_copied;
    std::optional<Grabbed> m_grabbed;
    std::optional<GrabbedKeys> m_grabbedKeys;
    std::optional<Band> m_band;
    int m_generation = -1;  // of the document that was scrolled to its first motion
};

}  // namespace wend
