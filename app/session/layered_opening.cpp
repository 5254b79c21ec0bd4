#include "app/session/layered_opening.h"

#include <algorithm>

#include "app/engine/shape/part_pictures.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/printable.h"
#include "warp/layer_merging.h"
#include "warp/layered_file.h"
#include "warp/outline.h"
#include "warp/picture_format.h"
#include "warp/picture_metadata.h"

namespace wend {

namespace {

bool hasOutline(const Image& picture) {
    try {
        outlineFromAlpha(picture);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// Returns what is shown of the layers that can be read, from front to back.
std::vector<ShownLayer> layersOf(const std::string& path, const Image& picture,
                                 std::vector<Message>& notices) {
    std::vector<PictureLayer> layers =
        fromTheFront(fileMetadata(picture)->layers, pictureFormat(InputFile(path)));
    for (const PictureLayer& layer : layers)
        if (!layer.unread.empty())
            notices.push_back(path + ": the layer \"" + layer.name + "\" " + layer.unread +
                              ": it is left out");
    std::vector<ShownLayer> shown = shownLayers(layers);
    std::erase_if(shown, [](const ShownLayer& one) { return one.layer.width < 1 || one.layer.height < 1; });
    return shown;
}

/// Attaches layers without an outline to the next one below that has one; at the back they are left out.
void letSmallOnesRide(std::vector<PicturePart>& parts, const PartPictures& pictures) {
    std::string below;
    for (std::size_t i = parts.size(); i-- > 0;) {
        const Image& picture = *pictures.sheets[i].picture;
        if (!picture.alpha) parts[i].outline = PartOutline{};
        if (!picture.alpha || hasOutline(picture)) {
            below = parts[i].name;
            continue;
        }
        parts[i].outline = PartOutline{};
        parts[i].ridesOn = below;
        if (below.empty()) parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

}  // namespace

std::vector<PicturePart> partsOfLayers(const std::string& path, const Image& picture, const DrawnSize& drawn,
                                       std::vector<Message>& notices) try {
    if (fileMetadata(picture)->layers.size() < 2) return {};
    std::vector<Message> ofLayers;
    const std::vector<ShownLayer> layers = layersOf(path, picture, ofLayers);
    if (layers.size() < 2) return {};
    std::vector<PicturePart> parts;
    std::vector<std::string*> names;
    parts.reserve(layers.size());
    for (const auto& [layer, name, merges] : layers) {
        PicturePart& part = parts.emplace_back();
        part.layer = layer.name;
        part.name = name;
        names.push_back(&part.name);
        part.path = path;
        part.hidden = !layer.visible;
        const auto blend = blendNamed(layer.blend);
        if (blend && *blend != BlendMode::Normal) part.blend = blend;
    }
    giveOwnNames(names);
    letSmallOnesRide(parts, loadParts(parts, {}, {}, &ofLayers, drawn));
    if (parts.size() < 2) return {};
    notices = std::move(ofLayers);  // instead of that it was flattened
    return parts;
} catch (const InputError& error) {
    notices.push_back(messageOf(error));
    return {};
}

}  // namespace wend
