#include "app/output/svg_export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "app/output/layer_export.h"
#include "app/output/run.h"
#include "app/project/domain.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "core/mesh/used_vertices.h"
#include "warp/convert.h"
#include "warp/drawn_picture.h"
#include "warp/layered_file.h"
#include "warp/picture_metadata.h"
#include "warp/picture_process.h"
#include "warp/png_bytes.h"
#include "warp/warp.h"

namespace wend {
namespace {

PlacedPng placedPng(const Image& picture, const Vec2& at) {
    const Image image = converted(picture, {PixelType::UInt8, 4, true, true});
    PngPixels pixels{image.width, image.height, 8, 3, true, {}};
    pixels.rows.assign(reinterpret_cast<const char*>(image.data.data()), image.data.size());
    return {pngBytes(pixels, {}), at, image.width, image.height};
}

/// Returns the view with pixels of the plane.
View unscaled(View view) {
    view.width = static_cast<int>(std::ceil(view.width * view.scale));
    view.height = static_cast<int>(std::ceil(view.height * view.scale));
    view.scale = 1;
    return view;
}

/// Carries a picture by the cells that have some of it.
PlacedPng warpedPicture(const Image& picture, const Vec2& at, const SimplicialMesh<2>& rest,
                        const Points2& pixels, const View& view, WarpOptions options) {
    SimplicialMesh<2> mesh{rest.points.colwise() - at, {}};
    std::vector<float> depths;
    for (std::size_t c = 0; c < rest.cells.size(); ++c) {
        const Extent<2> extent = extentOf<2>(mesh.points, {rest.cells[c]});
        const bool isBeside =
            extent.high.minCoeff() < 0 || extent.low.x() > picture.width || extent.low.y() > picture.height;
        if (isBeside) continue;
        mesh.cells.push_back(rest.cells[c]);
        if (!options.depth.empty()) depths.push_back(options.depth[c]);
    }
    options.depth = std::move(depths);
    const PixelBox box = mesh.cells.empty() ? PixelBox{0, 0, 1, 1} : visibleBox(view, pixels, mesh.cells);
    View own = view;
    own.origin += Vec2(box.x, box.y);
    own.width = std::max(1, box.width), own.height = std::max(1, box.height);
    if (mesh.cells.empty()) return {{}, own.origin, 0, 0};
    const Image warped = warpImage(picture, mesh, pixels, own, options);
    if (warped.data.empty()) throw Cancelled();
    return placedPng(warped, own.origin);
}

WarpOptions plain(WarpOptions options) {
    options.blends.clear();
    options.restMargin = 0;
    options.outside = Outside::Transparent;
    options.frameWidth = options.frameHeight = 0;
    return options;
}

std::string colourText(const std::array<float, 4>& colour) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (std::size_t c = 0; c < 3; ++c) {
        const auto value = static_cast<unsigned>(std::lround(255 * std::clamp(colour[c], 0.0F, 1.0F)));
        text += kDigits[value >> 4U], text += kDigits[value & 15U];
    }
    return text;
}

/// Returns a length of a document times a factor, in its own unit; none if it has none or is relative.
std::string scaledLength(const std::string& length, double factor) {
    NumberScanner scanner(length);
    double value = 0;
    if (!scanner.number(value) || scanner.skip('%')) return {};
    return numberText(value * factor) + std::string(scanner.word());
}

/// Returns the parts from back to front.
std::vector<std::size_t> backToFront(const std::vector<int>& levels) {
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t k) { return levels[k]; });
    return order;
}

}  // namespace

bool isSvgFile(const std::string& path) {
    return lowerExtension(path) == ".svg";
}

bool hasDrawing(const Domain& domain, const std::string& folder) {
    return !drawingIn(domain, folder).empty();
}

void requireDrawing(const std::string& path, const Project& project, const std::string& folder,
                    const RunOptions& options) {
    if (!isSvgFile(path)) return;
    if (!hasDrawing(domainOf(project), folder))
        throw InputError(path,
                         sentence("Core",
                                  "the project's picture is no SVG drawing: it has no paths that could be "
                                  "written"));
    if (options.outside == Outside::Clamp || options.outside == Outside::Original)
        throw InputError(path, "--outside clamp and original are for pictures of pixels");
}

SvgExport::SvgExport(const Project& project, std::string folder, std::function<void(const Message&)> notice)
    : m_domain(domainOf(project)), m_folder(std::move(folder)), m_notice(std::move(notice)) {}

void SvgExport::tell(const Message& text) {
    if (std::ranges::find(m_warned, text.text()) != m_warned.end()) return;
    m_warned.push_back(text);
    if (m_notice) m_notice(text);
}

const VectorDrawing& SvgExport::drawingOf(const std::string& file, const std::string& layer) {
    const std::string path = pathIn(m_folder, file);
    const auto [found, isNew] = m_drawings.try_emplace({path, layer});
    if (!isNew) return found->second;
    const bool isSized = m_domain.kind == DomainKind::Image;
    found->second = readVectors(path, layer, isSized ? m_domain.size : DrawnSize{});
    for (const Message& notice : found->second.notices) tell(path + ": " + notice);
    return found->second;
}

