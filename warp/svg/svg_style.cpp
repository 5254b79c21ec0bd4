#include "warp/svg/svg_style.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace wend {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";

/// A compound selector such as path.line#top.
struct Compound {
    std::string type, id;
    std::vector<std::string> classes;
    bool isChild = false;  // of what stands before it, not any descendant
    bool isKnown = true;
};

struct Rule {
    std::vector<Compound> selector;
    std::string style;

    int weight() const {
        int sum = 0;
        for (const Compound& one : selector)
            sum += (one.id.empty() ? 0 : 10000) + 100 * static_cast<int>(one.classes.size()) +
                   (one.type.empty() ? 0 : 1);
        return sum;
    }
};

Compound compoundOf(std::string_view text) {
    Compound one;
    while (!text.empty()) {
        const char kind = text.front();
        const bool isMarked = kind == '.' || kind == '#' || kind == '*';
        if (isMarked) text.remove_prefix(1);
        const auto end = std::min(text.find_first_of(".#:[*"), text.size());
        const std::string name(text.substr(0, end));
        if (kind == '.')
            one.classes.push_back(name);
        else if (kind == '#')
            one.id = name;
        else if (kind == ':' || kind == '[')
            one.isKnown = false;
        else if (kind != '*')
            one.type = name;
        if (!one.isKnown || (end == 0 && kind != '*')) return one.isKnown = false, one;
        text.remove_prefix(end);
    }
    return one;
}

std::vector<Compound> selectorOf(std::string_view text) {
    std::vector<Compound> selector;
    bool isChild = false;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        if (text.empty()) return selector;
        if (text.front() == '>') {
            isChild = true;
            text.remove_prefix(1);
            continue;
        }
        const auto end = std::min(text.find_first_of(" \t\r\n\f>"), text.size());
        selector.push_back(compoundOf(text.substr(0, end)));
        selector.back().isChild = std::exchange(isChild, false);
        text.remove_prefix(end);
    }
}

std::string withoutComments(std::string text) {
    for (std::size_t at = 0; (at = text.find("/*", at)) != std::string::npos;) {
        const auto end = text.find("*/", at + 2);
        text.erase(at, end == std::string::npos ? std::string::npos : end + 2 - at);
    }
    for (const std::string_view mark : {"<!--", "-->"})
        for (std::size_t at = 0; (at = text.find(mark)) != std::string::npos;) text.erase(at, mark.size());
    return text;
}

/// Returns where the block that begins at `open` ends, with those in it.
std::size_t endOfBlock(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        if (text[at] == '{') ++depth;
        if (text[at] == '}' && --depth == 0) return at;
    }
    return text.size();
}

void readRules(std::string_view text, std::vector<Rule>& rules) {
    while (true) {
        const auto open = text.find('{'), semicolon = text.find(';');
        if (semicolon < open && trimmed(text.substr(0, semicolon)).starts_with('@')) {
            text.remove_prefix(semicolon + 1);  // @import
            continue;
        }
        if (open == std::string_view::npos) return;
        const auto close = endOfBlock(text, open);
        std::string_view selectors = text.substr(0, open);
        const std::string style = trimmed(text.substr(open + 1, close - open - 1));
        if (!trimmed(selectors).starts_with('@'))
            while (!selectors.empty()) {
                const auto comma = std::min(selectors.find(','), selectors.size());
                std::vector<Compound> selector = selectorOf(selectors.substr(0, comma));
                if (!selector.empty() && std::ranges::all_of(selector, &Compound::isKnown))
                    rules.push_back({std::move(selector), style});
                selectors.remove_prefix(std::min(comma + 1, selectors.size()));
            }
        text.remove_prefix(std::min(close + 1, text.size()));
    }
}

bool hasClass(const pugi::xml_node& node, const std::string& name) {
    const std::string all = ' ' + std::string(node.attribute("class").value()) + ' ';
    return all.find(' ' + name + ' ') != std::string::npos;
}

bool fits(const Compound& one, const pugi::xml_node& node) {
    if (node.type() != pugi::node_element) return false;
    if (!one.type.empty() && one.type != node.name()) return false;
    if (!one.id.empty() && one.id != node.attribute("id").value()) return false;
    return std::ranges::all_of(one.classes, [&](const std::string& name) { return hasClass(node, name); });
}

