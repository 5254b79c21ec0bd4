#include "core/mesh/formats/lost_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "core/mesh/formats/colours.h"
#include "core/mesh/formats/exodus.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/turned_normals.h"

namespace wend::formats {
namespace {

/// Says how a format holds a cell: whole, without nodes between corners, split, or not at all.
enum class Fate { Whole, Linear, Split, Lost };

CellKind partKind(int dimension) {
    constexpr CellKind kinds[] = {CellKind::Vertex, CellKind::Line, CellKind::Triangle,
                                  CellKind::Tetrahedron};
    return kinds[dimension];
}

Fate fateOf(const MeshFormat& format, CellKind kind) {
    if (format.holds(kind)) return Fate::Whole;
    if (linearKind(kind) != kind && format.holds(linearKind(kind))) return Fate::Linear;
    const int dimension = factsOf(kind).dimension;
    const bool splits = dimension >= 2 || kind == CellKind::PolyLine || kind == CellKind::PolyVertex;
    return splits && format.holds(partKind(dimension)) ? Fate::Split : Fate::Lost;
}

/// A list of cells that becomes the bag's, with the cell that each came from.
class Remaking {
  public:
    Remaking(const MeshFormat& format, MeshFile& bag) : m_format(format), m_bag(bag) {}

    /// Replaces every cell by what the format holds of it, and assigns values and groups to the new cells.
    void remake() {
        const CellList old = std::move(m_bag.cells);
        m_bag.cells = {};
        m_bag.cornerUv.clear();
        const auto triangles = std::move(m_bag.cellOfTriangle),
                   tetrahedra = std::move(m_bag.cellOfTetrahedron);
        m_bag.cellOfTriangle.assign(m_bag.triangles.size(), -1);
        m_bag.cellOfTetrahedron.assign(m_bag.tetrahedra.size(), -1);
        std::size_t t = 0, q = 0;  // in the order of the cells
        for (int c = 0; c < old.size(); ++c) {
            const std::size_t firstT = t, firstQ = q;
            while (t < triangles.size() && triangles[t] == c) ++t;
            while (q < tetrahedra.size() && tetrahedra[q] == c) ++q;
            take(old, c);
            addParts(m_bag.triangles, firstT, t, c, m_bag.cellOfTriangle);
            addParts(m_bag.tetrahedra, firstQ, q, c, m_bag.cellOfTetrahedron);
        }
        for (MeshField& field : m_bag.fields)
            if (field.perCell) {
                field.ofCells = taken(field.ofCells, field.components);
                if (!field.beyond.empty()) field.beyond = taken(field.beyond, field.components);
            }
        takeGroups(old.size());
    }

  private:
    /// Adds what the format holds of one cell.
    void take(const CellList& old, int c) {
        const CellKind kind = old.kinds[static_cast<std::size_t>(c)];
        m_fate = fateOf(m_format, kind);
        const auto nodes = old[c];
        if (m_fate == Fate::Whole) add(kind, nodes, c);
        if (m_fate == Fate::Linear)
            add(linearKind(kind), nodes.first(static_cast<std::size_t>(factsOf(kind).corners)), c);
        if (m_fate != Fate::Split || factsOf(kind).dimension >= 2) return;
        const std::size_t step = kind == CellKind::PolyLine ? 2 : 1;
        for (std::size_t k = 0; k + step <= nodes.size(); ++k)
            add(partKind(factsOf(kind).dimension), nodes.subspan(k, step), c);
    }
    template <std::size_t N>
    void addParts(const std::vector<std::array<int, N>>& parts, std::size_t first, std::size_t end, int c,
                  std::vector<int>& cellOf) {
        for (std::size_t k = first; k < end; ++k) {
            if (m_fate == Fate::Split) add(partKind(static_cast<int>(N) - 1), parts[k], c);
            cellOf[k] = m_fate == Fate::Lost ? -1 : m_bag.cells.size() - 1;
        }
    }
    void add(CellKind kind, std::span<const int> nodes, int from) {
        m_bag.cells.add(kind, nodes);
        m_from.push_back(from);
    }
    template <class T>
    std::vector<T> taken(const std::vector<T>& all, int components) const {
        std::vector<T> values;
        values.reserve(m_from.size() * static_cast<std::size_t>(components));
        for (const int c : m_from) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(c) * components;
            values.insert(values.end(), first, first + components);
        }
        return values;
    }
    /// Replaces the cells in all groups by the new ones.
    void takeGroups(int oldCount) {
        std::vector<char> within(static_cast<std::size_t>(oldCount), 0);
        for (MeshGroup& group : m_bag.groups) {
            for (const int c : group.cells) within[static_cast<std::size_t>(c)] = 1;
            std::vector<int> cells;
            for (std::size_t c = 0; c < m_from.size(); ++c)
                if (within[static_cast<std::size_t>(m_from[c])]) cells.push_back(static_cast<int>(c));
            for (const int c : group.cells) within[static_cast<std::size_t>(c)] = 0;
            group.cells = std::move(cells);
        }
        std::erase_if(m_bag.groups,
                      [](const MeshGroup& group) { return group.cells.empty() && group.vertices.empty(); });
    }

