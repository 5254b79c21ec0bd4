#include "warp/svg/vector_maker.h"

#include <Eigen/LU>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "warp/svg/drawn_text.h"
#include "warp/svg/svg_paints.h"

namespace wend {
namespace {

constexpr int kDecimals = 6;              // of coordinates, in units of the view box of 1,000
constexpr int kDeepest = 200;             // groups in groups
constexpr int kMostElements = 1'000'000;  // with those that are used
constexpr std::size_t kMostNotices = 20;
constexpr double kNegligible = 1e-12;  // of a determinant

/// The things that hold for the children of an element.
struct Around {
    Affine map;  // to the coordinates of the view box
    SvgStyle style;
    Vec2 viewport;
    int depth = 0;
};

QPainterPath painterPath(const SvgPath& path) {
    QPainterPath result;
    const auto at = [](const Vec2& p) { return QPointF(p.x(), p.y()); };
    for (const PathPiece& piece : path) switch (piece.kind) {
            case PathPiece::Kind::Move:
                result.moveTo(at(piece.points[0]));
                break;
            case PathPiece::Kind::Line:
                result.lineTo(at(piece.points[0]));
                break;
            case PathPiece::Kind::Cubic:
                result.cubicTo(at(piece.points[0]), at(piece.points[1]), at(piece.points[2]));
                break;
            case PathPiece::Kind::Close:
                result.closeSubpath();
        }
    return result;
}

bool isNone(const std::string& value) {
    return value.empty() || value == "none";
}

Affine fromUnitSquare(const QRectF& box) {
    return {Mat2(Vec2(box.width(), box.height()).asDiagonal()), {box.x(), box.y()}};
}

QTransform painterTransform(const Affine& map) {
    return {map.A(0, 0), map.A(1, 0), map.A(0, 1), map.A(1, 1), map.b.x(), map.b.y()};
}

class VectorMaker {
  public:
    VectorMaker(const pugi::xml_document& source, const QRectF& viewBox, const QSize& size)
        : m_elements(source), m_viewBox(viewBox), m_size(size) {
        m_root = m_document.append_child("svg");
        m_root.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
        m_root.append_attribute("xmlns:xlink") = "http://www.w3.org/1999/xlink";
        m_root.append_attribute("xmlns:inkscape") = "http://www.inkscape.org/namespaces/inkscape";
        m_defs = m_root.append_child("defs");
        m_paints.emplace(m_elements, m_defs, [this](const Message& text) { tell(text); });
    }

    /// Returns the box around an element in its own coordinates, without pens, clip paths and masks.
    QRectF boxOf(const pugi::xml_node& node, const SvgStyle& style, const Vec2& viewport) {
        Around outer{{}, style, viewport};
        if (!readTransform(node.attribute("transform").value(), outer.map)) outer.map = {};
        outer.map = outer.map.inverse();
        QRectF box;
        QRectF* const before = std::exchange(m_measured, &box);
        element(node, {}, outer);
        m_measured = before;
        return box;
    }

    VectorDrawing make(const pugi::xml_node& svg) {
        Around around{{}, {}, {m_viewBox.width(), m_viewBox.height()}};
        around.style = styleOf(svg, {});
        children(svg, begin(svg, around, m_root, nullptr), around);
        VectorDrawing drawing;
        drawing.svg = textOf(m_document);
        drawing.viewBox = {m_viewBox.x(), m_viewBox.y(), m_viewBox.width(), m_viewBox.height()};
        drawing.width = m_size.width(), drawing.height = m_size.height();
        drawing.ownWidth = svg.attribute("width").value();
        drawing.ownHeight = svg.attribute("height").value();
        drawing.pictures = std::move(m_pictures);
        drawing.notices = std::move(m_notices);
        return drawing;
    }

  private:
    void tell(const Message& text) {
        if (m_notices.size() < kMostNotices &&
            std::ranges::find(m_notices, text.text(), &Message::text) == m_notices.end())
            m_notices.push_back(text);
    }

    // --- Elements ---

