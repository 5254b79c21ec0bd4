#pragma once

#include <string>
#include <vector>

#include "app/project/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

// Locations of the files that a project names, and readers of our own formats.

/// Returns the folder that the paths in this file are relative to.
std::string folderOf(const std::string& path);
/// `file` as the project means it: relative to the folder, unless absolute.
std::string pathIn(const std::string& folder, const std::string& file);

/// Reads the file of material.cells, a JSON object {"phi": [one per cell], "B": [[row-major] per cell]}, or a
/// mesh file with these as cell values (.vtu, .vtk). `path` is used as it is. Throws InputError(path, key and
/// reason).
void readCells(const std::string& path, MaterialSpec& spec, int dimension);

/// Reads `count` factors, one per line or separated by blanks, each in the range of domain.sizes[].factor.
/// Throws InputError(path, place and reason).
std::vector<double> readSizes(const std::string& path, int count);

/// Reads an outline from a file of its own: {"polygons": [outer, hole, …]}. Throws InputError(path, key and
/// reason).
Outline readOutlineFile(const std::string& path);

}  // namespace wend
