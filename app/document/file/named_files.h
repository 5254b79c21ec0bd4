#pragma once

#include <string>
#include <vector>

#include "app/document/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

// Where the files are that a project names, and what stands in those of a format of their own.

/// The folder that the paths in this file are relative to.
std::string folderOf(const std::string& path);
/// `file` as the project means it: relative to the folder, unless absolute.
std::string pathIn(const std::string& folder, const std::string& file);

/// The file of material.cells, a JSON object {"phi": [one per cell], "B": [[row-major] per cell]}, or a mesh
/// file with these as values per cell (.vtu, .vtk); `path` as it is. Throws InputError(path, key and
/// reason).
template <int Dim>
void readCells(const std::string& path, MaterialSpec<Dim>& spec);

/// One number per line or separated by blanks, each a factor in range of domain.sizes[].factor; as many as
/// `count`. Throws InputError(path, place and reason).
std::vector<double> readSizes(const std::string& path, int count);

/// An outline in a file of its own: {"polygons": [outer, hole, …]}. Throws InputError(path, key and reason).
Outline readOutlineFile(const std::string& path);

}  // namespace wend
