#include "tests/fuzz/picture_samples.h"

#include <OpenImageIO/imageio.h>
#include <zlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace fs = std::filesystem;

namespace wend::fuzz {
namespace {

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

using Set = std::function<void(OIIO::ImageSpec&)>;

/// A gradient with something of noise, written by OpenImageIO.
void add(std::vector<Sample>& samples, const fs::path& folder, const std::string& name, int channels,
         OIIO::TypeDesc type, const Set& set = {}) {
    OIIO::ImageSpec spec(23, 17, channels, type);
    spec.attribute("ImageDescription", "a small picture");
    if (set) set(spec);
    std::vector<float> pixels(static_cast<std::size_t>(23 * 17 * channels));
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i * i % 251) / 251;
    const fs::path path = folder / name;
    const auto output = OIIO::ImageOutput::create(path.string());
    const bool written = output && output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
    if (!written) {
        std::fprintf(stderr, "%s cannot be made: %s\n", name.c_str(), OIIO::geterror().c_str());
        std::exit(3);
    }
    samples.push_back({name, contents(path)});
}

// --- Put together by hand ---

/// Encodes with the least significant byte first.
std::string little(std::uint32_t value, unsigned size) {
    std::string bytes;
    for (unsigned k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * k);
    return bytes;
}
std::string big(std::uint32_t value) {
    const std::string bytes = little(value, 4);
    return {bytes.rbegin(), bytes.rend()};
}

constexpr unsigned kSide = 8;  // in pixels

/// Two colours and a square of their numbers, packed as four packets that repeat and four that do not.
std::string tgaWithPalette(bool packed) {
    std::string bytes("\0\1\1\0\0\2\0\x18\0\0\0\0\x8\0\x8\0\x08\0", 18);
    if (packed) bytes[2] = 9;
    bytes += "abcdef";
    for (unsigned y = 0; y < kSide; ++y)
        bytes += !packed     ? std::string("\0\1\0\1\0\1\0\1", 8)
                 : y % 2 > 0 ? std::string("\x87\1", 2)
                             : std::string("\7\0\1\0\1\0\1\0\1", 9);
    return bytes;
}

/// `compression` 0: none; 1, 2: runs of 8 or 4 bits.
std::string bmp(unsigned bits, unsigned compression, unsigned colours) {
    std::string palette, rows;
    for (unsigned k = 0; k < colours; ++k) palette += little(k * 0x30507, 4);
    for (unsigned y = 0; y < kSide; ++y) {
        if (compression > 0)  // a run, and as many that are not one
            rows += (compression == 1 ? std::string("\4\1\0\4\1\2\1\2", 8)
                                      : std::string("\4\x12\0\4\x12\x21", 6)) +
                    (y + 1 < kSide ? std::string(2, '\0') : std::string("\0\1", 2));
        else
            rows +=
                std::string((kSide * bits + 31) / 32 * 4, static_cast<char>(colours == 3 ? y % 3 : y * 9));
    }
    const auto offset = static_cast<std::uint32_t>(54 + palette.size());
    const auto size = static_cast<std::uint32_t>(rows.size());
    return "BM" + little(offset + size, 4) + little(0, 4) + little(offset, 4) + little(40, 4) +
           little(kSide, 4) + little(kSide, 4) + little(1, 2) + little(bits, 2) + little(compression, 4) +
           little(size, 4) + little(2835, 4) + little(2835, 4) + little(colours, 4) + little(0, 4) + palette +
           rows;
}

std::string pngWithPalette(unsigned bits) {
    const auto chunk = [](const std::string& name, const std::string& data) {
        const std::string all = name + data;
        const auto sum = crc32(0, reinterpret_cast<const Bytef*>(all.data()), static_cast<uInt>(all.size()));
        return big(static_cast<std::uint32_t>(data.size())) + all + big(static_cast<std::uint32_t>(sum));
    };
    std::string colours, rows;
    for (unsigned k = 0; k < 3U << bits; ++k) colours += static_cast<char>(k * 7);
    for (unsigned y = 0; y < kSide; ++y)
        rows += std::string(1, static_cast<char>(y % 5)) +
                std::string(kSide * bits / 8, static_cast<char>(y * 5));
    std::string packed(compressBound(rows.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
             rows.size());
    packed.resize(size);
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big(kSide) + big(kSide) + static_cast<char>(bits) + std::string("\3\0\0\0", 4)) +
           chunk("PLTE", colours) + chunk("tRNS", std::string("\0\x80", 2)) + chunk("IDAT", packed) +
           chunk("IEND", "");
}

/// One strip; `photometric` 0: of grey values, 3: with a palette.
std::string tiff(unsigned bits, unsigned photometric) {
    const std::string pixels(kSide * kSide * bits / 8, '\x21');
    std::string colours;
    if (photometric == 3)
        for (unsigned k = 0; k < 3U << bits; ++k) colours += little(k * 700, 2);
    const std::uint32_t count = photometric == 3 ? 10 : 9, after = 8 + 2 + 12 * count + 4,
                        atPixels = after + static_cast<std::uint32_t>(colours.size());
    const auto entry = [](unsigned tag, unsigned type, std::uint32_t number, std::uint32_t value) {
        return little(tag, 2) + little(type, 2) + little(number, 4) + little(value, 4);
    };
    std::string bytes = "II*" + std::string(1, '\0') + little(8, 4) + little(count, 2) +
                        entry(256, 3, 1, kSide) + entry(257, 3, 1, kSide) + entry(258, 3, 1, bits) +
                        entry(259, 3, 1, 1) + entry(262, 3, 1, photometric) + entry(273, 4, 1, atPixels) +
                        entry(277, 3, 1, 1) + entry(278, 3, 1, kSide) +
                        entry(279, 4, 1, static_cast<std::uint32_t>(pixels.size()));
    if (photometric == 3) bytes += entry(320, 3, 3U << bits, after);
    return bytes + little(0, 4) + colours + pixels;
}

/// Returns a drawing with shapes of every kind in groups, with gradients, a clip path, a mask, a reference
/// and text.
std::string drawing() {
    return R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="40mm" height="30mm" viewBox="0 0 80 60">
<style>.thin { stroke: #123; stroke-width: .5px }</style>
<defs><linearGradient id="g" x1="0" x2="1" gradientTransform="rotate(20)"><stop offset="0" stop-color="red"/>
<stop offset="100%" stop-color="#00f8" stop-opacity=".5"/></linearGradient>
<radialGradient id="r" cx="40" cy="30" r="20" fx="35" gradientUnits="userSpaceOnUse" xlink:href="#g"/>
<clipPath id="c"><circle cx="20" cy="20" r="15"/></clipPath>
<filter id="f"><feGaussianBlur stdDeviation="2 1"/></filter><g id="u"><rect width="9" height="4" clip-path="url(#c)"/></g>
<g id="v"><use href="#u"/><path d="M1 1h9v5z" filter="url(#f)"/></g>
<mask id="m"><rect width="80" height="60" fill="white" opacity=".4" filter="url(#f)"/></mask></defs>
<g id="body" opacity=".8" clip-path="url(#c)"><path fill="url(#g)" d="M10 10h20v-5l3,3 C40 20 50-1e1 60,40 S 70 50 20 50 Q1 2 3 4 T 9 9 A 8 5 30 1 0 12 30 z m5 5 l2-2"/></g>
<g id="arm" transform="translate(3 4) scale(1.5) matrix(1 .1 0 1 0 0)" mask="url(#m)"><rect x="5" y="5" width="9" height="7" rx="2" style="fill:url(#r);stroke:black"/>
<ellipse cx="30" cy="20" rx="9" ry="4" class="thin"/><polyline points="1,1 5 9 7,3" fill="none" stroke-dasharray="3 1" stroke-linejoin="round"/></g>
<use xlink:href="#arm" x="4"/><use href="#v" y="20"/><text x="10" y="50" font-size="8">words</text><line x2="9" y2="9" stroke="hsl(120, 50%, 50%)"/></svg>
)svg";
}

/// Adds the metadata that a camera and an archive write: EXIF with its parts, IPTC, XMP and an ICC profile.
void describe(OIIO::ImageSpec& spec) {
    spec.attribute("Make", "a camera");
    spec.attribute("Orientation", 6);
    spec.attribute("DateTime", "2020:01:02 03:04:05");
    spec.attribute("Exif:FNumber", 2.8F);
    spec.attribute("Exif:ExposureTime", 0.01F);
    spec.attribute("Exif:UserComment", "by hand");
    spec.attribute("Exif:LensSpecification", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 4),
                   std::array{24.0F, 70.0F, 2.8F, 4.0F}.data());
    spec.attribute("GPS:LatitudeRef", "N");
    spec.attribute("GPS:Latitude", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 3),
                   std::array{48.0F, 8.0F, 14.0F}.data());
    spec.attribute("IPTC:City", "a town");
    spec.attribute("Keywords", "one; two");
    std::string profile(132, '\0');
    profile.replace(0, 4, big(132)).replace(12, 12, "mntrRGB XYZ ").replace(36, 4, "acsp");
    profile.replace(68, 12,
                    big(0xf6d6) + big(0x10000) + big(0xd32d));  // the light that they are all for, D50
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
}

}  // namespace

