#include "app/output/run_options.h"

#include "app/engine/shape/flat_shape.h"
#include "app/project/domain.h"
#include "app/project/file/rgb_text.h"

#include "core/base/error.h"
#include "core/integration/integration_options.h"
#include "warp/image_formats.h"
#include "warp/warp.h"

namespace wend {
namespace {

std::optional<PixelType> depthOf(const std::string& name) {
    static const std::map<std::string, PixelType> depths{{"8", PixelType::UInt8},
                                                         {"16", PixelType::UInt16},
                                                         {"half", PixelType::Half},
                                                         {"float", PixelType::Float}};
    const auto found = depths.find(name);
    return found == depths.end() ? std::nullopt : std::optional(found->second);
}

void takeOutside(const std::string& name, RunOptions& options) {
    static const std::map<std::string, Outside> kinds{
        {"transparent", Outside::Transparent}, {"clamp", Outside::Clamp}, {"original", Outside::Original}};
    const auto kind = kinds.find(name);
    options.outside = kind == kinds.end() ? Outside::Colour : kind->second;
    const unsigned rgb = rgbOf(name).value_or(name == "white" ? 0xffffff : 0);
    const auto channel = [rgb](int shift) { return static_cast<float>(rgb >> shift & 0xff) / 255; };
    options.colour = {channel(16), channel(8), channel(0), 1};
}

CanvasChoice canvasOf(const std::string& text) {
    CanvasChoice canvas = text == "fit" ? Canvas::Fit : Canvas::Picture;
    if (const auto part = pixelRectOf(text)) canvas.kind = Canvas::Part, canvas.part = *part;
    return canvas;
}

}  // namespace

MeshWriteOptions meshOptionsFrom(const OptionValues& values) {
    MeshWriteOptions options;
    options.encoding = values.choice<MeshWriteOptions::Encoding>("--encoding");
    options.boundary = values.has("--border");
    options.gmshVersion = values.text("--msh") == "2.2" ? 2 : 4;
    return options;
}

RunOptions runOptionsFrom(const OptionValues& values) {
    RunOptions options;
    options.outputs.count = values.integer("--count");
    options.outputs.framesPerSecond = values.number("--fps");
    options.outputs.loop = values.has("--loop");
    options.filter = values.choice<Filter>("--filter");
    options.canvas = canvasOf(values.text("--canvas"));
    options.canvas.scale = values.number("--scale") / 100;
    options.canvas.width = values.has("--width") ? values.integer("--width") : 0;
    options.depth = depthOf(values.text("--depth"));
    options.lossy = values.text("--webp") == "lossy";
    takeOutside(values.text("--outside"), options);
    options.partial = values.has("--partial");
    options.strict = values.has("--strict");
    options.fields = values.text("--fields") == "all";
    options.meshes = meshOptionsFrom(values);
    return options;
}

WarpOptions warpOptionsOf(const Project& project, const RunOptions& options) {
    WarpOptions warp;
    warp.filter = options.filter;
    warp.outside = options.outside;
    warp.colour = options.colour;
    warp.restMargin = restMarginOf(domainOf(project));
    warp.threads = integrationOf(project).threads;
    return warp;
}

void requireDepth(const std::string& path, const RunOptions& options) {
    const bool hasDepths = canWriteImage(path) || holdsType(path, PixelType::UInt8);
    if (!options.depth || path.empty() || path == "-" || !hasDepths) return;
    if (!holdsType(path, *options.depth))
        throw InputError(path, "the format does not hold pictures of this depth (--depth)");
}

void requireNothingOutside(const Project& project, const RunOptions& options) {
    if (!domainOf(project).parts.empty() &&
        (options.outside == Outside::Clamp || options.outside == Outside::Original))
        throw InputError("--outside clamp and original are for a picture that is one part");
}

}  // namespace wend
