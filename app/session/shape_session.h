#pragma once

#include <optional>

#include "app/engine/motion/playback.h"
#include "app/session/pins.h"
#include "app/session/selection.h"
#include "app/session/shape_gesture.h"
#include "app/session/shape_motion.h"

namespace wend {

/// A document with its moving shape: what the window shows and what gestures change. It owns and connects
/// ShapeMotion, which computes and chooses the shown frame, ShownPins, which places the handles in it, and
/// ShapeGesture, which moves them. Lives in the window's thread; the compute thread does all computing.
class ShapeSession : public QObject {
    Q_OBJECT

  public:
    explicit ShapeSession(QObject* parent = nullptr);

    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    Selection& selection() { return m_selection; }
    const Selection& selection() const { return m_selection; }
    Playback& playback() { return m_playback; }
    const Playback& playback() const { return m_playback; }
    const FrameTrack& track() const { return m_motion.track(); }
    /// Returns the handle if one alone is selected, else −1.
    int singleHandle() const;
    int handleCount() const { return m_pins.count(); }

    /// Returns the frame to show: that of the drag or of the shown time; null before the first mesh. It
    /// always belongs to the current document.
    FramePtr frame() const { return m_motion.frame(); }
    /// The same with its shape; null if that has another dimension.
    template <int Dim>
    PosedPtr<Dim> frame() const {
        return posed<Dim>(frame());
    }
    /// Returns true while the frame does not show the document's state yet.
    bool isStale() const { return m_motion.isStale(); }
    /// Returns true if the project cannot be computed: an older shape is shown.
    bool hasFailed() const { return m_motion.hasFailed(); }
    /// Returns whether memory is lacking for that.
    bool lacksMemory() const { return m_motion.lacksMemory(); }
    /// Returns true while something is being computed.
    bool isBusy() const { return m_motion.isBusy(); }
    /// Returns true while the shape or its material is being made, rather than its motion.
    bool isMeshing() const { return m_motion.isMeshing(); }
    /// Cancels the computation and restores the last state with a complete motion (redo tries again). Without
    /// one, the document stays, with as much motion as was computed.
    void cancelWork();
    /// The handles at the time that is shown; dragged ones are where the pointer has them. Hidden ones are
    /// among them only if `all`.
    std::vector<PinView> pins(bool all = false) const {
        return m_gesture.carriedAlong(m_pins.at(m_gesture.time(), true, all));
    }
    /// The handles that do not hold at that time: where they would be. None that is hidden.
    std::vector<PinView> ghosts() const { return m_pins.at(m_gesture.time(), false, false); }
    /// Returns the points of a handle when it starts to hold: the starts of its paths.
    std::vector<Vec3> pathStarts(int handle) const { return m_pins.pathStarts(handle); }
    /// Returns the velocities at the shown time: v̂ once it is solved (see setFieldWanted), until then the
    /// difference of the neighbouring frames.
    Eigen::MatrixXd velocity() const { return m_motion.velocity(); }
    bool hasVelocity() const { return m_motion.hasVelocity(); }
    /// Returns the influence of the selected handles on each vertex in the first row; no columns while it is
    /// unknown, or if nothing is selected.
    Eigen::MatrixXd influence() const { return m_motion.influence(); }
    using FieldKind = ShapeMotion::FieldKind;
    /// Sets the field that is solved for at the shown time, except during playback; `frameChanged` reports
    /// its arrival.
    void setFieldWanted(FieldKind wanted) { m_motion.setFieldWanted(wanted); }
    /// The length in domain units that a tolerance of the stroke is measured in: one pixel of a picture, or a
    /// 2000th of the shape's diagonal.
    double pixel() const { return m_motion.pixel(); }

    // gestures
    /// Adds a pin at a point of the shown shape. Returns −1 and emits a notice if the point is outside.
    int addPin(const Vec3& p);
    /// Does the same at a place of it.
    int addPin(const std::optional<Place>& place);
    /// Adds a handle of any kind, in terms of the rest shape, named "<kind> 1", "<kind> 2" …
    int addHandle(Placement<3> at, const std::string& kind, const std::string& part = {});
    void changeHandle(int handle, Placement<3> at);
    /// Returns the placement of a solid's vertices: by number if the mesh comes from a file, by position if
    /// it is generated and may be generated again.
    Placement<3> placementOf(const std::vector<int>& vertices) const { return m_pins.placementOf(vertices); }
    /// The vertices that a handle of a solid holds, increasing.
    std::vector<int> verticesOf(int handle) const { return m_pins.verticesOf(handle); }
    void removeSelected();
    /// Returns false and emits notice() if the handle is locked.
    bool mayChange(int handle) { return !m_gesture.unlocked({handle}).empty(); }
    /// Returns whether a handle may not be changed: it is locked, or the part of the picture that it is in.
    bool isLocked(int handle) const { return m_pins.isLocked(handle); }
    /// The name of one pin, or how many they are.
    QString nameOf(const std::vector<int>& handles) const { return m_pins.nameOf(handles); }
    /// How the selected handles are moved.
    ShapeGesture& gestures() { return m_gesture; }
    const ShapeGesture& gestures() const { return m_gesture; }
    bool isDragging() const { return m_gesture.drag(); }
    /// Shows a line in the status bar: what could not be done, and where.
    void notify(const QString& text) { emit notice(text); }

  signals:
    void frameChanged();
    void pinsChanged();
    void busyChanged(bool busy);
    /// Emitted with the time up to which the motion is computed.
    void progress(double time, double end);
    /// Emitted with the approximate time that the current step has reached.
    void within(double time, double end);
    /// Emitted with a line for the status bar.
    void notice(QString text);
    /// Emitted if the project cannot be computed; an empty text withdraws the problem.
    void problem(QString text);

  private:
    void reset();
    void takeProject();

    Document m_document;
    Selection m_selection{m_document};
    Playback m_playback;
    ShapeMotion m_motion{m_document, m_selection, m_playback};
    ShownPins m_pins{m_document, m_motion};
    ShapeGesture m_gesture{m_document, m_selection, m_playback, m_motion, m_pins};
};

}  // namespace wend
