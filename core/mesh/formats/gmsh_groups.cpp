#include "core/mesh/formats/gmsh_groups.h"

#include <algorithm>

namespace wend::formats {

const char* groupOfTheRest(bool volume, int dimension) {
    return dimension == 3 ? "volume" : volume ? "boundary" : "surface";
}

GmshGroups::GmshGroups(const MeshFile& mesh)
    : m_mesh(mesh),
      m_physical(cellField(mesh, {"physical", "ref", "attribute"})),
      m_entity(cellField(mesh, {"entity"})) {
    for (const int dimension : {2, 3}) findRest(dimension);
    for (const int dimension : {2, 3}) findEntities(dimension);
}

std::size_t GmshGroups::count(int dimension) const {
    return dimension == 3 ? m_mesh.tetrahedra.size() : m_mesh.triangles.size();
}

/// 0 is none.
long GmshGroups::tag(int dimension, std::size_t cell) const {
    if (hasOwnTags(dimension)) return tagOf(m_physical, static_cast<int>(cell), 0);
    return m_mesh.labels.empty() ? 0 : m_mesh.labels[cell];
}

void GmshGroups::findRest(int dimension) {
    long maximum = 0;
    bool untagged = false;
    for (std::size_t c = 0; c < count(dimension); ++c) {
        const long one = tag(dimension, c);
        maximum = std::max(maximum, one);
        untagged = untagged || one == 0;
    }
    if (untagged) m_rest[dimension] = maximum + 1;
}

long GmshGroups::physical(int dimension, std::size_t cell) const {
    const long own = tag(dimension, cell);
    return own != 0 ? own : m_rest[dimension];
}

/// The field's number where it is one, else the group's; a second group in an entity gets an entity behind
/// all others.
void GmshGroups::findEntities(int dimension) {
    std::map<long, long> groupOf;
    std::vector<std::array<long, 3>> late;
    long maximum = 0;
    for (std::size_t c = 0; c < count(dimension); ++c) {
        const std::array<long, 3> key{dimension, wishedEntity(dimension, c), physical(dimension, c)};
        maximum = std::max(maximum, key[1]);
        if (m_entities.contains(key)) continue;
        const bool first = groupOf.try_emplace(key[1], key[2]).second;
        m_entities[key] = first ? key[1] : 0;
        if (!first) late.push_back(key);
    }
    for (const auto& key : late) m_entities[key] = ++maximum;
}

long GmshGroups::wishedEntity(int dimension, std::size_t cell) const {
    const long own = hasOwnTags(dimension) ? tagOf(m_entity, static_cast<int>(cell), 0) : 0;
    return std::max(1L, own > 0 ? own : physical(dimension, cell));
}

long GmshGroups::entity(int dimension, std::size_t cell) const {
    return m_entities.at({dimension, wishedEntity(dimension, cell), physical(dimension, cell)});
}

std::vector<GmshGroups::Name> GmshGroups::names() const {
    std::vector<Name> names;
    if (isVolume(m_mesh) && !m_mesh.triangles.empty() && !m_mesh.labels.empty())
        for (std::size_t i = 0; i < m_mesh.labelNames.size(); ++i)
            if (!m_mesh.labelNames[i].empty())
                names.push_back({2, static_cast<long>(i) + 1, m_mesh.labelNames[i]});
    for (const int dimension : {2, 3})
        if (m_rest[dimension] > 0)
            names.push_back({dimension, m_rest[dimension], groupOfTheRest(isVolume(m_mesh), dimension)});
    for (Name& name : names) std::replace(name.name.begin(), name.name.end(), '"', '\'');
    return names;
}

}  // namespace wend::formats
