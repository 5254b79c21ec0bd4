#pragma once

#include <string>
#include <vector>

namespace wend {

/// A field of a mesh file: `components` numbers per vertex or per cell. The cells are the tetrahedra if there
/// are any, else the triangles. Values may be NaN or infinite where the file says so.
struct MeshField {
    std::string name;
    bool perCell = false;
    int components = 1;
    std::vector<double> values;
};

}  // namespace wend
