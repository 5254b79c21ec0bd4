#include "warp/svg/svg_paints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace wend {
namespace {

constexpr int kLongestChain = 32;

std::string attributeIn(const std::vector<pugi::xml_node>& chain, const char* name) {
    for (const pugi::xml_node& node : chain)
        if (const pugi::xml_attribute found = node.attribute(name)) return found.value();
    return {};
}

bool isOfBox(const std::vector<pugi::xml_node>& chain, const char* units) {
    return attributeIn(chain, units) != "userSpaceOnUse";
}

/// Takes the unit square to a box.
Affine boxMap(const QRectF& box) {
    return {Mat2(Vec2(box.width(), box.height()).asDiagonal()), Vec2(box.x(), box.y())};
}

void setNumber(pugi::xml_node node, const char* name, double value) {
    node.append_attribute(name) = numberText(value).c_str();
}

}  // namespace

SvgElements::SvgElements(const pugi::xml_document& document) {
    for (const auto& found : document.select_nodes("//*[@id]"))
        m_byId.try_emplace(found.node().attribute("id").value(), found.node());
}

pugi::xml_node SvgElements::byId(const std::string& id) const {
    const auto found = m_byId.find(id);
    return found == m_byId.end() ? pugi::xml_node() : found->second;
}

std::string SvgElements::hrefOf(const pugi::xml_node& node) {
    for (const char* name : {"href", "xlink:href"})
        if (const pugi::xml_attribute href = node.attribute(name)) {
            const std::string value = trimmed(href.value());
            return value.starts_with('#') ? value.substr(1) : std::string();
        }
    return {};
}

std::vector<pugi::xml_node> SvgElements::chainOf(const pugi::xml_node& node) const {
    std::vector<pugi::xml_node> chain;
    for (pugi::xml_node one = node; one; one = byId(hrefOf(one))) {
        if (chain.size() == kLongestChain || std::ranges::find(chain, one) != chain.end())
            throw InputError("its \"" + std::string(node.attribute("id").value()) +
                             "\" takes attributes from itself");
        chain.push_back(one);
    }
    return chain;
}

double lengthOf(std::string_view text, double whole, double otherwise) {
    NumberScanner scanner(text);
    double value = 0;
    if (!scanner.number(value)) return otherwise;
    if (scanner.skip('%')) return value / 100 * whole;
    constexpr std::array kUnits{std::pair("pt", 4.0 / 3),   std::pair("pc", 16.0),
                                std::pair("mm", 96 / 25.4), std::pair("cm", 96 / 2.54),
                                std::pair("in", 96.0),      std::pair("em", 16.0),
                                std::pair("ex", 8.0),       std::pair("q", 24 / 25.4)};
    const std::string_view unit = scanner.word();
    const auto found = std::ranges::find(kUnits, unit, [](const auto& one) { return one.first; });
    return found == kUnits.end() ? value : value * found->second;
}

std::string SvgPaints::paint(const SvgStyle& style, const std::string& property, const Affine& map,
                             const QRectF& box, const Vec2& viewport) {
    const std::string value = valueOf(style, property, property == "fill" ? "black" : "none");
    if (value == "currentColor" || value == "currentcolor") return valueOf(style, "color", "black");
    if (!value.starts_with("url(")) return value.starts_with("context-") ? "none" : value;
    const std::string id = idInUrl(value);
    const std::string fallback =
        trimmed(std::string_view(value).substr(std::min(value.find(')'), value.size() - 1) + 1));
    const pugi::xml_node node = m_elements.byId(id);
    const std::string kind = node.name();
    std::string own;
    if (kind == "linearGradient" || kind == "radialGradient")
        own = gradient(m_elements.chainOf(node), map, box, viewport);
    else if (kind == "pattern")
        own = pattern(m_elements.chainOf(node), map, box, viewport);
    else
        m_tell("its paint " + value.substr(0, 60) + " is missing");
    if (!own.empty()) return "url(#" + own + ")";
    return fallback.empty() ? "none" : fallback;
}

/// Returns the id of a gradient that has the stops of this one alone.
std::string SvgPaints::stopsOf(const pugi::xml_node& node) {
    const auto chain = m_elements.chainOf(node);
    const auto isStop = [](const pugi::xml_node& child) { return std::string_view(child.name()) == "stop"; };
    const auto owner =
        std::ranges::find_if(chain, [&](const pugi::xml_node& one) { return bool(one.find_child(isStop)); });
    if (owner == chain.end()) return {};
    std::string& id = m_stops[owner->attribute("id").value()];
    if (!id.empty()) return id;
    id = "wend-s" + std::to_string(m_stops.size());
    pugi::xml_node stops = m_defs.append_child("linearGradient");
    stops.append_attribute("id") = id.c_str();
    const SvgStyle outer = wend::styleOf(*owner, {});
    for (const pugi::xml_node& stop : owner->children("stop")) {
        const SvgStyle style = wend::styleOf(stop, outer);
        pugi::xml_node copy = stops.append_child("stop");
        copy.append_attribute("offset") = stop.attribute("offset").value();
        const std::string colour = valueOf(style, "stop-color", "black");
        const bool isCurrent = colour == "currentColor";
        copy.append_attribute("stop-color") = (isCurrent ? valueOf(style, "color", "black") : colour).c_str();
        if (const std::string opacity = valueOf(style, "stop-opacity", "1"); opacity != "1")
            copy.append_attribute("stop-opacity") = opacity.c_str();
    }
    return id;
}

