#include "warp/openimageio/image_metadata.h"

#include <array>
#include <vector>

#include "core/meshing/array_bytes.h"

namespace wend {
namespace {

constexpr auto kString = static_cast<unsigned char>(OIIO::TypeDesc::STRING);
constexpr auto kPointer = static_cast<unsigned char>(OIIO::TypeDesc::PTR);

struct PackedType {
    unsigned char base, aggregate, semantics;
    int length, values;

    OIIO::TypeDesc type() const {
        return {static_cast<OIIO::TypeDesc::BASETYPE>(base),
                static_cast<OIIO::TypeDesc::AGGREGATE>(aggregate),
                static_cast<OIIO::TypeDesc::VECSEMANTICS>(semantics), length};
    }
};

std::array<int, 8> windowsOf(const OIIO::ImageSpec& spec) {
    return {spec.x,      spec.y,      spec.width,      spec.height,
            spec.full_x, spec.full_y, spec.full_width, spec.full_height};
}

/// Returns the bytes of a value; texts end with zero.
std::string bytesOf(const OIIO::ParamValue& value) {
    if (value.type().basetype != kString)
        return {static_cast<const char*>(value.data()), static_cast<std::size_t>(value.datasize())};
    std::string bytes;
    const auto* texts = static_cast<const OIIO::ustring*>(value.data());
    for (std::size_t k = 0; k < value.type().numelements() * static_cast<std::size_t>(value.nvalues()); ++k)
        bytes += texts[k].string() + '\0';
    return bytes;
}

void addTexts(const std::string& name, const PackedType& type, const std::string& bytes,
              OIIO::ImageSpec& spec) {
    std::vector<OIIO::ustring> texts;
    for (std::size_t at = 0, end; (end = bytes.find('\0', at)) != std::string::npos; at = end + 1)
        texts.emplace_back(bytes.substr(at, end - at));
    if (texts.size() == type.type().numelements() * static_cast<std::size_t>(type.values))
        spec.extra_attribs.add_or_replace(OIIO::ParamValue(name, type.type(), type.values, texts.data()));
}

void addValue(const std::string& name, const PackedType& type, const std::string& bytes,
              OIIO::ImageSpec& spec) {
    if (type.base == kString) return addTexts(name, type, bytes, spec);
    if (bytes.size() == type.type().size() * static_cast<std::size_t>(type.values))
        spec.extra_attribs.add_or_replace(OIIO::ParamValue(name, type.type(), type.values, bytes.data()));
}

}  // namespace

std::string packed(const OIIO::ImageSpec& spec) {
    ArrayWriter writer;
    writer.array(windowsOf(spec));
    for (const OIIO::ParamValue& value : spec.extra_attribs) {
        const OIIO::TypeDesc type = value.type();
        if (type.basetype == kPointer) continue;
        writer.array(value.name().string());
        writer.array(std::array{
            PackedType{type.basetype, type.aggregate, type.vecsemantics, type.arraylen, value.nvalues()}});
        writer.array(bytesOf(value));
    }
    return writer.take();
}

OIIO::ImageSpec unpacked(const std::string& bytes) {
    OIIO::ImageSpec spec;
    ArrayReader reader(bytes);
    std::vector<int> windows;
    if (!reader.array(windows) || windows.size() != windowsOf(spec).size()) return spec;
    spec.x = windows[0], spec.y = windows[1], spec.width = windows[2], spec.height = windows[3];
    spec.full_x = windows[4], spec.full_y = windows[5];
    spec.full_width = windows[6], spec.full_height = windows[7];
    std::string name, value;
    std::vector<PackedType> type;
    while (reader.array(name) && reader.array(type) && reader.array(value) && type.size() == 1)
        addValue(name, type[0], value, spec);
    return spec;
}

}  // namespace wend
