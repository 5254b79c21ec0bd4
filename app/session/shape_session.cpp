#include "app/session/shape_session.h"

#include <algorithm>

#include "app/document/handle_edits.h"
#include "app/session/fields.h"

namespace wend {

namespace {

constexpr int kTick = 20;  // milliseconds

bool isIn(const FrameTrack& track, const FramePtr& frame) {
    const auto& frames = track.frames();
    return std::find(frames.begin(), frames.end(), frame) != frames.end();
}

}  // namespace

ShapeSession::ShapeSession(QObject* parent) : QObject(parent) {
    m_goOn.setInterval(kTick);
    connect(&m_goOn, &QTimer::timeout, this, &ShapeSession::goOn);
    connect(&m_document, &Document::projectChanged, this, &ShapeSession::postShape);
    connect(&m_document, &Document::opened, this, &ShapeSession::reset);
    connect(&m_playback, &Playback::timeChanged, this, [this](double time) {
        if (m_drag) return;
        if (m_preview && m_preview->time != time) m_preview.reset();
        showTime();
    });
    connect(&m_playback, &Playback::playingChanged, this, &ShapeSession::askField);
    connect(&m_selection, &Selection::changed, this, &ShapeSession::pinsChanged);
    connect(&m_selection, &Selection::changed, this, [this] {
        if (m_fieldWanted != FieldKind::Influence) return;
        askField();
        emit frameChanged();  // its influence is another one, or none
    });
    connect(&m_compute, &ComputeThread::shapeReady, this, &ShapeSession::takeShape);
    connect(&m_compute, &ComputeThread::frameReady, this, &ShapeSession::takeFrame);
    connect(&m_compute, &ComputeThread::fieldReady, this, &ShapeSession::takeField);
    connect(&m_compute, &ComputeThread::finished, this, &ShapeSession::takeFinished);
    connect(&m_compute, &ComputeThread::failed, this, &ShapeSession::takeFailure);
    connect(&m_compute, &ComputeThread::progress, this, &ShapeSession::progress);
}

/// For another file: what went on with the last one ends. First everything of it goes, only then others hear
/// of it: nobody sees the last file's shape, selection or drag beside the new one's project.
void ShapeSession::reset() {
    dropAll();
    m_selection.clear();
    m_playback.setPlaying(false);
    m_playback.setEnd(0);
    show({}, false);
    emit pinsChanged();
    if (m_document.isEmpty()) setBusy(false);
}

void ShapeSession::dropAll() {
    if (m_drag) m_compute.post(EndDrag{});
    if (m_document.isEmpty()) m_compute.post(CancelWork{});
    m_drag.reset();
    m_goOn.stop();
    ++m_gesture;   // frames of a drag that are under way are void,
    ++m_revision;  // and so is a shape
    m_complete.reset();
    dropShape();
}

void ShapeSession::dropShape() {
    m_track.clear();
    m_frame.reset();
    m_preview.reset();
    m_previewBefore.reset();
    m_asked = m_answered = {};
    m_field.reset();
    m_shape.reset();
    m_holds = {};
    m_trackIsCurrent = m_stale = m_sameShape = false;
}

void ShapeSession::postShape() {
    if (m_document.isEmpty()) return;
    cancelDrag();  // undo in the middle of it: its handles may be gone
    const double end = motionEnd(*m_document.project());
    if (m_preview && end < m_preview->time) m_preview.reset();
    const int count = handleCount();
    std::vector<int> kept = m_selection.handles();
    std::erase_if(kept, [count](int h) { return h >= count; });
    m_selection.set(std::move(kept));
    m_trackIsCurrent = false;
    m_sameShape = m_addsHandle && !m_stale;
    setBusy(true);
    m_compute.post(SetShape{{m_document.generation(), ++m_revision, m_document.project(),
                             m_document.picture(), m_document.folder().toStdString()}});
    m_playback.setEnd(end);
    showTime();
    emit pinsChanged();
}

void ShapeSession::takeShape(int revision, const std::shared_ptr<const void>& shape, const KeptFrames& kept) {
    if (revision != m_revision) return;
    m_asked = m_answered = {};  // the question may have been dropped with the last shape
    if (m_failed) emit problem({});
    m_failed = false;
    m_shape = shape;
    m_trackIsCurrent = true;
    m_track.keep(kept);
    m_playback.setReady(m_track.lastTime());
}

void ShapeSession::takeFrame(const FramePtr& frame) {
    if (frame->live) {
        if (frame->gesture == m_gesture) takeLive(frame);
        return;
    }
    if (frame->shape != m_shape) return;
    m_track.add(frame);
    m_playback.setReady(frame->time);
    if (!m_drag) showTime();
}

void ShapeSession::takeLive(const FramePtr& frame) {
    if (!m_drag) {
        if (!m_preview) return;
        m_preview = atTime(frame, m_preview->time);  // the tail of a drag that has just ended
        showTime();
        return;
    }
    const bool wasStopped = m_drag->isStopped();
    m_drag->follow(*frame);
    m_preview = frame;
    show(frame, false);
    if (m_drag && frame->stopped && !wasStopped)  // who sees the frame may have ended the drag
        emit notice(tr("%1 cannot go further: %2")
                        .arg(nameOf(m_drag->handles()), QString::fromStdString(frame->message)));
}

void ShapeSession::takeFinished(double time, const QString& problem) {
    if (!m_trackIsCurrent) return;
    m_complete = m_document.project();
    m_completeAt = m_document.undoStack()->index();
    if (!problem.isEmpty()) emit notice(tr("The motion stops at %1: %2").arg(time, 0, 'f', 2).arg(problem));
    m_preview.reset();
    m_previewBefore.reset();
    setBusy(false);
    if (!m_track.isEmpty()) m_playback.setReady(m_playback.end());
    showTime();
}

void ShapeSession::takeFailure(int revision, const QString& reason, bool shapeless) {
    if (revision != m_revision) return;  // of what is not wanted any more
    m_failed = true;
    cancelDrag();
    m_preview.reset();
    if (shapeless) {
        dropShape();
        show({}, false);
    }
    setBusy(false);
    emit problem(reason);
}

void ShapeSession::cancelWork() {
    if (!m_busy) return;
    cancelDrag();
    const bool meshing = isMeshing();
    if (m_complete && m_complete != m_document.project()) {
        goBack();
        emit notice(tr("Cancelled: everything is as it was before the last change."));
        return;
    }
    if (meshing) ++m_revision;  // a shape that is just ready comes too late
    m_compute.post(CancelWork{});
    m_preview.reset();
    setBusy(false);
    showTime();
    m_failed = meshing;
    if (meshing)
        emit problem(tr("Meshing was cancelled. Any change makes a mesh again, such as fewer vertices."));
    else
        emit notice(tr("The motion was cancelled. Any change computes it again."));
}

/// By undo steps if they lead there (and redo forth), otherwise by a change of its own: steps may have
/// merged.
void ShapeSession::goBack() {
    const auto target = m_complete;
    QUndoStack& undo = *m_document.undoStack();
    if (m_completeAt < undo.index()) undo.setIndex(m_completeAt);
    if (m_document.project() != target) m_document.change(tr("Cancel"), *target);
}

void ShapeSession::showTime() {
    if (m_drag) return;
    FramePtr frame = m_track.at(m_playback.time());
    const bool endedEarly = !frame && !m_busy && !m_track.isEmpty();
    if (endedEarly) frame = m_track.last();
    if (m_preview && (!frame || !m_trackIsCurrent))
        show(m_preview, false);
    else if (frame)
        show(frame, !m_trackIsCurrent && !m_sameShape);
    else if (m_trackIsCurrent && !m_track.isEmpty() && (!m_frame || isIn(m_track, m_frame)))
        show(m_track.last(), true);  // as far as it has come
    else
        show(m_frame, m_frame && !m_sameShape);
}

void ShapeSession::show(const FramePtr& frame, bool stale) {
    m_frame = frame;
    m_stale = stale;
    askField();
    emit frameChanged();
}

void ShapeSession::setFieldWanted(FieldKind wanted) {
    m_fieldWanted = wanted;
    askField();
}

/// What is wanted of what is shown.
ShapeSession::Question ShapeSession::question() const {
    if (m_fieldWanted != FieldKind::Influence) return {m_frame, m_fieldWanted};
    return {m_frame, m_selection.isEmpty() ? FieldKind::None : m_fieldWanted, m_selection.handles()};
}

bool ShapeSession::answers(FieldKind kind) const {
    return m_frame && m_field && m_answered.kind == kind && m_answered.frame == m_frame;
}

void ShapeSession::askField() {
    const bool stands = m_frame && !m_frame->live && !m_stale && !m_drag && !m_playback.isPlaying();
    const Question next = question();
    if (next.kind == FieldKind::None || !stands || !m_trackIsCurrent) return;
    if (next == m_asked || !isIn(m_track, m_frame)) return;
    m_asked = next;
    m_compute.post(AskField{m_frame, m_revision, next.handles, ++m_question});
}

void ShapeSession::takeField(int number, const VelocityPtr& field) {
    if (number != m_question) return;
    m_answered = m_asked;
    m_field = field;
    if (m_answered.frame == m_frame) emit frameChanged();
}

template <int Dim>
Points<Dim> ShapeSession::velocity() const {
    if (hasVelocity() && m_field->rows() == Dim) return *m_field;
    const auto shown = frame<Dim>();
    return shown ? velocityBetween<Dim>(m_track, *shown) : Points<Dim>(Dim, 0);
}

template <int Dim>
Points<Dim> ShapeSession::influence() const {
    const bool isThere = answers(FieldKind::Influence) && m_field->rows() == Dim &&
                         m_answered.handles == m_selection.handles();
    return isThere ? Points<Dim>(*m_field) : Points<Dim>(Dim, 0);
}

void ShapeSession::setBusy(bool busy) {
    if (busy == m_busy) return;
    m_busy = busy;
    emit busyChanged(busy);
}

template Points<2> ShapeSession::influence<2>() const;
template Points<3> ShapeSession::influence<3>() const;
template Points<2> ShapeSession::velocity<2>() const;
template Points<3> ShapeSession::velocity<3>() const;

}  // namespace wend
