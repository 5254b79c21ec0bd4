#include "app/session/shape_motion.h"

#include <algorithm>
#include <utility>

#include "app/engine/motion/compute_thread.h"
#include "app/engine/motion/fields.h"
#include "app/engine/motion/playback.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/session/selection.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

bool isIn(const FrameTrack& track, const FramePtr& frame) {
    const auto& frames = track.frames();
    return std::find(frames.begin(), frames.end(), frame) != frames.end();
}

}  // namespace

ShapeMotion::ShapeMotion(Document& document, const Selection& selection, Playback& playback)
    : m_document(document),
      m_selection(selection),
      m_playback(playback),
      m_compute(std::make_unique<ComputeThread>(this)) {
    connect(&m_playback, &Playback::timeChanged, this, &ShapeMotion::takeTime);
    connect(&m_playback, &Playback::playingChanged, this, &ShapeMotion::askField);
    connect(m_compute.get(), &ComputeThread::shapeReady, this, &ShapeMotion::takeShape);
    connect(m_compute.get(), &ComputeThread::frameReady, this, &ShapeMotion::takeFrame);
    connect(m_compute.get(), &ComputeThread::fieldReady, this, &ShapeMotion::takeField);
    connect(m_compute.get(), &ComputeThread::finished, this, &ShapeMotion::takeFinished);
    connect(m_compute.get(), &ComputeThread::failed, this, &ShapeMotion::takeFailure);
    connect(m_compute.get(), &ComputeThread::progress, this, &ShapeMotion::progress);
    connect(m_compute.get(), &ComputeThread::within, this, &ShapeMotion::within);
}

ShapeMotion::~ShapeMotion() = default;

void ShapeMotion::drop() {
    if (m_dragging) m_compute->post(EndDrag{});
    if (m_document.isEmpty()) m_compute->post(CancelWork{});
    m_dragging = false;
    ++m_gesture;                // invalidates pending frames of a drag
    m_voidUpTo = ++m_revision;  // and so is a shape
    m_complete.reset();
    dropShape();
}

void ShapeMotion::tellDropped() {
    show({}, false);
    if (m_document.isEmpty()) setBusy(false);
}

void ShapeMotion::dropShape() {
    m_track.clear();
    m_frame.reset();
    m_preview.reset();
    m_previewBefore.reset();
    m_asked = m_answered = {};
    m_field.reset();
    m_shape.reset();
    m_trackIsCurrent = m_stale = m_sameShape = false;
}

void ShapeMotion::compute() {
    const double end = motionEnd(*m_document.project());
    if (m_preview && end < m_preview->time) m_preview.reset();
    m_trackIsCurrent = false;
    m_sameShape = m_changeMovesNothing && !m_stale;
    setBusy(true);
    m_compute->post(SetShape{{m_document.generation(), ++m_revision, m_document.project(),
                              m_document.picture(), m_document.folder().toStdString()}});
    m_playback.setEnd(end);
    showTime();
}

void ShapeMotion::takeShape(int revision, const std::shared_ptr<const void>& shape, const KeptFrames& kept) {
    if (revision <= m_voidUpTo) return;
    m_asked = m_answered = {};  // the question may have been dropped with the last shape
    m_shape = shape;
    m_track.keep(kept);
    m_playback.setReady(m_track.lastTime());
    m_trackIsCurrent = revision == m_revision;
    if (m_trackIsCurrent && std::exchange(m_failed, false)) emit problem({});
}

void ShapeMotion::takeFrame(const FramePtr& frame) {
    if (frame->live) {
        if (frame->gesture == m_gesture) takeLive(frame);
        return;
    }
    if (frame->shape != m_shape) return;
    m_track.add(frame);
    m_playback.setReady(frame->time);
    showTime();
}

void ShapeMotion::takeLive(const FramePtr& frame) {
    if (m_dragging) {
        emit liveReady(frame);
    } else if (m_preview) {
        m_preview = atTime(frame, m_preview->time);  // the tail of a drag that has just ended
        showTime();
    }
}

void ShapeMotion::takeFinished(double time, const QString& problem, const QString& remark) {
    if (!m_trackIsCurrent) return;
    m_complete = m_document.project();
    m_completeAt = m_document.undoStack()->index();
    if (!problem.isEmpty())
        m_document.notify(ShapeSession::tr("The motion stops at %1 s: %2")
                              .arg(time * Playback::kSecondsPerUnit, 0, 'f', 2)
                              .arg(problem));
    else if (!remark.isEmpty())
        m_document.notify(remark.left(1).toUpper() + remark.mid(1) + QLatin1Char('.'));
    m_preview.reset();
    m_previewBefore.reset();
    setBusy(false);
    if (!m_track.isEmpty()) m_playback.setReady(m_playback.end());
    showTime();
}

void ShapeMotion::takeFailure(int revision, const QString& reason, ComputeFailure failure) {
    if (revision != m_revision) return;  // result of an outdated request
    m_failed = true;
    m_lacksMemory = failure == ComputeFailure::Memory;
    emit dragMustEnd();
    m_preview.reset();
    if (failure == ComputeFailure::Shapeless) {
        dropShape();
        show({}, false);
    }
    setBusy(false);
    emit problem(reason);
}

void ShapeMotion::cancelWork() {
    if (!m_busy) return;
    emit dragMustEnd();
    if (m_complete && m_complete != m_document.project()) {
        goBack();
        m_document.notify(ShapeSession::tr("Cancelled: everything is as it was before the last change."));
        return;
    }
    const bool meshing = isMeshing();
    if (meshing) m_voidUpTo = ++m_revision;  // invalidates a shape that is about to arrive
    m_compute->post(CancelWork{});
    m_preview.reset();
    setBusy(false);
    showTime();
    m_failed = meshing;
    const QString motion = ShapeSession::tr("The motion was cancelled. Any change computes it again.");
    if (!meshing)
        m_document.notify(motion);
    else if (m_shape)  // as a rule its mesh serves again
        emit problem(motion);
    else
        emit problem(
            ShapeSession::tr("Meshing was cancelled. Any change, such as fewer vertices, starts it again."));
}