    void children(const pugi::xml_node& parent, pugi::xml_node out, const Around& around) {
        for (const pugi::xml_node& child : parent.children())
            if (std::string_view(child.name()) == "title" || std::string_view(child.name()) == "desc")
                out.append_copy(child);
            else if (isDrawn(child))
                element(child, out, around);
    }

    void element(const pugi::xml_node& node, pugi::xml_node out, const Around& around) {
        if (around.depth > kDeepest) throw InputError("has groups more than 200 deep in each other");
        if (++m_count > kMostElements) throw InputError("draws more than a million shapes (see its uses)");
        Around own{around.map, styleOf(node, around.style), around.viewport, around.depth + 1};
        if (!readTransform(node.attribute("transform").value(), own.map))
            tell("the transform \"" + std::string(node.attribute("transform").value()).substr(0, 60) +
                 "\" cannot be read");
        if (!(std::abs(own.map.A.determinant()) > kNegligible) || !own.map.b.allFinite()) return;
        if (m_measured && valueOf(own.style, "display") == "none") return;
        const std::string name = node.name();
        if (name == "g" || name == "a") return children(node, begin(node, own, out, nullptr), own);
        if (name == "svg") return nested(node, out, own);
        if (name == "use") return use(node, out, own);
        if (name == "switch") return chosen(node, begin(node, own, out, nullptr), own);
        if (name == "text") return text(node, out, own);
        if (name == "image") return image(node, out, own);
        if (const auto path = pathOfShape(node, own)) return shape(node, *path, out, own);
        tell({sentence("Core", "its <%1> is left out"), name.substr(0, 40)});
    }

    void chosen(const pugi::xml_node& node, pugi::xml_node out, const Around& around) {
        for (const pugi::xml_node& child : node.children())
            if (isDrawn(child) && std::string_view(child.name()) != "foreignObject")
                return element(child, out, around);
    }

    /// Places the view box of a nested drawing or symbol in an area.
    static Affine placed(const pugi::xml_node& node, const Vec2& from, Vec2& size) {
        Affine place;
        place.b = from;
        NumberScanner scanner(node.attribute("viewBox").value());
        std::array<double, 4> box{};
        for (double& value : box)
            if (!scanner.number(value)) return place;
        if (!(box[2] > 0 && box[3] > 0)) return place;
        Vec2 scale(size.x() / box[2], size.y() / box[3]);
        const std::string aspect = node.attribute("preserveAspectRatio").as_string("xMidYMid meet");
        Vec2 rest(0, 0);
        if (aspect.find("none") == std::string::npos) {
            const bool isSlice = aspect.find("slice") != std::string::npos;
            scale.setConstant(isSlice ? scale.maxCoeff() : scale.minCoeff());
            rest = size - scale.cwiseProduct(Vec2(box[2], box[3]));
            const auto part = [&](const char* min, const char* max) {
                return aspect.find(min) != std::string::npos   ? 0.0
                       : aspect.find(max) != std::string::npos ? 1.0
                                                               : 0.5;
            };
            rest = rest.cwiseProduct(Vec2(part("xMin", "xMax"), part("YMin", "YMax")));
        }
        place.A = scale.asDiagonal();
        place.b = from + rest - scale.cwiseProduct(Vec2(box[0], box[1]));
        size = {box[2], box[3]};
        return place;
    }

    void nested(const pugi::xml_node& node, pugi::xml_node out, Around around) {
        const Vec2 whole = around.viewport;
        const Vec2 from(lengthOf(node.attribute("x").value(), whole.x(), 0),
                        lengthOf(node.attribute("y").value(), whole.y(), 0));
        around.viewport = {lengthOf(node.attribute("width").value(), whole.x(), whole.x()),
                           lengthOf(node.attribute("height").value(), whole.y(), whole.y())};
        around.map = around.map * placed(node, from, around.viewport);
        children(node, begin(node, around, out, nullptr), around);
    }

