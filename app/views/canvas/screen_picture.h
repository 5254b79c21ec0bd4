#pragma once

#include <QImage>
#include <memory>

#include "core/mesh/simplicial_mesh.h"
#include "warp/pyramid.h"

namespace wend {

struct View;
struct WarpOptions;

/// A picture for the screen: RGBA of 8 bits, or of halves where the file has linear light (half and float),
/// which is encoded as sRGB only after it has been warped and blended, as exports do that. Alpha keeps its
/// association, so that warping it equals warping the original. This is the only conversion for display.
class ScreenPicture {
  public:
    explicit ScreenPicture(const std::shared_ptr<const Image>& picture);

    /// Returns the pixels of a warp; a null image if it was stopped.
    QImage warped(const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                  const WarpOptions& options) const;
    const Image& image() const { return m_pyramid.base(); }
    /// Returns the mean lightness from 0 (black) to 1 (white) of what is not transparent: the luma (BT.709)
    /// of encoded colours, weighted with alpha. 1 for an empty picture.
    double lightness() const { return m_lightness; }
    /// Returns whether no pixel is transparent.
    bool opaque() const { return m_pyramid.opaque(); }

  private:
    Pyramid m_pyramid;
    double m_lightness;
};

}  // namespace wend
