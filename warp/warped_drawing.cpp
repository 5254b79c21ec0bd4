#include "warp/warped_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "warp/curve_fit.h"

namespace wend {
namespace {

std::string base64(const std::string& bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += at + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
    }
    return text;
}

/// Returns how many decimals tell thousandths of a pixel that is that wide.
int decimalsFor(double pixel) {
    return std::clamp(static_cast<int>(std::ceil(3 - std::log10(pixel))), 0, 12);
}

/// Takes the coordinates of a drawing's view box to its pixels.
Affine pixelsOf(const VectorDrawing& drawing) {
    const Vec2 scale(drawing.width / drawing.viewBox[2], drawing.height / drawing.viewBox[3]);
    return {Mat2(scale.asDiagonal()), -scale.cwiseProduct(Vec2(drawing.viewBox[0], drawing.viewBox[1]))};
}

Image imageOf(const DrawnPicture& picture) {
    Image image;
    image.width = picture.width, image.height = picture.height;
    image.channels = 4;
    image.alpha = image.unassociated = true;
    image.makePixels();
    if (image.data.size() != picture.pixels.size()) throw InputError("its reader failed");
    std::ranges::transform(picture.pixels, image.data.begin(),
                           [](char value) { return static_cast<std::byte>(value); });
    return image;
}

const char* cssName(BlendMode mode) {
    switch (mode) {
        case BlendMode::Multiply:
            return "multiply";
        case BlendMode::Screen:
            return "screen";
        case BlendMode::Add:
            return "plus-lighter";
        case BlendMode::Normal:
            break;
    }
    return "normal";
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.remove_attribute(name);
    node.append_attribute(name) = value.c_str();
}

Affine transformOf(const pugi::xml_node& node, const char* name) {
    Affine transform;
    readTransform(node.attribute(name).value(), transform);
    return transform;
}

void setImage(pugi::xml_node node, const PlacedPng& png, const Affine& fromPixels) {
    const Vec2 from = fromPixels(png.at), size = fromPixels.A * Vec2(png.width, png.height);
    set(node, "x", numberText(from.x()));
    set(node, "y", numberText(from.y()));
    set(node, "width", numberText(size.x()));
    set(node, "height", numberText(size.y()));
    set(node, "preserveAspectRatio", "none");
    set(node, "xlink:href", "data:image/png;base64," + base64(png.bytes));
}

}  // namespace

// --- A drawing ---

/// Carries the paths, paints and pictures of a drawing.
class SvgFile::Carrier {
  public:
    Carrier(const VectorDrawing& drawing, const Vec2& shift, const PlaneMap& map, const WarpToPng& warp)
        : m_drawing(drawing), m_shift(shift), m_map(map), m_warp(warp) {
        m_toPixels = pixelsOf(drawing);
        m_fromPixels = m_toPixels.inverse();
        m_toPixels.b += shift;
        m_decimals = decimalsFor(m_fromPixels.A.cwiseAbs().maxCoeff());
    }

    /// Takes pixels of the plane to the drawing's coordinates.
    const Affine& fromPixels() const { return m_fromPixels; }

    void carry(pugi::xml_node svg) {
        for (const auto& found : svg.select_nodes(".//*[@id]"))
            m_byId[found.node().attribute("id").value()] = found.node();
        for (const auto& found : svg.select_nodes(".//image[@data-picture]")) carryPicture(found.node());
        const bool isInDefs = false;
        carryPaths(svg, isInDefs);
    }

    /// Returns whether anything that is drawn is outside the shape.
    bool reachesOut() const { return m_reachesOut; }

    /// Returns the `d` of the border of the pose.
    std::string border() const {
        SvgPath path;
        for (const auto& loop : m_map.border()) {
            for (const Vec2& p : loop)
                path.push_back({path.empty() || path.back().kind == PathPiece::Kind::Close
                                    ? PathPiece::Kind::Move
                                    : PathPiece::Kind::Line,
                                {m_fromPixels(p)}});
            path.push_back({PathPiece::Kind::Close, {}});
        }
        return pathText(path, m_decimals);
    }

