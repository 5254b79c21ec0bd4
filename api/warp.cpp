#include "wend/warp.h"

#include "api/boundary.h"
#include "core/base/error.h"
#include "core/meshing/planar_mesher.h"
#include "warp/image.h"
#include "warp/outline.h"
#include "warp/warp.h"

namespace wend {
namespace {

PixelType typeOf(Depth depth) {
    switch (depth) {
        case Depth::UInt16:
            return PixelType::UInt16;
        case Depth::Half:
            return PixelType::Half;
        case Depth::Float:
            return PixelType::Float;
        case Depth::UInt8:
            break;
    }
    return PixelType::UInt8;
}

Depth depthOf(PixelType type) {
    switch (type) {
        case PixelType::UInt16:
            return Depth::UInt16;
        case PixelType::Half:
            return Depth::Half;
        case PixelType::Float:
            return Depth::Float;
        case PixelType::UInt8:
            break;
    }
    return Depth::UInt8;
}

Filter filterOf(Lookup lookup) {
    switch (lookup) {
        case Lookup::Nearest:
            return Filter::Nearest;
        case Lookup::Bilinear:
            return Filter::Bilinear;
        case Lookup::Bicubic:
            return Filter::Bicubic;
        case Lookup::Ewa:
            break;
    }
    return Filter::Ewa;
}

Outside outsideOf(Beyond beyond) {
    switch (beyond) {
        case Beyond::Clamp:
            return Outside::Clamp;
        case Beyond::Source:
            return Outside::Original;
        case Beyond::Transparent:
            break;
    }
    return Outside::Transparent;
}

Image imageOf(const Picture& picture) {
    if (picture.width <= 0 || picture.height <= 0)
        throw InputError("a picture of " + std::to_string(picture.width) + " × " +
                         std::to_string(picture.height) + " pixels");
    if (picture.channels < 1 || picture.channels > 4)
        throw InputError("a picture of " + std::to_string(picture.channels) + " channels");
    Image image;
    image.width = picture.width;
    image.height = picture.height;
    image.channels = picture.channels;
    image.type = typeOf(picture.depth);
    image.alpha = picture.hasAlpha();
    image.unassociated = image.alpha && !picture.premultiplied;
    if (picture.pixels.size() != image.rowBytes() * static_cast<std::size_t>(image.height))
        throw InputError("the picture has " + std::to_string(picture.pixels.size()) +
                         " bytes, and its size, channels and depth are those of " +
                         std::to_string(image.rowBytes() * static_cast<std::size_t>(image.height)));
    image.data = picture.pixels;
    image.metadata = std::static_pointer_cast<const Image::Metadata>(picture.metadata);
    return image;
}

Picture pictureOf(Image image) {
    return {image.width,
            image.height,
            image.channels,
            depthOf(image.type),
            !image.unassociated && image.alpha,
            std::move(image.data),
            image.metadata};
}

View viewOf(const Picture& source, const PictureWarp& options) {
    if (options.width == 0) return {source.width, source.height};
    if (options.width < 0 || options.height <= 0 || 1e-6 * options.width * options.height > kMaxMegapixels)
        throw InputError("a part of " + std::to_string(options.width) + " × " +
                         std::to_string(options.height) + " pixels");
    return {options.width, options.height, vecOf<2>(options.origin)};
}

}  // namespace

Picture loadPicture(const std::string& path) {
    return documented([&] { return pictureOf(readImage(path)); });
}

void savePicture(const std::string& path, const Picture& picture) {
    documented([&] { writeImage(path, imageOf(picture)); });
}

Picture warpPicture(const Picture& source, const Mesh<2>& rest, std::span<const Coordinates<2>> pose,
                    const PictureWarp& given) {
    return documented([&] {
        const SimplicialMesh<2> mesh = meshOf<2>(rest.points, rest.cells);
        requireValid<2>(mesh);
        if (pose.size() != rest.points.size())
            throw InputError("a pose of " + std::to_string(pose.size()) + " vertices for a mesh of " +
                             std::to_string(rest.points.size()));
        WarpOptions options;
        options.filter = filterOf(given.lookup);
        options.outside = outsideOf(given.beyond);
        options.antialias = given.antialias;
        options.threads = given.threads;
        options.stop = given.stop;
        Image warped = warpImage(imageOf(source), mesh, columnsOf<2>(pose), viewOf(source, given), options);
        if (given.stop.stop_requested()) throw Cancelled();
        return pictureOf(std::move(warped));
    });
}

Mesh<2> meshPicture(const Picture& picture, const PictureMeshing& given) {
    return documented([&] {
        AlphaOutlineOptions alpha;
        alpha.threshold = given.threshold;
        alpha.margin = given.margin;
        PlanarMeshOptions options;
        options.vertices = given.mesh.vertices;
        options.edge = given.mesh.edge;
        options.minAngle = given.mesh.minAngle;
        options.points = vecsOf<2>(given.mesh.points);
        options.stop = given.mesh.stop;
        if (given.fromAlpha) options.simplify = std::max(0.0, alpha.margin - alpha.simplify);
        const Outline outline = given.fromAlpha ? outlineFromAlpha(imageOf(picture), alpha)
                                                : frameOutline(picture.width, picture.height);
        return meshOf<2>(meshOutline(outline, options));
    });
}

}  // namespace wend
