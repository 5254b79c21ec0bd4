#include "warp/colour_space.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace wend {
namespace {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

const Vector kD50(0.9642, 1.0, 0.8249);

/// Returns X, Y = 1 and Z of a chromaticity.
Vector tristimulus(double x, double y) {
    return {x / y, 1, (1 - x - y) / y};
}

/// Returns Bradford's adaptation of a white to D50.
Matrix adaptationFrom(const Vector& white) {
    Matrix cones;
    cones << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
    const Vector scale = (cones * kD50).cwiseQuotient(cones * white);
    return cones.inverse() * scale.asDiagonal() * cones;
}

/// Returns red, green and blue of full light as columns, in X, Y, Z under the white of the space.
Matrix colorantsOf(const ColourSpace::Chromaticities& xy) {
    Matrix colours;
    for (int k = 0; k < 3; ++k)
        colours.col(k) =
            tristimulus(xy[2 * static_cast<std::size_t>(k)], xy[2 * static_cast<std::size_t>(k) + 1]);
    const Vector amounts = colours.inverse() * tristimulus(xy[6], xy[7]);
    return colours * amounts.asDiagonal();
}

/// Returns the light of SMPTE ST 2084, full light being 10,000 cd/m².
double pqLight(double value) {
    constexpr double m1 = 0.1593017578125, m2 = 78.84375, c1 = 0.8359375, c2 = 18.8515625, c3 = 18.6875;
    const double root = std::pow(value, 1 / m2);
    return std::pow(std::max(root - c1, 0.0) / (c2 - c3 * root), 1 / m1);
}

/// Returns the inverse OETF of BT.2100's hybrid log-gamma.
double hlgLight(double value) {
    constexpr double a = 0.17883277, b = 1 - 4 * a;
    const double c = 0.5 - a * std::log(4 * a);
    return value <= 0.5 ? value * value / 3 : (std::exp((value - c) / a) + b) / 12;
}

/// Bytes in the order of ICC: most significant first.
class Bytes {
  public:
    void number(std::uint64_t value, int bytes) {
        for (int k = bytes - 1; k >= 0; --k) m_text += static_cast<char>(value >> 8 * k & 0xff);
    }
    void text(std::string_view text) { m_text += text; }
    /// Appends an s15Fixed16Number.
    void fixed(double value) {
        number(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536))), 4);
    }
    const std::string& bytes() const { return m_text; }

  private:
    std::string m_text;
};

std::string textTag(const std::string& text) {
    Bytes tag;
    tag.text(std::string_view("mluc\0\0\0\0", 8));
    tag.number(1, 4), tag.number(12, 4), tag.text("enUS");
    tag.number(2 * text.size(), 4), tag.number(28, 4);
    for (const char c : text) tag.number(static_cast<unsigned char>(c), 2);
    return tag.bytes();
}

std::string xyzTag(const Vector& xyz) {
    Bytes tag;
    tag.text(std::string_view("XYZ \0\0\0\0", 8));
    for (const double value : xyz) tag.fixed(value);
    return tag.bytes();
}

std::string matrixTag(const Matrix& matrix) {
    Bytes tag;
    tag.text(std::string_view("sf32\0\0\0\0", 8));
    for (int k = 0; k < 9; ++k) tag.fixed(matrix(k / 3, k % 3));
    return tag.bytes();
}

/// Function 0: value^g; function 3: (a value + b)^g from d on, c value below.
std::string parametricTag(int function, std::initializer_list<double> parameters) {
    Bytes tag;
    tag.text(std::string_view("para\0\0\0\0", 8));
    tag.number(static_cast<std::uint64_t>(function), 2), tag.number(0, 2);
    for (const double value : parameters) tag.fixed(value);
    return tag.bytes();
}

std::string sampledTag(double (*light)(double)) {
    constexpr int kCount = 4096;
    Bytes tag;
    tag.text(std::string_view("curv\0\0\0\0", 8));
    tag.number(kCount, 4);
    for (int k = 0; k < kCount; ++k)
        tag.number(
            static_cast<std::uint64_t>(std::lround(65535 * std::clamp(light(k / (kCount - 1.0)), 0.0, 1.0))),
            2);
    return tag.bytes();
}