std::vector<Sample> makeSamples(const fs::path& folder) {
    using T = OIIO::TypeDesc;
    std::vector<Sample> samples;
    const auto packed = [](const char* how) {
        return [how](OIIO::ImageSpec& spec) { spec.attribute("compression", how); };
    };
    const auto tiled = [](OIIO::ImageSpec& spec) { spec.tile_width = spec.tile_height = 16; };
    for (int channels = 1; channels <= 4; ++channels) {
        const std::string n = std::to_string(channels);
        add(samples, folder, "8-" + n + ".png", channels, T::UINT8);
        add(samples, folder, "16-" + n + ".png", channels, T::UINT16);
        add(samples, folder, "f-" + n + ".tif", channels, T::FLOAT);
    }
    for (const char* how : {"none", "lzw", "zip", "packbits"})
        add(samples, folder, std::string("c-") + how + ".tif", 3, T::UINT8, packed(how));
    add(samples, folder, "tiled.tif", 3, T::UINT16, tiled);
    for (const char* how : {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "b44a", "dwaa"})
        add(samples, folder, std::string("c-") + how + ".exr", 4, T::HALF, packed(how));
    add(samples, folder, "float.exr", 3, T::FLOAT);
    add(samples, folder, "tiled.exr", 3, T::HALF, tiled);
    for (int channels : {1, 3})
        add(samples, folder, "p-" + std::to_string(channels) + ".jpg", channels, T::UINT8);
    add(samples, folder, "progressive.jpg", 3, T::UINT8,
        [](OIIO::ImageSpec& spec) { spec.attribute("jpeg:progressive", 1); });
    for (int channels : {3, 4})
        add(samples, folder, "w-" + std::to_string(channels) + ".webp", channels, T::UINT8);
    for (const char* extension : {"jpg", "tif", "png", "webp", "exr", "hdr"})
        add(samples, folder, std::string("described.") + extension, 3, T::UINT8, describe);
    add(samples, folder, "a.hdr", 3, T::FLOAT);
    for (int channels : {1, 3, 4})
        add(samples, folder, "b-" + std::to_string(channels) + ".bmp", channels, T::UINT8);
    for (const char* how : {"none", "rle"})
        for (int channels : {1, 3, 4})
            add(samples, folder, std::string(how) + std::to_string(channels) + ".tga", channels, T::UINT8,
                packed(how));
    for (int binary : {0, 1})
        for (int channels : {1, 3})
            add(samples, folder, std::to_string(binary) + std::to_string(channels) + ".ppm", channels,
                T::UINT8, [binary](OIIO::ImageSpec& spec) { spec.attribute("pnm:binary", binary); });
    for (const bool isPacked : {false, true})
        samples.push_back({isPacked ? "packed-palette.tga" : "palette.tga", tgaWithPalette(isPacked)});
    for (const unsigned bits : {1U, 4U, 8U})
        samples.push_back({"palette-" + std::to_string(bits) + ".bmp", bmp(bits, 0, 1U << bits)});
    samples.push_back({"short-palette.bmp", bmp(8, 0, 3)});
    samples.push_back({"packed-8.bmp", bmp(8, 1, 256)});
    samples.push_back({"packed-4.bmp", bmp(4, 2, 16)});
    samples.push_back({"five-bits.bmp", bmp(16, 0, 0)});
    for (const unsigned bits : {1U, 2U, 4U, 8U})
        samples.push_back({"palette-" + std::to_string(bits) + ".png", pngWithPalette(bits)});
    for (const unsigned bits : {4U, 8U})
        samples.push_back({"palette-" + std::to_string(bits) + ".tif", tiff(bits, 3)});
    samples.push_back({"bits.tif", tiff(1, 0)});
    samples.push_back({"grey.pfm", "Pf\n4 2\n-1.0\n" + std::string(32, '?')});
    samples.push_back({"bits.pbm", "P1\n4 2\n0 1 0 1\n1 0 1 0\n"});
    samples.push_back({"drawing.svg", drawing()});
    const fs::path pictures = WEND_SOURCE_DIR "/tests/data/pictures";
    for (const char* name : {"layers.ora", "layers.psd", "layers16.psd", "layers.psb", "layers.tif"})
        samples.push_back({name, contents(pictures / name)});
    samples.push_back({"layers.kra", contents(pictures / "layers.kra"),
                       ": its layer \"words\" is a vector layer and cannot be read"});
    return samples;
}

}  // namespace wend::fuzz
