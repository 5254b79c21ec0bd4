#include "warp/krita_layer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "warp/krita_pixels.h"
#include "warp/png_bytes.h"

namespace wend {
namespace {

using namespace std::string_view_literals;

/// The kinds of colours that are read. Those of three channels are stored blue first, numbers of 16 bits with
/// the least significant byte first.
struct KritaColours {
    std::string_view name;
    int colours, bits;
};
constexpr std::array kColours{KritaColours{"RGBA", 3, 8}, KritaColours{"RGBA16", 3, 16},
                              KritaColours{"GRAYA", 1, 8}, KritaColours{"GRAYA16", 1, 16}};

constexpr std::array kOtherLayers{
    std::pair{"shapelayer"sv, "a vector layer"},   std::pair{"adjustmentlayer"sv, "a filter layer"},
    std::pair{"generatorlayer"sv, "a fill layer"}, std::pair{"clonelayer"sv, "a clone layer"},
    std::pair{"filelayer"sv, "a layer of a file"}, std::pair{"referenceimages"sv, "a reference picture"},
    std::pair{"colorizemask"sv, "a colorize mask"}};
constexpr std::array kOtherMasks{std::pair{"filtermask"sv, "its filter mask"},
                                 std::pair{"transformmask"sv, "its transform mask"},
                                 std::pair{"colorizemask"sv, "its colorize mask"}};

const KritaColours* coloursOf(std::string_view name) {
    const auto found = std::ranges::find(kColours, name, &KritaColours::name);
    return found != kColours.end() ? &*found : nullptr;
}

template <std::size_t N>
std::string wordOf(const std::array<std::pair<std::string_view, const char*>, N>& words,
                   std::string_view name) {
    for (const auto& [key, word] : words)
        if (key == name) return word;
    return {};
}

pugi::xml_node pictureOf(pugi::xml_node node) {
    while (node && node.name() != "IMAGE"sv) node = node.parent();
    return node;
}

int placeIn(const pugi::xml_node& node, const char* axis) {
    constexpr int kFarthestLayer = 100'000'000;
    return std::clamp(node.attribute(axis).as_int(), -kFarthestLayer, kFarthestLayer);
}

std::string fileOf(const pugi::xml_node& node) {
    return std::string(pictureOf(node).attribute("name").value()) + "/layers/" +
           node.attribute("filename").value();
}

KritaPixels pixelsOf(const ZipArchive& zip, const std::string& name) try {
    auto bytes = zip.file(name);
    if (!bytes) throw InputError("has no " + name);
    return {std::move(*bytes), zip.file(name + ".defaultpixel").value_or("")};
} catch (const InputError& error) {
    zip.fail(error.reason());
}

/// Returns the box of all that is not transparent: that of the tiles, or of the picture if the rest is not.
PixelBox boxOf(const KritaPixels& pixels, const KritaColours& colours, const pugi::xml_node& node) {
    const std::string_view alpha =
        std::string_view(pixels.other())
            .substr(pixels.pixelBytes() - static_cast<std::size_t>(colours.bits / 8));
    PixelBox box = pixels.box();
    box.x += placeIn(node, "x"), box.y += placeIn(node, "y");
    if (alpha.find_first_not_of('\0') == std::string_view::npos) return box;
    const pugi::xml_node picture = pictureOf(node);
    return {0, 0, picture.attribute("width").as_int(), picture.attribute("height").as_int()};
}

void takeMasks(const pugi::xml_node& node, KritaLayer& kritas, PictureLayer& layer) {
    for (const pugi::xml_node& mask : node.child("masks").children("mask")) {
        if (!mask.attribute("visible").as_bool(true)) continue;
        const std::string_view kind = mask.attribute("nodetype").value();
        if (kind == "transparencymask")
            kritas.masks.push_back(
                {fileOf(mask) + ".pixelselection", placeIn(mask, "x"), placeIn(mask, "y")});
        else if (std::string word = wordOf(kOtherMasks, kind); !word.empty())
            layer.leftOut.push_back(std::move(word));
    }
}

std::string whyNotRead(const pugi::xml_node& node) {
    const std::string_view kind = node.attribute("nodetype").as_string("paintlayer");
    if (kind != "paintlayer") {
        const std::string word = wordOf(kOtherLayers, kind);
        return "is " + (word.empty() ? "of the kind " + std::string(kind) : word);
    }
    const std::string colours = node.attribute("colorspacename").value();
    if (!coloursOf(colours))
        return "has colours of the kind " + colours + ", not RGB or grey of 8 or 16 bits";
    return {};
}

/// Multiplies the alpha of rows with a mask of 8 bits, before the bytes are sorted as PNG has them.
void multiply(PngPixels& picture, const std::string& mask) {
    const std::size_t bytes = static_cast<std::size_t>(picture.bits / 8), pixel = picture.pixelBytes();
    const unsigned full = bytes == 1 ? 255 : 65535;
    for (std::size_t p = 0; p < mask.size(); ++p) {
        unsigned value = 0;
        char* const alpha = picture.rows.data() + (p + 1) * pixel - bytes;
        for (std::size_t k = bytes; k-- > 0;) value = value << 8U | static_cast<unsigned char>(alpha[k]);
        const auto factor = static_cast<unsigned>(static_cast<unsigned char>(mask[p]));
        value = std::min(full, (value * factor + 127) / 255);
        for (std::size_t k = 0; k < bytes; ++k) alpha[k] = static_cast<char>(value >> (8U * k) & 0xffU);
    }
}

/// Red first, and the most significant bytes first.
void sortAsPng(PngPixels& picture) {
    const auto bytes = static_cast<std::size_t>(picture.bits / 8);
    for (std::size_t at = 0; at < picture.rows.size(); at += picture.pixelBytes()) {
        char* const pixel = picture.rows.data() + at;
        if (picture.colours == 3) std::swap_ranges(pixel, pixel + bytes, pixel + 2 * bytes);
        for (std::size_t k = 0; bytes == 2 && k < picture.pixelBytes(); k += 2)
            std::swap(pixel[k], pixel[k + 1]);
    }
}

}  // namespace

KritaLayer kritaLayerOf(const ZipArchive& zip, const pugi::xml_node& node, PictureLayer& layer) {
    KritaLayer kritas;
    layer.unread = whyNotRead(node);
    if (!layer.unread.empty()) return kritas;
    kritas.file = fileOf(node);
    kritas.colours = node.attribute("colorspacename").value();
    kritas.x = placeIn(node, "x"), kritas.y = placeIn(node, "y");
    takeMasks(node, kritas, layer);
    const KritaColours& colours = *coloursOf(kritas.colours);
    const KritaPixels pixels = pixelsOf(zip, kritas.file);
    if (pixels.pixelBytes() != static_cast<std::size_t>(colours.bits / 8 * (colours.colours + 1)))
        zip.fail({sentence("Core", "has a damaged %1"), kritas.file});
    kritas.box = boxOf(pixels, colours, node);
    layer.x = kritas.box.x, layer.y = kritas.box.y;
    layer.width = kritas.box.width, layer.height = kritas.box.height;
    if (1e-6 * layer.width * layer.height > kMaxMegapixels)
        layer.unread = "extends over more than 400 million pixels";
    return kritas;
}

std::string kritaLayerPicture(const ZipArchive& zip, const KritaLayer& layer) try {
    const KritaColours& colours = *coloursOf(layer.colours);
    const auto rowsAt = [&](const KritaPixels& pixels, int x, int y) {
        return pixels.rows({layer.box.x - x, layer.box.y - y, layer.box.width, layer.box.height});
    };
    PngPixels picture{layer.box.width, layer.box.height, colours.bits, colours.colours, true, {}};
    picture.rows = rowsAt(pixelsOf(zip, layer.file), layer.x, layer.y);
    for (const KritaLayer::Mask& mask : layer.masks) {
        const KritaPixels pixels = pixelsOf(zip, mask.file);
        if (pixels.pixelBytes() != 1) zip.fail({sentence("Core", "has a damaged %1"), mask.file});
        multiply(picture, rowsAt(pixels, mask.x, mask.y));
    }
    sortAsPng(picture);
    return pngBytes(picture, zip.file(layer.file + ".icc").value_or(""));
} catch (const InputError& error) {
    zip.fail(error.reason());
}

}  // namespace wend
