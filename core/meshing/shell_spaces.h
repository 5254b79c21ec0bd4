#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/meshing/surface.h"

namespace wend {

/// Selects what is inside of nested shells: `Holes` fills every second space, `Regions` fills all.
/// `Automatic` is as Holes.
enum class Shells { Automatic, Holes, Regions };

/// Returns the number of the shell of each triangle, in the order of their first triangles. A shell is
/// connected through edges.
std::vector<int> shellsOf(const std::vector<std::array<int, 3>>& triangles, int vertices);

/// A face of a mesh that belongs to the surface: between two spaces, or a space and the outside (−1).
struct SpaceWall {
    std::array<int, 2> spaces;
    int shell;
    std::vector<int> labels;  // of the triangles at this place; empty if the surface has none
    std::array<int, 3> vertices;
};

/// A space that a surface encloses.
struct ShellSpace {
    int shell = -1;     // the innermost one around it; −1: none
    int depth = 0;      // shells around it
    bool kept = false;  // it is filled
    int label = 0;      // of its cells, 1 …; 0 if it is hollow
};

/// The spaces within the shells of a surface.
struct ShellSpaces {
    std::vector<ShellSpace> spaces;
    std::vector<std::string> names;  // of the labels; empty where the surface has no name for a space

    int filled() const;
    int deepest() const;
    /// Returns whether one shell contains several spaces: bodies share walls.
    bool shareWalls() const;
    /// Returns one line for the user if shells are nested or bodies share walls; else empty.
    Message summary() const;
};

/// Finds the spaces of `count` regions of a mesh from the walls between them. A shell is around a region that
/// cannot be reached from the outside except through it. `labelNames`: of the labels 1, 2, ….
ShellSpaces shellSpaces(int count, const std::vector<SpaceWall>& walls, Shells choice,
                        const std::vector<std::string>& labelNames);

}  // namespace wend