std::string SvgPaints::gradient(const std::vector<pugi::xml_node>& chain, const Affine& map,
                                const QRectF& box, const Vec2& viewport) {
    const std::string stops = stopsOf(chain.front());
    const bool ofBox = isOfBox(chain, "gradientUnits");
    if (stops.empty() || (ofBox && (box.width() <= 0 || box.height() <= 0))) return {};
    const std::string id = "wend-g" + std::to_string(++m_count), kind = chain.front().name();
    pugi::xml_node own = m_defs.append_child(kind.c_str());
    own.append_attribute("id") = id.c_str();
    own.append_attribute("xlink:href") = ("#" + stops).c_str();
    own.append_attribute("gradientUnits") = "userSpaceOnUse";
    const Vec2 whole = ofBox ? Vec2(1, 1) : viewport;
    const double diagonal = std::sqrt(whole.squaredNorm() / 2);
    const auto copy = [&](const char* name, double of, const char* standard) {
        std::string text = attributeIn(chain, name);
        if (text.empty()) text = standard;
        const double value = lengthOf(text, of, 0);
        setNumber(own, name, value);
        return value;
    };
    if (kind == "linearGradient") {
        copy("x1", whole.x(), "0"), copy("y1", whole.y(), "0");
        copy("x2", whole.x(), "100%"), copy("y2", whole.y(), "0");
    } else {
        const std::string cx = numberText(copy("cx", whole.x(), "50%"));
        const std::string cy = numberText(copy("cy", whole.y(), "50%"));
        copy("r", diagonal, "50%");
        copy("fx", whole.x(), cx.c_str()), copy("fy", whole.y(), cy.c_str());
    }
    if (const std::string spread = attributeIn(chain, "spreadMethod"); !spread.empty())
        own.append_attribute("spreadMethod") = spread.c_str();
    Affine transform = ofBox ? map * boxMap(box) : map;
    readTransform(attributeIn(chain, "gradientTransform"), transform);
    own.append_attribute("gradientTransform") = transformText(transform).c_str();
    return id;
}

std::string SvgPaints::pattern(const std::vector<pugi::xml_node>& chain, const Affine& map, const QRectF& box,
                               const Vec2& viewport) {
    const bool ofBox = isOfBox(chain, "patternUnits");
    const std::string original = chain.front().attribute("id").value();
    if ((ofBox && (box.width() <= 0 || box.height() <= 0)) || !keep(original)) return {};
    const std::string id = "wend-g" + std::to_string(++m_count);
    pugi::xml_node own = m_defs.append_child("pattern");
    own.append_attribute("id") = id.c_str();
    own.append_attribute("xlink:href") = ("#" + original).c_str();
    own.append_attribute("patternUnits") = "userSpaceOnUse";
    const Vec2 from = ofBox ? Vec2(box.x(), box.y()) : Vec2(0, 0);
    const Vec2 whole = ofBox ? Vec2(1, 1) : viewport;
    const Vec2 unit = ofBox ? Vec2(box.width(), box.height()) : Vec2(1, 1);
    setNumber(own, "x", from.x() + unit.x() * lengthOf(attributeIn(chain, "x"), whole.x(), 0));
    setNumber(own, "y", from.y() + unit.y() * lengthOf(attributeIn(chain, "y"), whole.y(), 0));
    setNumber(own, "width", unit.x() * lengthOf(attributeIn(chain, "width"), whole.x(), 0));
    setNumber(own, "height", unit.y() * lengthOf(attributeIn(chain, "height"), whole.y(), 0));
    Affine transform = map;
    readTransform(attributeIn(chain, "patternTransform"), transform);
    own.append_attribute("patternTransform") = transformText(transform).c_str();
    m_tell({sentence("Core", "its pattern \"%1\" turns and stretches with each shape, but is not bent"),
            original});
    return id;
}

bool SvgPaints::keep(const std::string& id) {
    const pugi::xml_node node = m_elements.byId(id);
    if (!node) return false;
    if (!m_kept.insert(id).second) return true;
    m_defs.append_copy(node);
    keepReferences(node);
    return true;
}

void SvgPaints::keepReferences(const pugi::xml_node& node) {
    std::vector<pugi::xml_node> open{node};
    while (!open.empty()) {
        const pugi::xml_node one = open.back();
        open.pop_back();
        if (const std::string href = SvgElements::hrefOf(one); !href.empty()) keep(href);
        for (const pugi::xml_attribute& attribute : one.attributes()) {
            const std::string_view value = attribute.value();
            for (std::size_t at = 0; (at = value.find("url(", at)) != std::string_view::npos; ++at)
                if (const std::string id = idInUrl(value.substr(at)); !id.empty()) keep(id);
        }
        for (const pugi::xml_node& child : one.children())
            if (child.type() == pugi::node_element) open.push_back(child);
    }
}

}  // namespace wend
