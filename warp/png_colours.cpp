#include "warp/png_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "warp/byte_numbers.h"

namespace wend {
namespace {

struct CodedColours {
    unsigned code;
    const char* name;
    ColourSpace::Chromaticities chromaticities;
};

/// ITU-T H.273, table 2.
constexpr std::array kPrimaries{
    CodedColours{1, "BT.709", ColourSpace::kBt709},
    CodedColours{4, "BT.470 System M", {0.67, 0.33, 0.21, 0.71, 0.14, 0.08, 0.310, 0.316}},
    CodedColours{5, "BT.470 System B, G", {0.64, 0.33, 0.29, 0.60, 0.15, 0.06, 0.3127, 0.3290}},
    CodedColours{6, "BT.601", {0.630, 0.340, 0.310, 0.595, 0.155, 0.070, 0.3127, 0.3290}},
    CodedColours{7, "SMPTE 240M", {0.630, 0.340, 0.310, 0.595, 0.155, 0.070, 0.3127, 0.3290}},
    CodedColours{8, "film", {0.681, 0.319, 0.243, 0.692, 0.145, 0.049, 0.310, 0.316}},
    CodedColours{9, "BT.2020", {0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290}},
    CodedColours{11, "DCI-P3", {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.314, 0.351}},
    CodedColours{12, "Display P3", {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290}},
    CodedColours{22, "EBU 3213", {0.630, 0.340, 0.295, 0.605, 0.155, 0.077, 0.3127, 0.3290}}};

struct CodedCurve {
    unsigned code;
    const char* name;
    ColourSpace::Curve curve;
    double gamma = 1;
};

/// ITU-T H.273, table 3.
constexpr std::array kCurves{CodedCurve{1, "BT.709 curve", ColourSpace::Curve::Bt709},
                             CodedCurve{4, "gamma 2.2", ColourSpace::Curve::Power, 2.2},
                             CodedCurve{5, "gamma 2.8", ColourSpace::Curve::Power, 2.8},
                             CodedCurve{6, "BT.601 curve", ColourSpace::Curve::Bt709},
                             CodedCurve{8, "linear", ColourSpace::Curve::Power, 1},
                             CodedCurve{13, "sRGB curve", ColourSpace::Curve::Srgb},
                             CodedCurve{14, "BT.2020 curve", ColourSpace::Curve::Bt709},
                             CodedCurve{15, "BT.2020 curve", ColourSpace::Curve::Bt709},
                             CodedCurve{16, "PQ", ColourSpace::Curve::Pq},
                             CodedCurve{17, "gamma 2.6", ColourSpace::Curve::Power, 2.6},
                             CodedCurve{18, "HLG", ColourSpace::Curve::Hlg}};

template <typename Table>
auto coded(const Table& table, unsigned code) {
    return std::ranges::find_if(table, [code](const auto& entry) { return entry.code == code; });
}

/// The chunks before the pixels that speak of colours, by their names.
struct Chunks {
    std::string cicp, chrm, gama, actl;
    bool hasProfile = false, isSrgb = false;
};

void take(Chunks& chunks, const std::string& name, std::string data) {
    if (name == "cICP" && data.size() == 4) chunks.cicp = std::move(data);
    if (name == "cHRM" && data.size() == 32) chunks.chrm = std::move(data);
    if (name == "gAMA" && data.size() == 4) chunks.gama = std::move(data);
    if (name == "acTL" && data.size() == 8) chunks.actl = std::move(data);
    chunks.hasProfile = chunks.hasProfile || name == "iCCP";
    chunks.isSrgb = chunks.isSrgb || name == "sRGB";
}

Chunks chunksOf(const InputFile& file) {
    constexpr std::uint64_t kAround = 12, kLongest = 32;
    Chunks chunks;
    for (std::uint64_t at = 8; at + kAround <= file.size();) {
        const std::string head = file.bytes(at, 8), name = head.substr(4);
        const std::uint64_t length = bigEndian(head);
        if (name == "IDAT" || name == "IEND") break;
        take(chunks, name, length <= kLongest ? file.bytes(at + 8, length) : std::string());
        at += kAround + length;
    }
    return chunks;
}

std::optional<ColourSpace> spaceOfCodes(const std::string& cicp) {
    const auto byte = [&](std::size_t k) { return bigEndian(cicp, k, 1); };
    const auto primaries = coded(kPrimaries, byte(0));
    const auto curve = coded(kCurves, byte(1));
    const bool isFullRgb = byte(2) == 0 && byte(3) == 1;
    if (primaries == kPrimaries.end() || curve == kCurves.end() || !isFullRgb) return std::nullopt;
    return ColourSpace{primaries->chromaticities, curve->curve, curve->gamma,
                       std::string(primaries->name) + ", " + curve->name};
}

std::optional<ColourSpace> spaceOfNumbers(const Chunks& chunks) {
    constexpr double kUnit = 1e-5, kCommonGamma = 2.2;
    ColourSpace space;
    if (!chunks.chrm.empty()) {
        const auto value = [&](std::size_t k) { return kUnit * bigEndian(chunks.chrm, 4 * k); };
        for (std::size_t k = 0; k < 6; ++k) space.chromaticities[k] = value(k + 2);
        space.chromaticities[6] = value(0), space.chromaticities[7] = value(1);
    }
    const std::uint32_t gamma = chunks.gama.empty() ? 0 : bigEndian(chunks.gama);
    if (gamma > 0) space.curve = ColourSpace::Curve::Power, space.gamma = 1 / (kUnit * gamma);
    const bool isCommon = gamma == 0 || std::abs(space.gamma - kCommonGamma) < 0.01;
    if (isCommon && space.hasCommonColours()) return std::nullopt;
    return space;
}

bool isPlain(const ColourSpace& space) {
    return space.curve == ColourSpace::Curve::Srgb && space.hasCommonColours();
}

}  // namespace

PngExtras pngExtras(const InputFile& file) {
    const Chunks chunks = chunksOf(file);
    PngExtras extras;
    if (!chunks.actl.empty()) extras.frames = std::max(1U, bigEndian(chunks.actl));
    if (!chunks.cicp.empty()) {
        extras.colours = spaceOfCodes(chunks.cicp);
        if (extras.colours) {
            if (isPlain(*extras.colours)) extras.colours.reset();
            return extras;
        }
        for (std::size_t k = 0; k < 4; ++k)
            extras.unknownColours += (k > 0 ? "-" : "") + std::to_string(bigEndian(chunks.cicp, k, 1));
    }
    extras.hasProfile = chunks.hasProfile;
    if (!chunks.hasProfile && !chunks.isSrgb) extras.colours = spaceOfNumbers(chunks);
    return extras;
}

}  // namespace wend
