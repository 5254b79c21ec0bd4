#pragma once

#include <memory>
#include <vector>

#include "warp/image.h"

namespace wend {

/// A picture and its reduced levels: a pixel of level k averages 2^k × 2^k pixels of level 0 (fewer at
/// borders). Immutable and shared by threads.
class Pyramid {
  public:
    /// Makes `levels` reductions (fewer if the picture becomes smaller than a pixel); −1: all.
    explicit Pyramid(std::shared_ptr<const Image> image, int levels = -1);

    const Image& base() const { return *m_levels.front(); }
    const Image& level(int k) const { return *m_levels[static_cast<std::size_t>(k)]; }
    /// Returns whether no pixel is transparent.
    bool opaque() const { return m_opaque; }
    /// Returns the number of levels for a picture's size.
    static int levelsOf(int width, int height);
    int levels() const { return static_cast<int>(m_levels.size()); }

  private:
    std::vector<std::shared_ptr<const Image>> m_levels;
    bool m_opaque;
};

}  // namespace wend
