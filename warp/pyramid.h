#pragma once

#include <memory>
#include <vector>

#include "warp/image.h"

namespace wend {

/// A picture and its halvings: level k has 2^k × 2^k pixels of level 0 in one (borders are averaged over what
/// is there). Made once per picture; levels are immutable and may be shared between threads.
class Pyramid {
  public:
    /// Only `levels` halvings are made (fewer when the picture gets smaller than a pixel); −1: all.
    explicit Pyramid(std::shared_ptr<const Image> image, int levels = -1);

    const Image& base() const { return *m_levels.front(); }
    const Image& level(int k) const { return *m_levels[static_cast<std::size_t>(k)]; }
    /// Whether no pixel is transparent, not even partly.
    bool opaque() const { return m_opaque; }
    /// How many levels a picture of that size can have.
    static int levelsOf(int width, int height);
    int levels() const { return static_cast<int>(m_levels.size()); }

  private:
    std::vector<std::shared_ptr<const Image>> m_levels;
    bool m_opaque;
};

}  // namespace wend
