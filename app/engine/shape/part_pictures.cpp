#include "app/engine/shape/part_pictures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "warp/drawn_picture.h"
#include "warp/layer_merging.h"
#include "warp/layered_file.h"
#include "warp/picture_metadata.h"

namespace wend {
namespace {

/// The layers that a file lists, and its size.
struct LayersOfFile {
    int width = 0, height = 0;
    std::vector<PictureLayer> layers;  // from front to back
    std::vector<ShownLayer> shown;
};

/// Reads pictures of parts, each file's list of layers once.
class PartReader {
  public:
    PartReader(const std::string& folder, const DrawnSize& drawn, std::vector<Message>* notices)
        : m_folder(folder), m_drawn(drawn), m_notices(notices) {}

    std::shared_ptr<const Image> read(const PicturePart& part) {
        const std::string path = pathIn(m_folder, part.path);
        if (part.layer.empty()) return std::make_shared<const Image>(readImage(path, m_drawn, m_notices));
        const LayersOfFile& file = layersOf(path);
        if (const ShownLayer* merged = mergedNamed(file, part.layer))
            return std::make_shared<const Image>(pictureOf(file, path, *merged, part.blend.has_value()));
        const PictureLayer& layer = named(file, path, part.layer);
        auto picture = std::make_shared<const Image>(readLayer(path, part.layer, m_drawn, m_notices));
        if (m_notices) tellOf(layer, path, part.blend.has_value());
        return picture;
    }

    const LayersOfFile& layersOf(const std::string& path) {
        const auto [found, isNew] = m_files.try_emplace(path);
        if (!isNew) return found->second;
        const Image header = readImageHeader(path, m_drawn);
        found->second = {header.width,
                         header.height,
                         fromTheFront(fileMetadata(header)->layers, pictureFormat(InputFile(path))),
                         {}};
        found->second.shown = shownLayers(found->second.layers);
        return found->second;
    }
    /// Sets place, opacity and visibility of a sheet: the project's, otherwise those of the layer's file.
    void place(const PicturePart& part, Sheet& sheet) {
        sheet.opacity = part.opacity;
        sheet.at = part.at.value_or(Vec<2>::Zero());
        if (!part.layer.empty()) {
            const std::string path = pathIn(m_folder, part.path);
            const LayersOfFile& file = layersOf(path);
            const ShownLayer* merged = mergedNamed(file, part.layer);
            const PictureLayer& layer = merged ? merged->layer : named(file, path, part.layer);
            if (!part.at) sheet.at = {layer.x, layer.y};
            if (part.opacity == 1) sheet.opacity = layer.opacity;
            sheet.blend = blendNamed(layer.blend).value_or(BlendMode::Normal);
        }
        sheet.blend = part.blend.value_or(sheet.blend);
        sheet.hidden = part.hidden;
    }

  private:
    /// Returns what is shown of several layers under that name; null if it is a layer's.
    static const ShownLayer* mergedNamed(const LayersOfFile& file, const std::string& name) {
        const auto found = std::ranges::find_if(
            file.shown, [&](const ShownLayer& one) { return !one.merges.empty() && one.layer.name == name; });
        return found == file.shown.end() ? nullptr : &*found;
    }

    Image pictureOf(const LayersOfFile& file, const std::string& path, const ShownLayer& merged,
                    bool hasOwnBlend) {
        const auto read = [&](const std::string& layer) {
            return readLayer(path, layer, m_drawn, m_notices);
        };
        std::vector<Message> notices;
        Image picture = mergedPicture(file.layers, merged, read, &notices).picture;
        if (!m_notices) return picture;
        std::string names;
        for (const std::string& name : merged.merges) names += (names.empty() ? "\"" : ", \"") + name + '"';
        m_notices->push_back(path + ": the layers " + names + " are shown as one");
        for (const Message& notice : notices) m_notices->push_back(path + ": " + notice);
        tellOf(merged.layer, path, hasOwnBlend);
        return picture;
    }
    void tellOf(const PictureLayer& layer, const std::string& path, bool hasOwnBlend) {
        const std::string which = path + ": the layer \"" + layer.name + "\" ";
        if (!hasOwnBlend && !blendNamed(layer.blend))
            m_notices->push_back(
                path + ": " +
                Message(sentence("Core", "the layer \"%1\" has the blend mode %2: it is shown as normal"),
                        layer.name, layer.blend));
        if (layer.clipped) m_notices->push_back(which + "is clipped by the one below: it is shown whole");
        if (layer.atop && !layer.clipped)
            m_notices->push_back(which + "is shown without the alpha that it inherits from those below");
        for (const std::string& what : layer.leftOut)
            m_notices->push_back(which + "is shown without " + what);
    }
    static const PictureLayer& named(const LayersOfFile& file, const std::string& path,
                                     const std::string& name) try {
        return file.layers[layerNamed(file.layers, name)];
    } catch (const InputError& error) {
        throw error.named(path);
    }

