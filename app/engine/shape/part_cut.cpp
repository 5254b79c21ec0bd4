#include "app/engine/shape/part_cut.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/region.h"
#include "warp/convert.h"
#include "warp/inpaint.h"
#include "warp/matte.h"

namespace wend {
namespace {

constexpr int kGap = 8;  // transparent pixels around the cut

/// How far a point is inside the cut, in [0, 1].
float cutAt(const PicturePart& part, const Vec<2>& p) {
    double inside = 0;
    for (const auto& loop : part.cut.loops) {
        const double own = membership<2>(Polygon{loop}, p, part.feather);
        inside += own - 2 * inside * own;  // even and odd
    }
    return static_cast<float>(inside);
}

/// The mean of the cut over a pixel, by 4 × 4 places where its border is near.
float cutOver(const PicturePart& part, const Vec<2>& centre) {
    constexpr int kPlaces = 4;
    double nearest = INFINITY;
    for (const auto& loop : part.cut.loops)
        nearest = std::min(nearest, std::abs(signedDistance<2>(Polygon{loop}, centre)));
    if (nearest > 1 + part.feather) return cutAt(part, centre);
    float sum = 0;
    for (int j = 0; j < kPlaces; ++j)
        for (int i = 0; i < kPlaces; ++i)
            sum += cutAt(part, centre + Vec<2>(i + 0.5 - kPlaces / 2, j + 0.5 - kPlaces / 2) / kPlaces);
    return sum / (kPlaces * kPlaces);
}

/// The pixels of a picture that a cut may take something of, with a gap around them.
PixelBox boxOf(const PicturePart& part, const Sheet& from) {
    Vec<2> low = Vec<2>::Constant(INFINITY), high = -low;
    for (const auto& loop : part.cut.loops)
        for (const Vec<2>& p : loop) low = low.cwiseMin(p - from.at), high = high.cwiseMax(p - from.at);
    const Image& picture = *from.picture;
    const double most = 1.0 + std::max(picture.width, picture.height);
    const auto pixel = [&](double x) { return static_cast<int>(std::floor(std::clamp(x, -most, most))); };
    const double around = part.feather + kGap;
    const int x = pixel(low.x() - around), y = pixel(low.y() - around);
    return PixelBox{x, y, pixel(high.x() + around) + 1 - x, pixel(high.y() + around) + 1 - y}.within(
        picture.width, picture.height);
}

/// How much of each pixel of a box a cut takes.
std::vector<float> sharesIn(const PicturePart& part, const Vec<2>& at, const PixelBox& box) {
    std::vector<float> shares;
    shares.reserve(static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            shares.push_back(cutOver(part, at + Vec<2>(x + 0.5, y + 0.5)));
    return shares;
}

Image emptyLike(const Image& image, const PixelBox& box) {
    Image piece{box.width,          box.height, image.channels, image.type, image.alpha,
                image.unassociated, {},         image.metadata};
    piece.makePixels();
    return piece;
}

Image pieceOf(const Image& image, const PixelBox& box) {
    Image piece = emptyLike(image, box);
    for (int y = 0; y < box.height; ++y)
        std::memcpy(piece.row(y), image.row(box.y + y) + image.pixelBytes() * static_cast<std::size_t>(box.x),
                    piece.rowBytes());
    return piece;
}

void place(const Image& piece, const PixelBox& box, Image& image) {
    for (int y = 0; y < box.height; ++y)
        std::memcpy(image.row(box.y + y) + image.pixelBytes() * static_cast<std::size_t>(box.x), piece.row(y),
                    piece.rowBytes());
}

Image withShares(const Image& piece, const std::vector<float>& shares) {
    return faded(piece, [&](int y, std::vector<float>& factors) {
        const auto begin = shares.begin() + static_cast<std::ptrdiff_t>(y) * piece.width;
        std::copy_n(begin, factors.size(), factors.begin());
    });
}

/// The cut is left transparent.
CutPictures cutOpen(const Sheet& from, const PixelBox& box, std::vector<float> shares) {
    const Image piece = pieceOf(*from.picture, box);
    CutPictures pictures;
    pictures.taken.picture = std::make_shared<const Image>(withShares(piece, shares));
    for (float& share : shares) share = share < 1 ? 1 : 0;
    const Image hollow = withShares(piece, shares);
    Image left = converted(*from.picture, layoutOf(hollow));
    place(hollow, box, left);
    pictures.left = std::make_shared<const Image>(std::move(left));
    return pictures;
}

/// The ground of a box: the picture without what the cut takes.
Image groundIn(const Image& picture, const PixelBox& box, const std::vector<float>& shares,
               const std::stop_token& stop) {
    PixelLayout floats = layoutOf(picture);
    floats.type = PixelType::Float, floats.unassociated = false;
    const PixelBox around = surroundings(box, picture.width, picture.height);
    std::vector<bool> hole(static_cast<std::size_t>(around.width) * static_cast<std::size_t>(around.height));
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto width = static_cast<std::size_t>(box.width);
        const auto x = static_cast<int>(i % width) + box.x - around.x,
                   y = static_cast<int>(i / width) + box.y - around.y;
        hole[static_cast<std::size_t>(y) * static_cast<std::size_t>(around.width) +
             static_cast<std::size_t>(x)] = shares[i] > 0;
    }
    const Image filled = inpainted(converted(pieceOf(picture, around), floats), hole, stop);
    return pieceOf(filled, {box.x - around.x, box.y - around.y, box.width, box.height});
}

CutPictures cutFilled(const Sheet& from, const PixelBox& box, const std::vector<float>& shares,
                      const std::stop_token& stop) {
    const Image& picture = *from.picture;
    PixelLayout layout = layoutOf(picture);
    if (!layout.alpha) layout.alpha = layout.unassociated = true, ++layout.channels;
    PixelLayout floats = layout;
    floats.type = PixelType::Float, floats.unassociated = false;
    const Matte matte = separated(converted(pieceOf(picture, box), floats),
                                  converted(groundIn(picture, box, shares, stop), floats), shares);
    CutPictures pictures;
    pictures.taken.picture = std::make_shared<const Image>(converted(matte.top, layout));
    Image left = picture;
    place(converted(matte.ground, layoutOf(picture)), box, left);
    pictures.left = std::make_shared<const Image>(std::move(left));
    return pictures;
}

}  // namespace

CutPictures cutOut(const PicturePart& part, const Sheet& from, std::vector<Message>* notices,
                   const std::stop_token& stop) {
    const PixelBox box = boxOf(part, from);
    if (box.width == 0 || box.height == 0) throw InputError("the cut is outside of \"" + part.cutFrom + '"');
    const std::vector<float> shares = sharesIn(part, from.at, box);
    const bool fills = part.fill && canInpaint();
    if (part.fill && !fills && notices)
        notices->push_back("the ground behind \"" + part.name +
                           "\" is not filled: the program gmic is not installed");
    CutPictures pictures = fills ? cutFilled(from, box, shares, stop) : cutOpen(from, box, shares);
    pictures.taken.at = from.at + Vec<2>(box.x, box.y);
    return pictures;
}

}  // namespace wend