    void use(const pugi::xml_node& node, pugi::xml_node out, Around around) {
        const std::string id = SvgElements::hrefOf(node);
        const pugi::xml_node target = m_elements.byId(id);
        if (!target) return tell("a <use> refers to \"" + id.substr(0, 60) + "\", which is missing");
        pugi::xml_node group = begin(node, around, out, nullptr);  // which may measure what is used
        if (!m_used.insert(id).second)
            throw InputError("uses its \"" + id.substr(0, 60) + "\" within itself");
        const Vec2 whole = around.viewport;
        const Vec2 shift(lengthOf(node.attribute("x").value(), whole.x(), 0),
                         lengthOf(node.attribute("y").value(), whole.y(), 0));
        around.map = around.map * Affine{Mat2::Identity(), shift};
        const std::string_view name = target.name();
        if (name == "symbol" || name == "svg") {
            around.style = styleOf(target, around.style);
            around.viewport = {lengthOf(node.attribute("width").value(), whole.x(), whole.x()),
                               lengthOf(node.attribute("height").value(), whole.y(), whole.y())};
            around.map = around.map * placed(target, {0, 0}, around.viewport);
            children(target, group, around);
        } else if (isDrawn(target)) {
            element(target, group, around);
        }
        m_used.erase(id);
    }

    // --- Groups ---

    bool giveName(const pugi::xml_node& node, pugi::xml_node own) {
        const std::string id = node.attribute("id").value();
        if (!id.empty() && m_names.insert(id).second) own.append_attribute("id") = id.c_str();
        for (const char* name : {"inkscape:label", "inkscape:groupmode"})
            if (const pugi::xml_attribute attribute = node.attribute(name))
                own.append_attribute(name) = attribute.value();
        return !id.empty();
    }

    static void copyOwn(const SvgStyle& style, pugi::xml_node own) {
        for (const char* name : {"opacity", "display"})
            if (const std::string value = valueOf(style, name); !value.empty() && value != "inline")
                own.append_attribute(name) = value.c_str();
        std::string blend;
        for (const char* name : {"mix-blend-mode", "isolation"})
            if (const std::string value = valueOf(style, name); !value.empty())
                blend += std::string(name) + ':' + value + ';';
        if (!blend.empty()) own.append_attribute("style") = blend.c_str();
    }

    /// Begins a group with what applies to an element as a whole, and returns where its content belongs.
    /// `box` is around it in its own coordinates, or null.
    pugi::xml_node begin(const pugi::xml_node& node, const Around& around, pugi::xml_node out,
                         const QRectF* box) {
        if (m_measured) return out;
        const SvgStyle& style = around.style;
        const Affine& map = around.map;
        const auto boxed = [&] { return box ? *box : boxOf(node, style, around.viewport); };
        pugi::xml_node group = out.append_child("g");
        giveName(node, group);
        copyOwn(style, group);
        if (const std::string id = clip(valueOf(style, "clip-path"), map, boxed); !id.empty())
            group.append_attribute("clip-path") = ("url(#" + id + ")").c_str();
        if (const std::string id = mask(valueOf(style, "mask"), map, boxed); !id.empty())
            group.append_attribute("mask") = ("url(#" + id + ")").c_str();
        const std::string filter = valueOf(style, "filter");
        if (isNone(filter) || !m_paints->keep(idInUrl(filter))) return group;
        pugi::xml_node frame = group.append_child("g");
        if (!map.isIdentity()) frame.append_attribute("transform") = transformText(map).c_str();
        frame.append_attribute("filter") = filter.c_str();
        if (map.isIdentity()) return frame;
        pugi::xml_node inside = frame.append_child("g");
        inside.append_attribute("transform") = transformText(map.inverse()).c_str();
        return inside;
    }

    /// Returns the definition that represents an element at a place; begins it if it is new.
    std::string definition(const char* kind, const std::string& id, const Affine& map,
                           pugi::xml_node& begun) {
        std::string& own = m_definitions[std::string(kind) + id + transformText(map)];
        if (!own.empty()) return own;
        own = "wend-" + std::string(kind).substr(0, 1) + std::to_string(m_definitions.size());
        begun = m_defs.append_child(kind);
        begun.append_attribute("id") = own.c_str();
        return own;
    }

    using BoxOf = std::function<QRectF()>;