    const std::string& m_folder;
    DrawnSize m_drawn;
    std::vector<Message>* m_notices;
    std::map<std::string, LayersOfFile> m_files;
};

/// Adds a notice if colour profiles differ. Colours are compared and combined without conversion.
void tellOfProfiles(const std::vector<Sheet>& sheets, std::vector<Message>& notices) {
    const auto colours = [](const Sheet& sheet) {
        const bool isOfExr = sheet.picture->metadata && sheet.picture->metadata->isOfExr;
        return std::pair(sheet.picture->iccProfile(), isOfExr);
    };
    const auto differs = [&](const Sheet& sheet) { return colours(sheet) != colours(sheets.front()); };
    if (std::ranges::any_of(sheets, differs))
        notices.push_back(
            "domain.parts: the pictures have different colour profiles: their numbers are taken as those of "
            "the "
            "first part");
}

std::size_t placeOf(const std::vector<PicturePart>& parts, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(parts, name, &PicturePart::name) - parts.begin());
}

void takeCanvas(PartReader& reader, const std::string& folder, PartPictures& pictures) {
    for (const PicturePart& part : pictures.parts)
        if (!part.layer.empty()) {
            const LayersOfFile& file = reader.layersOf(pathIn(folder, part.path));
            pictures.width = std::max(pictures.width, file.width);
            pictures.height = std::max(pictures.height, file.height);
        }
    if (pictures.width > 0) return;
    for (const Sheet& sheet : pictures.sheets) {
        pictures.width =
            std::max(pictures.width, static_cast<int>(std::ceil(sheet.at.x() + sheet.picture->width)));
        pictures.height =
            std::max(pictures.height, static_cast<int>(std::ceil(sheet.at.y() + sheet.picture->height)));
    }
    if (pictures.width < 1 || pictures.height < 1)
        throw InputError("domain.parts: all parts are left of or above the picture");
}

/// Makes the sheets of parts from what is known and what has to be read or cut.
class SheetMaker {
  public:
    SheetMaker(PartPictures& pictures, const PartPictures& known, PartReader& reader,
               std::vector<Message>* notices, std::stop_token stop)
        : m_pictures(pictures), m_known(known), m_reader(reader), m_notices(notices), m_stop(stop) {}

    void make() {
        const std::vector<PicturePart>& parts = m_pictures.parts;
        std::vector<bool> isDone(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!parts[i].cutFrom.empty()) continue;
            m_pictures.sheets[i].picture = sourceOf(parts[i]);
            m_reader.place(parts[i], m_pictures.sheets[i]);
            isDone[i] = true;
        }
        // A cut may be cut from, too: those that are cut from what is there come first.
        while (std::ranges::find(isDone, false) != isDone.end())
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const std::size_t from = isDone[i] ? i : placeOf(parts, parts[i].cutFrom);
                if (isDone[i] || !isDone[from]) continue;
                cut(i, m_pictures.sheets[from]);
                isDone[i] = true;
            }
    }

  private:
    std::shared_ptr<const Image> sourceOf(const PicturePart& part) {
        const auto in = [&](const std::vector<PartSource>& sources) {
            return std::ranges::find_if(sources, [&](const PartSource& one) {
                return one.path == part.path && one.layer == part.layer;
            });
        };
        std::vector<PartSource>& sources = m_pictures.sources;
        if (const auto read = in(sources); read != sources.end()) return read->picture;
        const auto known = m_known.drawn == m_pictures.drawn ? in(m_known.sources) : m_known.sources.end();
        sources.push_back(
            known != m_known.sources.end() ? *known : PartSource{part.path, part.layer, m_reader.read(part)});
        return sources.back().picture;
    }

    void cut(std::size_t i, Sheet& from) {
        const PicturePart& part = m_pictures.parts[i];
        const auto isSame = [&](const PartCut& one) {
            return one.whole == from.picture && one.at == from.at && one.cut == part.cut &&
                   one.feather == part.feather && one.fill == part.fill;
        };
        const auto known = std::ranges::find_if(m_known.cuts, isSame);
        try {
            m_pictures.cuts.push_back(known != m_known.cuts.end()
                                          ? *known
                                          : PartCut{from.picture, from.at, part.cut, part.feather, part.fill,
                                                    cutOut(part, from, m_notices, m_stop)});
        } catch (const InputError& error) {
            throw error.named("domain.parts[" + std::to_string(i) + "]");
        }
        m_pictures.sheets[i] = m_pictures.cuts.back().pictures.taken;
        m_pictures.sheets[i].opacity = part.opacity;
        m_pictures.sheets[i].hidden = part.hidden;
        m_pictures.sheets[i].blend = part.blend.value_or(from.blend);
        from.picture = m_pictures.cuts.back().pictures.left;
    }

    PartPictures& m_pictures;
    const PartPictures& m_known;
    PartReader& m_reader;
    std::vector<Message>* m_notices;
    std::stop_token m_stop;
};

}  // namespace

PartPictures loadParts(const std::vector<PicturePart>& parts, const std::string& folder,
                       const PartPictures& known, std::vector<Message>* notices, const DrawnSize& drawn,
                       const std::stop_token& stop) {
    PartPictures pictures;
    pictures.parts = parts;
    pictures.drawn = drawn;
    pictures.sheets.resize(parts.size());
    PartReader reader(folder, drawn, notices);
    SheetMaker(pictures, known, reader, notices, stop).make();
    takeCanvas(reader, folder, pictures);
    if (notices) tellOfProfiles(pictures.sheets, *notices);
    return pictures;
}

std::vector<PicturePart> atRest(std::vector<PicturePart> parts) {
    for (PicturePart& part : parts) part.fill = false;
    return parts;
}

}  // namespace wend
