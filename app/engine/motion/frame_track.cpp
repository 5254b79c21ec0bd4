#include "app/engine/motion/frame_track.h"

#include <algorithm>

namespace wend {

namespace {

constexpr double kSameTime = 1e-9;

bool before(const FramePtr& frame, double time) {
    return frame->time < time;
}

}  // namespace

void FrameTrack::keep(const KeptFrames& kept) {
    while (!m_frames.empty() && m_frames.back()->time * kept.timeScale > kept.upTo + kSameTime)
        m_frames.pop_back();
    if (kept.timeScale == 1) return;
    for (FramePtr& frame : m_frames) frame = atTime(frame, frame->time * kept.timeScale);
}

void FrameTrack::add(FramePtr frame) {
    while (!m_frames.empty() && m_frames.back()->time >= frame->time) m_frames.pop_back();
    m_frames.push_back(std::move(frame));
}

FramePtr FrameTrack::at(double time) const {
    if (m_frames.empty() || time > m_frames.back()->time + kSameTime) return {};
    const auto next = std::lower_bound(m_frames.begin(), m_frames.end(), time, before);
    if (next == m_frames.begin()) return m_frames.front();
    if (next == m_frames.end()) return m_frames.back();
    return (*next)->time - time < time - (*std::prev(next))->time ? *next : *std::prev(next);
}

}  // namespace wend
