#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/engine/motion/drag_gesture.h"
#include "app/project/project_fwd.h"
#include "app/session/pins.h"

namespace wend {

class Document;
struct Gesture;
class Playback;
class Selection;
class ShapeMotion;
class ShownPins;

/// Moves the selected handles and those linked with them: by a drag, or at once by numbers. A gesture changes
/// the document once, at its end. Lives in the window's thread. ShapeSession, which forwards to it, documents
/// the functions that tools call.
class ShapeGesture : public QObject {
    Q_OBJECT

  public:
    ShapeGesture(Document& document, const Selection& selection, Playback& playback, ShapeMotion& motion,
                 const ShownPins& pins);

    /// Returns the current drag, or null.
    const DragGesture* drag() const { return m_drag ? &*m_drag : nullptr; }
    /// Returns the time at which handles are shown: that of the drag's start, or the shown time.
    double time() const;
    /// Returns the pins with dragged ones at the pointer: they follow at once, the shape later.
    std::vector<PinView> carriedAlong(std::vector<PinView> views) const;
    /// Returns the handles that are not locked, and emits a notice about locked ones.
    std::vector<int> unlocked(std::vector<int> handles);

    void setRecording(bool records) { m_records = records; }
    void setPosing(bool poses) { m_poses = poses; }
    void setKeepsWay(bool keeps) { m_keepsWay = keeps; }
    void begin(const Grip& grip, bool records);
    void moveBy(const Amount& amount, double seconds);
    void end(double tolerance);
    void endStraight();
    void cancel();
    void letGo();
    /// Forgets the drag without signals, for another file.
    void drop();

    void nudge(const Vec3& by);
    void moveAtOnce(const Grip& grip, const Amount& amount);
    void followCurve(const std::vector<Vec3>& points);

  signals:
    void began();
    void moved(const wend::Amount& amount);
    void ended();
    void cancelled();
    void pinsChanged();
    void notice(QString text);

  private:
    std::vector<int> movableHandles();
    void takeHold(const std::vector<int>& handles);
    double armOf(const DragGesture& drag) const;
    void lead();
    void follow(const FramePtr& frame);
    void goOn();
    double recordedTime() const;
    void end(const TimedPath& path);
    void push(const DragGesture& drag, const TimedPath& path, double from, const QString& key = {},
              const std::vector<Amount>& curve = {});
    bool pushPose(const Gesture& gesture, const std::vector<Vec3>& starts, const QString& step,
                  const QString& key);
    void tellReplaced(const std::vector<Pin>& before, const std::vector<int>& own, double from,
                      const QString& otherwise);

    Document& m_document;
    const Selection& m_selection;
    Playback& m_playback;
    ShapeMotion& m_motion;
    const ShownPins& m_pins;
    std::optional<DragGesture> m_drag;
    double m_from = 0;  // when it began, by the clock of the motion
    /// The handles of the gesture at its start.
    std::vector<PinView> m_grabbed;
    bool m_records = false;   // every drag
    bool m_poses = false;     // a drag sets a pose at its time
    bool m_keepsWay = false;  // a drag after one at the end of the film is another move
    /// The last pose that made the film longer: its handles, and the project until something else changes.
    std::pair<std::vector<int>, std::shared_ptr<const Project>> m_added;
    QTimer m_goOn;                             // advances the other handles while recording
    QElapsedTimer m_sinceSample, m_sinceLead;  // since the last sample was added; since the last request
    QTimer m_waits;                            // delays the newest sample
    bool m_isQuick = false;                    // the shape, in following
};

}  // namespace wend