/// Returns the drawing of a part; none if it is one of pixels: also what is cut out of a drawing, and what
/// that leaves.
const VectorDrawing* SvgExport::drawingOf(const PicturePart& part) {
    const bool isCut =
        std::ranges::find(m_domain.parts, part.name, &PicturePart::cutFrom) != m_domain.parts.end();
    if (isCut || !part.cutFrom.empty()) {
        tell({sentence("Core", "the part \"%1\" is cut: it becomes a picture in the SVG file"), part.name});
        return nullptr;
    }
    if (isDrawing(pathIn(m_folder, part.path))) return &drawingOf(part.path, part.layer);
    tell({sentence("Core", "the part \"%1\" is no SVG drawing: it becomes a picture in the SVG file"),
          part.name});
    return nullptr;
}

/// Returns the drawing whose coordinates the file has.
const VectorDrawing& SvgExport::mainDrawing() {
    if (m_domain.kind != DomainKind::Image) return drawingOf(m_domain.texture, {});
    if (m_domain.parts.empty()) return drawingOf(m_domain.path, {});
    for (const PicturePart& part : m_domain.parts)
        if (part.cutFrom.empty() && isDrawing(pathIn(m_folder, part.path)))
            return drawingOf(part.path, part.layer);
    throw InputError("the project has no SVG drawing");
}

/// Returns how far a part is from its place in its file.
Vec2 SvgExport::shiftOf(const PicturePart& part) {
    if (!part.at) return {0, 0};
    if (part.layer.empty()) return *part.at;
    const Image header = readImageHeader(pathIn(m_folder, part.path), m_domain.size);
    const std::vector<PictureLayer>& layers = fileMetadata(header)->layers;
    const PictureLayer& layer = layers[layerNamed(layers, part.layer)];
    return *part.at - Vec2(layer.x, layer.y);
}

SvgPage SvgExport::pageOf(const Shape<2>& shape, const View& view, const WarpOptions& options) {
    const VectorDrawing& drawing = mainDrawing();
    SvgPage page;
    const Vec2 unit(drawing.viewBox[2] / drawing.width, drawing.viewBox[3] / drawing.height);
    page.fromPixels = {Mat2(unit.asDiagonal()), Vec2(drawing.viewBox[0], drawing.viewBox[1])};
    if (options.outside == Outside::Colour) page.outside = colourText(options.colour);
    const auto [width, height] = canvasSize(shape);
    const bool isOwn = view.scale == 1 && view.origin.isZero() && view.width == width &&
                       view.height == height && drawing.width == width && drawing.height == height;
    if (isOwn) {
        page.viewBox = drawing.viewBox;
        page.width = drawing.ownWidth, page.height = drawing.ownHeight;
        return page;
    }
    const Vec2 size = view.scale * Vec2(view.width, view.height);
    const Vec2 from = page.fromPixels(view.origin), extent = page.fromPixels.A * size;
    page.viewBox = {from.x(), from.y(), extent.x(), extent.y()};
    page.width = scaledLength(drawing.ownWidth, size.x() / drawing.width);
    page.height = scaledLength(drawing.ownHeight, size.y() / drawing.height);
    if (view.scale != 1) page.width = std::to_string(view.width), page.height = std::to_string(view.height);
    return page;
}

std::string SvgExport::text(const Shape<2>& shape, const Points2& pixels, const std::vector<int>& levels,
                            const View& view, const WarpOptions& options) {
    SvgFile file(pageOf(shape, view, options));
    const WarpOptions own = plain(options);
    const auto add = [&](const SvgGroup& group, const VectorDrawing& drawing, const Vec2& shift,
                         const SimplicialMesh<2>& rest, const WarpOptions& ofRest) {
        if (options.stop.stop_requested()) throw Cancelled();
        const PlaneMap map(rest, pixels);
        file.add(group, drawing, shift, map, [&](const Image& picture, const Vec2& at) {
            return warpedPicture(picture, at, rest, pixels, unscaled(view), ofRest);
        });
    };
    if (levels.empty()) {
        add({}, mainDrawing(), {0, 0}, restInPixels(shape), own);
        return file.text();
    }
    for (const std::size_t k : backToFront(levels)) {
        const MeshPart& meshPart = shape.texture->drawn->parts[k];
        const Sheet& sheet = shape.texture->sheets[k];
        const PicturePart& part = *std::ranges::find(m_domain.parts, meshPart.name, &PicturePart::name);
        const SvgGroup group{part.name, sheet.opacity, sheet.hidden, sheet.blend};
        if (const VectorDrawing* drawing = drawingOf(part)) {
            const SimplicialMesh<2> rest{shape.texture->drawn->points,
                                         partCells(*shape.texture->drawn, meshPart)};
            WarpOptions ofPart = own;
            ofPart.depth = partDepths(own.depth, meshPart);
            add(group, *drawing, shiftOf(part), rest, ofPart);
        } else {
            const View whole = unscaled(view);
            const LayerToWrite layer = warpedPart(*shape.texture, k, pixels, whole, options);
            file.add(group, placedPng(layer.picture, whole.origin + Vec2(layer.x, layer.y)));
        }
    }
    return file.text();
}

}  // namespace wend
