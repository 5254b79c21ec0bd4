#include "warp/layered_file.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "core/mesh/error.h"
#include "warp/byte_numbers.h"

namespace wend {
namespace {

constexpr std::uint64_t kLongest = std::uint64_t(2) << 30;  // bytes of a file in an archive

class ZipArchive {
  public:
    explicit ZipArchive(const std::string& path) : m_path(path), m_zip(unzOpen64(path.c_str()), unzClose) {
        if (!m_zip) fail("is a damaged ZIP archive");
    }

    /// Returns the file of that name, or its first bytes; nothing if there is none.
    std::optional<std::string> file(const std::string& name, std::uint64_t most = kLongest) const {
        unz_file_info64 info{};
        if (unzLocateFile(m_zip.get(), name.c_str(), 1) != UNZ_OK) return std::nullopt;
        if (unzGetCurrentFileInfo64(m_zip.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK ||
            unzOpenCurrentFile(m_zip.get()) != UNZ_OK)
            fail("has a damaged " + name);
        if (info.uncompressed_size > kLongest) fail("has a " + name + " of more than 2 GB");
        std::string bytes(std::min<std::uint64_t>(info.uncompressed_size, most), '\0');
        for (std::size_t at = 0; at < bytes.size();) {
            const auto part = static_cast<unsigned>(std::min<std::size_t>(bytes.size() - at, 1 << 20));
            const int got = unzReadCurrentFile(m_zip.get(), bytes.data() + at, part);
            if (got <= 0) fail("has a damaged " + name);
            at += static_cast<std::size_t>(got);
        }
        if (unzCloseCurrentFile(m_zip.get()) == UNZ_CRCERROR) fail("has a damaged " + name);
        return bytes;
    }

    [[noreturn]] void fail(const std::string& why) const { throw InputError(m_path, why); }

  private:
    std::string m_path;
    std::unique_ptr<void, int (*)(unzFile)> m_zip;
};

/// The places where a format keeps the properties of its layers.
struct Description {
    const char* file;
    const char* blend;
    const char* visible;
    const char* shown;  // the value of a visible layer
    double opaque;
};
constexpr Description kOpenRaster{"stack.xml", "composite-op", "visibility", "visible", 1};
constexpr Description kKrita{"maindoc.xml", "compositeop", "visible", "1", 255};

PictureLayer layerOf(const pugi::xml_node& node, const Description& description) {
    PictureLayer layer;
    layer.name = node.attribute("name").value();
    layer.x = node.attribute("x").as_int();
    layer.y = node.attribute("y").as_int();
    std::string blend = node.attribute(description.blend).as_string("normal");
    layer.blend = blend.substr(blend.find(':') + 1);        // "svg:multiply" by OpenRaster
    for (pugi::xml_node at = node; at; at = at.parent()) {  // with the groups that it is in
        const std::string_view shown = at.attribute(description.visible).as_string(description.shown);
        layer.visible = layer.visible && shown == description.shown;
        layer.opacity *= at.attribute("opacity").as_double(description.opaque) / description.opaque;
    }
    return layer;
}

/// Takes the size from the header of the layer's PNG file.
void takeSize(const std::optional<std::string>& png, PictureLayer& layer) {
    constexpr std::size_t kHeader = 24, kWidth = 16, kHeight = 20;
    if (!png || png->size() < kHeader || !png->starts_with("\x89PNG")) return;
    layer.width = static_cast<int>(bigEndian(*png, kWidth));
    layer.height = static_cast<int>(bigEndian(*png, kHeight));
}

/// The layers of a description, without groups, and where their pictures are in the archive.
struct LayerList {
    std::vector<PictureLayer> layers;
    std::vector<std::string> files;
};

LayerList layersOf(const ZipArchive& zip, const Description& description) {
    const auto text = zip.file(description.file);
    pugi::xml_document document;
    if (!text || !document.load_buffer(text->data(), text->size()))
        zip.fail("has a damaged " + std::string(description.file));
    LayerList list;
    for (const auto& found : document.select_nodes("//layer[not(@nodetype='grouplayer')]")) {
        PictureLayer layer = layerOf(found.node(), description);
        list.files.emplace_back(found.node().attribute("src").value());
        if (!list.files.back().empty()) takeSize(zip.file(list.files.back(), 24), layer);
        list.layers.push_back(std::move(layer));
    }
    std::vector<std::string*> names;
    for (PictureLayer& layer : list.layers) names.push_back(&layer.name);
    giveOwnNames(names);
    return list;
}

}  // namespace

LayeredFile readLayeredFile(const std::string& path, PictureFormat format) {
    const ZipArchive zip(path);
    auto merged = zip.file("mergedimage.png");
    if (!merged) zip.fail("holds no picture of all its layers (mergedimage.png): save it with one");
    return {std::move(*merged), layersOf(zip, format == PictureFormat::Krita ? kKrita : kOpenRaster).layers};
}

void giveOwnNames(const std::vector<std::string*>& names) {
    std::set<std::string> taken;
    for (std::string* name : names) {
        if (name->empty()) *name = "layer";
        const std::string own = *name;
        for (int number = 2; !taken.insert(*name).second; ++number)
            *name = own + " (" + std::to_string(number) + ")";
    }
}

std::size_t layerNamed(const std::vector<PictureLayer>& layers, const std::string& name) {
    const auto found = std::ranges::find(layers, name, &PictureLayer::name);
    if (found == layers.end()) throw InputError("has no layer \"" + name + '"');
    return static_cast<std::size_t>(found - layers.begin());
}

std::string readLayerPicture(const std::string& path, const std::string& name) try {
    const ZipArchive zip(path);
    const LayerList list = layersOf(zip, kOpenRaster);
    auto picture = zip.file(list.files[layerNamed(list.layers, name)]);
    if (!picture) throw InputError("holds no picture of its layer \"" + name + '"');
    return std::move(*picture);
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
