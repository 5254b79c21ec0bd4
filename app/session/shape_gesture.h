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
/// the document once, at its end. Lives in the window's thread.
class ShapeGesture : public QObject {
    Q_OBJECT

  public:
    ShapeGesture(Document& document, const Selection& selection, Playback& playback, ShapeMotion& motion,
                 const ShownPins& pins);

    /// Returns the current drag, or null.
    const DragGesture* drag() const { return m_drag ? &*m_drag : nullptr; }
    /// Returns the time at which handles are shown: that of the drag's start, or the shown time.
    double time() const;
    /// Returns the handles that hold at that time. Dragged ones are where the pointer has them: they follow
    /// at once, the shape later. Hidden ones are among them only if `all`.
    std::vector<PinView> pins(bool all = false) const;
    /// Returns where the handles that do not hold at that time would be, without hidden ones.
    std::vector<PinView> ghosts() const { return m_pins.at(time(), false, false); }
    /// Announces that handles may have come, gone or moved.
    void tellPins() { emit pinsChanged(); }
    /// Returns the handles that are not locked, and shows a notice about locked ones.
    std::vector<int> unlocked(std::vector<int> handles);
    /// Returns false and shows a notice if the handle is locked.
    bool mayChange(int handle) { return !unlocked({handle}).empty(); }

    /// Makes every following drag record.
    void setRecording(bool records) { m_records = records; }
    /// Makes every following drag and step of the arrow keys set where the handles are at the shown time,
    /// while what they do before and after stays (see withPose()); at the end the film becomes longer.
    void setPosing(bool poses) { m_poses = poses; }
    /// Decides what a drag does that directly follows one of the same pins at the end of the film: it leads
    /// them on, or else it replaces that move by a straight one to the new place.
    void setKeepsWay(bool keeps) { m_keepsWay = keeps; }
    /// Begins a drag of the selected and linked handles that act at the shown time and are not locked; shows
    /// a notice if there are none. The gesture replaces the later motion. If it `records`, it keeps the times
    /// of its samples and replaces only the later motion of its own handles.
    void begin(const Grip& grip = {}, bool records = false);
    void moveBy(const Amount& amount, double seconds = 0);
    /// Ends the drag and keeps its path within the tolerance.
    void end(double tolerance);
    /// Ends the drag and keeps the straight path to its end, which was given as a number.
    void endStraight();
    void cancel();
    /// Ends the drag without a change; the reached pose is shown until the motion of a coming project is
    /// computed.
    void letGo();
    /// Forgets the drag without signals, for another file.
    void drop();

    void nudge(const Vec3& by);
    /// Performs a whole gesture at once, for typed numbers.
    void moveAtOnce(const Grip& grip, const Amount& amount);
    /// Moves the selection along a Bézier chain from its first point. Within the film it lasts until the end
    /// and replaces only the motion of its own handles; at the end it is appended like a drag.
    void followCurve(const std::vector<Vec3>& points);

  signals:
    /// Emitted for drag(), which another session may follow.
    void began();
    void moved(const wend::Amount& amount);
    /// Emitted before the document changes.
    void ended();
    void cancelled();
    /// Emitted at the end of a drag that could not go further, with the reason; an empty text withdraws it
    /// once the project changes.
    void stopped(QString text);
    void pinsChanged();

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
    QString m_stop;     // why the shape does not follow it further
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