  private:
    /// Patterns, filters and markers are the file's own.
    static bool isOwn(const std::string& name) {
        constexpr std::array kOwn{"pattern", "filter", "marker", "symbol"};
        return std::ranges::find(kOwn, name) != kOwn.end();
    }

    void carryPaths(const pugi::xml_node& node, bool isInDefs) {
        for (pugi::xml_node child : node.children()) {
            const std::string name = child.name();
            if (isOwn(name)) continue;
            if (name == "path" && child.attribute("d"))
                carryPath(child, isInDefs);
            else
                carryPaths(child, isInDefs || name == "defs");
        }
    }

    void carryPath(pugi::xml_node node, bool isInDefs) {
        const SvgPath source = transformed(pathOf(node.attribute("d").value()), m_toPixels);
        const Affine frame = transformOf(node, "transform");
        const Affine back = frame.isIdentity() ? Affine{} : frame.inverse();
        if (!isInDefs && !m_reachesOut) m_reachesOut = reachesOut(source);
        for (const char* name : {"fill", "stroke"}) carryPaint(node.attribute(name).value(), source, back);
        const SvgPath carried = carriedPath(source, m_map, kCurveTolerance);
        const double shrink = frame.isIdentity() ? 1 : frame.scale();
        const int decimals = m_decimals + static_cast<int>(std::ceil(std::log10(std::max(1.0, shrink))));
        set(node, "d", pathText(transformed(carried, back * m_fromPixels), decimals));
    }

    bool reachesOut(const SvgPath& path) const {
        return std::ranges::any_of(path, [this](const PathPiece& piece) {
            return piece.count() > 0 &&
                   !m_map.contains(piece.points[static_cast<std::size_t>(piece.count() - 1)]);
        });
    }

    /// Carries a gradient or pattern along by the affine map that is nearest to the warp on its path.
    void carryPaint(const std::string& paint, const SvgPath& source, const Affine& back) {
        if (!paint.starts_with("url(#")) return;
        const auto found = m_byId.find(paint.substr(5, paint.find(')') - 5));
        if (found == m_byId.end()) return;
        const bool isPattern = std::string_view(found->second.name()) == "pattern";
        const char* const name = isPattern ? "patternTransform" : "gradientTransform";
        const Affine carried = m_fromPixels * nearestAffine(m_map, samplesOf(source)) * m_toPixels;
        set(found->second, name, transformText(back * carried * transformOf(found->second, name)));
    }

    static std::vector<Vec2> samplesOf(const SvgPath& path) {
        std::vector<Vec2> samples;
        Vec2 at(0, 0);
        for (const PathPiece& piece : path) {
            if (piece.count() == 0) continue;
            const Vec2 to = piece.points[static_cast<std::size_t>(piece.count() - 1)];
            if (piece.kind != PathPiece::Kind::Move) samples.emplace_back((at + to) / 2);
            samples.push_back(to);
            at = to;
        }
        return samples;
    }

    void carryPicture(pugi::xml_node node) {
        const std::size_t number = node.attribute("data-picture").as_uint();
        if (number >= m_drawing.pictures.size()) throw InputError("its reader failed");
        const DrawnPicture& picture = m_drawing.pictures[number];
        node.remove_attribute("data-picture");
        setImage(node, m_warp(imageOf(picture), Vec2(picture.x, picture.y) + m_shift), m_fromPixels);
    }

    const VectorDrawing& m_drawing;
    Vec2 m_shift;
    const PlaneMap& m_map;
    const WarpToPng& m_warp;
    Affine m_toPixels, m_fromPixels;
    int m_decimals = 3;
    bool m_reachesOut = false;
    std::map<std::string, pugi::xml_node> m_byId;
};

// --- The file ---

