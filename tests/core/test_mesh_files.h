#pragma once

#include "core/base/error.h"
#include "core/mesh/mesh_file.h"
#include "test_folder.h"
#include "test_mesh_samples.h"

namespace wend::samples {

/// Every format in every encoding that can be written.
struct Encoding {
    const char* name;
    const char* file;
    MeshWriteOptions options;
    bool tetrahedra, triangles3d;  // what it can hold
    bool uv, fields;
    bool exact;  // all doubles come back
};

inline std::vector<Encoding> encodings() {
    using enum MeshWriteOptions::Encoding;
    return {
        {"obj", "a.obj", {}, false, true, true, false, true},
        {"off", "a.off", {}, false, true, false, false, true},
        {"ply text", "a.ply", {}, false, true, true, true, true},
        {"ply little endian", "a.ply", {Binary, false, false, 4}, false, true, true, true, true},
        {"ply big endian", "a.ply", {Binary, true, false, 4}, false, true, true, true, true},
        {"stl text", "a.stl", {}, false, true, false, false, true},
        {"stl binary", "a.stl", {Binary, false, false, 4}, false, true, false, false, false},
        {"medit", "a.mesh", {}, true, true, false, false, true},
        {"gmsh 2.2 text", "a.msh", {Text, false, false, 2}, true, true, false, false, true},
        {"gmsh 2.2 binary", "a.msh", {Binary, false, false, 2}, true, true, false, false, true},
        {"gmsh 4.1 text", "a.msh", {Text, false, false, 4}, true, true, false, false, true},
        {"gmsh 4.1 binary", "a.msh", {Binary, false, false, 4}, true, true, false, false, true},
        {"tetgen", "a.node", {}, true, false, false, false, true},
        {"vtk text", "a.vtk", {}, true, true, true, true, true},
        {"vtk binary", "a.vtk", {Binary, false, false, 4}, true, true, true, true, true},
        {"ucd", "a.avs", {}, true, true, false, true, true},
        {"vtp text", "a.vtp", {}, false, true, true, true, true},
        {"vtp compressed appended", "a.vtp", {Compressed, false, true, 4}, false, true, true, true, true},
        {"vtu text", "a.vtu", {}, true, true, true, true, true},
        {"vtu base64", "a.vtu", {Binary, false, false, 4}, true, true, true, true, true},
        {"vtu appended", "a.vtu", {Binary, false, true, 4}, true, true, true, true, true},
        {"vtu compressed", "a.vtu", {Compressed, false, false, 4}, true, true, true, true, true},
        {"vtu compressed appended", "a.vtu", {Compressed, false, true, 4}, true, true, true, true, true},
    };
}

/// Awkward doubles: of all magnitudes, with all digits.
template <int Dim>
SimplicialMesh<Dim> awkwardMesh(int n) {
    auto mesh = jitteredGrid<Dim>(n);
    mesh.points *= 1.0 / 3;
    mesh.points.row(0) *= 1e-7;
    mesh.points.row(1).array() += 12345.678901234567;
    return mesh;
}

inline bool sameBits(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a.array() == b.array()).all();
}

}  // namespace wend::samples
