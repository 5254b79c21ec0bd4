#include "warp/warp.h"

#include "warp/warped_picture.h"

namespace wend {
namespace {

Image painted(const WarpedPicture& picture) {
    Image image = picture.header();
    if (image.width <= 0 || image.height <= 0) return image;
    image.makePixels();
    return picture.paint(0, image) ? std::move(image) : Image();
}

}  // namespace

Image warpImage(const Pyramid& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                const WarpOptions& options) {
    return painted(WarpedPicture(source, rest, pose, view, options));
}

Image warpImage(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                const WarpOptions& options) {
    return painted(WarpedPicture(source, rest, pose, view, options));
}

}  // namespace wend
