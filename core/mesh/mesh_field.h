#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/formats/scalar_type.h"

namespace wend {

/// A field of a mesh file: `components` numbers per vertex or per cell. The cells are the tetrahedra if there
/// are any, else the triangles. Values may be NaN or infinite where the file says so.
struct MeshField {
    std::string name;
    bool perCell = false;
    int components = 1;
    std::vector<double> values;
    /// The values of a field per cell that was read, for every one of the file's own cells (MeshFile::cells).
    std::vector<double> ofCells = {};
    formats::Scalar type = formats::Scalar::Float64;  // in the file
    /// The difference between each number of a file (per vertex, or per its own cell) and the double that
    /// represents it: whole numbers of eight bytes may have more digits. Empty if there is none.
    std::vector<std::int16_t> beyond = {};
    double time = 0;  // of the step of a film that the values belong to, and its number
    int step = 0;
};

}  // namespace wend
