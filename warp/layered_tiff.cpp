#include "warp/layered_tiff.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "warp/convert.h"
#include "warp/layered_file.h"
#include "warp/picture_library.h"
#include "warp/tiff_names.h"
#include "warp/tiff_pages.h"

namespace wend {
namespace {

constexpr int kPageRows = 64;
constexpr std::size_t kLongestName = 999;  // bytes

/// Returns the names of pages: all different, and not cut within a letter.
std::vector<std::string> pageNames(const std::vector<LayerToWrite>& layers) {
    std::vector<std::string> names;
    for (const LayerToWrite& layer : layers) {
        std::string& name = names.emplace_back(layer.name);
        if (name.size() <= kLongestName) continue;
        const auto isWithin = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
        std::size_t end = kLongestName;
        while (end > 0 && isWithin(name[end])) --end;
        name.resize(end);
    }
    std::vector<std::string*> all;
    for (std::string& name : names) all.push_back(&name);
    giveOwnNames(all);
    return names;
}

/// Returns a layer in the layout of its page, on the whole canvas if that is given.
Image pageOf(const LayerToWrite& layer, const PixelLayout& layout, const Image* canvas) {
    PixelLayout own = layout;
    own.unassociated = layer.picture.unassociated;
    Image picture = converted(layer.picture, own);
    picture.place = {layer.x, layer.y, 0, 0};
    if (!canvas) return picture;
    Image whole = picture;
    whole.width = canvas->width, whole.height = canvas->height;
    whole.place = {};
    whole.makePixels();
    const int left = std::max(0, layer.x), right = std::min(whole.width, layer.x + picture.width);
    for (int y = 0; y < picture.height && left < right; ++y) {
        const int to = y + layer.y;
        if (to < 0 || to >= whole.height) continue;
        const auto at = [&](int x) { return picture.pixelBytes() * static_cast<std::size_t>(x); };
        std::memcpy(whole.row(to) + at(left), picture.row(y) + at(left - layer.x), at(right - left));
    }
    return whole;
}

void writePage(const std::string& path, const std::string& temporary, const Image& picture, int page) {
    Image header = picture;
    header.data = {};
    PictureToWrite writing{PictureFormat::Tiff, path, temporary, header, {}};
    writing.page = page;
    writing.strips = [&](const TakeRows& take) {
        for (int top = 0; top < picture.height; top += kPageRows) {
            Image strip = header;
            strip.height = std::min(kPageRows, picture.height - top);
            strip.makePixels();
            std::copy_n(picture.row(top), strip.data.size(), strip.data.data());
            if (!take(top, strip)) return false;
        }
        return true;
    };
    pictureLibrary(path).write(writing);
}

/// Returns whether the file has these layers, as this program reads them.
bool isReadAgain(const std::string& file, const std::vector<std::string>& names,
                 const std::vector<LayerToWrite>& layers) {
    if (layers.size() < 2) return true;
    const InputFile input(file);
    const auto found = tiffLayers(input).layers;
    if (found.size() != layers.size()) return false;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t from = layers.size() - 1 - k;
        const bool isBack = k == 0;
        if (found[k].name != names[from] || found[k].x != (isBack ? 0 : layers[from].x) ||
            found[k].y != (isBack ? 0 : layers[from].y))
            return false;
    }
    return true;
}

std::string quoted(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "\"" : ", \"") + name + '"';
    return all;
}

}  // namespace

void writeLayeredTiff(const std::string& path, const Image& merged, const std::vector<LayerToWrite>& layers,
                      std::optional<PixelType> type) {
    const bool isGrey =
        std::ranges::all_of(layers, [](const LayerToWrite& layer) { return layer.picture.colours() == 1; });
    const PixelLayout layout{type.value_or(merged.type), isGrey ? 2 : 4, true, false};
    const std::vector<std::string> names = pageNames(layers);
    writeWhole(path, [&](const std::string& temporary) {
        const std::size_t back = layers.size() - 1;
        for (std::size_t k = 0; k <= back; ++k)
            writePage(path, temporary, pageOf(layers[back - k], layout, k == 0 ? &merged : nullptr),
                      static_cast<int>(k));
        nameTiffPages(temporary, {names.rbegin(), names.rend()});
        if (!isReadAgain(temporary, names, layers))
            throw InputError(path, "cannot be written: has other layers when it is read again");
    });
}

Message lostInLayeredTiff(const std::vector<LayerToWrite>& layers) {
    std::vector<std::string> looks, renamed;
    const std::vector<std::string> names = pageNames(layers);
    for (std::size_t k = 0; k < layers.size(); ++k) {
        const LayerToWrite& layer = layers[k];
        if (layer.opacity != 1 || !layer.visible || layer.blend != BlendMode::Normal)
            looks.push_back(layer.name);
        if (names[k] != layer.name) renamed.push_back(names[k]);
    }
    const Message lost(sentence("Core",
                                "layers of a TIFF have no opacity, visibility and blend mode: those "
                                "of %1 are left out"),
                       quoted(looks));
    const Message other(sentence("Core", "layers of a TIFF need names of their own: %1"), quoted(renamed));
    if (looks.empty()) return renamed.empty() ? Message() : other;
    return renamed.empty() ? lost : lost + "; " + other;
}

}  // namespace wend
