#pragma once

#include <optional>

#include "app/session/motion/playback.h"
#include "app/session/selection.h"
#include "app/session/shape_gesture.h"
#include "app/session/shape_motion.h"
#include "app/session/shown_pins.h"

namespace wend {

/// A document with its shape in motion: what the window shows and what its gestures do. It owns and connects
/// the parts that do the work: ShapeMotion computes and chooses the frame that is shown, ShownPins knows
/// where the handles are in it, ShapeGesture moves them; handles come and go here. Lives in the thread of the
/// window; all computing is done by the compute thread.
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
    /// The handle if one alone is selected, else −1. (In the middle of an undo the selection may be that of
    /// the project before.)
    int singleHandle() const;
    int handleCount() const { return m_pins.count(); }

    /// The frame to show now: of the drag, or of the time that is shown; null before the first mesh. Never
    /// that of another file: where there is a frame, the document is the one that it was made for.
    FramePtr frame() const { return m_motion.frame(); }
    /// The same with its shape; null if that has another dimension.
    template <int Dim>
    PosedPtr<Dim> frame() const {
        return posed<Dim>(frame());
    }
    /// True while the frame does not yet show what the document says.
    bool isStale() const { return m_motion.isStale(); }
    /// The project cannot be computed as it is: what is seen is an older shape.
    bool hasFailed() const { return m_motion.hasFailed(); }
    /// True while something is being computed.
    bool isBusy() const { return m_motion.isBusy(); }
    /// True while that is the shape, or its material, rather than its motion.
    bool isMeshing() const { return m_motion.isMeshing(); }
    /// Ends what is being computed. The document goes back to the last state whose motion was complete (redo
    /// tries again); without one it stays, with as much as there is.
    void cancelWork();
    /// The handles at the time that is shown; dragged ones are where the pointer has them. Hidden ones are
    /// among them only if `all`.
    template <int Dim = 2>
    std::vector<PinView<Dim>> pins(bool all = false) const {
        return m_gesture.carriedAlong<Dim>(m_pins.at<Dim>(m_gesture.time(), true, all));
    }
    /// The handles that do not hold at that time: where they would be. None that is hidden.
    template <int Dim = 2>
    std::vector<PinView<Dim>> ghosts() const {
        return m_pins.at<Dim>(m_gesture.time(), false, false);
    }
    /// Where a handle's points are when it begins to hold: the starts of its paths.
    template <int Dim = 2>
    std::vector<Vec<Dim>> pathStarts(int handle) const {
        return m_pins.pathStarts<Dim>(handle);
    }
    /// How the vertices move at the time that is shown: v̂ itself once it is there (see setFieldWanted), until
    /// then the difference of the neighbouring frames.
    template <int Dim>
    Points<Dim> velocity() const {
        return m_motion.velocity<Dim>();
    }
    bool hasVelocity() const { return m_motion.hasVelocity(); }
    /// How far the selected handles take each vertex along, in the first row; no columns where it is not
    /// known (yet), or if nothing is selected.
    template <int Dim>
    Points<Dim> influence() const {
        return m_motion.influence<Dim>();
    }
    using FieldKind = ShapeMotion::FieldKind;
    /// From now on that is solved for at the time that is shown, unless it plays; `frameChanged` tells when
    /// it is there.
    void setFieldWanted(FieldKind wanted) { m_motion.setFieldWanted(wanted); }
    /// The length in domain units that a tolerance of the stroke is measured in: one pixel of a picture, or a
    /// 2000th of the shape's diagonal.
    double pixel() const { return m_motion.pixel(); }

