#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// Returns the name of the group for elements without a tag: programs that solve on a mesh find its parts by
/// their groups, and 0 means none. The reader takes a group of that name whose number follows all others as
/// no tag.
const char* groupOfTheRest(bool volume, int dimension);

/// Maps the groups of a bag to Gmsh's physical groups and entities.
class GmshGroups {
  public:
    explicit GmshGroups(const MeshFile& bag);

    /// The name of a physical group, which its dimension and number identify.
    struct Name {
        int dimension;
        long tag;
        std::string name;
    };
    /// Returns the names of the physical groups.
    std::vector<Name> names() const;
    /// Returns the physical groups of a cell: at least one, and none of them 0. Where only one is possible,
    /// the first is used.
    const std::vector<long>& physical(int cell) const { return m_physical[static_cast<std::size_t>(cell)]; }
    /// Returns the entity of a cell, at least 1. All cells of an entity are in the same physical groups.
    long entity(int cell) const { return m_entities[static_cast<std::size_t>(cell)]; }
    /// Returns whether a field is one of those that the groups are made of.
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
