#include "warp/openimageio/icc_profile.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "warp/byte_numbers.h"
#include "warp/colour_space.h"

namespace wend {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHeader = 128, kTag = 12;  // in bytes

std::string_view bytesOf(const OIIO::ParamValue& profile) {
    return {static_cast<const char*>(profile.data()), static_cast<std::size_t>(profile.datasize())};
}

bool tagsAreInside(std::string_view bytes) {
    const std::size_t count = bigEndian(bytes, kHeader);
    if (count > (bytes.size() - kHeader - 4) / kTag) return false;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t at = kHeader + 4 + k * kTag, begin = bigEndian(bytes, at + 4),
                          size = bigEndian(bytes, at + 8);
        if (begin % 4 != 0 || begin > bytes.size() || size > bytes.size() - begin) return false;
    }
    return true;
}

}  // namespace

bool profileFits(const OIIO::ParamValue& profile, int colours) {
    const std::string_view bytes = bytesOf(profile);
    return bytes.size() >= kHeader + 4 && bigEndian(bytes, 0) == bytes.size() &&
           bytes.substr(36, 4) == "acsp" && bytes.substr(16, 4) == (colours < 3 ? "GRAY" : "RGB ");
}

std::vector<std::byte> colouredProfile(const OIIO::ParamValue& grey) {
    const std::string_view bytes = bytesOf(grey);
    if (!profileFits(grey, 1) || !tagsAreInside(bytes)) return {};
    for (std::size_t k = 0; k < bigEndian(bytes, kHeader); ++k) {
        const std::size_t at = kHeader + 4 + k * kTag;
        if (bytes.substr(at, 4) == "kTRC")
            return colouredProfileOf(bytes.substr(bigEndian(bytes, at + 4), bigEndian(bytes, at + 8)));
    }
    return {};
}

bool profileIsStrict(const OIIO::ParamValue& profile) {
    constexpr std::array kKinds{"scnr"sv, "mntr"sv, "prtr"sv, "spac"sv};
    constexpr auto kD50 = "\0\0\xf6\xd6\0\1\0\0\0\0\xd3\x2d"sv;
    const std::string_view bytes = bytesOf(profile), space = bytes.substr(20, 4);
    const bool isVersion4 = bigEndian(bytes, 8, 1) > 3;
    return (!isVersion4 || bytes.size() % 4 == 0) && bigEndian(bytes, 64) < 4 &&
           bytes.substr(68, 12) == kD50 && std::ranges::find(kKinds, bytes.substr(12, 4)) != kKinds.end() &&
           (space == "XYZ " || space == "Lab ") && tagsAreInside(bytes);
}

}  // namespace wend
