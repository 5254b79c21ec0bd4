#include "core/mesh/formats/gmsh_groups.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/mesh/formats/mesh_bag.h"

namespace wend::formats {

const char* groupOfTheRest(bool volume, int dimension) {
    if (dimension == 3) return "volume";
    if (dimension == 2) return volume ? "boundary" : "surface";
    return dimension == 1 ? "lines" : "points";
}

GmshGroups::GmshGroups(const MeshFile& bag)
    : m_bag(bag),
      m_ofGroups(cellField(bag, {"physical", "ref", "attribute", "material", "pid"})),
      m_entity(cellField(bag, {"entity"})) {
    nameGroups();
    listGroups();
    findRest();
    findEntities();
}

/// Gives groups of cells their own numbers where these are positive and free, and others behind all. Own
/// numbers are taken first, so that a group without one cannot displace them.
void GmshGroups::nameGroups() {
    std::set<std::pair<int, long>> taken;
    for (const MeshGroup& group : m_bag.groups) {
        const bool own =
            group.tag > 0 && !group.cells.empty() && taken.insert({group.dimension, group.tag}).second;
        m_tags.push_back(own || group.cells.empty() ? group.tag : 0);
        long& highest = m_highest[static_cast<std::size_t>(group.dimension)];
        if (own) highest = std::max(highest, group.tag);
    }
    for (std::size_t g = 0; g < m_tags.size(); ++g)
        if (m_tags[g] <= 0 && !m_bag.groups[g].cells.empty())
            m_tags[g] = ++m_highest[static_cast<std::size_t>(m_bag.groups[g].dimension)];
}

void GmshGroups::listGroups() {
    m_physical.resize(static_cast<std::size_t>(m_bag.cells.size()));
    for (std::size_t g = 0; g < m_tags.size(); ++g)
        for (const int c : m_bag.groups[g].cells)
            m_physical[static_cast<std::size_t>(c)].push_back(m_tags[g]);
}

void GmshGroups::findRest() {
    for (int c = 0; c < m_bag.cells.size(); ++c) {
        auto& physical = m_physical[static_cast<std::size_t>(c)];
        if (!physical.empty()) continue;
        const auto dimension = static_cast<std::size_t>(m_bag.cells.dimension(c));
        m_rest[dimension] = m_highest[dimension] + 1;
        physical.push_back(m_rest[dimension]);
    }
}

/// Takes the field's number where it is one, else the group's. All cells of an entity must be in the same
/// physical groups: the first cell decides, and others get an entity behind all others, one for each wish and
/// set of groups.
void GmshGroups::findEntities() {
    std::map<std::pair<int, long>, std::vector<long>> groupsOf;
    std::map<std::pair<int, std::vector<long>>, std::map<long, long>> known;
    std::array<long, 4> highest{};
    std::vector<int> late;
    m_entities.resize(m_physical.size());
    for (int c = 0; c < m_bag.cells.size(); ++c) {
        const int dimension = m_bag.cells.dimension(c);
        const long wished = wishedEntity(c);
        highest[static_cast<std::size_t>(dimension)] =
            std::max(highest[static_cast<std::size_t>(dimension)], wished);
        const auto [entry, isNew] = groupsOf.try_emplace({dimension, wished}, physical(c));
        if (entry->second == physical(c))
            m_entities[static_cast<std::size_t>(c)] = wished;
        else
            late.push_back(c);
    }
    for (const int c : late) {
        const int dimension = m_bag.cells.dimension(c);
        long& entity = known[{dimension, physical(c)}][wishedEntity(c)];
        if (entity == 0) entity = ++highest[static_cast<std::size_t>(dimension)];
        m_entities[static_cast<std::size_t>(c)] = entity;
    }
}

long GmshGroups::wishedEntity(int cell) const {
    const double own = m_entity ? m_entity->ofCells[static_cast<std::size_t>(cell)] : 0;
    const bool valid = own > 0 && own < 2147483647;
    return std::max(1L, valid ? std::lround(own) : physical(cell)[0]);
}

std::vector<GmshGroups::Name> GmshGroups::names() const {
    std::vector<Name> names;
    for (std::size_t g = 0; g < m_tags.size(); ++g)
        if (const MeshGroup& group = m_bag.groups[g];
            !group.name.empty() && m_tags[g] > 0 && group.vertices.empty())
            names.push_back({group.dimension, m_tags[g], group.name});
    for (int dimension = 0; dimension < 4; ++dimension)
        if (const long rest = m_rest[static_cast<std::size_t>(dimension)]; rest > 0)
            names.push_back({dimension, rest, groupOfTheRest(isVolume(m_bag), dimension)});
    for (Name& name : names) std::replace(name.name.begin(), name.name.end(), '"', '\'');
    return names;
}

bool GmshGroups::holds(const MeshField& field) const {
    const bool beside =
        field.perCell && field.components == 1 && (field.name == "label" || field.name == "marker");
    return &field == m_ofGroups || &field == m_entity || beside;
}

}  // namespace wend::formats
