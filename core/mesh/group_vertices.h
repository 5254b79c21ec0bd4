#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wend {

struct MeshFile;

/// The cells and vertices of all groups that a file calls by a name, or by a number if nothing has that name;
/// see groupVertices.
struct GroupParts {
    std::vector<int> cells, vertices;
};
/// Returns these parts. Throws InputError that lists the groups of the file.
GroupParts groupParts(const MeshFile& file, const std::string& name, std::optional<int> dimension);

/// Returns the vertices of what a file calls by a name, or by a number if nothing has that name: those of its
/// cells' triangles and tetrahedra, or of a list. `dimension` is that of the cells, 0 for vertices; without
/// it the name must belong to one dimension only. Throws InputError that lists the groups of the file.
std::vector<int> groupVertices(const MeshFile& file, const std::string& name, std::optional<int> dimension);

/// The facts about a group that are shown to users.
struct GroupFacts {
    std::string name;  // empty: it has a number only
    long tag;          // 0: it has a name only
    int dimension;     // of its cells; 0: it is one of vertices
    int count;
};
/// Returns the facts about all groups of a file.
std::vector<GroupFacts> groupFacts(const MeshFile& file);

/// Lists the groups of a file in words: "'fixed end' (surfaces), 11 (volumes)"; empty if there are none.
std::string groupList(const MeshFile& file);

}  // namespace wend
