#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scalar_type.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_fields.h"

namespace wend::formats {
namespace {

/// Names end at a blank; VTK writes those as %20.
std::string encoded(const std::string& name) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text;
    for (char c : name) {
        if (c > ' ' && c <= '~' && c != '%' && c != '"')
            text += c;
        else
            text +=
                {'%', digits[static_cast<unsigned char>(c) / 16], digits[static_cast<unsigned char>(c) % 16]};
    }
    return text.empty() ? "field" : text;
}

class VtkPrinter {
  public:
    VtkPrinter(const MeshFile& mesh, bool binary)
        : m_mesh(mesh), m_fields(vtkFieldsOf(mesh)), m_binary(binary) {}

    /// The layout of version 3, which every reader knows.
    std::string print() {
        m_out << "# vtk DataFile Version 3.0\nWend\n"
              << (m_binary ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\n";
        m_out << "POINTS " << m_mesh.points.cols() << " double\n";
        for (const auto& p : m_mesh.points.colwise()) numbers(std::vector<double>(p.begin(), p.end()), 3);
        endArray();
        const auto cells = vtkCellsOf(m_mesh);
        printCells(cells);
        printData(cells, false);
        printData(cells, true);
        return std::move(m_out.text());
    }

  private:
    void numbers(const std::vector<double>& values, int perLine) {
        int inLine = 0;
        for (double value : values) {
            if (m_binary) {
                appendReal(m_out.text(), value, Scalar::Float64, std::endian::big);
            } else {
                m_out << value << (++inLine == perLine ? '\n' : ' ');
                if (inLine == perLine) inLine = 0;
            }
        }
    }
    void whole(std::int64_t value, bool last) {
        if (m_binary)
            appendInteger(m_out.text(), value, Scalar::Int32, std::endian::big);
        else
            m_out << value << (last ? '\n' : ' ');
    }
    void endArray() {
        if (m_binary) m_out << '\n';
    }
    void printCells(const VtkCells& cells) {
        const auto count = cells.types.size();
        m_out << "CELLS " << count << ' ' << count + cells.connectivity.size() << '\n';
        for (std::size_t c = 0; c < count; ++c) {
            whole(cells.offsets[c + 1] - cells.offsets[c], false);
            for (auto at = cells.offsets[c]; at < cells.offsets[c + 1]; ++at)
                whole(cells.connectivity[at], at + 1 == cells.offsets[c + 1]);
        }
        endArray();
        m_out << "CELL_TYPES " << count << '\n';
        for (auto type : cells.types) whole(type, true);
        endArray();
    }
    void printData(const VtkCells& cells, bool perCell) {
        int fieldCount = 0;
        for (const auto& field : m_fields) fieldCount += field.perCell == perCell;
        const bool texture = !perCell && m_mesh.uv.cols();
        if (!fieldCount && !texture) return;
        m_out << (perCell ? "CELL_DATA " : "POINT_DATA ")
              << (perCell ? static_cast<std::int64_t>(cells.types.size()) : m_mesh.points.cols()) << '\n';
        if (texture) printTexture();
        if (!fieldCount) return;
        m_out << "FIELD FieldData " << fieldCount << '\n';
        for (const auto& field : m_fields)
            if (field.perCell == perCell) printField(field);
    }
    void printTexture() {
        m_out << "TEXTURE_COORDINATES uv 2 double\n";
        numbers(std::vector<double>(m_mesh.uv.data(), m_mesh.uv.data() + m_mesh.uv.size()), 2);
        endArray();
    }
    void printField(const MeshField& field) {
        m_out << encoded(field.name) << ' ' << field.components << ' '
              << field.values.size() / field.components << " double\n";
        numbers(field.values, field.components);
        endArray();
    }

    const MeshFile& m_mesh;
    std::vector<MeshField> m_fields;
    bool m_binary;
    TextWriter m_out;
};

}  // namespace

std::vector<std::string> printVtk(const MeshFile& mesh, const MeshWriteOptions& options) {
    return {VtkPrinter(mesh, options.binary()).print()};
}

}  // namespace wend::formats
