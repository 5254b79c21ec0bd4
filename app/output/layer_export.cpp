#include "app/output/layer_export.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/safe_file.h"
#include "core/mesh/used_vertices.h"
#include "warp/layered_exr.h"
#include "warp/photoshop_file.h"
#include "warp/warp.h"

namespace wend {

PixelBox visibleBox(const View& view, const Points2& pixels, const std::vector<Cell<2>>& cells) {
    const Extent<2> extent = extentOf<2>(pixels, cells);
    const Vec2 low = ((extent.low - view.origin) / view.scale).array().floor() - 1;
    const Vec2 high = ((extent.high - view.origin) / view.scale).array().ceil() + 1;
    const auto inside = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    PixelBox box{inside(low.x(), view.width), inside(low.y(), view.height), 0, 0};
    box.width = inside(high.x(), view.width) - box.x;
    box.height = inside(high.y(), view.height) - box.y;
    return box;
}

std::vector<Cell<2>> partCells(const SimplicialMesh<2>& mesh, const MeshPart& part) {
    return {mesh.cells.begin() + part.firstCell, mesh.cells.begin() + part.endCell};
}

std::vector<float> partDepths(const std::vector<float>& all, const MeshPart& part) {
    if (all.empty()) return {};
    return {all.begin() + part.firstCell, all.begin() + part.endCell};
}

LayerToWrite warpedPart(const Texture& texture, std::size_t k, const Points2& pixels, const View& view,
                        WarpOptions options) {
    const MeshPart& part = texture.drawn->parts[k];
    const Sheet& sheet = texture.sheets[k];
    SimplicialMesh<2> mesh{texture.drawn->points.colwise() - sheet.at, partCells(*texture.drawn, part)};
    const PixelBox box = visibleBox(view, pixels, mesh.cells);
    View own = view;
    own.origin += view.scale * Vec2(box.x, box.y);
    own.width = std::max(1, box.width), own.height = std::max(1, box.height);
    options.depth = partDepths(options.depth, part);
    options.blends.clear();
    options.restMargin = 0;
    options.outside = Outside::Transparent;
    Image picture = warpImage(*sheet.picture, mesh, pixels, own, options);
    if (picture.data.empty()) throw Cancelled();
    return {part.name, std::move(picture), box.x, box.y, sheet.opacity, !sheet.hidden, sheet.blend};
}

bool isLayeredFile(const std::string& path) {
    const std::string extension = lowerExtension(path);
    return extension == ".ora" || extension == ".psd";
}

void writeLayers(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged,
                 std::optional<PixelType> depth) {
    const std::string extension = lowerExtension(path);
    if (extension == ".exr") {
        writeLayeredExr(path, merged, layers, depth);
    } else if (extension == ".ora") {
        writeWhole(path, [&](const std::string& temporary) { writeOpenRaster(temporary, layers, merged); });
    } else {
        writePhotoshopFile(path, layers, merged, depth);
    }
}

bool getsPartChannels(const std::string& path, const Shape<2>& shape) {
    return lowerExtension(path) == ".exr" && shape.texture && shape.texture->sheets.size() > 1;
}

std::vector<LayerToWrite> stMapsOfParts(const Shape<2>& shape, const Points2& pixels, const View& view,
                                        const std::vector<float>& depth) {
    const SimplicialMesh<2>& rest = sourceRest(shape);
    const auto [width, height] = canvasSize(shape);
    std::vector<LayerToWrite> maps;
    for (const MeshPart& part : shape.texture->drawn->parts) {
        const SimplicialMesh<2> own{rest.points, partCells(rest, part)};
        maps.push_back({part.name, stMap(own, pixels, view, width, height, partDepths(depth, part))});
    }
    return maps;
}

std::vector<LayerToWrite> warpedLayers(const Shape<2>& shape, const Points2& pixels,
                                       const std::vector<int>& levels, const View& view,
                                       const WarpOptions& options) {
    std::vector<LayerToWrite> layers;
    if (levels.empty()) {
        Image picture = warpImage(*shape.picture, restInPixels(shape), pixels, view, options);
        if (picture.data.empty()) throw Cancelled();
        layers.push_back({"picture", std::move(picture)});
        return layers;
    }
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, std::greater<>(), [&](std::size_t k) { return levels[k]; });
    for (const std::size_t k : order) layers.push_back(warpedPart(*shape.texture, k, pixels, view, options));
    return layers;
}

}  // namespace wend
