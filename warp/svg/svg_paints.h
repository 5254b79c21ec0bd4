#pragma once

#include <QRectF>
#include <functional>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "warp/svg/svg_style.h"
#include "warp/svg_path.h"

namespace wend {

/// The elements of a drawing by their ids, and what is read of them.
class SvgElements {
  public:
    explicit SvgElements(const pugi::xml_document& document);

    /// Returns an element, or none.
    pugi::xml_node byId(const std::string& id) const;
    /// Returns the id of the element that a node's href names; empty for other places.
    static std::string hrefOf(const pugi::xml_node& node);
    /// Returns the node and those that it inherits attributes from (href). Throws InputError if it inherits
    /// from itself.
    std::vector<pugi::xml_node> chainOf(const pugi::xml_node& node) const;

  private:
    std::map<std::string, pugi::xml_node, std::less<>> m_byId;
};

/// Returns a length in user units; `whole` is that of which it may be a part in percent.
double lengthOf(std::string_view text, double whole, double otherwise);

/// Makes the paints of paths: gradients and patterns of their own, in <defs>.
class SvgPaints {
  public:
    SvgPaints(const SvgElements& elements, pugi::xml_node defs, std::function<void(const Message&)> tell)
        : m_elements(elements), m_defs(defs), m_tell(std::move(tell)) {}

    /// Returns the paint of a path; `map` leads from its own coordinates, in which `box` is around it, to
    /// those of the view box.
    std::string paint(const SvgStyle& style, const std::string& property, const Affine& map,
                      const QRectF& box, const Vec2& viewport);
    /// Copies an element to <defs> as it is, with all that it refers to. Returns whether it is there.
    bool keep(const std::string& id);

  private:
    std::string gradient(const std::vector<pugi::xml_node>& chain, const Affine& map, const QRectF& box,
                         const Vec2& viewport);
    std::string pattern(const std::vector<pugi::xml_node>& chain, const Affine& map, const QRectF& box,
                        const Vec2& viewport);
    std::string stopsOf(const pugi::xml_node& node);
    void keepReferences(const pugi::xml_node& node);

    const SvgElements& m_elements;
    pugi::xml_node m_defs;
    std::function<void(const Message&)> m_tell;
    std::map<std::string, std::string> m_stops;  // by the id of the gradient
    std::set<std::string> m_kept;
    int m_count = 0;
};

}  // namespace wend