bool selects(const std::vector<Compound>& selector, pugi::xml_node node) {
    if (!fits(selector.back(), node)) return false;
    for (std::size_t k = selector.size() - 1; k-- > 0;) {
        const bool isChild = selector[k + 1].isChild;
        node = node.parent();
        while (!isChild && node && !fits(selector[k], node)) node = node.parent();
        if (!node || !fits(selector[k], node)) return false;
    }
    return true;
}

/// The properties that are attributes, too.
constexpr const char* kProperties[] = {"fill",
                                       "fill-rule",
                                       "fill-opacity",
                                       "stroke",
                                       "stroke-width",
                                       "stroke-opacity",
                                       "stroke-linecap",
                                       "stroke-linejoin",
                                       "stroke-miterlimit",
                                       "stroke-dasharray",
                                       "stroke-dashoffset",
                                       "paint-order",
                                       "clip-rule",
                                       "color",
                                       "visibility",
                                       "marker",
                                       "marker-start",
                                       "marker-mid",
                                       "marker-end",
                                       "font-family",
                                       "font-size",
                                       "font-weight",
                                       "font-style",
                                       "font-variant",
                                       "font-stretch",
                                       "text-anchor",
                                       "text-decoration",
                                       "letter-spacing",
                                       "word-spacing",
                                       "opacity",
                                       "display",
                                       "clip-path",
                                       "mask",
                                       "filter",
                                       "mix-blend-mode",
                                       "isolation",
                                       "vector-effect",
                                       "stop-color",
                                       "stop-opacity",
                                       "shape-rendering"};

}  // namespace

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(kBlanks) + 1 - first));
}

void resolveStyleSheets(pugi::xml_document& document) {
    std::vector<Rule> rules;
    for (const auto& found : document.select_nodes("//*[local-name()='style']")) {
        std::string text;
        for (const pugi::xml_node& part : found.node().children()) text += part.value();
        readRules(withoutComments(std::move(text)), rules);
        found.node().parent().remove_child(found.node());
    }
    if (rules.empty()) return;
    std::ranges::stable_sort(rules, {}, &Rule::weight);
    for (const auto& found : document.select_nodes("//*")) {
        pugi::xml_node node = found.node();
        std::string style;
        for (const Rule& rule : rules)
            if (selects(rule.selector, node)) style += rule.style + ';';
        if (style.empty()) continue;
        style += node.attribute("style").value();
        node.remove_attribute("style");
        node.append_attribute("style") = style.c_str();
    }
}

bool isInherited(std::string_view property) {
    constexpr std::array kOwn{"opacity",    "display",        "clip-path",     "mask",
                              "filter",     "mix-blend-mode", "isolation",     "transform",
                              "stop-color", "stop-opacity",   "vector-effect", "enable-background",
                              "overflow",   "flood-color",    "flood-opacity"};
    return std::ranges::find(kOwn, property) == kOwn.end();
}

SvgStyle styleOf(const pugi::xml_node& node, const SvgStyle& parent) {
    SvgStyle style;
    for (const auto& [property, value] : parent)
        if (isInherited(property)) style[property] = value;
    const auto set = [&](const std::string& property, std::string value) {
        if (const auto mark = value.find("!important"); mark != std::string::npos)
            value = trimmed(value.substr(0, mark));
        if (value == "inherit") value = valueOf(parent, property);
        if (value.empty())
            style.erase(property);
        else
            style[property] = value;
    };
    for (const char* property : kProperties)
        if (const pugi::xml_attribute attribute = node.attribute(property))
            set(property, trimmed(attribute.value()));
    std::string_view text = node.attribute("style").value();
    while (!text.empty()) {
        const auto end = std::min(text.find(';'), text.size());
        const std::string_view one = text.substr(0, end);
        if (const auto colon = one.find(':'); colon != std::string_view::npos)
            set(trimmed(one.substr(0, colon)), trimmed(one.substr(colon + 1)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return style;
}

std::string valueOf(const SvgStyle& style, std::string_view property, const char* otherwise) {
    const auto found = style.find(property);
    return found == style.end() ? otherwise : found->second;
}

bool isOfBox(const pugi::xml_node& node, const char* units) {
    return std::string_view(node.attribute(units).value()) == "objectBoundingBox";
}

std::string idInUrl(std::string_view value) {
    const auto open = value.find("url("), close = value.find(')');
    if (open != 0 || close == std::string_view::npos) return {};
    std::string id = trimmed(value.substr(4, close - 4));
    std::erase_if(id, [](char c) { return c == '"' || c == '\''; });
    return id.starts_with('#') ? id.substr(1) : std::string();
}

}  // namespace wend
