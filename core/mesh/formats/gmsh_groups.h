#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// The name of the group that elements without a tag are written in: programs that solve on a mesh find its
/// parts by their groups, and 0 is none. The reader takes a group of that name and of the number behind all
/// others for no tag again.
const char* groupOfTheRest(bool volume, int dimension);

/// Physical groups and entities of a mesh in Gmsh's terms: numbers of its cells, and of the triangles of a
/// volume's boundary, whose tags are the labels.
class GmshGroups {
  public:
    explicit GmshGroups(const MeshFile& mesh);

    struct Name {
        int dimension;
        long tag;
        std::string name;
    };
    std::vector<Name> names() const;
    /// Never 0.
    long physical(int dimension, std::size_t cell) const;
    /// At least 1; an entity has one physical group only.
    long entity(int dimension, std::size_t cell) const;
    /// True for the fields that the groups are made of.
    bool holds(const MeshField& field) const { return &field == m_physical || &field == m_entity; }

  private:
    bool hasOwnTags(int dimension) const { return (dimension == 3) == isVolume(m_mesh); }
    std::size_t count(int dimension) const;
    long tag(int dimension, std::size_t cell) const;
    long wishedEntity(int dimension, std::size_t cell) const;
    void findRest(int dimension);
    void findEntities(int dimension);

    const MeshFile& m_mesh;
    const MeshField *m_physical, *m_entity;
    std::array<long, 4> m_rest{};  // per dimension, the group of what has no tag; 0: all have one
    std::map<std::array<long, 3>, long> m_entities;  // of (dimension, entity, physical)
};

}  // namespace wend::formats
