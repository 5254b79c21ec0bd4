#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh/quality.h"
#include "core/meshing/surface_facts.h"
#include "core/meshing/surface_faults.h"

namespace wend {

struct MeshFile;

/// A fault of a mesh, with all cells (or vertices) that have it.
struct MeshProblem {
    std::string what;                            // "cells without area"
    std::vector<int> where;                      // their numbers
    bool fatal = true;                           // a deformation refuses it
    std::vector<std::array<int, 2>> pairs = {};  // of surfaces, instead of numbers: edges as their vertices,
                                                 // or triangles that cross

    std::size_t count() const { return where.size() + pairs.size(); }
};

struct MeshInspection {
    int dimension = 0;  // 2 or 3; 0: a surface in space
    int vertices = 0, cells = 0, triangles = 0, parts = 0;
    double diagonal = 0;     // of the bounding box
    QualitySummary quality;  // of a partition
    std::vector<MeshProblem> problems;
    double volume = 0;                     // of a surface that encloses one
    std::string surface;                   // of a surface: its faults (SurfaceProblems::summary)
    std::optional<SurfaceFacts> facts;     // of a surface, or of the border of tetrahedra
    std::optional<int> intersectingPairs;  // of a surface; at most 10000 are counted
    std::vector<FaultKind> faults;         // of a surface: the kind of each fault
    std::vector<int> suspects;  // the cells, or of a surface the triangles, that have a part in a problem
};

/// Looks at everything, where requireValid stops at the first. The file's indices are valid and its
/// coordinates finite.
MeshInspection inspect(const MeshFile& file);
MeshInspection inspectFile(const std::string& path);

/// Writes the suspects alone, as a mesh: only their vertices, and fields "vertex" and "cell" with the numbers
/// that they have in the file; of a surface also one per kind of fault, 1 at the triangles that have it.
/// There must be some.
void writeSuspects(const std::string& path, const MeshFile& file, const MeshInspection& inspection);

}  // namespace wend
