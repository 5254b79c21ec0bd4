#pragma once

#include <string>
#include <type_traits>

#include "app/project/project_fwd.h"
#include "core/mesh/plane_frame.h"
#include "core/motion/handle.h"

namespace wend {

/// Reads the files of all motions by fields and poses, and the surfaces to slide on. Throws InputError
/// "handles[2].motion[0].file: FILE: …".
void readHandleFiles(Project& project, const std::string& folder);

/// Reads displacements of vertices: a point field of a mesh file, by name where there are several, or a table
/// (.csv, .txt, .tsv) with the columns id, dx, dy[, dz]. `vertices`: as many the mesh has to have; 0: any.
/// `plane`: of a flat shape, in which vectors of space become those of the plane. Throws InputError(path,
/// place and reason).
Displacements<3> readDisplacements(const std::string& path, const std::string& array, int vertices = 0,
                                   const PlaneFrame* plane = nullptr);

/// Reads a table of poses: time, position, and a rotation vector (7 columns), a quaternion (8 columns: x, y,
/// z, w, or as the header names them), or in the plane an angle (4 columns). Throws InputError(path, place
/// and reason).
PoseMotion<3> readPoseTable(const std::string& path, int dimension);

/// Returns the file that a motion is read from; null for one that is in the project itself.
template <class Kind>
auto fileOf(Kind& kind) {
    using File = std::conditional_t<std::is_const_v<Kind>, const std::string, std::string>;
    return std::visit(
        [](auto& one) -> File* {
            if constexpr (requires { one.file; }) return one.file.empty() ? nullptr : &one.file;
            return nullptr;
        },
        kind);
}

}  // namespace wend
