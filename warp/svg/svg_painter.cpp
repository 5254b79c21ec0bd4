#include "warp/svg/svg_painter.h"

#include <QPainter>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "warp/svg/svg_blur.h"
#include "warp/svg/svg_paints.h"
#include "warp/svg/svg_style.h"
#include "warp/svg/vector_maker.h"
#include "warp/svg_path.h"

namespace wend {
namespace {

constexpr int kMostLayers = 200;    // composited of one drawing: each is drawn in full size
constexpr int kMostCopied = 20000;  // nodes of what uses with layers refer to, which may use one another
constexpr int kDeepest = 12;        // layers within layers
constexpr const char* kMark = "data-wend-layer";
constexpr const char* kRetired = "data-wend-retired";

/// Removes a property, wherever the element says it.
void removeProperty(pugi::xml_node node, const char* name) {
    node.remove_attribute(name);
    const std::string style = node.attribute("style").value();
    std::string rest;
    for (std::size_t at = 0; at < style.size();) {
        const std::size_t end = std::min(style.find(';', at), style.size());
        const std::string one = style.substr(at, end - at);
        if (trimmed(one.substr(0, one.find(':'))) != name) rest += one + ';';
        at = end + 1;
    }
    if (node.attribute("style")) node.attribute("style").set_value(rest.c_str());
}

pugi::xml_node markedIn(const pugi::xml_node& document) {
    return document.find_node([](const pugi::xml_node& node) { return bool(node.attribute(kMark)); });
}

/// Returns the element that a property of another one refers to; none if it is of another kind.
pugi::xml_node referred(const pugi::xml_node& from, const std::string& value, const char* kind) {
    const std::string id = idInUrl(value);
    if (id.empty()) return {};
    return from.root().find_node([&](const pugi::xml_node& node) {
        return std::string_view(node.name()) == kind && id == node.attribute("id").value();
    });
}

pugi::xml_node clipOf(const pugi::xml_node& node) {
    return referred(node, valueOf(styleOf(node, {}), "clip-path"), "clipPath");
}

pugi::xml_node maskOf(const pugi::xml_node& node) {
    return referred(node, valueOf(styleOf(node, {}), "mask"), "mask");
}

/// Standard deviations across columns and rows, in the user units of an element.
struct Deviations {
    double x = 0, y = 0;
};

/// Returns by how much an element's filter blurs it; nothing if it does anything else.
std::optional<Deviations> blurOf(const pugi::xml_node& node) {
    const pugi::xml_node filter = referred(node, valueOf(styleOf(node, {}), "filter"), "filter");
    if (!filter || isOfBox(filter, "primitiveUnits")) return std::nullopt;
    Deviations sum;
    std::string before = "SourceGraphic";
    for (const pugi::xml_node& step : filter.children()) {
        if (step.type() != pugi::node_element) continue;
        const std::string in = step.attribute("in").value();
        if (std::string_view(step.name()) != "feGaussianBlur" || !(in.empty() || in == before))
            return std::nullopt;
        before = step.attribute("result").value();
        NumberScanner numbers(step.attribute("stdDeviation").value());
        Deviations own;
        if (!numbers.number(own.x) || own.x < 0) return std::nullopt;
        if (!numbers.number(own.y)) own.y = own.x;
        sum = {std::hypot(sum.x, own.x), std::hypot(sum.y, own.y)};
    }
    return sum.x > 0 || sum.y > 0 ? std::optional(sum) : std::nullopt;
}

/// Returns the mean scale of an element's user units, in those of the drawing.
double scaleOf(pugi::xml_node node) {
    double scale = 1;
    for (; node; node = node.parent())
        if (Affine map; readTransform(node.attribute("transform").value(), map)) scale *= map.scale();
    return scale;
}

double opacityOf(const pugi::xml_node& node) {
    const std::string value = valueOf(styleOf(node, {}), "opacity", "1");
    const double number = std::strtod(value.c_str(), nullptr);
    return std::isnan(number) ? 1 : std::clamp(value.ends_with('%') ? number / 100 : number, 0.0, 1.0);
}

/// Returns whether an element has several shapes, or one with a stroke, which overlap.
bool mayOverlap(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    if (name == "use" || name == "text") return true;
    int drawn = 0;
    for (const pugi::xml_node& child : node.children())
        if (isDrawn(child) && (++drawn > 1 || mayOverlap(child))) return true;
    return valueOf(styleOf(node, {}), "stroke", "none") != "none";
}

pugi::xml_node firstLayer(const pugi::xml_node& parent);

/// Returns whether an element is composited. With an opacity, also what has such elements in it: that would
/// be drawn both with them and with what clips them.
bool isLayer(const pugi::xml_node& node) {
    return clipOf(node) || maskOf(node) || blurOf(node) ||
           (opacityOf(node) < 1 && (mayOverlap(node) || firstLayer(node)));
}

/// Finds the first element that is composited, in the order of the drawing.
pugi::xml_node firstLayer(const pugi::xml_node& parent) {
    for (const pugi::xml_node& node : parent.children()) {
        if (!isDrawn(node)) continue;
        if (isLayer(node)) return node;
        if (const pugi::xml_node found = firstLayer(node)) return found;
    }
    return {};
}

using Ids = std::set<std::string, std::less<>>;

/// Returns the ids that uses refer to.
Ids usedIn(const pugi::xml_document& document) {
    Ids used;
    document.find_node([&](const pugi::xml_node& node) {
        if (std::string_view(node.name()) == "use") used.insert(SvgElements::hrefOf(node));
        return false;
    });
    return used;
}

void removeIds(pugi::xml_node node) {
    node.remove_attribute("id");
    for (const pugi::xml_node& child : node.children()) removeIds(child);
}

/// Makes a use a group with a copy of what it refers to. The element stays: it may be referred to itself.
void makeGroup(pugi::xml_node use, const pugi::xml_node& target) {
    const auto place = [&](const char* name) {
        const std::string value = use.attribute(name).value();
        return value.empty() ? std::string("0") : value;
    };
    const std::string transform =
        std::string(use.attribute("transform").value()) + " translate(" + place("x") + ' ' + place("y") + ')';
    for (const char* name : {"x", "y", "width", "height", "href", "xlink:href", "transform"})
        use.remove_attribute(name);
    use.set_name("g");
    use.append_attribute("transform") = transform.c_str();
    removeIds(use.append_copy(target));
}

using NodesById = std::map<std::string, pugi::xml_node, std::less<>>;

bool isWithin(pugi::xml_node node, const pugi::xml_node& around) {
    while (node && node != around) node = node.parent();
    return bool(node);
}

/// Calls `take` with the uses in a node, or itself, and what they refer to.
void forUsesIn(const pugi::xml_node& root, const NodesById& byId,
               const std::function<void(const pugi::xml_node& use, const pugi::xml_node& target)>& take) {
    const auto look = [&](const pugi::xml_node& node) {
        if (std::string_view(node.name()) != "use") return false;
        if (const auto found = byId.find(SvgElements::hrefOf(node)); found != byId.end())
            take(node, found->second);
        return false;
    };
    look(root);
    root.find_node(look);
}

/// Returns whether an element is in what uses in it refer to.
bool usesItself(const pugi::xml_node& element, const NodesById& byId) {
    std::vector<pugi::xml_node> seen{element};
    bool isFound = false;
    for (std::size_t k = 0; k < seen.size() && !isFound; ++k)
        forUsesIn(pugi::xml_node(seen[k]), byId, [&](const pugi::xml_node&, const pugi::xml_node& target) {
            isFound = isFound || isWithin(element, target);
            if (std::ranges::find(seen, target) == seen.end()) seen.push_back(target);
        });
    return isFound;
}

/// Makes groups of uses of what has layers in it, also of other such uses: only elements of the drawing
/// itself are composited. Symbols stay, which have a view of their own.
void replaceUsesOfLayers(pugi::xml_document& document) {
    NodesById byId;
    document.find_node([&](const pugi::xml_node& node) {
        if (const pugi::xml_attribute id = node.attribute("id")) byId.emplace(id.value(), node);
        return false;
    });
    int left = kMostCopied;
    for (bool isDone = false; !isDone;) {
        std::vector<std::pair<pugi::xml_node, pugi::xml_node>> uses;
        forUsesIn(document, byId, [&](const pugi::xml_node& use, const pugi::xml_node& target) {
            if (isDrawn(target) && std::string_view(target.name()) != "svg" &&
                (isLayer(target) || firstLayer(target)) && !isWithin(use, target) &&
                !usesItself(target, byId))
                uses.emplace_back(use, target);
        });
        isDone = uses.empty();
        for (const auto& [use, target] : uses) {
            target.find_node([&left](const pugi::xml_node&) { return left-- == 0; });
            if (left < 0) return;
            makeGroup(use, target);
        }
    }
}

/// Moves an element to definitions, where it is not drawn, but may be used.
void moveToDefinitions(pugi::xml_node node) {
    node.remove_attribute(kMark);
    pugi::xml_node root = node;
    while (root.parent() != node.root()) root = root.parent();
    pugi::xml_node place = root.first_child();
    if (!place.attribute(kRetired)) {
        place = root.prepend_child("defs");
        place.append_attribute(kRetired) = "";
    }
    place.append_move(node);
}

/// Removes an element from what is drawn, but for those in it that something else may refer to.
void retire(pugi::xml_node node, const Ids& used) {
    if (!isDrawn(node) || used.contains(node.attribute("id").value())) return moveToDefinitions(node);
    for (pugi::xml_node child = node.first_child(), next; child; child = next) {
        next = child.next_sibling();
        if (child.type() == pugi::node_element) retire(child, used);
    }
    node.parent().remove_child(node);
}

/// Moves clip paths and masks among the drawn elements to definitions: Qt's library would draw them.
void retireClips(const pugi::xml_node& parent) {
    for (pugi::xml_node node = parent.first_child(), next; node; node = next) {
        next = node.next_sibling();
        const std::string_view name = node.name();
        if (name == "clipPath" || name == "mask")
            moveToDefinitions(node);
        else if (name != "defs")
            retireClips(node);
    }
}

/// Returns whether a shape, text or picture is drawn within a node.
bool drawsAny(const pugi::xml_node& parent) {
    return std::ranges::any_of(parent.children(), [](const pugi::xml_node& node) {
        const std::string_view name = node.name();
        const bool holds = name == "g" || name == "a" || name == "svg" || name == "switch";
        return isDrawn(node) && (!holds || drawsAny(node));
    });
}

enum class Side { Before, After };

/// Removes what is drawn on a side of an element, all the way up; definitions stay.
void removeSide(pugi::xml_node node, Side side, const Ids& used) {
    const auto next = [side](const pugi::xml_node& one) {
        return side == Side::Before ? one.previous_sibling() : one.next_sibling();
    };
    for (; node.parent(); node = node.parent())
        for (pugi::xml_node other = next(node), then; other; other = then) {
            then = next(other);
            if (isDrawn(other)) retire(other, used);
        }
}

/// Returns the transform list that takes the unit square to a box.
std::string fromUnitSquare(const QRectF& box) {
    std::string text = "matrix(" + numberText(box.width()) + " 0 0 " + numberText(box.height());
    return text + ' ' + numberText(box.x()) + ' ' + numberText(box.y()) + ')';
}

/// Puts the content of a clip path or a mask in the place of the marked element. `viewBox` is the drawing's.
void replaceByContent(const pugi::xml_document& drawing, const pugi::xml_node& node,
                      const pugi::xml_node& content, bool clips, const QRectF& viewBox, const Ids& used) {
    pugi::xml_node place = node.parent().insert_child_before("g", node);
    place.append_attribute("transform") = node.attribute("transform").value();
    pugi::xml_node inner = place.append_child("g");
    std::string transform = clips ? content.attribute("transform").value() : "";
    if (isOfBox(content, clips ? "clipPathUnits" : "maskContentUnits"))
        transform += ' ' + fromUnitSquare(boxOf(drawing, node, viewBox));
    inner.append_attribute("transform") = transform.c_str();
    inner.append_attribute("style") = "fill:#000;stroke:none;fill-opacity:1;fill-rule:nonzero";
    for (const pugi::xml_node& child : content.children()) {
        pugi::xml_node copy = inner.append_copy(child);
        if (!clips) continue;
        const std::string rule = valueOf(styleOf(child, styleOf(content, {})), "clip-rule");
        for (const char* paint : {"fill", "stroke", "fill-opacity", "opacity", "fill-rule"})
            removeProperty(copy, paint);
        if (!rule.empty()) copy.append_attribute("fill-rule") = rule.c_str();
    }
    removeSide(node, Side::After, used);
    removeSide(place, Side::Before, used);
    retire(node, used);
}

using Rgba = std::array<uchar, 4>;

/// A picture of a part of the drawing, with its first pixel at a place of it.
struct PaintedArea {
    QImage image;
    QRect area;

