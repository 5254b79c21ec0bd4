#include "app/engine/shape/part_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/mesh/region.h"
#include "warp/convert.h"
#include "warp/drawn_picture.h"
#include "warp/inpaint.h"
#include "warp/layer_merging.h"
#include "warp/layered_file.h"
#include "warp/matte.h"
#include "warp/picture_metadata.h"

namespace wend {

namespace {

constexpr int kGap = 8;  // transparent pixels around the cut

/// Returns how far a point is inside the cut, in [0, 1].
float cutAt(const PicturePart& part, const Vec2& p) {
    double inside = 0;
    for (const auto& loop : part.cut.loops) {
        const double own = membership<2>(Polygon{loop}, p, part.feather);
        inside += own - 2 * inside * own;  // even and odd
    }
    return static_cast<float>(inside);
}

/// Returns the mean of the cut over a pixel, from 4 × 4 samples near the border.
float cutOver(const PicturePart& part, const Vec2& centre) {
    constexpr int kPlaces = 4;
    double nearest = INFINITY;
    for (const auto& loop : part.cut.loops)
        nearest = std::min(nearest, std::abs(signedDistance<2>(Polygon{loop}, centre)));
    if (nearest > 1 + part.feather) return cutAt(part, centre);
    float sum = 0;
    for (int j = 0; j < kPlaces; ++j)
        for (int i = 0; i < kPlaces; ++i)
            sum += cutAt(part, centre + Vec2(i + 0.5 - kPlaces / 2, j + 0.5 - kPlaces / 2) / kPlaces);
    return sum / (kPlaces * kPlaces);
}

/// Returns the box of pixels that a cut may touch, with a gap around it.
PixelBox boxOf(const PicturePart& part, const Sheet& from) {
    Vec2 low = Vec2::Constant(INFINITY), high = -low;
    for (const auto& loop : part.cut.loops)
        for (const Vec2& p : loop) low = low.cwiseMin(p - from.at), high = high.cwiseMax(p - from.at);
    const Image& picture = *from.picture;
    const double most = 1.0 + std::max(picture.width, picture.height);
    const auto pixel = [&](double x) { return static_cast<int>(std::floor(std::clamp(x, -most, most))); };
    const double around = part.feather + kGap;
    const int x = pixel(low.x() - around), y = pixel(low.y() - around);
    return PixelBox{x, y, pixel(high.x() + around) + 1 - x, pixel(high.y() + around) + 1 - y}.within(
        picture.width, picture.height);
}

/// Returns the share of each pixel of a box that a cut takes.
std::vector<float> sharesIn(const PicturePart& part, const Vec2& at, const PixelBox& box) {
    std::vector<float> shares;
    shares.reserve(static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            shares.push_back(cutOver(part, at + Vec2(x + 0.5, y + 0.5)));
    return shares;
}

Image emptyLike(const Image& image, const PixelBox& box) {
    Image piece{box.width,          box.height, image.channels, image.type, image.alpha,
                image.unassociated, {},         image.metadata};
    piece.makePixels();
    return piece;
}

Image pieceOf(const Image& image, const PixelBox& box) {
    Image piece = emptyLike(image, box);
    for (int y = 0; y < box.height; ++y)
        std::memcpy(piece.row(y), image.row(box.y + y) + image.pixelBytes() * static_cast<std::size_t>(box.x),
                    piece.rowBytes());
    return piece;
}

void place(const Image& piece, const PixelBox& box, Image& image) {
    for (int y = 0; y < box.height; ++y)
        std::memcpy(image.row(box.y + y) + image.pixelBytes() * static_cast<std::size_t>(box.x), piece.row(y),
                    piece.rowBytes());
}

Image withShares(const Image& piece, const std::vector<float>& shares) {
    return faded(piece, [&](int y, std::vector<float>& factors) {
        const auto begin = shares.begin() + static_cast<std::ptrdiff_t>(y) * piece.width;
        std::copy_n(begin, factors.size(), factors.begin());
    });
}

/// Cuts the box out and leaves it transparent.
CutPictures cutOpen(const Sheet& from, const PixelBox& box, std::vector<float> shares) {
    const Image piece = pieceOf(*from.picture, box);
    CutPictures pictures;
    pictures.taken.picture = std::make_shared<const Image>(withShares(piece, shares));
    for (float& share : shares) share = share < 1 ? 1 : 0;
    const Image hollow = withShares(piece, shares);
    Image left = converted(*from.picture, layoutOf(hollow));
    place(hollow, box, left);
    pictures.left = std::make_shared<const Image>(std::move(left));
    return pictures;
}

/// Returns the picture in a box with what the cut takes filled in.
Image groundIn(const Image& picture, const PixelBox& box, const std::vector<float>& shares,
               const std::stop_token& stop) {
    PixelLayout floats = layoutOf(picture);
    floats.type = PixelType::Float, floats.unassociated = false;
    const PixelBox around = surroundings(box, picture.width, picture.height);
    std::vector<bool> hole(static_cast<std::size_t>(around.width) * static_cast<std::size_t>(around.height));
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto width = static_cast<std::size_t>(box.width);
        const auto x = static_cast<int>(i % width) + box.x - around.x,
                   y = static_cast<int>(i / width) + box.y - around.y;
        hole[static_cast<std::size_t>(y) * static_cast<std::size_t>(around.width) +
             static_cast<std::size_t>(x)] = shares[i] > 0;
    }
    const Image filled = inpainted(converted(pieceOf(picture, around), floats), hole, stop);
    return pieceOf(filled, {box.x - around.x, box.y - around.y, box.width, box.height});
}

CutPictures cutFilled(const Sheet& from, const PixelBox& box, const std::vector<float>& shares,
                      const std::stop_token& stop) {
    const Image& picture = *from.picture;
    PixelLayout layout = layoutOf(picture);
    if (!layout.alpha) layout.alpha = layout.unassociated = true, ++layout.channels;
    PixelLayout floats = layout;
    floats.type = PixelType::Float, floats.unassociated = false;
    const Matte matte = separated(converted(pieceOf(picture, box), floats),
                                  converted(groundIn(picture, box, shares, stop), floats), shares);
    CutPictures pictures;
    pictures.taken.picture = std::make_shared<const Image>(converted(matte.top, layout));
    Image left = picture;
    place(converted(matte.ground, layoutOf(picture)), box, left);
    pictures.left = std::make_shared<const Image>(std::move(left));
    return pictures;
}

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
        sheet.at = part.at.value_or(Vec2::Zero());
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
            if (!error.file().empty()) throw;
            throw InputError("domain.parts[" + std::to_string(i) + "]: " + error.message());
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

CutPictures cutOut(const PicturePart& part, const Sheet& from, std::vector<Message>* notices,
                   const std::stop_token& stop) {
    const PixelBox box = boxOf(part, from);
    if (box.width == 0 || box.height == 0) throw InputError("the cut is outside of \"" + part.cutFrom + '"');
    const std::vector<float> shares = sharesIn(part, from.at, box);
    const bool fills = part.fill && canInpaint();
    if (part.fill && !fills && notices)
        notices->push_back("the ground behind \"" + part.name +
                           "\" is not filled: the program gmic is not installed");
    CutPictures pictures = fills ? cutFilled(from, box, shares, stop) : cutOpen(from, box, shares);
    pictures.taken.at = from.at + Vec2(box.x, box.y);
    return pictures;
}

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