SvgFile::SvgFile(const SvgPage& page) : m_page(page) {
    m_root = m_document.append_child("svg");
    set(m_root, "xmlns", "http://www.w3.org/2000/svg");
    set(m_root, "xmlns:xlink", "http://www.w3.org/1999/xlink");
    set(m_root, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    if (!page.width.empty()) set(m_root, "width", page.width);
    if (!page.height.empty()) set(m_root, "height", page.height);
    std::string box;
    for (const double value : page.viewBox) box += (box.empty() ? "" : " ") + numberText(value);
    set(m_root, "viewBox", box);
    if (page.outside.empty()) return;
    pugi::xml_node ground = m_root.append_child("rect");
    const std::array<const char*, 4> names{"x", "y", "width", "height"};
    for (std::size_t k = 0; k < 4; ++k) set(ground, names[k], numberText(page.viewBox[k]));
    set(ground, "fill", page.outside);
}

pugi::xml_node SvgFile::begin(const SvgGroup& group, const char* kind) {
    pugi::xml_node node = m_root.append_child(kind);
    if (!group.name.empty()) {
        set(node, "inkscape:label", group.name);
        if (std::string_view(kind) == "g") set(node, "inkscape:groupmode", "layer");
    }
    if (group.opacity != 1) set(node, "opacity", numberText(group.opacity));
    std::string style = group.hidden ? "display:none;" : "";
    if (group.blend != BlendMode::Normal)
        style += std::string("mix-blend-mode:") + cssName(group.blend) + ';';
    if (!style.empty()) set(node, "style", style);
    return node;
}

void SvgFile::add(const SvgGroup& group, const VectorDrawing& drawing, const Vec2& shift, const PlaneMap& map,
                  const WarpToPng& warp) {
    pugi::xml_document own;
    if (!own.load_buffer(drawing.svg.data(), drawing.svg.size(),
                         pugi::parse_default | pugi::parse_ws_pcdata_single))
        throw InputError("its reader failed");
    pugi::xml_node svg = own.document_element();
    Carrier carrier(drawing, shift, map, warp);
    carrier.carry(svg);
    pugi::xml_node to = begin(group, "g");
    if (carrier.reachesOut()) {
        pugi::xml_node clip = svg.child("defs").append_child("clipPath");
        set(clip, "id", "wend-shape");
        set(clip.append_child("path"), "d", carrier.border());
        set(to, "clip-path", "url(#wend-shape)");
    }
    const Affine frame = m_page.fromPixels * carrier.fromPixels().inverse();
    const bool isOwnFrame = (frame.A - Mat2::Identity()).norm() > 1e-9 || frame.b.norm() > 1e-9;
    if (isOwnFrame) set(to, "transform", transformText(frame));
    for (const pugi::xml_node& child : svg.children()) to.append_copy(child);
    giveOwnIds(to);
}

/// Gives new ids to what has the id of something before it.
void SvgFile::giveOwnIds(pugi::xml_node drawing) {
    std::map<std::string, std::string> renamed;
    for (const auto& found : drawing.select_nodes(".//*[@id]")) {
        const std::string id = found.node().attribute("id").value();
        std::string own = id;
        for (int number = 2; !m_ids.insert(own).second; ++number) own = id + "-" + std::to_string(number);
        if (own == id) continue;
        renamed[id] = own;
        found.node().attribute("id").set_value(own.c_str());
    }
    if (renamed.empty()) return;
    for (const auto& found : drawing.select_nodes("descendant-or-self::*"))
        for (pugi::xml_attribute attribute : found.node().attributes()) {
            std::string value = attribute.value();
            const bool isWhole = value.starts_with('#');
            const auto at = isWhole ? 0 : value.find("url(#");
            if (at == std::string::npos) continue;
            const auto from = isWhole ? 1 : at + 5, to = isWhole ? value.size() : value.find(')', from);
            if (to == std::string::npos) continue;
            if (const auto other = renamed.find(value.substr(from, to - from)); other != renamed.end())
                attribute.set_value(value.replace(from, to - from, other->second).c_str());
        }
}

void SvgFile::add(const SvgGroup& group, const PlacedPng& png) {
    setImage(begin(group, "image"), png, m_page.fromPixels);
}

std::string SvgFile::text() const {
    std::ostringstream text;
    m_document.save(text, " ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

}  // namespace wend
