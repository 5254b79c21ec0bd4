#include "warp/layered_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/zip_archive.h"
#include "warp/blend_mode.h"
#include "warp/byte_numbers.h"
#include "warp/krita_layer.h"

namespace wend {
namespace {

/// The places where a format keeps the properties of its layers.
struct Description {
    const char* file;
    const char* blend;
    const char* visible;
    const char* shown;  // the value of a visible layer
    double opaque;
};
constexpr Description kOpenRaster{"stack.xml", "composite-op", "visibility", "visible", 1};
constexpr Description kKrita{"maindoc.xml", "compositeop", "visible", "1", 255};

std::string blendOf(const pugi::xml_node& node, const Description& description) {
    const std::string blend = node.attribute(description.blend).as_string("normal");
    return blend.substr(blend.find(':') + 1);  // "svg:multiply" by OpenRaster
}

/// Returns whether a layer or group leaves the alpha of what is below it in its group.
bool isAtop(const pugi::xml_node& node, const Description& description) {
    if (&description == &kOpenRaster) return blendOf(node, description) == "src-atop";
    const std::string_view flags = node.attribute("channelflags").value();
    return !flags.empty() && flags.back() == '0';
}

/// Marks a layer that is atop of those below it in its group. If that is one layer or group, it clips this
/// one.
template <class Layer>
void takeAtop(const pugi::xml_node& node, const Description& description, Layer& layer) {
    if (!isAtop(node, description) || !node.next_sibling()) return;
    int whole = 0;
    for (pugi::xml_node below = node.next_sibling(); below; below = below.next_sibling())
        whole += isAtop(below, description) && below.next_sibling() ? 0 : 1;
    layer.atop = true;
    layer.clipped = whole == 1;
    if (layer.blend == "src-atop") layer.blend = "normal";
}

bool isVisible(const pugi::xml_node& node, const Description& description) {
    return std::string_view(node.attribute(description.visible).as_string(description.shown)) ==
           description.shown;
}

double writtenOpacity(const pugi::xml_node& node, const Description& description) {
    return node.attribute("opacity").as_double(description.opaque) / description.opaque;
}

/// Returns the opacity within 0 … 1, and 1 for one that is not a number.
double opacityOf(const pugi::xml_node& node, const Description& description) {
    const double opacity = writtenOpacity(node, description);
    return std::isnan(opacity) ? 1 : std::clamp(opacity, 0.0, 1.0);
}

/// Returns whether a group is combined before it is put over what is below: in Krita unless it passes
/// through; in OpenRaster if it says so, or has an opacity or a mode.
bool isIsolated(const pugi::xml_node& node, const Description& description) {
    if (&description == &kKrita) return !node.attribute("passthrough").as_bool(false);
    const std::string_view isolation = node.attribute("isolation").as_string("auto");
    return isolation != "auto" || opacityOf(node, description) < 1 ||
           !isPlainBlend(blendOf(node, description));
}

/// Returns whether the node is a group. In OpenRaster the whole picture is a stack, too, but no group.
bool isGroup(const pugi::xml_node& node) {
    const std::string_view kind = node.name();
    return (kind == "stack" && std::string_view(node.parent().name()) == "stack") ||
           (kind == "layer" && node.attribute("nodetype").value() == std::string_view("grouplayer"));
}

LayerGroup groupOf(const pugi::xml_node& node, const Description& description) {
    LayerGroup group;
    group.id = static_cast<int>(node.offset_debug());
    group.name = node.attribute("name").value();
    group.blend = blendOf(node, description);
    group.opacity = opacityOf(node, description);
    group.visible = isVisible(node, description);
    takeAtop(node, description, group);
    group.isolated = isIsolated(node, description);
    return group;
}

PictureLayer layerOf(const pugi::xml_node& node, const Description& description) {
    PictureLayer layer;
    layer.name = node.attribute("name").value();
    layer.x = node.attribute("x").as_int();
    layer.y = node.attribute("y").as_int();
    layer.blend = blendOf(node, description);
    takeAtop(node, description, layer);
    layer.visible = isVisible(node, description);
    layer.opacity = layer.ownOpacity = opacityOf(node, description);
    for (pugi::xml_node at = node.parent(); at; at = at.parent()) {
        if (!isGroup(at)) continue;
        const LayerGroup group = groupOf(at, description);
        layer.visible = layer.visible && group.visible;
        layer.opacity *= group.opacity;
        layer.groups.insert(layer.groups.begin(), group);
    }
    return layer;
}

/// Takes the size from the header of the layer's PNG file.
void takeSize(const std::optional<std::string>& png, PictureLayer& layer) {
    constexpr std::size_t kHeader = 24, kWidth = 16, kHeight = 20;
    if (!png || png->size() < kHeader || !png->starts_with("\x89PNG")) return;
    layer.width = static_cast<int>(bigEndian(*png, kWidth));
    layer.height = static_cast<int>(bigEndian(*png, kHeight));
}

/// The layers of a description, without groups, and where their pictures are in the archive.
struct LayerList {
    std::vector<PictureLayer> layers;
    std::vector<Message> notices;
    std::vector<std::string> files;  // of OpenRaster
    std::vector<KritaLayer> kritas;
};

LayerList layersOf(const ZipArchive& zip, PictureFormat format) {
    const bool isKrita = format == PictureFormat::Krita;
    const Description& description = isKrita ? kKrita : kOpenRaster;
    const auto text = zip.file(description.file);
    pugi::xml_document document;
    if (!text || !document.load_buffer(text->data(), text->size()))
        zip.fail({sentence("Core", "has a damaged %1"), description.file});
    LayerList list;
    for (const auto& found : document.select_nodes("//layer[not(@nodetype='grouplayer')]")) {
        PictureLayer layer = layerOf(found.node(), description);
        list.files.emplace_back(found.node().attribute("src").value());
        if (!list.files.back().empty()) takeSize(zip.file(list.files.back(), 24), layer);
        if (isKrita) list.kritas.push_back(kritaLayerOf(zip, found.node(), layer));
        list.layers.push_back(std::move(layer));
    }
    for (const auto& found : document.select_nodes("//*[@opacity]"))
        if (writtenOpacity(found.node(), description) != opacityOf(found.node(), description))
            list.notices.emplace_back(
                sentence("Core",
                         "has a layer \"%1\" with an opacity out of range: it is limited to 0 … 100 %"),
                found.node().attribute("name").value());
    std::vector<std::string*> names;
    for (PictureLayer& layer : list.layers) names.push_back(&layer.name);
    giveOwnNames(names);
    return list;
}

}  // namespace

LayeredFile readLayeredFile(const std::string& path, PictureFormat format) {
    const ZipArchive zip(path);
    auto merged = zip.file("mergedimage.png");
    if (!merged)
        zip.fail({sentence("Core", "holds no picture of all its layers (%1): save it with one"),
                  "mergedimage.png"});
    LayerList list = layersOf(zip, format);
    return {std::move(*merged), std::move(list.layers), std::move(list.notices)};
}

bool isPlainBlend(const std::string& mode) {
    return mode == "pass-through" || blendNamed(mode) == BlendMode::Normal;
}

std::string readLayerPicture(const std::string& path, PictureFormat format, const std::string& name) try {
    const ZipArchive zip(path);
    const LayerList list = layersOf(zip, format);
    const std::size_t place = layerNamed(list.layers, name);
    if (!list.layers[place].unread.empty())
        throw InputError("its layer \"" + name + "\" " + list.layers[place].unread + " and cannot be read");
    if (format == PictureFormat::Krita) return kritaLayerPicture(zip, list.kritas[place]);
    auto picture = zip.file(list.files[place]);
    if (!picture) throw InputError("holds no picture of its layer \"" + name + '"');
    return std::move(*picture);
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
