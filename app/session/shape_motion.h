#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/engine/motion/frame_track.h"
#include "app/project/edits/document.h"

namespace wend {

class ComputeThread;
enum class ComputeFailure;
class Playback;
class Selection;

/// Computes the motion of the document's shape and chooses the shown frame. Lives in the window's thread and
/// owns the compute thread: requests are posted to it, frames return as queued signals. Every request for a
/// shape has a number, its revision, and every drag has one, too. The track follows every shape of the file,
/// including outdated ones, because the thread reports the validity of frames from one shape to the next.
class ShapeMotion : public QObject {
    Q_OBJECT

  public:
    ShapeMotion(Document& document, const Selection& selection, Playback& playback);
    ~ShapeMotion() override;

    /// Returns the document whose shape it moves.
    const Document& document() const { return m_document; }
    const FrameTrack& track() const { return m_track; }
    /// Returns the frame to show: that of the drag or of the shown time; null before the first mesh. It
    /// always belongs to the current document.
    FramePtr frame() const {
        return m_frame && m_frame->generation == m_document.generation() ? m_frame : FramePtr();
    }
    /// Returns the frame with its shape; null if that has another dimension.
    template <int Dim>
    PosedPtr<Dim> frame() const {
        return posed<Dim>(frame());
    }
    /// Returns true while the frame does not show the document's state yet.
    bool isStale() const { return m_stale; }
    /// Returns true if the project cannot be computed: an older shape is shown.
    bool hasFailed() const { return m_failed; }
    /// Returns whether memory is lacking for that.
    bool lacksMemory() const { return m_failed && m_lacksMemory; }
    /// Returns true while something is being computed.
    bool isBusy() const { return m_busy; }
    /// Returns true while the shape or its material is being made, rather than its motion.
    bool isMeshing() const { return m_busy && !m_trackIsCurrent; }
    bool isDragging() const { return m_dragging; }
    /// Returns the unit of the stroke's tolerance, in domain units: one pixel of a picture, or a 2000th of
    /// the shape's diagonal.
    double pixel() const;
    /// Returns the start time of gestures and new pins: the shown time, or 0 before anything moves.
    double gestureTime() const;

    /// Requests the motion of the current project.
    void compute();
    /// Keeps the shown frame from becoming stale during a change that moves nothing.
    void setChangeMovesNothing(bool nothing) { m_changeMovesNothing = nothing; }
    /// Cancels the computation and restores the last state with a complete motion (redo tries again). Without
    /// one, the document stays, with as much motion as was computed.
    void cancelWork();
    /// Forgets everything for another file; signals are emitted by tellDropped() only.
    void drop();
    void tellDropped();

    /// Begins a drag from the shown frame at a time of the motion. Its live frames arrive with liveReady();
    /// those passed to showLive() are shown.
    void beginDrag(const std::vector<int>& handles, const Grip& grip, double from);
    void dragTo(const Amount& amount, int sample, std::optional<double> time);
    void showLive(const FramePtr& frame);
    /// Shows the reached pose until the end of the motion is computed.
    void endDrag();
    /// Restores the frame from before the drag.
    void cancelDrag();
    void dropPreview() { m_preview.reset(); }

    enum class FieldKind { None, Velocity, Influence };
    /// Sets the field that is solved for at the shown time, except during playback; `frameChanged` reports
    /// its arrival.
    void setFieldWanted(FieldKind wanted);
    bool hasVelocity() const { return answers(FieldKind::Velocity); }
    /// Returns the velocities at the shown time: v̂ once it is solved, until then the difference of the
    /// neighbouring frames.
    Eigen::MatrixXd velocity() const;
    /// Returns the influence of the selected handles on each vertex in the first row; no columns while it is
    /// unknown, or if nothing is selected.
    Eigen::MatrixXd influence() const;
    void takeSelection();

  signals:
    void frameChanged();
    void liveReady(const wend::FramePtr& frame);
    /// Emitted when a drag must end: the project cannot be computed, or its computation is cancelled.
    void dragMustEnd();
    void busyChanged(bool busy);
    /// Emitted with the time up to which the motion is computed.
    void progress(double time, double end);
    /// Emitted with the approximate time that the current step has reached.
    void within(double time, double end);
    /// Emitted if the project cannot be computed; an empty text withdraws the problem.
    void problem(QString text);

  private:
    void takeShape(int revision, const std::shared_ptr<const void>& shape, const KeptFrames& kept);
    void takeFrame(const FramePtr& frame);
    void takeLive(const FramePtr& frame);
    void takeFinished(double time, const QString& problem, const QString& remark);
    void takeFailure(int revision, const QString& reason, ComputeFailure failure);
    void takeField(int number, const VelocityPtr& field);
    void takeTime(double time);
    void dropShape();
    void goBack();
    void showTime();
    void show(const FramePtr& frame, bool stale);
    void setBusy(bool busy);
    struct Question {  // for a field
        FramePtr frame;
        FieldKind kind = FieldKind::None;
        std::vector<int> handles = {};
        bool operator==(const Question&) const = default;
    };
    Question question() const;
    bool answers(FieldKind kind) const;
    void askField();

    Document& m_document;
    const Selection& m_selection;
    Playback& m_playback;
    FrameTrack m_track;
    bool m_trackIsCurrent = false;        // it is of the newest request
    std::shared_ptr<const void> m_shape;  // of the newest revision
    int m_revision = 0;                   // of the newest request for a shape
    int m_voidUpTo = 0;                   // shapes up to this revision are of another file, or cancelled
    int m_gesture = 0;                    // number of the newest drag
    bool m_dragging = false;
    FramePtr m_frame;          // shown
    FramePtr m_preview;        // the last frame of a drag, until the exact motion is there
    FramePtr m_previewBefore;  // of the current drag
    bool m_stale = false, m_busy = false, m_failed = false, m_lacksMemory = false;
    bool m_changeMovesNothing = false;
    bool m_sameShape = false;                   // the current request does not make the shown frame stale
    std::shared_ptr<const Project> m_complete;  // whose motion was computed to its end
    int m_completeAt = 0;                       // its place among the undo steps
    FieldKind m_fieldWanted = FieldKind::None;
    Question m_asked, m_answered;
    int m_question = 0;  // number of the newest
    VelocityPtr m_field;
    // last, so that the thread stops before the other members are destroyed
    std::unique_ptr<ComputeThread> m_compute;
};

}  // namespace wend