    const MeshFormat& m_format;
    MeshFile& m_bag;
    Fate m_fate = Fate::Whole;
    std::vector<int> m_from;
};

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < 4; ++i) text += (i ? ", " : " (") + names[i];
    return text.empty() ? text : text + (names.size() > 4 ? " …)" : ")");
}

bool namesATag(const MeshField& field) {
    constexpr std::string_view tags[] = {"physical", "entity",   "ref",   "attribute",
                                         "marker",   "material", "label", "partition"};
    return field.components == 1 && std::ranges::count(tags, field.name) > 0;
}

/// Returns whether Gmsh draws values of so many components; 2 and 4 are extended.
bool isHeldByGmsh(int components) {
    return components == 9 || (components >= 1 && components <= 4);
}

/// Returns whether a format without fields holds one as a tag, a colour, a normal or an attribute.
bool holdsField(const MeshFormat& format, const MeshField& field) {
    return namesATag(field) || (format.holdsColours && isColour(field, false)) ||
           (format.holdsFaceColours && isColour(field, true)) || (format.holdsNormals && isNormals(field)) ||
           (format.print == printTetgen && field.name == "attribute");
}

/// The restrictions of a format on names: bytes that are replaced by another, the maximum number of bytes,
/// and whether names that differ only in case are equal.
struct NameRule {
    std::string_view extension, replaced;
    char by;
    std::size_t longest;
    bool foldsCase;
};
constexpr std::size_t kAnyLength = 100000;
constexpr NameRule kNameRules[] = {{".obj", " \t", '_', kAnyLength, false},
                                   {".inp", ",\"=", '_', 80, true},
                                   {".msh", "\"", '\'', kAnyLength, false},
                                   {".med", "", '_', 80, false}};
/// The same for those of fields.
constexpr NameRule kFieldRules[] = {{".ply", " \t", '_', kAnyLength, false},
                                    {".msh", "\"", '\'', kAnyLength, false},
                                    {".med", "/", '_', 64, false},
                                    {".cgns", "/", '_', 32, false}};

const NameRule* ruleOf(const MeshFormat& format, std::span<const NameRule> rules) {
    const auto rule = std::ranges::find(rules, format.extensions.front(), &NameRule::extension);
    return rule == rules.end() ? nullptr : &*rule;
}

/// Returns whether a file has another name for a group or a field.
bool changesName(const MeshFormat& format, const std::string& name, std::span<const NameRule> rules) {
    const NameRule* rule = ruleOf(format, rules);
    return rule && (name.find_first_of(rule->replaced) != std::string::npos || name.size() > rule->longest);
}

/// Returns the first `size` bytes of a UTF-8 text, or less, so that no letter is cut.
std::string shortened(const std::string& text, std::size_t size) {
    if (text.size() <= size) return text;
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
    return text.substr(0, size);
}

/// Maps different names to different names in a file: names that would become equal get a number at their
/// end.
class DistinctNames {
  public:
    explicit DistinctNames(const NameRule& rule) : m_rule(rule) {}

    /// Keeps a name from being given to another one.
    void reserve(const std::string& name) { m_taken.insert(folded(name)); }
    /// Returns the name in the file, the same one for every call with a name.
    const std::string& of(const std::string& name) {
        const auto [known, isNew] = m_names.try_emplace(name);
        if (isNew) known->second = unused(name);
        return known->second;
    }
    /// Returns the names that got a number.
    const std::vector<std::string>& numbered() const { return m_numbered; }

