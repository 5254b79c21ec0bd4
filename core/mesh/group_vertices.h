#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wend {

struct MeshFile;

/// The cells and vertices of all groups that a file calls by a name, or by a number where nothing has that
/// name; see groupVertices. Throws InputError that lists the groups of the file.
struct GroupParts {
    std::vector<int> cells, vertices;
};
GroupParts groupParts(const MeshFile& file, const std::string& name, std::optional<int> dimension);

/// The vertices of what a file calls by a name, or by a number where nothing has that name: of its cells'
/// triangles and tetrahedra, or of a list. `dimension` is that of the cells, 0 for vertices; without it the
/// name must be one dimension's only. Throws InputError that lists the groups of the file.
std::vector<int> groupVertices(const MeshFile& file, const std::string& name, std::optional<int> dimension);

/// What there is to tell of a group.
struct GroupFacts {
    std::string name;  // empty: it has a number only
    long tag;          // 0: it has a name only
    int dimension;     // of its cells; 0: it is one of vertices
    int count;
};
std::vector<GroupFacts> groupFacts(const MeshFile& file);

/// The groups of a file in words: "'fixed end' (surfaces), 11 (volumes)"; empty if there are none.
std::string groupList(const MeshFile& file);

}  // namespace wend
