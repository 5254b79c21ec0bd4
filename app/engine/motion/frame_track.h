#pragma once

#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

/// The frames of final quality that are there so far, in the order of time.
class FrameTrack {
  public:
    void clear() { m_frames.clear(); }
    /// Rescales the times of all frames and drops the invalid ones.
    void keep(const KeptFrames& kept);
    void add(FramePtr frame);
    bool isEmpty() const { return m_frames.empty(); }
    double lastTime() const { return m_frames.empty() ? -1 : m_frames.back()->time; }
    const FramePtr& last() const { return m_frames.back(); }
    /// Returns the frame nearest to `time`; null if the track does not reach it yet.
    FramePtr at(double time) const;
    const std::vector<FramePtr>& frames() const { return m_frames; }

  private:
    std::vector<FramePtr> m_frames;
};

}  // namespace wend
