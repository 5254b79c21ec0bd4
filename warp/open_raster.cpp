#include "warp/open_raster.h"

#include <minizip/zip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <pugixml.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/temporary_folder.h"
#include "warp/convert.h"

namespace wend {
namespace {

constexpr int kThumbnail = 256;  // pixels, at most

/// Writes a ZIP archive to a file.
class ZipWriter {
  public:
    explicit ZipWriter(const std::string& path)
        : m_path(path), m_zip(zipOpen64(path.c_str(), APPEND_STATUS_CREATE), close) {
        if (!m_zip) fail();
    }

    void add(const std::string& name, const std::string& bytes, bool isPacked) {
        zip_fileinfo info{};
        info.tmz_date = {0, 0, 0, 1, 0, 1980};  // the earliest: equal files have equal bytes
        const int method = isPacked ? Z_DEFLATED : 0;
        if (zipOpenNewFileInZip64(m_zip.get(), name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, method,
                                  Z_DEFAULT_COMPRESSION, bytes.size() > 0xffffffffU) != ZIP_OK)
            fail();
        constexpr std::size_t kPiece = std::size_t(1) << 30;
        for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
            const auto size = static_cast<unsigned>(std::min(kPiece, bytes.size() - at));
            if (zipWriteInFileInZip(m_zip.get(), bytes.data() + at, size) != ZIP_OK) fail();
        }
        if (zipCloseFileInZip(m_zip.get()) != ZIP_OK) fail();
    }
    void finish() {
        if (zipClose(m_zip.release(), nullptr) != ZIP_OK) fail();
    }

  private:
    static int close(zipFile zip) { return zip ? zipClose(zip, nullptr) : ZIP_OK; }
    [[noreturn]] void fail() const { throw InputError(m_path, "cannot be written"); }

    std::string m_path;
    std::unique_ptr<void, int (*)(zipFile)> m_zip;
};

std::string pngOf(const Image& image, const std::string& folder) {
    const std::string name = (std::filesystem::path(folder) / "layer.png").string();
    writeImage(name, image);
    std::string bytes = readInput(name);
    std::filesystem::remove(name);
    return bytes;
}

/// Returns a smaller image, whose pixels are the means of squares of pixels.
Image reduced(const Image& image) {
    const int factor = (std::max(image.width, image.height) + kThumbnail - 1) / kThumbnail;
    const Image source = converted(image, {PixelType::UInt8, 4, true, false});
    Image small = source;
    small.width = std::max(1, image.width / factor), small.height = std::max(1, image.height / factor);
    small.makePixels();
    std::vector<float> row(4 * static_cast<std::size_t>(image.width)),
        sums(4 * static_cast<std::size_t>(small.width));
    for (int y = 0; y < small.height; ++y) {
        std::ranges::fill(sums, 0.0F);
        const int high = std::min(factor, image.height), wide = std::min(factor, image.width);
        for (int k = 0; k < high; ++k) {
            loadRow(source, y * factor + k, row.data());
            for (std::size_t i = 0; i < sums.size(); ++i)
                for (int j = 0; j < wide; ++j)
                    sums[i] +=
                        row[4 * ((i / 4) * static_cast<std::size_t>(factor) + static_cast<std::size_t>(j)) +
                            i % 4] /
                        static_cast<float>(high * wide);
        }
        storeRow(small, y, sums.data());
    }
    return small;
}

std::string fileOf(std::size_t layer) {
    return "data/layer" + std::to_string(layer) + ".png";
}

const char* compositeOf(BlendMode mode) {
    switch (mode) {
        case BlendMode::Multiply:
            return "svg:multiply";
        case BlendMode::Screen:
            return "svg:screen";
        case BlendMode::Add:
            return "svg:plus";
        case BlendMode::Normal:
            break;
    }
    return "svg:src-over";
}

/// Returns the fewest digits that give the same number when they are read.
std::string fewestDigits(double value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string description(const std::vector<LayerToWrite>& layers, const Image& merged) {
    pugi::xml_document document;
    pugi::xml_node image = document.append_child("image");
    image.append_attribute("version") = "0.0.5";
    image.append_attribute("w") = merged.width;
    image.append_attribute("h") = merged.height;
    pugi::xml_node stack = image.append_child("stack");
    for (std::size_t k = 0; k < layers.size(); ++k) {
        pugi::xml_node layer = stack.append_child("layer");
        layer.append_attribute("name") = layers[k].name.c_str();
        layer.append_attribute("src") = fileOf(k).c_str();
        layer.append_attribute("x") = layers[k].x;
        layer.append_attribute("y") = layers[k].y;
        layer.append_attribute("opacity") = fewestDigits(layers[k].opacity).c_str();
        layer.append_attribute("visibility") = layers[k].visible ? "visible" : "hidden";
        layer.append_attribute("composite-op") = compositeOf(layers[k].blend);
    }
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

}  // namespace

void writeOpenRaster(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged) {
    const TemporaryFolder folder(scratchFolder());
    ZipWriter zip(path);
    zip.add("mimetype", "image/openraster", false);
    zip.add("stack.xml", description(layers, merged), true);
    for (std::size_t k = 0; k < layers.size(); ++k)
        zip.add(fileOf(k), pngOf(layers[k].picture, folder.path()), false);
    zip.add("mergedimage.png", pngOf(merged, folder.path()), false);
    zip.add("Thumbnails/thumbnail.png", pngOf(reduced(merged), folder.path()), false);
    zip.finish();
}

}  // namespace wend
