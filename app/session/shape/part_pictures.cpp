#include "app/session/shape/part_pictures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/document/file/named_files.h"
#include "core/mesh/error.h"
#include "core/mesh/region.h"
#include "warp/layered_file.h"
#include "warp/picture_metadata.h"

namespace wend {
namespace {

/// The layers that a file lists, and its size.
struct LayersOfFile {
    int width = 0, height = 0;
    std::vector<PictureLayer> layers;
};

/// Reads pictures of parts, each file's list of layers once.
class PartReader {
  public:
    PartReader(const std::string& folder, std::vector<std::string>* notices)
        : m_folder(folder), m_notices(notices) {}

    Sheet read(const PicturePart& part) {
        Sheet sheet;
        const std::string path = pathIn(m_folder, part.path);
        if (part.layer.empty()) {
            sheet.picture = std::make_shared<const Image>(readImage(path, kMaxMegapixels, m_notices));
            return sheet;
        }
        const LayersOfFile& file = layersOf(path);
        const PictureLayer& layer = named(file, path, part.layer);
        sheet.picture = std::make_shared<const Image>(readLayer(path, part.layer, m_notices));
        const bool isPlain = layer.blend.empty() || layer.blend == "normal" || layer.blend == "src-over";
        if (!isPlain && m_notices)
            m_notices->push_back(path + ": the layer \"" + layer.name + "\" has the blend mode " +
                                 layer.blend + ": it is shown as normal");
        return sheet;
    }

    const LayersOfFile& layersOf(const std::string& path) {
        const auto [found, isNew] = m_files.try_emplace(path);
        if (!isNew) return found->second;
        const Image header = readImageHeader(path);
        found->second = {header.width, header.height, fileMetadata(header)->layers};
        return found->second;
    }
    /// Sets place, opacity and visibility of a sheet: the project's, otherwise those of the layer's file.
    void place(const PicturePart& part, Sheet& sheet) {
        sheet.opacity = part.opacity;
        sheet.at = part.at.value_or(Vec<2>::Zero());
        if (!part.layer.empty()) {
            const std::string path = pathIn(m_folder, part.path);
            const PictureLayer& layer = named(layersOf(path), path, part.layer);
            if (!part.at) sheet.at = {layer.x, layer.y};
            if (part.opacity == 1) sheet.opacity = layer.opacity;
        }
        sheet.hidden = part.hidden;
    }

  private:
    static const PictureLayer& named(const LayersOfFile& file, const std::string& path,
                                     const std::string& name) try {
        return file.layers[layerNamed(file.layers, name)];
    } catch (const InputError& error) {
        throw error.named(path);
    }

    const std::string& m_folder;
    std::vector<std::string>* m_notices;
    std::map<std::string, LayersOfFile> m_files;
};

/// How far a point is inside the cut, in [0, 1].
float cutAt(const PicturePart& part, const Vec<2>& p) {
    double inside = 0;
    for (const auto& loop : part.cut.loops) {
        const double own = membership<2>(Polygon{loop}, p, part.feather);
        inside += own - 2 * inside * own;  // even and odd
    }
    return static_cast<float>(inside);
}

/// The mean of the cut over a pixel, by 4 × 4 places where its border is near.
float cutOver(const PicturePart& part, const Vec<2>& centre) {
    constexpr int kPlaces = 4;
    double nearest = INFINITY;
    for (const auto& loop : part.cut.loops)
        nearest = std::min(nearest, std::abs(signedDistance<2>(Polygon{loop}, centre)));
    if (nearest > 1 + part.feather) return cutAt(part, centre);
    float sum = 0;
    for (int j = 0; j < kPlaces; ++j)
        for (int i = 0; i < kPlaces; ++i)
            sum += cutAt(part, centre + Vec<2>(i + 0.5 - kPlaces / 2, j + 0.5 - kPlaces / 2) / kPlaces);
    return sum / (kPlaces * kPlaces);
}

/// Moves a region from one sheet to a new one. Pixels that the new one does not hide at rest remain below it.
void cutOut(const PicturePart& part, Sheet& from, Sheet& sheet) {
    const Image whole = *from.picture;
    const auto share = [&](int y, std::vector<float>& factors) {
        for (std::size_t x = 0; x < factors.size(); ++x)
            factors[x] = cutOver(part, from.at + Vec<2>(static_cast<double>(x) + 0.5, y + 0.5));
    };
    sheet.picture = std::make_shared<const Image>(faded(whole, share));
    sheet.at = from.at;
    const auto rest = [&](int y, std::vector<float>& factors) {
        share(y, factors);
        for (float& factor : factors) factor = factor < 1 ? 1 : 0;
    };
    from.picture = std::make_shared<const Image>(faded(whole, rest));
}

/// Colours are compared, and laid over one another, as the numbers that they are.
void tellOfProfiles(const std::vector<Sheet>& sheets, std::vector<std::string>& notices) {
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

bool isSameCut(const PicturePart& a, const PicturePart& b) {
    return a.name == b.name && a.path == b.path && a.layer == b.layer && a.cutFrom == b.cutFrom &&
           a.cut == b.cut && a.feather == b.feather && a.at == b.at;
}

/// The sheet of a part's file that is known. Where anything is cut out, only if all is cut as before.
const Sheet* knownSheet(const PartPictures& known, const std::vector<PicturePart>& parts,
                        const PicturePart& part) {
    const auto isCut = [](const PicturePart& one) { return !one.cutFrom.empty(); };
    const bool hasCuts = std::ranges::any_of(parts, isCut) || std::ranges::any_of(known.parts, isCut);
    if (hasCuts && !std::ranges::equal(parts, known.parts, isSameCut)) return nullptr;
    for (std::size_t i = 0; i < known.parts.size(); ++i)
        if (const PicturePart& one = known.parts[i];
            one.path == part.path && one.layer == part.layer && (!hasCuts || one.name == part.name))
            return &known.sheets[i];
    return nullptr;
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

}  // namespace

PartPictures loadParts(const std::vector<PicturePart>& parts, const std::string& folder,
                       const PartPictures& known, std::vector<std::string>* notices) {
    PartPictures pictures;
    pictures.parts = parts;
    pictures.sheets.resize(parts.size());
    PartReader reader(folder, notices);
    std::vector<bool> isDone(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Sheet* sheet = knownSheet(known, parts, parts[i]);
        if (sheet) pictures.sheets[i] = *sheet;
        if (!sheet && parts[i].cutFrom.empty()) pictures.sheets[i] = reader.read(parts[i]);
        if (parts[i].cutFrom.empty()) reader.place(parts[i], pictures.sheets[i]);
        isDone[i] = sheet || parts[i].cutFrom.empty();
        if (parts[i].cutFrom.empty()) continue;
        pictures.sheets[i].opacity = parts[i].opacity;
        pictures.sheets[i].hidden = parts[i].hidden;
    }
    // A cut may be cut from, too: those that are cut from what is there come first.
    while (std::ranges::find(isDone, false) != isDone.end())
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t from = isDone[i] ? i : placeOf(parts, parts[i].cutFrom);
            if (isDone[i] || !isDone[from]) continue;
            cutOut(parts[i], pictures.sheets[from], pictures.sheets[i]);
            isDone[i] = true;
        }
    takeCanvas(reader, folder, pictures);
    if (notices) tellOfProfiles(pictures.sheets, *notices);
    return pictures;
}

}  // namespace wend
