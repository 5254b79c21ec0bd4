#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace wend {

/// Values of properties by their names.
using SvgStyle = std::map<std::string, std::string, std::less<>>;

/// Writes what style sheets in a drawing say into the style attributes of the elements that they select, and
/// removes them. Selectors are types, classes and ids, and chains of these; others select nothing.
void resolveStyleSheets(pugi::xml_document& document);

/// Returns the properties of an element: its attributes, and its style in their place. Those that children
/// inherit come from `parent` where it has none.
SvgStyle styleOf(const pugi::xml_node& node, const SvgStyle& parent);

/// Returns whether children inherit a property.
bool isInherited(std::string_view property);

/// Returns a value without blanks around it.
std::string trimmed(std::string_view text);

/// Returns the property, or `otherwise`.
std::string valueOf(const SvgStyle& style, std::string_view property, const char* otherwise = "");

/// Returns whether an element measures in parts of the box around what refers to it: what its attribute
/// `units` says.
bool isOfBox(const pugi::xml_node& node, const char* units);

/// Returns the id that url(#id) names; empty for anything else.
std::string idInUrl(std::string_view value);

}  // namespace wend