  private:
    std::string unused(std::string name) {
        for (char& c : name)
            if (m_rule.replaced.find(c) != std::string_view::npos) c = m_rule.by;
        std::string one = shortened(name, m_rule.longest);
        for (int n = 2; !m_taken.insert(folded(one)).second; ++n) {
            const std::string end = "_" + std::to_string(n);
            one = shortened(name, m_rule.longest - end.size()) + end;
        }
        if (one != shortened(name, m_rule.longest)) m_numbered.push_back(one);
        return one;
    }
    std::string folded(std::string name) const {
        for (char& c : name)
            if (m_rule.foldsCase && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return name;
    }

    NameRule m_rule;
    std::map<std::string, std::string> m_names;
    std::set<std::string> m_taken;
    std::vector<std::string> m_numbered;
};

/// Gives groups the names that they have in a file, and returns those with a number at their end. Names that
/// the format allows as they are take precedence.
std::vector<std::string> nameGroupsFor(const MeshFormat& format, std::vector<MeshGroup>& groups) {
    const NameRule* rule = ruleOf(format, kNameRules);
    if (!rule) return {};
    DistinctNames names(*rule), materials({format.extensions.front(), "", '_', kAnyLength, false});
    for (const MeshGroup& group : groups)
        if (group.name.empty())
            names.reserve(format.print == printObj ? "ref_" + std::to_string(group.tag)
                          : format.print == printAbaqus
                              ? "SET-" + std::to_string(group.dimension) + "-" + std::to_string(group.tag)
                              : std::to_string(group.tag));
    for (const bool changed : {false, true})
        for (MeshGroup& group : groups)
            if (!group.name.empty() && changesName(format, group.name, kNameRules) == changed)
                (group.material && format.print == printObj ? materials : names).of(group.name);
    for (MeshGroup& group : groups)
        if (!group.name.empty())
            group.name = (group.material && format.print == printObj ? materials : names).of(group.name);
    return names.numbered();
}

/// Renames fields in the same manner, separately for those of vertices and those of cells.
std::vector<std::string> nameFieldsFor(const MeshFormat& format, std::vector<MeshField>& fields) {
    const NameRule* rule = ruleOf(format, kFieldRules);
    if (!rule) return {};
    std::vector<std::string> numbered;
    for (const bool perCell : {false, true}) {
        DistinctNames names(*rule);
        for (const bool changed : {false, true})
            for (const MeshField& field : fields)
                if (field.perCell == perCell && changesName(format, field.name, kFieldRules) == changed)
                    names.of(field.name);
        for (MeshField& field : fields)
            if (field.perCell == perCell) field.name = names.of(field.name);
        numbered.insert(numbered.end(), names.numbered().begin(), names.numbered().end());
    }
    return numbered;
}

/// Everything that is left out, as "3 lines".
class Losses {
  public:
    Losses(const MeshFormat& format, const MeshFile& bag) : m_format(format), m_bag(bag) {
        if (bag.deck && bag.deckFormat == format.extensions.front()) return;  // all of it is kept
        countCells();
        countGroups();
        countFields();
        m_lost.insert(m_lost.end(), bag.notices.begin(), bag.notices.end());
    }
    std::string text() const {
        const std::string in =
            " not in " + std::string(m_format.article) + std::string(m_format.name) + " file";
        std::string text;
        if (!m_lost.empty()) text = joined(m_lost) + (isOne() ? " is" : " are") + in;
        for (const std::string& one : m_changed) text += (text.empty() ? "" : "; ") + one;
        return text;
    }

