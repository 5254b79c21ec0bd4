#pragma once

#include <QImage>
#include <memory>
#include <vector>

#include "warp/image.h"

namespace wend {

/// A picture as the screen needs it: 8 bits, colours associated with alpha, and halved again and again, so
/// that a large picture that is shown small is read at about the size in which it is shown.
class DisplayPicture {
  public:
    explicit DisplayPicture(const Image& picture);

    int width() const { return m_levels.front().width; }
    int height() const { return m_levels.front().height; }
    /// Level k has pixels of 2^k of the picture's.
    const Image& level(int k) const { return m_levels[k]; }
    /// The level for `scale` picture pixels per pixel of the screen.
    int levelFor(double scale) const;

  private:
    std::vector<Image> m_levels;
};

/// RGBA, 8 bits, associated: wrapped without a copy of more than the pixels.
QImage toQImage(const Image& image);

}  // namespace wend
