#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <tuple>

#include "app/document/document.h"
#include "app/session/compute_thread.h"
#include "app/session/drag_gesture.h"
#include "app/session/frame_track.h"
#include "app/session/pins.h"
#include "app/session/playback.h"
#include "app/session/selection.h"

namespace wend {

/// A document with its shape in motion: what the window shows and what its gestures do. Lives in the thread
/// of the window; all computing is done by the compute thread.
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
    const FrameTrack& track() const { return m_track; }
    /// The handle if one alone is selected, else −1. (In the middle of an undo the selection may be that of
    /// the project before.)
    int singleHandle() const;
    int handleCount() const;

    /// The frame to show now: of the drag, or of the time that is shown; null before the first mesh. Never
    /// that of another file: where there is a frame, the document is the one that it was made for.
    FramePtr frame() const {
        return m_frame && m_frame->generation == m_document.generation() ? m_frame : FramePtr();
    }
    /// The same with its shape; null if that has another dimension.
    template <int Dim>
    PosedPtr<Dim> frame() const {
        return posed<Dim>(frame());
    }
    /// When gestures begin, and new pins: at the time of what is shown; 0 before anything moves.
    double gestureTime() const;
    /// True while the frame does not yet show what the document says.
    bool isStale() const { return m_stale; }
    /// True while something is being computed.
    bool isBusy() const { return m_busy; }
    /// True while that is the shape, or its material, rather than its motion.
    bool isMeshing() const { return m_busy && !m_trackIsCurrent; }
    /// Ends what is being computed. The document goes back to the last state whose motion was complete (redo
    /// tries again); without one it stays, with as much as there is.
    void cancelWork();
    /// The handles at the time that is shown; dragged ones are where the pointer has them. Hidden ones are
    /// among them only if `all`.
    template <int Dim = 2>
    std::vector<PinView<Dim>> pins(bool all = false) const;
    /// The handles that do not hold at that time: where they would be. None that is hidden.
    template <int Dim = 2>
    std::vector<PinView<Dim>> ghosts() const;
    /// Where a handle's points are when it begins to hold: the starts of its paths.
    template <int Dim = 2>
    std::vector<Vec<Dim>> pathStarts(int handle) const;
    /// How the vertices move at the time that is shown: v̂ itself once it is there (see setFieldWanted), until
    /// then the difference of the neighbouring frames.
    template <int Dim>
    Points<Dim> velocity() const;
    bool hasVelocity() const { return answers(FieldKind::Velocity); }
    /// How far the selected handles take each vertex along, in the first row; no columns where it is not
    /// known (yet), or if nothing is selected.
    template <int Dim>
    Points<Dim> influence() const;
    /// From now on that is solved for at the time that is shown, unless it plays; `frameChanged` tells when it
    /// is there.
    enum class FieldKind { None, Velocity, Influence };
    void setFieldWanted(FieldKind wanted);
    /// The length in domain units that a tolerance of the stroke is measured in: one pixel of a picture, or a
    /// 2000th of the shape's diagonal.
    double pixel() const;

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
    /// Vertices of a solid as one handle: by number where the mesh is a file's, by their places where it is
    /// made and may be made anew.
    int addSolidHandle(const std::vector<int>& vertices, const std::string& kind);
    void changeHandle(int handle, const std::vector<int>& vertices);
    /// The vertices that a handle of a solid holds, increasing.
    std::vector<int> verticesOf(int handle) const;
    Placement<3> placementOf(const std::vector<int>& vertices) const;
    void removeSelected();
    /// True unless the handle is locked, which is told.
    bool mayChange(int handle) { return !unlocked({handle}).empty(); }
    /// The name of one pin, or how many they are.
    QString nameOf(const std::vector<int>& handles) const;
    template <int Dim = 2>
    void nudgeSelected(const Vec<Dim>& by);
    /// A whole gesture at once, as with numbers.
    template <int Dim>
    void moveSelected(const Grip& grip, const Amount& amount);
    bool isDragging() const { return m_drag.has_value(); }
    /// Of the selected handles, and those that are linked with them, the ones that hold at the time that is
    /// shown and are not locked; a notice if there are none. The gesture goes on from there and replaces what
    /// came after.
    /// One that `records` keeps its own times, from a clock that comes with its samples, and replaces only
    /// what its own handles did after.
    void beginDrag(const Grip& grip = {}, bool records = false);
    template <int Dim = 2>
    void dragTo(const Vec<Dim>& offset, double seconds = 0) {
        dragBy(amountOf<Dim>(offset), seconds);
    }
    void dragBy(const Amount& amount, double seconds = 0);
    /// From now on every drag records.
    void setRecording(bool records) { m_records = records; }
    /// Keeps the way as it was gone, within the tolerance.
    void endDrag(double tolerance);
    /// Keeps the straight way to where it ended: its amount was given as a number.
    void endDragStraight();
    void cancelDrag();
    /// Ends the drag and keeps nothing: what was reached stands for the end of the motion until that is
    /// there, of a project that is to come.
    void letGo();
    /// The gesture that goes on: how far it has come.
    const DragGesture* gesture() const { return m_drag ? &*m_drag : nullptr; }

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
    void dropAll();
    void dropShape();
    void postShape();
    void takeShape(int revision, const std::shared_ptr<const void>& shape, const KeptFrames& kept);
    void takeFrame(const FramePtr& frame);
    void takeLive(const FramePtr& frame);
    void takeFinished(double time, const QString& problem);
    void takeFailure(int revision, const QString& reason, bool shapeless);
    void showTime();
    void show(const FramePtr& frame, bool stale);
    void askField();
    void takeField(int number, const VelocityPtr& field);
    struct Question;
    Question question() const;
    bool answers(FieldKind kind) const;
    void setBusy(bool busy);
    void goBack();
    template <int Dim>
    const std::vector<PinPlace<Dim>>& places() const;
    template <int Dim>
    double armOf(const DragGesture& drag) const;
    template <int Dim>
    std::vector<PinView<Dim>> views(bool holding) const;
    template <int Dim>
    std::vector<PinView<Dim>> shown(std::vector<PinView<Dim>> views) const;
    std::vector<int> movableHandles();
    template <int Dim>
    void takeHold(const std::vector<int>& handles);
    template <int Dim>
    void pushGesture(const DragGesture& drag, const TimedPath& path, double from, const QString& key = {});
    void endDrag(const TimedPath& path);
    void goOn();
    double recordedTime() const;
    template <int Dim>
    void tellReplaced(const std::vector<Handle<Dim>>& before, const std::vector<int>& recorded, double from);
    std::vector<int> unlocked(std::vector<int> handles);

