#include "warp/picture_protocol.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/printable.h"

namespace wend {
namespace {

PictureMessage binary(const void* bytes, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(bytes);
    return PictureMessage::binary({begin, begin + size});
}

PictureMessage messageOf(const std::vector<LayerGroup>& groups) {
    PictureMessage list = PictureMessage::array();
    for (const LayerGroup& group : groups)
        list.push_back({group.id, group.name, group.blend, group.opacity, group.visible, group.clipped,
                        group.atop, group.isolated});
    return list;
}

std::vector<LayerGroup> groupsOf(const PictureMessage& list) {
    std::vector<LayerGroup> groups;
    for (const PictureMessage& group : list)
        groups.push_back({group.at(0), group.at(1), group.at(2), group.at(3), group.at(4), group.at(5),
                          group.at(6), group.at(7)});
    return groups;
}

PictureMessage messageOf(const std::vector<PictureLayer>& layers) {
    PictureMessage list = PictureMessage::array();
    for (const PictureLayer& layer : layers)
        list.push_back({layer.name, layer.x, layer.y, layer.width, layer.height, layer.opacity, layer.blend,
                        layer.visible, layer.clipped, layer.unread, layer.leftOut, layer.ownOpacity,
                        messageOf(layer.groups), layer.atop});
    return list;
}

std::vector<PictureLayer> layersOf(const PictureMessage& list) {
    std::vector<PictureLayer> layers;
    for (const PictureMessage& layer : list)
        layers.push_back({layer.at(0), layer.at(1), layer.at(2), layer.at(3), layer.at(4), layer.at(5),
                          layer.at(6), layer.at(7), layer.at(8), layer.at(9), layer.at(10), layer.at(11),
                          groupsOf(layer.at(12)), layer.at(13)});
    return layers;
}

PictureMessage messageOf(const PictureMetadata& metadata) {
    const PixelBox& box = metadata.stored;
    return {{"profile", binary(metadata.iccProfile.data(), metadata.iccProfile.size())},
            {"isOfExr", metadata.isOfExr},
            {"stored", {box.x, box.y, box.width, box.height}},
            {"leftOut", metadata.leftOut},
            {"pictures", metadata.pictures},
            {"layers", messageOf(metadata.layers)},
            {"description", binary(metadata.description.data(), metadata.description.size())}};
}

PictureMetadata metadataOf(const PictureMessage& message) {
    PictureMetadata metadata;
    for (const std::uint8_t byte : message.at("profile").get_binary())
        metadata.iccProfile.push_back(static_cast<std::byte>(byte));
    metadata.isOfExr = message.at("isOfExr");
    const std::array<int, 4> box = message.at("stored");
    metadata.stored = {box[0], box[1], box[2], box[3]};
    metadata.leftOut = message.at("leftOut");
    metadata.pictures = message.at("pictures");
    metadata.layers = layersOf(message.at("layers"));
    const auto& description = message.at("description").get_binary();
    metadata.description.assign(description.begin(), description.end());
    return metadata;
}

PictureMessage packedLines(const std::vector<Message>& lines) {
    PictureMessage all = PictureMessage::array();
    for (const Message& line : lines) all.push_back(binaryOf(printableMessage(line)));
    return all;
}

std::vector<Message> unpackedLines(const PictureMessage& lines) {
    std::vector<Message> all;
    for (const PictureMessage& line : lines) all.push_back(textOf(line));
    return all;
}

}  // namespace

PictureMessage binaryOf(const Message& text) {
    const std::string bytes = packed(text);
    return binary(bytes.data(), bytes.size());
}

Message textOf(const PictureMessage& binary) {
    const auto& bytes = binary.get_binary();
    return unpackedMessage({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string pack(const PictureMessage& message) {
    std::string bytes;
    PictureMessage::to_cbor(message, bytes);
    return bytes;
}

PictureMessage unpackMessage(const std::string& bytes) {
    return PictureMessage::from_cbor(bytes);
}

PictureMessage messageOf(const StoredPicture& stored) {
    const Image& image = stored.image;
    return {{"size", {image.width, image.height}},
            {"channels", image.channels},
            {"type", static_cast<int>(image.type)},
            {"alpha", image.alpha},
            {"unassociated", image.unassociated},
            {"metadata", image.metadata ? messageOf(*fileMetadata(image)) : PictureMessage()},
            {"orientation", stored.orientation},
            {"notices", packedLines(stored.notices)}};
}

StoredPicture pictureOf(const PictureMessage& message) {
    StoredPicture stored;
    Image& image = stored.image;
    const std::array<int, 2> size = message.at("size");
    const int type = message.at("type");
    image.width = size[0], image.height = size[1];
    image.channels = message.at("channels");
    if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 || type < 0 ||
        type > static_cast<int>(PixelType::Float))
        throw InputError("is no picture");
    image.type = static_cast<PixelType>(type);
    image.alpha = message.at("alpha");
    image.unassociated = message.at("unassociated");
    if (const PictureMessage& metadata = message.at("metadata"); !metadata.is_null())
        image.metadata = std::make_shared<const PictureMetadata>(metadataOf(metadata));
    stored.orientation = message.at("orientation");
    stored.notices = unpackedLines(message.at("notices"));
    return stored;
}

PictureMessage messageOf(const VectorDrawing& drawing) {
    PictureMessage pictures = PictureMessage::array();
    for (const DrawnPicture& one : drawing.pictures)
        pictures.push_back(
            {one.x, one.y, one.width, one.height, binary(one.pixels.data(), one.pixels.size())});
    return {{"svg", binary(drawing.svg.data(), drawing.svg.size())},
            {"viewBox", drawing.viewBox},
            {"size", {drawing.width, drawing.height}},
            {"own", {printable(drawing.ownWidth), printable(drawing.ownHeight)}},
            {"pictures", std::move(pictures)},
            {"notices", packedLines(drawing.notices)}};
}

VectorDrawing drawingOf(const PictureMessage& message) {
    VectorDrawing drawing;
    const auto text = [](const PictureMessage& bytes) {
        return std::string(bytes.get_binary().begin(), bytes.get_binary().end());
    };
    drawing.svg = text(message.at("svg"));
    drawing.viewBox = message.at("viewBox");
    drawing.width = message.at("size").at(0), drawing.height = message.at("size").at(1);
    drawing.ownWidth = message.at("own").at(0), drawing.ownHeight = message.at("own").at(1);
    for (const PictureMessage& one : message.at("pictures"))
        drawing.pictures.push_back({one.at(0), one.at(1), one.at(2), one.at(3), text(one.at(4))});
    drawing.notices = unpackedLines(message.at("notices"));
    return drawing;
}

}  // namespace wend
