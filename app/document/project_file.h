#pragma once

#include <string>
#include <vector>

#include "app/document/project.h"

namespace wend {

/// A loaded project and what the user should hear about it.
struct LoadedProject {
    Project project;
    std::vector<std::string> warnings;  // unknown keys …
};

/// Throws InputError(path, reason with line or key such as `handles[2].motion[0].points`). The dimension is
/// that of the domain; a mesh domain's file is opened for it, and if that fails the coordinates tell (the
/// scene reports the file).
LoadedProject readProject(const std::string& path);
LoadedProject parseProject(const std::string& text, const std::string& path);

/// UTF-8 JSON, written whole or not at all. The domain's relative paths refer to `folder` (empty: the folder
/// of `path`) and are written relative to `path`. readProject of the result is the same project. Throws
/// InputError.
void writeProject(const std::string& path, const Project& project, const std::string& folder = {});
std::string toJson(const Project& project);

/// The files that a project names, in their places.
std::vector<std::string*> filesOf(Project& project);

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

/// The folder that the paths in this file are relative to.
std::string folderOf(const std::string& path);
/// `file` as the project means it: relative to the folder, unless absolute.
std::string pathIn(const std::string& folder, const std::string& file);

}  // namespace wend
