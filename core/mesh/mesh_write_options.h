#pragma once

namespace wend {

struct MeshWriteOptions {
    enum class Encoding { Text, Binary, Compressed };
    /// Binary where the format has it (PLY, STL, .msh, .vtk, .vtu). Compressed: .vtu, elsewhere binary. Text
    /// has 17 significant digits; binary STL has single precision.
    Encoding encoding = Encoding::Text;
    bool bigEndian = false;  // PLY; the others have their own order
    bool appended = false;   // .vtu, not as text: data as raw bytes behind the XML instead of base64 in it
    int gmshVersion = 4;     // 4 writes 4.1, 2 writes 2.2
    /// The triangles of a volume's boundary as cells beside its tetrahedra, made where there are none.
    /// Without: those that the input had, in every format; those that were made with the cells, in formats
    /// for solvers
    /// (.mesh, .msh), which find their boundary conditions there. In .vtu and .vtk they would lie on the
    /// faces of the tetrahedra and count in every mean.
    bool boundary = false;

    bool binary() const { return encoding != Encoding::Text; }
};

}  // namespace wend