std::string curveTag(const ColourSpace& space) {
    switch (space.curve) {
        case ColourSpace::Curve::Srgb:
            return parametricTag(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
        case ColourSpace::Curve::Bt709:
            return parametricTag(3, {1 / 0.45, 1 / 1.099, 0.099 / 1.099, 1 / 4.5, 0.081});
        case ColourSpace::Curve::Pq:
            return sampledTag(pqLight);
        case ColourSpace::Curve::Hlg:
            return sampledTag(hlgLight);
        case ColourSpace::Curve::Power:
            break;
    }
    return parametricTag(0, {space.gamma});
}

struct Tag {
    std::string_view name;
    std::string data;
};

std::vector<Tag> tagsOf(const ColourSpace& space, const std::string& curve, bool grey) {
    std::vector<Tag> tags{{"desc", textTag(space.name.empty() ? "colours of the file" : space.name)},
                          {"cprt", textTag("no copyright")},
                          {"wtpt", xyzTag(kD50)}};
    if (grey) {
        tags.push_back({"kTRC", curve});
        return tags;
    }
    const Matrix adaptation = adaptationFrom(tristimulus(space.chromaticities[6], space.chromaticities[7]));
    const Matrix colorants = adaptation * colorantsOf(space.chromaticities);
    tags.push_back({"chad", matrixTag(adaptation)});
    constexpr std::array<std::string_view, 3> xyz{"rXYZ", "gXYZ", "bXYZ"}, trc{"rTRC", "gTRC", "bTRC"};
    for (std::size_t k = 0; k < 3; ++k) {
        tags.push_back({xyz[k], xyzTag(colorants.col(static_cast<int>(k)))});
        tags.push_back({trc[k], curve});
    }
    return tags;
}

std::string profileHeader(std::size_t size, bool grey) {
    Bytes header;
    header.number(size, 4), header.number(0, 4), header.number(0x04300000, 4);
    header.text("mntr"), header.text(grey ? "GRAY" : "RGB "), header.text("XYZ ");
    for (const int part : {2024, 1, 1, 0, 0, 0}) header.number(static_cast<std::uint64_t>(part), 2);
    header.text("acsp");
    for (int k = 0; k < 7; ++k) header.number(0, 4);  // platform … rendering intent
    for (const double value : kD50) header.fixed(value);
    header.text(std::string(48, '\0'));
    return header.bytes();
}

/// Returns the header, the table of tags, and their data; equal data are stored once.
std::string profileOf(std::vector<Tag> tags, bool grey) {
    Bytes table;
    std::string data;
    table.number(tags.size(), 4);
    const std::size_t begin = 128 + 4 + 12 * tags.size();
    for (Tag& tag : tags) {
        const std::size_t length = tag.data.size();
        tag.data.resize((length + 3) / 4 * 4);
        std::size_t at = data.find(tag.data);
        while (at != std::string::npos && at % 4 != 0) at = data.find(tag.data, at + 1);
        if (at == std::string::npos) at = data.size(), data += tag.data;
        table.text(tag.name), table.number(begin + at, 4), table.number(length, 4);
    }
    return profileHeader(begin + data.size(), grey) + table.bytes() + data;
}

/// ACES' blue has a negative y; a white must have light.
bool spansColours(const ColourSpace::Chromaticities& xy) {
    for (std::size_t k = 0; k < 8; k += 2)
        if (!(std::abs(xy[k]) <= 2 && std::abs(xy[k + 1]) <= 2 && std::abs(xy[k + 1]) > 1e-6)) return false;
    const Matrix colorants = colorantsOf(xy);
    return xy[7] > 0 && colorants.allFinite() && colorants.cwiseAbs().maxCoeff() < 100 &&
           std::abs(colorants.determinant()) > 1e-9;
}

std::vector<std::byte> asBytes(const std::string& text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

}  // namespace

bool ColourSpace::hasCommonColours() const {
    return std::equal(chromaticities.begin(), chromaticities.end(), kBt709.begin(),
                      [](double a, double b) { return std::abs(a - b) < 2e-3; });
}

std::vector<std::byte> iccProfileOf(const ColourSpace& space, bool grey) {
    if (!grey && !spansColours(space.chromaticities)) return {};
    return asBytes(profileOf(tagsOf(space, curveTag(space), grey), grey));
}

std::vector<std::byte> colouredProfileOf(std::string_view curve) {
    ColourSpace space;
    space.name = "grey curve";
    return asBytes(profileOf(tagsOf(space, std::string(curve), false), false));
}

}  // namespace wend