    std::string clip(const std::string& value, const Affine& map, const BoxOf& box) {
        if (isNone(value)) return {};
        const std::string id = idInUrl(value);
        const pugi::xml_node source = m_elements.byId(id);
        if (std::string_view(source.name()) != "clipPath")
            return tell("its clip path " + value.substr(0, 60) + " is missing"), std::string();
        Around around{map, styleOf(source, {}), {m_viewBox.width(), m_viewBox.height()}};
        readTransform(source.attribute("transform").value(), around.map);
        if (isOfBox(source, "clipPathUnits")) around.map = around.map * fromUnitSquare(box());
        pugi::xml_node begun;
        const std::string own = definition("clipPath", id, around.map, begun);
        if (!begun) return own;
        if (!m_used.insert("clip " + id).second) throw InputError("clips its \"" + id + "\" by itself");
        pugi::xml_document inside;
        children(source, inside.append_child("g"), around);
        flatten(inside.first_child(), begun);
        if (const std::string outer = clip(valueOf(around.style, "clip-path"), map, box); !outer.empty())
            begun.append_attribute("clip-path") = ("url(#" + outer + ")").c_str();
        m_used.erase("clip " + id);
        return own;
    }

    /// Clip paths hold no groups.
    static void flatten(const pugi::xml_node& from, pugi::xml_node to) {
        for (const pugi::xml_node& child : from.children())
            if (std::string_view(child.name()) == "path") {
                pugi::xml_node copy = to.append_copy(child);
                copy.remove_attribute("fill");
                if (from.attribute("clip-path") && !copy.attribute("clip-path"))
                    copy.append_attribute("clip-path") = from.attribute("clip-path").value();
            } else {
                flatten(child, to);
            }
    }

    std::string mask(const std::string& value, Affine map, const BoxOf& box) {
        if (isNone(value)) return {};
        const std::string id = idInUrl(value);
        const pugi::xml_node source = m_elements.byId(id);
        if (std::string_view(source.name()) != "mask")
            return tell("its mask " + value.substr(0, 60) + " is left out"), std::string();
        if (isOfBox(source, "maskContentUnits")) map = map * fromUnitSquare(box());
        pugi::xml_node begun;
        const std::string own = definition("mask", id, map, begun);
        if (!begun) return own;
        if (!m_used.insert("mask " + id).second) throw InputError("masks its \"" + id + "\" by itself");
        begun.append_attribute("maskUnits") = "userSpaceOnUse";
        const auto set = [&](const char* name, double number) {
            begun.append_attribute(name) = numberText(number).c_str();
        };
        set("x", m_viewBox.x() - m_viewBox.width()), set("width", 3 * m_viewBox.width());
        set("y", m_viewBox.y() - m_viewBox.height()), set("height", 3 * m_viewBox.height());
        const SvgStyle style = styleOf(source, {});
        if (const std::string type = valueOf(style, "mask-type"); !type.empty())
            begun.append_attribute("style") = ("mask-type:" + type).c_str();
        children(source, begun, {map, style, {m_viewBox.width(), m_viewBox.height()}});
        m_used.erase("mask " + id);
        return own;
    }

    // --- Shapes ---

    /// Takes a path, at its place, into the box that is wanted.
    void measure(const SvgPath& placed) { *m_measured |= painterPath(placed).boundingRect(); }

    static std::optional<SvgPath> pathOfShape(const pugi::xml_node& node, const Around& around) {
        const Vec2& whole = around.viewport;
        const double diagonal = std::sqrt(whole.squaredNorm() / 2);
        const auto length = [&](const char* key, double of, double otherwise = 0) {
            return lengthOf(node.attribute(key).value(), of, otherwise);
        };
        const std::string name = node.name();
        if (name == "path") return pathOf(node.attribute("d").value());
        if (name == "polyline" || name == "polygon")
            return polygonPath(node.attribute("points").value(), name == "polygon");
        if (name == "line")
            return SvgPath{{PathPiece::Kind::Move, {Vec2(length("x1", whole.x()), length("y1", whole.y()))}},
                           {PathPiece::Kind::Line, {Vec2(length("x2", whole.x()), length("y2", whole.y()))}}};
        if (name == "rect") {
            const Vec2 size(length("width", whole.x()), length("height", whole.y()));
            double rx = length("rx", whole.x(), -1), ry = length("ry", whole.y(), -1);
            if (rx < 0) rx = ry;
            if (ry < 0) ry = rx;
            if (!(size.minCoeff() > 0)) return SvgPath();
            return rectanglePath({length("x", whole.x()), length("y", whole.y())}, size, rx, ry);
        }
        if (name != "circle" && name != "ellipse") return std::nullopt;
        const double rx = name == "circle" ? length("r", diagonal) : length("rx", whole.x());
        const double ry = name == "circle" ? rx : length("ry", whole.y());
        if (!(rx > 0 && ry > 0)) return SvgPath();
        return ellipsePath({length("cx", whole.x()), length("cy", whole.y())}, rx, ry);
    }