    Document m_document;
    Selection m_selection;
    Playback m_playback;
    FrameTrack m_track;
    FramePtr m_frame;          // shown
    FramePtr m_preview;        // the last frame of a drag, until the exact motion is there
    FramePtr m_previewBefore;  // the drag that goes on
    struct Question {  // for a field
        FramePtr frame;
        FieldKind kind = FieldKind::None;
        std::vector<int> handles = {};
        bool operator==(const Question&) const = default;
    };
    FieldKind m_fieldWanted = FieldKind::None;
    Question m_asked, m_answered;
    int m_question = 0;  // number of the newest
    VelocityPtr m_field;
    bool m_records = false;
    bool m_stale = false, m_busy = false, m_failed = false;
    bool m_addsHandle = false;  // a change that moves nothing is being made
    bool m_sameShape = false;   // what is shown stays as it is, though something is computed
    int m_gesture = 0;          // number of the newest drag
    double m_dragFrom = 0;      // when it began, by the clock of the motion
    QTimer m_goOn;              // while a drag records: others go on though the hand rests
    QElapsedTimer m_sinceSample;
    int m_revision = 0;         // of the newest request for a shape
    bool m_trackIsCurrent = false;
    std::shared_ptr<const void> m_shape;        // the newest rest mesh
    std::shared_ptr<const Project> m_complete;  // the last whose motion was computed to its end
    int m_completeAt = 0;                       // its place among the undo steps
    template <int Dim>
    struct Hold {  // of the project's dimension; the other one is empty
        // the handles in the rest mesh of the frame that is shown
        std::shared_ptr<const SimplicialMesh<Dim>> rest;
        std::shared_ptr<const Project> project;
        std::vector<PinPlace<Dim>> places;
        std::vector<PinView<Dim>> grabbed;  // of a drag, as they were at its start
    };
    mutable std::tuple<Hold<2>, Hold<3>> m_holds;
    std::optional<DragGesture> m_drag;
    ComputeThread m_compute;  // the last member: it stops before the others go
};

}  // namespace wend