  private:
    /// Returns whether a single thing is lost.
    bool isOne() const {
        if (m_lost.size() != 1) return false;
        const std::string& lost = m_lost[0];
        return lost.starts_with("1 ") || lost.starts_with("the name of ") ||
               lost.starts_with("the time of ") || (!m_bag.notices.empty() && !isPlural(lost));
    }
    /// Returns whether a notice of a reader names several things, as "its 3 cameras" does.
    static bool isPlural(const std::string& notice) {
        const auto number = notice.find_first_of("0123456789");
        return notice.starts_with("the lists ") || notice.starts_with("the values ") ||
               (notice.starts_with("its ") && number == 4 && !notice.starts_with("its 1 ")) ||
               (notice.starts_with("the ") && number == 4 && !notice.starts_with("the 1 "));
    }
    /// Lists the cells that are split, lose nodes, or are left out, with their numbers.
    void countCells() {
        std::map<CellKind, std::size_t> counts;
        for (const CellKind kind : m_bag.cells.kinds) ++counts[kind];
        if (m_bag.polyhedra > 0)
            m_changed.push_back(counted(static_cast<std::size_t>(m_bag.polyhedra), "polyhedron is written",
                                        "polyhedra are written") +
                                " as tetrahedra around a vertex within");
        for (const auto& [kind, count] : counts) {
            const CellKindFacts& facts = factsOf(kind);
            const Fate fate = fateOf(m_format, kind);
            const std::string cells = counted(count, facts.name, facts.plural);
            if (fate == Fate::Lost) m_lost.push_back(cells);
            if (fate == Fate::Linear)
                m_changed.push_back(cells + (count == 1 ? " is" : " are") +
                                    " written without the nodes between corners");
            if (fate == Fate::Split)
                m_changed.push_back(cells + (count == 1 ? " is" : " are") + " written as " +
                                    factsOf(partKind(facts.dimension)).plural);
        }
    }
    /// Lists the groups that are lost, and the names and numbers that are.
    void countGroups() {
        std::size_t ofVertices = 0, names = 0, numbers = 0, changed = 0;
        std::vector<std::string> lost;
        const std::vector<int> main = mainGroups(m_bag);
        const std::set<int> used(main.begin(), main.end());
        for (std::size_t g = 0; g < m_bag.groups.size(); ++g) {
            const MeshGroup& group = m_bag.groups[g];
            const std::string name = group.name.empty() ? std::to_string(group.tag) : group.name;
            if (group.cells.empty()) {
                ofVertices += !m_format.holdsNodeGroups(group);
            } else if (!m_format.holdsGroup(group, used.contains(static_cast<int>(g)))) {
                ++numbers;
                lost.push_back(name);
            } else if (!group.name.empty() && !m_format.holdsNames(group)) {
                ++names;
            } else {
                changed += !group.material && changesName(m_format, group.name, kNameRules);
            }
        }
        if (ofVertices > 0) m_lost.push_back(counted(ofVertices, "group of vertices", "groups of vertices"));
        if (numbers > 0) m_lost.push_back(counted(numbers, "group", "groups") + listed(lost));
        if (changed > 0)
            m_changed.push_back((changed == 1 ? "the name of 1 group is"
                                              : "the names of " + std::to_string(changed) + " groups are") +
                                " changed to what the format allows");
        std::vector<MeshGroup> named = m_bag.groups;
        countNumbered(nameGroupsFor(m_format, named), "group is", "groups are");
        if (names > 0)
            m_lost.push_back(names == 1 ? "the name of 1 group"
                                        : "the names of " + std::to_string(names) + " groups");
    }
    /// Lists names that got a number at their end.
    void countNumbered(const std::vector<std::string>& names, const char* one, const char* many) {
        if (!names.empty())
            m_changed.push_back(counted(names.size(), one, many) +
                                " renamed, because another has the same name there" + listed(names));
    }
    /// Lists the fields that are lost.
    void countFields() {
        std::vector<std::string> lost;
        for (const MeshField& field : m_bag.fields) {
            const bool isDrawn = m_format.print != printGmsh || isHeldByGmsh(field.components);
            if ((!m_format.holdsFields && !holdsField(m_format, field)) || !isDrawn)
                lost.push_back(field.name);
        }
        if (!lost.empty()) m_lost.push_back(counted(lost.size(), "field", "fields") + listed(lost));
        const auto timed = std::ranges::count_if(m_bag.fields, [](const auto& one) { return one.time != 0; });
        if (timed > 0 && m_format.print != printGmsh && lost.size() < m_bag.fields.size())
            m_lost.push_back(timed == 1 ? "the time of 1 field"
                                        : "the times of " + std::to_string(timed) + " fields");
        countChangedFields();
        if (const std::size_t cells = cellsWithoutValues(); cells > 0)
            m_lost.push_back("the values of " + counted(cells, "cell", "cells") + " of lower dimension");
        if (!m_bag.fileFields.empty() && !m_format.holdsFileFields)
            m_lost.push_back(counted(m_bag.fileFields.size(), "field of the file", "fields of the file"));
        countTexture();
    }