    /// Returns the pixels of a row of the drawing from a column of it on.
    Rgba* pixels(int x, int y) {
        return reinterpret_cast<Rgba*>(image.scanLine(y - area.y())) + (x - area.x());
    }
    const Rgba* pixels(int x, int y) const {
        return reinterpret_cast<const Rgba*>(image.constScanLine(y - area.y())) + (x - area.x());
    }
};

/// Returns the box of the pixels that are not transparent.
QRect visibleIn(const PaintedArea& painted) {
    const QRect& area = painted.area;
    int left = area.right() + 1, right = area.left() - 1, top = area.bottom() + 1, bottom = area.top() - 1;
    const auto isVisible = [](const Rgba& pixel) { return pixel[3] > 0; };
    for (int y = area.top(); y <= area.bottom(); ++y) {
        const Rgba *begin = painted.pixels(area.left(), y), *end = begin + area.width();
        const Rgba* first = std::find_if(begin, end, isVisible);
        if (first == end) continue;
        const Rgba* last = end - 1;
        while (!isVisible(*last)) --last;
        left = std::min(left, area.left() + static_cast<int>(first - begin));
        right = std::max(right, area.left() + static_cast<int>(last - begin));
        top = std::min(top, y), bottom = y;
    }
    return {QPoint(left, top), QPoint(right, bottom)};
}

/// Draws documents, which it changes.
class SvgPainter {
  public:
    SvgPainter(const QRectF& viewBox, const QSize& size, Ids used)
        : m_viewBox(viewBox), m_size(size), m_used(std::move(used)) {}

