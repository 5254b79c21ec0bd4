#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// The name of the group that elements without a tag are written in: programs that solve on a mesh find its
/// parts by their groups, and 0 is none. The reader takes a group of that name and of the number behind all
/// others for no tag again.
const char* groupOfTheRest(bool volume, int dimension);

/// Physical groups and entities of a bag in Gmsh's terms.
class GmshGroups {
  public:
    explicit GmshGroups(const MeshFile& bag);

    struct Name {
        int dimension;
        long tag;
        std::string name;
    };
    std::vector<Name> names() const;
    /// At least one; none is 0. The first stands for all where there can be only one.
    const std::vector<long>& physical(int cell) const { return m_physical[static_cast<std::size_t>(cell)]; }
    /// At least 1; all cells of an entity are in the same physical groups.
    long entity(int cell) const { return m_entities[static_cast<std::size_t>(cell)]; }
    /// True for the fields that the groups are made of.
    bool holds(const MeshField& field) const;

  private:
    void nameGroups();
    void listGroups();
    void findRest();
    void findEntities();
    long wishedEntity(int cell) const;

    const MeshFile& m_bag;
    const MeshField *m_ofGroups, *m_entity;
    std::vector<long> m_tags;                   // of the bag's groups
    std::vector<std::vector<long>> m_physical;  // of the cells
    std::vector<long> m_entities;               // of the cells
    std::array<long, 4> m_highest{},
        m_rest{};  // per dimension; the group of what has no tag, 0: all have one
};

}  // namespace wend::formats
