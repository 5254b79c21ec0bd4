#include "core/mesh/group_vertices.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/mesh/mesh_file.h"

namespace wend {
namespace {

std::string groupInWords(const MeshGroup& group) {
    static const char* const kinds[] = {" (vertices)", " (lines)", " (surfaces)", " (volumes)"};
    const std::string name = group.name.empty() ? std::to_string(group.tag) : "'" + group.name + "'";
    return name + kinds[group.dimension];
}

/// Returns the groups of a name or, if there are none, those of a number.
std::vector<const MeshGroup*> groupsNamed(const MeshFile& file, const std::string& name,
                                          std::optional<int> dimension) {
    for (const bool byName : {true, false}) {
        std::vector<const MeshGroup*> found;
        for (const MeshGroup& group : file.groups)
            if ((!dimension || group.dimension == *dimension) &&
                (byName ? group.name == name : group.tag != 0 && std::to_string(group.tag) == name))
                found.push_back(&group);
        if (!found.empty()) return found;
    }
    return {};
}

/// Marks the vertices that triangles or tetrahedra of the mesh have, which are those that move.
std::vector<char> ownVertices(const MeshFile& file) {
    std::vector<char> own(static_cast<std::size_t>(file.points.cols()), 0);
    if (isVolume(file))
        for (const auto& cell : file.tetrahedra)
            for (const int v : cell) own[static_cast<std::size_t>(v)] = 1;
    else
        for (const auto& cell : file.triangles)
            for (const int v : cell) own[static_cast<std::size_t>(v)] = 1;
    return own;
}

}  // namespace

std::vector<GroupFacts> groupFacts(const MeshFile& file) {
    std::vector<GroupFacts> facts;
    for (const MeshGroup& group : file.groups)
        facts.push_back({group.name, group.tag, group.dimension,
                         static_cast<int>(group.cells.size() + group.vertices.size())});
    return facts;
}

std::string groupList(const MeshFile& file) {
    std::string list;
    for (const MeshGroup& group : file.groups) list += (list.empty() ? "" : ", ") + groupInWords(group);
    return list;
}

GroupParts groupParts(const MeshFile& file, const std::string& name, std::optional<int> dimension) {
    const auto groups = groupsNamed(file, name, dimension);
    if (groups.empty()) {
        const std::string list = groupList(file);
        throw InputError("there is no group '" + name + "' in the file; " +
                         (list.empty() ? "it has none" : "it has " + list));
    }
    for (const MeshGroup* group : groups)
        if (group->dimension != groups[0]->dimension)
            throw InputError("the group '" + name + "' is there as " + groupInWords(*groups[0]) + " and as " +
                             groupInWords(*group) + ": `dimension` (0 to 3) says which");
    GroupParts parts;
    for (const MeshGroup* group : groups) {
        parts.cells.insert(parts.cells.end(), group->cells.begin(), group->cells.end());
        parts.vertices.insert(parts.vertices.end(), group->vertices.begin(), group->vertices.end());
    }
    return parts;
}

std::vector<int> groupVertices(const MeshFile& file, const std::string& name, std::optional<int> dimension) {
    const GroupParts parts = groupParts(file, name, dimension);
    const std::vector<char> own = ownVertices(file);
    std::set<int> vertices;
    for (const int c : parts.cells)
        for (const int v : file.cells[c])
            if (own[static_cast<std::size_t>(v)]) vertices.insert(v);
    for (const int v : parts.vertices)
        if (own[static_cast<std::size_t>(v)]) vertices.insert(v);
    if (vertices.empty()) throw InputError("the group '" + name + "' has no vertex that cells have");
    return {vertices.begin(), vertices.end()};
}

}  // namespace wend