    QImage painted(pugi::xml_document& document) {
        return painted(document, QRect(QPoint(), m_size), 0).image;
    }

  private:
    PaintedArea painted(pugi::xml_document& document, const QRect& area, int depth) {
        PaintedArea result{QImage(area.size(), QImage::Format_RGBA8888_Premultiplied), area};
        if (result.image.isNull()) throw std::bad_alloc();
        result.image.fill(Qt::transparent);
        QPainter painter(&result.image);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        painter.translate(-area.topLeft());
        while (depth < kDeepest && m_layers < kMostLayers) {
            pugi::xml_node layer = firstLayer(document.document_element());
            if (!layer) break;
            ++m_layers;
            layer.append_attribute(kMark) = "";
            pugi::xml_document before;
            before.reset(document);
            const pugi::xml_node marked = markedIn(before);
            removeSide(marked, Side::After, m_used);
            retire(marked, m_used);
            plain(before, painter);
            const PaintedArea own = layerOf(document, area, depth);
            painter.drawImage(own.area.topLeft(), own.image);
            removeSide(layer, Side::Before, m_used);
            retire(layer, m_used);
        }
        plain(document, painter);
        return result;
    }

    void plain(const pugi::xml_document& document, QPainter& painter) const {
        if (!drawsAny(document.document_element())) return;
        const std::string text = textOf(document);
        QSvgRenderer renderer(QByteArray(text.data(), static_cast<qsizetype>(text.size())));
        renderer.render(&painter, QRectF(QPointF(), QSizeF(m_size)));
    }