    void shape(const pugi::xml_node& node, const SvgPath& path, pugi::xml_node out, const Around& around) {
        if (path.empty()) return;
        const SvgPath placed = transformed(path, around.map);
        if (!isFinite(placed))
            return tell("a <" + std::string(node.name()) + "> reaches too far: it is left out");
        if (m_measured) return measure(placed);
        const QRectF box = painterPath(path).boundingRect();
        const SvgStyle& style = around.style;
        const bool isWrapped =
            std::ranges::any_of(std::array{"clip-path", "mask", "filter"},
                                [&](const char* name) { return !isNone(valueOf(style, name)); });
        if (isWrapped) out = begin(node, around, out, &box);
        pugi::xml_node own = out.append_child("path");
        if (!isWrapped) giveName(node, own), copyOwn(style, own);
        own.append_attribute("d") = pathText(placed, decimals()).c_str();
        setPaint(own, "fill", around, box);
        setPaint(own, "stroke", around, box);
        finish(own, style, around);
    }

    int decimals() const {
        const double size = std::max(m_viewBox.width(), m_viewBox.height());
        return std::clamp(kDecimals + 3 - static_cast<int>(std::ceil(std::log10(size))), 2, 12);
    }

    void setPaint(pugi::xml_node own, const char* property, const Around& around, const QRectF& box) {
        const std::string paint = m_paints->paint(around.style, property, around.map, box, around.viewport);
        const bool isStandard = paint == (std::string_view(property) == "fill" ? "black" : "none");
        if (!isStandard) own.append_attribute(property) = paint.c_str();
    }

    /// Sets the rest of what a path is drawn with: its pen in its own frame unless that may be in the view
    /// box's.
    void finish(pugi::xml_node own, const SvgStyle& style, const Around& around) {
        for (const char* name :
             {"fill-rule", "fill-opacity", "clip-rule", "stroke-opacity", "stroke-linecap", "stroke-linejoin",
              "stroke-miterlimit", "paint-order", "visibility", "vector-effect", "shape-rendering"})
            if (const std::string value = valueOf(style, name); !value.empty())
                own.append_attribute(name) = value.c_str();
        const bool hasStroke = static_cast<bool>(own.attribute("stroke"));
        bool hasMarkers = false;
        for (const char* name : {"marker-start", "marker-mid", "marker-end"}) {
            const std::string value = valueOf(style, name, valueOf(style, "marker").c_str());
            if (isNone(value) || !m_paints->keep(idInUrl(value))) continue;
            own.append_attribute(name) = value.c_str();
            hasMarkers = true;
        }
        if (!hasStroke && !hasMarkers) return;
        const bool isFixed = valueOf(style, "vector-effect") == "non-scaling-stroke";
        const bool isFramed =
            !isFixed && !around.map.isIdentity() && (hasMarkers || !around.map.isSimilarity());
        if (isFramed) own.append_attribute("transform") = transformText(around.map).c_str();
        setPen(own, style, around, isFramed || isFixed ? 1 : around.map.scale());
    }

