#pragma once

#include <QString>
#include <string>
#include <vector>

namespace wend {

class ShapeSession;

/// A group of a mesh's or surface's file, with the vertices that a handle on it holds.
struct HeldGroup {
    std::string name;   // as a project names it: a number if the file has no name
    int dimension = 0;  // of its cells; 0: of vertices
    int count = 0;      // of its cells or vertices
    std::vector<int> vertices;
};

/// Returns the groups of a mesh file; none if it cannot be read. Thread-safe.
std::vector<HeldGroup> heldGroups(const std::string& path);

/// Adds a handle that holds a group, by its name, and selects it.
void holdGroup(ShapeSession& session, const HeldGroup& group);

}  // namespace wend
