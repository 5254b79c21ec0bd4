#include "warp/image.h"

#include "warp/image_metadata.h"

namespace wend {
namespace {

std::size_t sampleBytes(PixelType type) {
    switch (type) {
        case PixelType::UInt8:
            return 1;
        case PixelType::UInt16:
        case PixelType::Half:
            return 2;
        case PixelType::Float:
            return 4;
    }
    return 0;
}

}  // namespace

std::size_t Image::pixelBytes() const {
    return sampleBytes(type) * static_cast<std::size_t>(channels);
}

std::vector<std::byte> Image::iccProfile() const {
    const OIIO::ParamValue* profile = metadata ? metadata->spec.find_attribute("ICCProfile") : nullptr;
    if (!profile) return {};
    const std::byte* bytes = static_cast<const std::byte*>(profile->data());
    return {bytes, bytes + profile->datasize()};
}

}  // namespace wend
