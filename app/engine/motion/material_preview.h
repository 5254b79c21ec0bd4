#pragma once

#include <utility>

#include "app/engine/motion/frame.h"

namespace wend {

/// A material while it is painted. It replaces the material of its frame until a frame with another material
/// arrives.
template <int Dim>
class MaterialPreview {
  public:
    /// Shows the material of another frame, or none. `lasts`: through the next change of the project, which
    /// is that it is painted.
    void set(const PosedPtr<Dim>& frame, const PosedPtr<Dim>& painted, bool lasts) {
        m_upon = frame ? frame->material : nullptr;
        m_painted = painted ? painted->material : nullptr;
        m_lasts = lasts;
    }
    void takeProject() {
        if (!std::exchange(m_lasts, false)) m_painted.reset();
    }
    /// Returns the frame with the preview's material.
    PosedPtr<Dim> over(const PosedPtr<Dim>& frame) const {
        if (!frame || !m_painted || frame->material != m_upon) return frame;
        if (m_frame != frame || m_shown->material != m_painted) {
            auto shown = std::make_shared<PosedFrame<Dim>>(*frame);
            shown->material = m_painted;
            m_frame = frame;
            m_shown = shown;
        }
        return m_shown;
    }

  private:
    std::shared_ptr<const Material<Dim>> m_upon, m_painted;
    bool m_lasts = false;
    mutable PosedPtr<Dim> m_frame, m_shown;  // result of the last call of over()
};

}  // namespace wend
