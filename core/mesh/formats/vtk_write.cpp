#include <algorithm>
#include <cmath>

#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scalar_type.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_cells.h"
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

const char* nameInVtk(Scalar type) {
    switch (type) {
        case Scalar::Int8:
            return "char";
        case Scalar::UInt8:
            return "unsigned_char";
        case Scalar::Int16:
            return "short";
        case Scalar::UInt16:
            return "unsigned_short";
        case Scalar::Int32:
            return "int";
        case Scalar::UInt32:
            return "unsigned_int";
        case Scalar::Int64:
            return "long";  // meshio knows no "vtktypeint64"
        case Scalar::UInt64:
            return "unsigned_long";
        case Scalar::Float32:
            return "float";
        default:
            return "double";
    }
}

bool isFinite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

class VtkPrinter {
  public:
    /// VTK reads no NaN and no infinity from text, and drops all fields then: such files are binary.
    VtkPrinter(const MeshFile& mesh, bool binary)
        : m_mesh(mesh), m_fields(vtkFieldsOf(mesh)), m_binary(binary) {
        for (const MeshField& field : m_fields) m_binary = m_binary || !isFinite(field.values);
        for (const MeshField& field : mesh.fileFields) m_binary = m_binary || !isFinite(field.values);
    }

    /// Prints the layout of version 3, which every reader knows.
    std::string print() {
        m_out << "# vtk DataFile Version 3.0\nWend\n"
              << (m_binary ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\n";
        printFileFields();
        m_out << "POINTS " << m_mesh.points.cols() << " double\n";
        for (const auto& p : m_mesh.points.colwise())
            numbers(std::vector<double>(p.begin(), p.end()), 3, Scalar::Float64);
        endArray();
        const auto cells = vtkCellsOf(m_mesh.cells);
        printCells(cells);
        printData(cells, false);
        printData(cells, true);
        return std::move(m_out.text());
    }

  private:
    void printFileFields() {
        if (m_mesh.fileFields.empty()) return;
        m_out << "FIELD FieldData " << m_mesh.fileFields.size() << '\n';
        for (const auto& field : m_mesh.fileFields) printField(field);
    }
    /// Writes numbers, as big-endian bytes or as text with some per line.
    void numbers(const std::vector<double>& values, int perLine, Scalar type) {
        int inLine = 0;
        for (double value : values) {
            if (m_binary) {
                appendReal(m_out.text(), value, type, std::endian::big);
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
    /// Writes the fields of the points or of the cells.
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
        numbers(std::vector<double>(m_mesh.uv.data(), m_mesh.uv.data() + m_mesh.uv.size()), 2,
                Scalar::Float64);
        endArray();
    }
    void printField(const MeshField& field) {
        m_out << encoded(field.name) << ' ' << field.components << ' '
              << field.values.size() / field.components << ' ' << nameInVtk(field.type) << '\n';
        if (const auto whole = longNumbers<std::int64_t>(field); !whole.empty())
            printLong(whole, field);
        else if (const auto natural = longNumbers<std::uint64_t>(field); !natural.empty())
            printLong(natural, field);
        else
            numbers(field.values, field.components, field.type);
        endArray();
    }
    template <class Whole>
    void printLong(const std::vector<Whole>& values, const MeshField& field) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (m_binary)
                appendInteger(m_out.text(), static_cast<std::int64_t>(values[i]), field.type,
                              std::endian::big);
            else
                m_out << values[i] << ((i + 1) % static_cast<std::size_t>(field.components) ? ' ' : '\n');
        }
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
