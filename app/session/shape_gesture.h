#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <optional>
#include <tuple>

#include "app/session/motion/drag_gesture.h"
#include "app/session/pins.h"

namespace wend {

class Document;
class Playback;
class Selection;
class ShapeMotion;
class ShownPins;

/// What the selected handles, and those that are linked with them, are made to do: the drag that goes on, and
/// steps that are made at once. The document changes when a gesture ends, by one step. Lives in the thread of
/// the window. What tools call is described in ShapeSession, which passes it on.
class ShapeGesture : public QObject {
    Q_OBJECT

  public:
    ShapeGesture(Document& document, const Selection& selection, Playback& playback, ShapeMotion& motion,
                 const ShownPins& pins);

    /// The drag that goes on, or null.
    const DragGesture* drag() const { return m_drag ? &*m_drag : nullptr; }
    /// When handles are where they are seen: when the drag began, or the time that is shown.
    double time() const;
    /// The dragged ones among them are where the pointer has them: they follow at once, the shape catches up.
    template <int Dim>
    std::vector<PinView<Dim>> carriedAlong(std::vector<PinView<Dim>> views) const;
    /// Those that may be changed; which are locked is told.
    std::vector<int> unlocked(std::vector<int> handles);

    void setRecording(bool records) { m_records = records; }
    void begin(const Grip& grip, bool records);
    void moveBy(const Amount& amount, double seconds);
    void end(double tolerance);
    void endStraight();
    void cancel();
    void letGo();
    /// For another file: forgets the drag, and tells nobody.
    void drop();

    template <int Dim>
    void nudge(const Vec<Dim>& by);
    template <int Dim>
    void moveAtOnce(const Grip& grip, const Amount& amount);
    template <int Dim>
    void followCurve(const std::vector<Vec<Dim>>& points);

  signals:
    void began();
    void moved(const wend::Amount& amount);
    void ended();
    void cancelled();
    void pinsChanged();
    void notice(QString text);

  private:
    std::vector<int> movableHandles();
    template <int Dim>
    void takeHold(const std::vector<int>& handles);
    template <int Dim>
    double armOf(const DragGesture& drag) const;
    void lead();
    void follow(const FramePtr& frame);
    void goOn();
    double recordedTime() const;
    void end(const TimedPath& path);
    template <int Dim>
    void push(const DragGesture& drag, const TimedPath& path, double from, const QString& key = {},
              const std::vector<Amount>& curve = {});
    template <int Dim>
    void tellReplaced(const std::vector<Handle<Dim>>& before, const std::vector<int>& own, double from,
                      const QString& otherwise);

    Document& m_document;
    const Selection& m_selection;
    Playback& m_playback;
    ShapeMotion& m_motion;
    const ShownPins& m_pins;
    std::optional<DragGesture> m_drag;
    double m_from = 0;  // when it began, by the clock of the motion
    /// The handles of the gesture, as they were at its start.
    std::tuple<std::vector<PinView<2>>, std::vector<PinView<3>>> m_grabbed;
    bool m_records = false;                    // every drag
    QTimer m_goOn;                             // while a drag records: others go on though the hand rests
    QElapsedTimer m_sinceSample, m_sinceLead;  // a sample was taken; the shape was led
    QTimer m_waits;                            // the newest sample, to be led to
    bool m_isQuick = false;                    // the shape, in following
};

}  // namespace wend