/// Goes back by undo or redo steps if they reach the project, otherwise by a new change: steps may have
/// merged.
void ShapeMotion::goBack() {
    const auto target = m_complete;
    QUndoStack& undo = *m_document.undoStack();
    if (m_completeAt < undo.index()) undo.setIndex(m_completeAt);
    if (m_document.project() != target) m_document.changeBack(ShapeSession::tr("Cancel"), target);
}

/// Returns the end of the motion if it ended early.
double ShapeMotion::gestureTime() const {
    if (m_document.isEmpty()) return 0;
    const double end = motionEnd(*m_document.project());
    const bool endedEarly = m_trackIsCurrent && !m_busy && !m_track.isEmpty() && m_track.lastTime() < end;
    const bool scrubbed = m_frame && !m_stale && !m_frame->live && m_playback.time() < end;
    if (endedEarly || scrubbed) return std::min(m_frame->time, end);
    return std::min(m_playback.time(), end);
}

double ShapeMotion::pixel() const {
    return m_document.picture() || !m_frame ? 1 : m_frame->diagonal / 2000;
}

void ShapeMotion::beginDrag(const std::vector<int>& handles, const Grip& grip, double from) {
    m_dragging = true;
    m_previewBefore = m_preview;
    m_compute->post(BeginDrag{handles, grip, ++m_gesture, m_revision, m_frame, from});
}

void ShapeMotion::dragTo(const Amount& amount, int sample, std::optional<double> time) {
    m_compute->post(DragTo{amount, sample, time});
}

void ShapeMotion::showLive(const FramePtr& frame) {
    m_preview = frame;
    show(frame, false);
}

/// Previews the last frame until those of the drag that are still on their way arrive.
void ShapeMotion::endDrag() {
    m_dragging = false;
    m_compute->post(EndDrag{});
    m_preview = atTime(m_preview ? m_preview : m_frame, m_document.end());
}

void ShapeMotion::cancelDrag() {
    m_dragging = false;
    m_preview = m_previewBefore;
    ++m_gesture;  // invalidates its pending frames
    m_compute->post(EndDrag{});
    showTime();
}

void ShapeMotion::takeTime(double time) {
    if (m_dragging) return;
    if (m_preview && m_preview->time != time) m_preview.reset();
    showTime();
}

/// Does nothing during a drag, which shows its own frames.
void ShapeMotion::showTime() {
    if (m_dragging) return;
    FramePtr frame = m_track.at(m_playback.time());
    const bool endedEarly = !frame && !m_busy && !m_track.isEmpty();
    if (endedEarly) frame = m_track.last();
    if (m_preview && (!frame || !m_trackIsCurrent))
        show(m_preview, false);
    else if (frame)
        show(frame, !m_trackIsCurrent && !m_sameShape);
    else if (m_trackIsCurrent && !m_track.isEmpty() && (!m_frame || isIn(m_track, m_frame)))
        show(m_track.last(), true);  // the part that was computed
    else
        show(m_frame, m_frame && !m_sameShape);
}

void ShapeMotion::show(const FramePtr& frame, bool stale) {
    m_frame = frame;
    m_stale = stale;
    askField();
    emit frameChanged();
}

void ShapeMotion::setBusy(bool busy) {
    if (std::exchange(m_busy, busy) != busy) emit busyChanged(busy);
}

void ShapeMotion::setFieldWanted(FieldKind wanted) {
    m_fieldWanted = wanted;
    askField();
}

/// Requests the influence of the new selection.
void ShapeMotion::takeSelection() {
    if (m_fieldWanted != FieldKind::Influence) return;
    askField();
    emit frameChanged();
}

/// Returns the field request for the shown frame.
ShapeMotion::Question ShapeMotion::question() const {
    if (m_fieldWanted != FieldKind::Influence) return {m_frame, m_fieldWanted};
    return {m_frame, m_selection.isEmpty() ? FieldKind::None : m_fieldWanted, m_selection.handles()};
}

bool ShapeMotion::answers(FieldKind kind) const {
    return m_frame && m_field && m_answered.kind == kind && m_answered.frame == m_frame;
}

void ShapeMotion::askField() {
    const bool stands = m_frame && !m_frame->live && !m_stale && !m_dragging && !m_playback.isPlaying();
    const Question next = question();
    if (next.kind == FieldKind::None || !stands || !m_trackIsCurrent) return;
    if (next == m_asked || !isIn(m_track, m_frame)) return;
    m_asked = next;
    m_compute->post(AskField{m_frame, m_revision, next.handles, ++m_question});
}

void ShapeMotion::takeField(int number, const VelocityPtr& field) {
    if (number != m_question) return;
    m_answered = m_asked;
    m_field = field;
    if (m_answered.frame == m_frame) emit frameChanged();
}

Eigen::MatrixXd ShapeMotion::velocity() const {
    if (hasVelocity()) return *m_field;
    const FramePtr shown = frame();
    return shown ? velocityBetween(m_track, *shown) : Eigen::MatrixXd();
}

Eigen::MatrixXd ShapeMotion::influence() const {
    const bool isThere = answers(FieldKind::Influence) && m_answered.handles == m_selection.handles();
    return isThere ? *m_field : Eigen::MatrixXd();
}

}  // namespace wend
