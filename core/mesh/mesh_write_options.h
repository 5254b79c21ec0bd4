#pragma once

namespace wend {

/// The options of writing a mesh file.
struct MeshWriteOptions {
    /// Selects text, bytes, or compressed bytes.
    enum class Encoding { Text, Binary, Compressed };
    /// Binary applies where the format has it (PLY, STL, .msh, .vtk, .vtu); Compressed applies to .vtu and is
    /// binary elsewhere. Text has 17 significant digits; binary STL has single precision.
    Encoding encoding = Encoding::Text;
    bool bigEndian = false;  // PLY; the others have their own order
    bool appended = false;   // .vtu, not as text: data as raw bytes behind the XML instead of base64 in it
    int gmshVersion = 4;     // 4 writes 4.1, 2 writes 2.2
    /// Writes the boundary triangles of a volume as cells beside its tetrahedra, generated if necessary. By
    /// default: triangles from the input, in every format; generated ones in solver formats (.mesh, .msh),
    /// which need them for boundary conditions. In .vtu and .vtk they would coincide with the tetrahedra's
    /// faces and count in every mean.
    bool boundary = false;

    bool binary() const { return encoding != Encoding::Text; }
};

}  // namespace wend