    /// Returns a box around what a document draws in an area, seen from afar and without its clips and masks.
    QRect drawnIn(const pugi::xml_document& document, const QRect& area) const {
        constexpr int kCoarse = 8;
        if (document.find_node([](const pugi::xml_node& node) { return isDrawn(node) && blurOf(node); }))
            return area;
        PaintedArea coarse{QImage(area.size() / kCoarse + QSize(2, 2), QImage::Format_RGBA8888_Premultiplied),
                           {}};
        if (coarse.image.isNull()) throw std::bad_alloc();
        coarse.area = coarse.image.rect();
        coarse.image.fill(Qt::transparent);
        QPainter painter(&coarse.image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(1.0 / kCoarse, 1.0 / kCoarse);
        painter.translate(-area.topLeft());
        plain(document, painter);
        painter.end();
        const QRect seen = visibleIn(coarse);
        if (seen.isEmpty()) return {};
        const QRect box(kCoarse * (seen.topLeft() - QPoint(1, 1)), kCoarse * (seen.size() + QSize(2, 2)));
        return box.translated(area.topLeft()) & area;
    }

    /// Draws the marked element of a document as one picture, where it is seen of an area.
    PaintedArea layerOf(const pugi::xml_document& document, QRect area, int depth) {
        pugi::xml_document own;
        own.reset(document);
        pugi::xml_node node = markedIn(own);
        const double opacity = opacityOf(node);
        PaintedArea clip, mask;
        for (const bool clips : {true, false}) {
            if (!(clips ? clipOf(node) : maskOf(node))) continue;
            PaintedArea& content = clips ? clip : mask;
            content = contentOf(document, clips, area, depth);
            area = visibleIn(content);
            if (area.isEmpty()) return {};
        }
        node.remove_attribute(kMark);
        const Deviations blur = blurInPixels(node);
        const bool isBlurred = blur.x > 0 || blur.y > 0;
        for (const char* name : {"opacity", "clip-path", "mask", "filter"}) removeProperty(node, name);
        for (const Side side : {Side::Before, Side::After}) removeSide(node, side, m_used);
        const int left = isBlurred ? reachOfBlur(blur.x) : 0, top = isBlurred ? reachOfBlur(blur.y) : 0;
        if (clip.image.isNull() && mask.image.isNull())
            area &= drawnIn(own, area.adjusted(-left, -top, left, top)).adjusted(-left, -top, left, top);
        if (area.isEmpty()) return {};
        PaintedArea layer = isBlurred ? blurred(own, blur, area, depth) : painted(own, area, depth + 1);
        const bool byAlpha = valueOf(styleOf(maskOf(markedIn(document)), {}), "mask-type") == "alpha";
        for (int y = area.top(); y <= area.bottom(); ++y) {
            Rgba* row = layer.pixels(area.left(), y);
            const Rgba* by = clip.image.isNull() ? nullptr : clip.pixels(area.left(), y);
            const Rgba* through = mask.image.isNull() ? nullptr : mask.pixels(area.left(), y);
            for (int x = 0; x < area.width(); ++x) {
                double factor = opacity;
                if (by) factor *= by[x][3] / 255.0;
                if (through) factor *= (byAlpha ? through[x][3] : lightnessOf(through[x])) / 255.0;
                if (factor == 1) continue;
                for (uchar& number : row[x]) number = static_cast<uchar>(number * factor + 0.5);
            }
        }
        return layer;
    }

    /// Returns by how much an element is blurred, at most by the size of the picture.
    Deviations blurInPixels(const pugi::xml_node& node) const {
        const Deviations by = blurOf(node).value_or(Deviations());
        const double scale = scaleOf(node) * m_size.width() / m_viewBox.width();
        return {std::fmin(scale * by.x, m_size.width()), std::fmin(scale * by.y, m_size.height())};
    }

    /// Draws a document blurred, also by what is beside the area.
    PaintedArea blurred(pugi::xml_document& document, const Deviations& by, const QRect& area, int depth) {
        const int x = std::min(m_size.width() / 2, reachOfBlur(by.x)),
                  y = std::min(m_size.height() / 2, reachOfBlur(by.y));
        PaintedArea whole = painted(document, area.adjusted(-x, -y, x, y), depth + 1);
        blur(whole.image, by.y, by.x);
        return {whole.image.copy(x, y, area.width(), area.height()), area};
    }

    /// Returns the luminance of a premultiplied pixel.
    static double lightnessOf(const Rgba& pixel) {
        return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
    }

    /// Draws what clips or masks the marked element.
    PaintedArea contentOf(const pugi::xml_document& document, bool clips, const QRect& area, int depth) {
        pugi::xml_document own;
        own.reset(document);
        const pugi::xml_node node = markedIn(own);
        replaceByContent(own, node, clips ? clipOf(node) : maskOf(node), clips, m_viewBox, m_used);
        return painted(own, area, depth + 1);
    }

    QRectF m_viewBox;
    QSize m_size;
    Ids m_used;
    int m_layers = 0;
};

}  // namespace

QImage paintedSvg(const pugi::xml_document& drawing, const QRectF& viewBox, const QSize& size) {
    pugi::xml_document document;
    document.reset(drawing);
    resolveStyleSheets(document);
    replaceUsesOfLayers(document);
    const bool isPlain = !firstLayer(document.document_element());
    if (isPlain) document.reset(drawing);  // Qt's library reads style sheets itself
    retireClips(document.document_element());
    return SvgPainter(viewBox, size, usedIn(document)).painted(document);
}

}  // namespace wend
