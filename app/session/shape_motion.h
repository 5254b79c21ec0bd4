#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/document/edits/document.h"
#include "app/session/motion/frame_track.h"

namespace wend {

class ComputeThread;
class Playback;
class Selection;

/// The motion of the document's shape as far as it is computed, and which frame of it is shown. It lives in
/// the thread of the window and owns the compute thread: requests go there, and frames come back as queued
/// signals. Every request for a shape has a number, its revision, and so has every drag. The track follows
/// every shape of the file, also those that are not wanted any more, for what the thread keeps of its frames
/// is said from one to the next. What views ask is described in ShapeSession, which passes it on.
class ShapeMotion : public QObject {
    Q_OBJECT

  public:
    ShapeMotion(Document& document, const Selection& selection, Playback& playback);
    ~ShapeMotion() override;

    const FrameTrack& track() const { return m_track; }
    FramePtr frame() const {
        return m_frame && m_frame->generation == m_document.generation() ? m_frame : FramePtr();
    }
    bool isStale() const { return m_stale; }
    bool hasFailed() const { return m_failed; }
    bool isBusy() const { return m_busy; }
    bool isMeshing() const { return m_busy && !m_trackIsCurrent; }
    double pixel() const;
    /// When gestures begin, and new pins: at the time of what is shown; 0 before anything moves.
    double gestureTime() const;

    /// Asks for the motion of the project as it is now.
    void compute();
    /// While a change is made that moves nothing: what is shown does not become stale.
    void setChangeMovesNothing(bool nothing) { m_changeMovesNothing = nothing; }
    void cancelWork();
    /// For another file: forgets everything, and tells it only with tellDropped().
    void drop();
    void tellDropped();

    /// A drag begins with the frame that is shown, at a time of the motion. Until it ends, its live frames
    /// come with liveReady(), and only those that are given to showLive() are shown.
    void beginDrag(const std::vector<int>& handles, const Grip& grip, double from);
    void dragTo(const Amount& amount, int sample, std::optional<double> time);
    void showLive(const FramePtr& frame);
    /// What it has reached is a preview of the end of the motion until that is there.
    void endDrag();
    /// What was shown before it comes back.
    void cancelDrag();
    void dropPreview() { m_preview.reset(); }

    enum class FieldKind { None, Velocity, Influence };
    void setFieldWanted(FieldKind wanted);
    bool hasVelocity() const { return answers(FieldKind::Velocity); }
    template <int Dim>
    Points<Dim> velocity() const;
    template <int Dim>
    Points<Dim> influence() const;
    void takeSelection();

  signals:
    void frameChanged();
    void liveReady(const wend::FramePtr& frame);
    /// The project cannot be computed: a drag that goes on must end.
    void failing();
    void busyChanged(bool busy);
    void progress(double time, double end);
    void notice(QString text);
    void problem(QString text);

  private:
    void takeShape(int revision, const std::shared_ptr<const void>& shape, const KeptFrames& kept);
    void takeFrame(const FramePtr& frame);
    void takeLive(const FramePtr& frame);
    void takeFinished(double time, const QString& problem);
    void takeFailure(int revision, const QString& reason, bool shapeless);
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
    std::shared_ptr<const void> m_shape;  // the newest rest mesh
    int m_revision = 0;                   // of the newest request for a shape
    int m_voidUpTo = 0;                   // shapes up to this revision are of another file, or cancelled
    int m_gesture = 0;                    // number of the newest drag
    bool m_dragging = false;
    FramePtr m_frame;          // shown
    FramePtr m_preview;        // the last frame of a drag, until the exact motion is there
    FramePtr m_previewBefore;  // the drag that goes on
    bool m_stale = false, m_busy = false, m_failed = false;
    bool m_changeMovesNothing = false;
    bool m_sameShape = false;                   // what is shown stays as it is, though something is computed
    std::shared_ptr<const Project> m_complete;  // the last whose motion was computed to its end
    int m_completeAt = 0;                       // its place among the undo steps
    FieldKind m_fieldWanted = FieldKind::None;
    Question m_asked, m_answered;
    int m_question = 0;  // number of the newest
    VelocityPtr m_field;
    std::unique_ptr<ComputeThread> m_compute;  // the last member: it stops before the others go
};

}  // namespace wend