    /// Lists texture coordinates, those of vertices and those of corners.
    void countTexture() {
        const bool ofVertices = m_bag.uv.cols() > 0, ofCorners = m_bag.hasCornerUv();
        if ((ofVertices || ofCorners) && !m_format.holdsTexture) m_lost.push_back("texture coordinates");
        if (!ofCorners || !m_format.holdsTexture) return;
        const bool isWhole =
            std::ranges::all_of(m_bag.cells.kinds, [&](CellKind kind) { return m_format.holds(kind); });
        const bool holdsCorners = m_format.print
                                      ? (m_format.print == printObj || m_format.print == printPly) && isWhole
                                      : ofVertices;  // glTF
        if (!holdsCorners)
            m_lost.push_back(ofVertices ? "texture coordinates that differ between the faces of a vertex"
                                        : "texture coordinates that only some faces have");
    }

    void countChangedFields() {
        const auto changed = std::ranges::count_if(m_bag.fields, [this](const MeshField& field) {
            const bool spelled = m_format.print == printCgns && field.components == 3;  // with an X behind
            return changesName(m_format, field.name + (spelled ? "X" : ""), kFieldRules);
        });
        if (changed > 0)
            m_changed.push_back((changed == 1 ? "the name of 1 field is"
                                              : "the names of " + std::to_string(changed) + " fields are") +
                                std::string(" changed to what the format allows"));
        const bool holdsLong =
            m_format.print == printVtu || m_format.print == printVtp || m_format.print == printVtk;
        const auto rounded = std::ranges::count_if(m_bag.fields, [this](const MeshField& field) {
            return !field.beyond.empty() && (m_format.holdsFields || holdsField(m_format, field));
        });
        if (rounded > 0 && !holdsLong)
            m_changed.push_back("whole numbers of " +
                                counted(static_cast<std::size_t>(rounded), "field", "fields") +
                                " are rounded to 53 bits");
        std::vector<MeshField> named = m_bag.fields;
        countNumbered(nameFieldsFor(m_format, named), "field is", "fields are");
    }
    /// Returns how many cells have values that are not in the file: in CGNS files those of lower dimensions,
    /// in Exodus files those in side sets.
    std::size_t cellsWithoutValues() const {
        const bool exodus = m_format.print == printExodus;
        if (!exodus && m_format.print != printCgns) return 0;
        std::vector<char> isLost(static_cast<std::size_t>(m_bag.cells.size()), 0);
        int highest = 0;
        for (int c = 0; c < m_bag.cells.size(); ++c) highest = std::max(highest, m_bag.cells.dimension(c));
        std::vector<ExodusSide> sides;
        if (exodus) sides = sidesInExodus(m_bag);
        for (std::size_t c = 0; c < isLost.size(); ++c)
            isLost[c] = exodus ? sides[c].element >= 0 : m_bag.cells.dimension(static_cast<int>(c)) < highest;
        std::size_t count = 0;
        for (std::size_t c = 0; c < isLost.size(); ++c) count += isLost[c] && hasValue(c);
        return count;
    }
    /// Returns whether a field other than the number of a group has a value for a cell.
    bool hasValue(std::size_t cell) const {
        return std::ranges::any_of(m_bag.fields, [cell](const MeshField& field) {
            if (!field.perCell || namesATag(field)) return false;
            const auto first = field.ofCells.begin() +
                               static_cast<std::ptrdiff_t>(cell * static_cast<std::size_t>(field.components));
            return std::any_of(first, first + field.components,
                               [](double value) { return !std::isnan(value); });
        });
    }

    const MeshFormat& m_format;
    const MeshFile& m_bag;
    std::vector<std::string> m_lost, m_changed;
};

}  // namespace

MeshFile asHeld(const MeshFormat& format, MeshFile bag) {
    nameGroupsFor(format, bag.groups);
    nameFieldsFor(format, bag.fields);
    if (std::ranges::all_of(bag.cells.kinds, [&](CellKind kind) { return format.holds(kind); })) return bag;
    Remaking(format, bag).remake();
    return bag;
}

std::string lostParts(const MeshFormat& format, const MeshFile& bag) {
    return Losses(format, bag).text();
}

}  // namespace wend::formats