    // gestures
    /// A pin at a point of the shape as it is shown; −1, with a notice, beside it.
    template <int Dim = 2>
    int addPin(const Vec<Dim>& p);
    /// The same at a place of it.
    template <int Dim>
    int addPin(const std::optional<Location<Dim>>& place);
    /// A handle of any kind, in terms of the rest shape, named "<kind> 1", "<kind> 2" …
    template <int Dim>
    int addHandle(Placement<Dim> at, const std::string& kind);
    template <int Dim>
    void changeHandle(int handle, Placement<Dim> at);
    /// Vertices of a solid as what a handle holds: by number where the mesh is a file's, by their places
    /// where it is made and may be made anew.
    Placement<3> placementOf(const std::vector<int>& vertices) const { return m_pins.placementOf(vertices); }
    /// The vertices that a handle of a solid holds, increasing.
    std::vector<int> verticesOf(int handle) const { return m_pins.verticesOf(handle); }
    void removeSelected();
    /// True unless the handle is locked, which is told.
    bool mayChange(int handle) { return !m_gesture.unlocked({handle}).empty(); }
    /// The name of one pin, or how many they are.
    QString nameOf(const std::vector<int>& handles) const { return m_pins.nameOf(handles); }
    template <int Dim = 2>
    void nudgeSelected(const Vec<Dim>& by) {
        m_gesture.nudge<Dim>(by);
    }
    /// A whole gesture at once, as with numbers.
    template <int Dim>
    void moveSelected(const Grip& grip, const Amount& amount) {
        m_gesture.moveAtOnce<Dim>(grip, amount);
    }
    /// The same along a Bézier chain, from its first point. From a time within the film it lasts until the
    /// end and replaces only what its own handles did; at the end it takes its place as any drag.
    template <int Dim>
    void followCurve(const std::vector<Vec<Dim>>& points) {
        m_gesture.followCurve<Dim>(points);
    }
    bool isDragging() const { return m_gesture.drag(); }
    /// Of the selected handles, and those that are linked with them, the ones that hold at the time that is
    /// shown and are not locked; a notice if there are none. The gesture goes on from there and replaces what
    /// came after.
    /// One that `records` keeps its own times, from a clock that comes with its samples, and replaces only
    /// what its own handles did after.
    void beginDrag(const Grip& grip = {}, bool records = false) { m_gesture.begin(grip, records); }
    template <int Dim = 2>
    void dragTo(const Vec<Dim>& offset, double seconds = 0) {
        dragBy(amountOf<Dim>(offset), seconds);
    }
    void dragBy(const Amount& amount, double seconds = 0) { m_gesture.moveBy(amount, seconds); }
    /// From now on every drag records.
    void setRecording(bool records) { m_gesture.setRecording(records); }
    /// Keeps the way as it was gone, within the tolerance.
    void endDrag(double tolerance) { m_gesture.end(tolerance); }
    /// Keeps the straight way to where it ended: its amount was given as a number.
    void endDragStraight() { m_gesture.endStraight(); }
    void cancelDrag() { m_gesture.cancel(); }
    /// Ends the drag and keeps nothing: what was reached stands for the end of the motion until that is
    /// there, of a project that is to come.
    void letGo() { m_gesture.letGo(); }
    /// The gesture that goes on: how far it has come.
    const DragGesture* gesture() const { return m_gesture.drag(); }

  signals:
    void frameChanged();
    void pinsChanged();
    /// The drag of gesture(): another session may go along with it.
    void dragBegan();
    void dragMoved(const wend::Amount& amount);
    /// Before the document changes.
    void dragEnded();
    void dragCancelled();
    void busyChanged(bool busy);
    void progress(double time, double end);
    /// A line for the status bar: what could not be done, and where.
    void notice(QString text);
    /// The project cannot be computed as it is; an empty text takes it back.
    void problem(QString text);

  private:
    void reset();
    void takeProject();

    Document m_document;
    Selection m_selection;
    Playback m_playback;
    ShapeMotion m_motion{m_document, m_selection, m_playback};
    ShownPins m_pins{m_document, m_motion};
    ShapeGesture m_gesture{m_document, m_selection, m_playback, m_motion, m_pins};
};

}  // namespace wend
