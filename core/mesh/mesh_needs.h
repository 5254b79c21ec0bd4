#pragma once

namespace wend {

/// The least content of a file that a reader accepts: triangles or tetrahedra, or points alone.
enum class MeshNeeds { Cells, Points };

}  // namespace wend
