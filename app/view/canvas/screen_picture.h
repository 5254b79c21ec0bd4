#pragma once

#include <QImage>
#include <memory>

#include "core/mesh/simplicial_mesh.h"
#include "warp/pyramid.h"

namespace wend {

struct View;
struct WarpOptions;

/// A picture in the colours of the screen: red, green, blue and alpha in 8 bits, whatever the file holds;
/// light of half and float files is encoded as in sRGB. Alpha stays associated or not, so that a warp of it
/// is a warp of the original. The way from a picture to the screen leads through here alone: who draws meets
/// no other number of channels.
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
