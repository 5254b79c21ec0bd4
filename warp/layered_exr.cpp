#include "warp/layered_exr.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "warp/convert.h"
#include "warp/layered_file.h"
#include "warp/picture_library.h"

namespace wend {
namespace {

constexpr int kRows = 64, kChannels = 4;

PixelType typeOf(const Image& merged, const std::optional<PixelType>& wanted) {
    if (wanted == PixelType::Half || wanted == PixelType::Float) return *wanted;
    const bool isNarrow = merged.type == PixelType::UInt8 || merged.type == PixelType::Half;
    return isNarrow ? PixelType::Half : PixelType::Float;
}

/// Returns a layer in the file's layout, with its opacity.
Image laidOut(const LayerToWrite& layer, const PixelLayout& layout) {
    Image picture = converted(layer.picture, layout);
    if (layer.opacity == 1) return picture;
    std::vector<float> row(static_cast<std::size_t>(kChannels) * static_cast<std::size_t>(picture.width));
    for (int y = 0; y < picture.height; ++y) {
        loadRow(picture, y, row.data());
        for (float& value : row) value *= static_cast<float>(layer.opacity);
        storeRow(picture, y, row.data());
    }
    return picture;
}

/// A picture among the channels of a file.
struct Channels {
    Image picture;
    int x, y;  // of its first pixel
};

/// Copies what a picture has of a strip into its channels, of which `place` is the first.
void copyInto(Image& strip, int top, const Channels& from, std::size_t place) {
    const std::size_t bytes = from.picture.pixelBytes(), all = strip.pixelBytes();
    const int begin = std::max(0, from.x), end = std::min(strip.width, from.x + from.picture.width);
    const int first = std::max(top, from.y),
              last = std::min(top + strip.height, from.y + from.picture.height);
    for (int y = first; y < last; ++y)
        for (int x = begin; x < end; ++x)
            std::memcpy(strip.row(y - top) + all * static_cast<std::size_t>(x) + bytes * place,
                        from.picture.row(y - from.y) + bytes * static_cast<std::size_t>(x - from.x), bytes);
}

/// Returns the most bytes of UTF-8 text that are whole characters and no more than `most`.
std::size_t wholeCharacters(const std::string& text, std::size_t most) {
    std::size_t size = std::min(most, text.size());
    const auto continues = [&] { return (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80; };
    while (size > 0 && size < text.size() && continues()) --size;
    return size;
}

}  // namespace

std::vector<std::string> channelNames(const std::vector<LayerToWrite>& layers) {
    std::vector<std::string> names;
    for (const LayerToWrite& layer : layers) {
        names.push_back(layer.name.substr(0, wholeCharacters(layer.name, kLongestChannelName)));
        for (char& c : names.back())
            if (c >= 0 && std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    }
    std::vector<std::string*> all;
    for (std::string& name : names) all.push_back(&name);
    giveOwnNames(all, "_");
    return names;
}

void writeLayeredExr(const std::string& path, const Image& merged, const std::vector<LayerToWrite>& layers,
                     std::optional<PixelType> type) {
    const PixelLayout layout{typeOf(merged, type), kChannels, true, false};
    std::vector<Channels> pictures{{converted(merged, layout), 0, 0}};
    for (const LayerToWrite& layer : layers) pictures.push_back({laidOut(layer, layout), layer.x, layer.y});
    Image header = merged;
    header.data = {};
    header.type = layout.type, header.alpha = true, header.unassociated = false;
    header.channels = kChannels * static_cast<int>(pictures.size());
    PictureToWrite writing{PictureFormat::Exr, path, {}, header, {}};
    writing.channelNames = {"R", "G", "B", "A"};
    for (const std::string& name : channelNames(layers))
        for (const char* channel : {".R", ".G", ".B", ".A"}) writing.channelNames.push_back(name + channel);
    writing.strips = [&](const TakeRows& take) {
        for (int top = 0; top < header.height; top += kRows) {
            Image strip = header;
            strip.height = std::min(kRows, header.height - top);
            strip.makePixels();
            for (std::size_t k = 0; k < pictures.size(); ++k) copyInto(strip, top, pictures[k], k);
            if (!take(top, strip)) return false;
        }
        return true;
    };
    writeWhole(path, [&](const std::string& temporary) {
        writing.temporary = temporary;
        pictureLibrary(path).write(writing);
    });
}

}  // namespace wend
