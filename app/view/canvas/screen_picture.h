#pragma once

#include <QImage>
#include <memory>

#include "core/mesh/simplicial_mesh.h"
#include "warp/pyramid.h"

namespace wend {

struct View;
struct WarpOptions;

/// A picture for the screen: always RGBA8, with light of half and float files encoded as sRGB. Alpha keeps
/// its association, so that warping it equals warping the original. This is the only conversion for display.
class ScreenPicture {
  public:
    explicit ScreenPicture(const std::shared_ptr<const Image>& picture);

    /// The pixels of a warp; none if it was stopped.
    QImage warped(const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                  const WarpOptions& options) const;
    const Image& image() const { return m_pyramid.base(); }

  private:
    Pyramid m_pyramid;
};

}  // namespace wend
