#include "app/session/pose_watch.h"

namespace wend {

namespace {

constexpr int kRest = 300;  // milliseconds

}  // namespace

PoseWatch::PoseWatch(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    m_due.setSingleShot(true);
    m_due.setInterval(kRest);
    connect(&m_due, &QTimer::timeout, this, &PoseWatch::look);
    connect(&session, &ShapeSession::frameChanged, this, &PoseWatch::takeFrame);
    connect(&session, &ShapeSession::busyChanged, this, &PoseWatch::takeFrame);
    connect(&session.playback(), &Playback::playingChanged, this, &PoseWatch::takeFrame);
    takeFrame();
}

void PoseWatch::takeFrame() {
    if (m_session.frame() == m_seen) return;
    m_due.start();
    m_seen.reset();
    if (!m_flat && !m_solid) return;
    m_flat.reset();
    m_solid.reset();
    emit changed();
}

void PoseWatch::look() {
    const FramePtr& frame = m_session.frame();
    const bool moves = m_session.isDragging() || m_session.playback().isPlaying() || m_session.isBusy();
    if (!frame || frame == m_seen || frame->live || moves || m_work.isRunning()) return;
    frame->dimension == 2 ? lookAt<2>(posed<2>(frame)) : lookAt<3>(posed<3>(frame));
}

template <int Dim>
void PoseWatch::lookAt(const PosedPtr<Dim>& frame) {
    using Found = std::shared_ptr<const PoseFaults<Dim>>;
    const auto find = [frame]() -> Found {
        return std::make_shared<const PoseFaults<Dim>>(faultsOf<Dim>(*frame->built, frame->pose));
    };
    m_work = inBackground(this, find, [this, frame](const Found& found) {
        if (m_session.frame() != frame) return m_due.start();  // it has moved on
        m_seen = frame;
        if constexpr (Dim == 2)
            m_flat = found;
        else
            m_solid = found;
        emit changed();
    });
}

}  // namespace wend