    static void setPen(pugi::xml_node own, const SvgStyle& style, const Around& around, double scale) {
        const double diagonal = std::sqrt(around.viewport.squaredNorm() / 2);
        const double width = scale * lengthOf(valueOf(style, "stroke-width"), diagonal, 1);
        if (width != 1) own.append_attribute("stroke-width") = numberText(width).c_str();
        const std::string dashes = valueOf(style, "stroke-dasharray");
        if (isNone(dashes)) return;
        std::string scaled;
        for (std::string_view rest = dashes; !rest.empty();) {
            const auto end = std::min(rest.find_first_of(", \t\n"), rest.size());
            if (end > 0)
                scaled += (scaled.empty() ? "" : ",") +
                          numberText(scale * lengthOf(rest.substr(0, end), diagonal, 0));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        own.append_attribute("stroke-dasharray") = scaled.c_str();
        if (const std::string offset = valueOf(style, "stroke-dashoffset"); !offset.empty())
            own.append_attribute("stroke-dashoffset") =
                numberText(scale * lengthOf(offset, diagonal, 0)).c_str();
    }

    // --- What Qt's library draws ---

    /// Returns a drawing of one element alone at its place.
    std::string alone(const pugi::xml_node& node, const Around& around, const SvgStyle& style) const {
        pugi::xml_document document;
        pugi::xml_node svg = document.append_child("svg");
        svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
        svg.append_attribute("xmlns:xlink") = "http://www.w3.org/1999/xlink";
        std::string box;
        for (const double value : {m_viewBox.x(), m_viewBox.y(), m_viewBox.width(), m_viewBox.height()})
            box += numberText(value) + ' ';
        svg.append_attribute("viewBox") = box.c_str();
        pugi::xml_node group = svg.append_child("g");
        group.append_attribute("transform") = transformText(around.map).c_str();
        for (const auto& [name, value] : style)
            if (isInherited(name) && (name.starts_with("font") || name.starts_with("text") ||
                                      name == "fill" || name.ends_with("spacing")))
                group.append_attribute(name.c_str()) = value.c_str();
        pugi::xml_node copy = group.append_copy(node);
        for (const char* name : {"transform", "opacity", "clip-path", "mask", "filter", "display", "style"})
            copy.remove_attribute(name);
        copy.remove_attribute("fill");
        return textOf(document);
    }

    void text(const pugi::xml_node& node, pugi::xml_node out, const Around& around) {
        if (node.child("textPath")) tell(sentence("Core", "its text along a path is left out"));
        SvgStyle style = around.style;
        const std::string fill = valueOf(style, "fill", "black");
        const bool isPainted = fill.starts_with("url(");
        if (isPainted || fill == "none") style["fill"] = "#000000";
        if (fill == "currentColor") style["fill"] = valueOf(style, "color", "black");
        const std::vector<TextOutlines> outlines = textOutlines(alone(node, around, style), m_viewBox);
        if (outlines.empty()) return;
        if (m_measured) {
            for (const TextOutlines& one : outlines) measure(one.path);
            return;
        }
        pugi::xml_node group = begin(node, around, out, nullptr);
        QRectF box;
        for (const TextOutlines& one : outlines)
            box |= painterPath(transformed(one.path, around.map.inverse())).boundingRect();
        for (const TextOutlines& one : outlines) {
            if (!isFinite(one.path)) continue;
            pugi::xml_node own = group.append_child("path");
            own.append_attribute("d") = pathText(one.path, decimals()).c_str();
            if (isPainted || fill == "none")
                setPaint(own, "fill", around, box);
            else if (one.colour != "#000000")
                own.append_attribute("fill") = one.colour.c_str();
            if (!isPainted && one.opacity < 1)
                own.append_attribute("fill-opacity") = numberText(one.opacity).c_str();
            setPaint(own, "stroke", around, box);
            SvgStyle rest = around.style;
            if (own.attribute("fill-opacity")) rest.erase("fill-opacity");
            rest.erase("fill-rule");
            finish(own, rest, around);
        }
    }

    void image(const pugi::xml_node& node, pugi::xml_node out, const Around& around) {
        std::string href = node.attribute("href").value();
        if (href.empty()) href = node.attribute("xlink:href").value();
        if (!trimmed(href).starts_with("data:"))
            return tell({sentence("Core", "its picture \"%1\" is not in the file: it is left out"),
                         href.substr(0, 60)});
        const QRectF area(lengthOf(node.attribute("x").value(), around.viewport.x(), 0),
                          lengthOf(node.attribute("y").value(), around.viewport.y(), 0),
                          lengthOf(node.attribute("width").value(), around.viewport.x(), 1e6),
                          lengthOf(node.attribute("height").value(), around.viewport.y(), 1e6));
        if (m_measured)
            return measure(transformed(
                rectanglePath({area.x(), area.y()}, {area.width(), area.height()}, 0, 0), around.map));
        const double sx = m_size.width() / m_viewBox.width(), sy = m_size.height() / m_viewBox.height();
        QRectF box = painterTransform(around.map).mapRect(area);
        box = QRectF((box.x() - m_viewBox.x()) * sx, (box.y() - m_viewBox.y()) * sy, box.width() * sx,
                     box.height() * sy)
                  .intersected(QRectF(QPointF(), QSizeF(m_size)));
        const QRect pixels = box.toAlignedRect().adjusted(-2, -2, 2, 2);
        if (box.isEmpty()) return;
        QImage drawn(pixels.size(), QImage::Format_RGBA8888_Premultiplied);
        if (drawn.isNull()) throw std::bad_alloc();
        drawn.fill(Qt::transparent);
        const std::string svg = alone(node, around, around.style);
        QSvgRenderer renderer(QByteArray(svg.data(), static_cast<qsizetype>(svg.size())));
        QPainter painter(&drawn);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        painter.translate(-pixels.topLeft());
        renderer.render(&painter, QRectF(QPointF(), QSizeF(m_size)));
        painter.end();
        pugi::xml_node own = begin(node, around, out, &area).append_child("image");
        own.append_attribute("data-picture") = static_cast<unsigned>(m_pictures.size());
        drawn = drawn.convertToFormat(QImage::Format_RGBA8888);
        DrawnPicture& picture = m_pictures.emplace_back();
        picture = {pixels.x(), pixels.y(), pixels.width(), pixels.height(), {}};
        for (int y = 0; y < drawn.height(); ++y)
            picture.pixels.append(reinterpret_cast<const char*>(drawn.constScanLine(y)),
                                  4 * static_cast<std::size_t>(drawn.width()));
        tell(sentence("Core", "a picture in it stays one"));
    }

    SvgElements m_elements;
    QRectF m_viewBox;
    QSize m_size;
    pugi::xml_document m_document;
    pugi::xml_node m_root, m_defs;
    std::optional<SvgPaints> m_paints;
    std::map<std::string, std::string> m_definitions;  // by kind, id and place
    std::set<std::string> m_used, m_names;
    std::vector<DrawnPicture> m_pictures;
    std::vector<Message> m_notices;
    QRectF* m_measured = nullptr;  // the box that is wanted, while nothing is made
    int m_count = 0;
};

}  // namespace

VectorDrawing vectorsOf(const pugi::xml_document& drawing, const QRectF& viewBox, const QSize& size) {
    pugi::xml_document resolved;
    resolved.reset(drawing);
    resolveStyleSheets(resolved);
    return VectorMaker(resolved, viewBox, size).make(resolved.document_element());
}

QRectF boxOf(const pugi::xml_document& drawing, const pugi::xml_node& element, const QRectF& viewBox) {
    std::vector<pugi::xml_node> around;
    for (pugi::xml_node node = element.parent(); node; node = node.parent()) around.push_back(node);
    SvgStyle style;
    for (auto node = around.rbegin(); node != around.rend(); ++node) style = styleOf(*node, style);
    return VectorMaker(drawing, viewBox, viewBox.size().toSize())
        .boxOf(element, style, {viewBox.width(), viewBox.height()});
}

bool isDrawn(const pugi::xml_node& node) {
    constexpr std::array kNotDrawn{"defs",           "style",  "metadata", "title",   "desc",
                                   "script",         "symbol", "clipPath", "mask",    "linearGradient",
                                   "radialGradient", "filter", "marker",   "pattern", "font"};
    const std::string_view name = node.name();
    return node.type() == pugi::node_element && name.find(':') == std::string_view::npos &&
           std::ranges::find(kNotDrawn, name) == kNotDrawn.end();
}

std::string textOf(const pugi::xml_document& document) {
    std::ostringstream text;
    document.save(text, "", pugi::format_raw, pugi::encoding_utf8);
    return text.str();
}

}  // namespace wend
