#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_file.h"
#include "core/mesh/quality.h"

namespace wend {

/// One thing that is wrong with a mesh, and all cells (or vertices) that it is wrong with.
struct MeshProblem {
    std::string what;        // "cells without area"
    std::vector<int> where;  // their numbers
    bool fatal = true;       // a deformation refuses it
};

struct MeshInspection {
    int dimension = 0;  // 2 or 3; 0: a surface in space
    int vertices = 0, cells = 0, triangles = 0, parts = 0;
    double diagonal = 0;     // of the bounding box
    QualitySummary quality;  // of a partition
    std::vector<MeshProblem> problems;
    std::string surface;  // of a surface: what is wrong with it (SurfaceProblems::summary)
};

/// Looks at everything, where requireValid stops at the first. The file's indices are valid and its
/// coordinates finite.
MeshInspection inspect(const MeshFile& file);

}  // namespace wend
