#include <algorithm>
#include <numeric>

#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_cells.h"
#include "core/mesh/formats/vtk_fields.h"
#include "core/mesh/formats/vtu_array.h"

namespace wend::formats {
namespace {

class VtuPrinter {
  public:
    VtuPrinter(const MeshFile& mesh, const MeshWriteOptions& options)
        : m_mesh(mesh),
          m_fields(vtkFieldsOf(mesh)),
          m_binary(options.binary()),
          m_appended(options.binary() && options.appended) {
        m_encoding.order = std::endian::native;
        m_encoding.header = Scalar::UInt64;
        if (options.encoding == MeshWriteOptions::Encoding::Compressed)
            m_encoding.compressor = VtuEncoding::Compressor::Zlib;
        m_encoding.base64 = !m_appended;
    }

    /// Prints an unstructured grid: points, cells, and the fields of both.
    std::string print() {
        const auto cells = vtkCellsOf(m_mesh.cells);
        open("UnstructuredGrid", " NumberOfCells=\"" + std::to_string(cells.types.size()) + "\"");
        printPoints();
        m_out << "<Cells>\n";
        array<std::int64_t>("connectivity", 1, cells.connectivity);
        array<std::int64_t>("offsets", 1, std::span<const std::int64_t>(cells.offsets).subspan(1));
        array<std::int64_t>("types", 1, cells.types);
        m_out << "</Cells>\n";
        data(false);
        data(true);
        close("UnstructuredGrid");
        return std::move(m_out.text());
    }
    /// Prints the cells in the order of their sections.
    std::string printPolyData() {
        std::string counts;
        for (std::size_t k = 0; k < std::size(kPolySections); ++k)
            counts += std::string(" ") + kPolySections[k].count + "=\"" +
                      std::to_string(polyCells(k).offsets.size()) + "\"";
        open("PolyData", counts);
        printPoints();
        for (std::size_t k = 0; k < std::size(kPolySections); ++k) {
            const VtkCells cells = polyCells(k);
            m_out << "<" << kPolySections[k].name << ">\n";
            array<std::int64_t>("connectivity", 1, cells.connectivity);
            array<std::int64_t>("offsets", 1, cells.offsets);
            m_out << "</" << kPolySections[k].name << ">\n";
        }
        data(false);
        data(true);
        close("PolyData");
        return std::move(m_out.text());
    }

  private:
    /// Those of one section; the offsets are the ends of the cells.
    VtkCells polyCells(std::size_t section) const {
        VtkCells cells;
        for (int c = 0; c < m_mesh.cells.size(); ++c) {
            const CellKind kind = m_mesh.cells.kinds[static_cast<std::size_t>(c)];
            if (polySectionOf(kind) != static_cast<int>(section)) continue;
            const auto nodes = m_mesh.cells[c];
            cells.connectivity.insert(cells.connectivity.end(), nodes.begin(), nodes.end());
            cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
        }
        return cells;
    }
    void printPoints() {
        m_out << "<Points>\n";
        array("Points", 3, std::span(m_mesh.points.data(), static_cast<std::size_t>(m_mesh.points.size())));
        m_out << "</Points>\n";
    }
    void open(const std::string& grid, const std::string& counts) {
        const bool little = m_encoding.order == std::endian::little;
        m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << grid << "\" version=\"1.0\" byte_order=\""
              << (little ? "LittleEndian" : "BigEndian") << "\" header_type=\"UInt64\""
              << (m_encoding.compressor == VtuEncoding::Compressor::Zlib
                      ? " compressor=\"vtkZLibDataCompressor\""
                      : "")
              << ">\n<" << grid << ">\n";
        printFileFields();
        m_out << "<Piece NumberOfPoints=\"" << m_mesh.points.cols() << '"' << counts << ">\n";
    }
    void close(const std::string& grid) {
        m_out << "</Piece>\n</" << grid << ">\n";
        if (m_appended) m_out << "<AppendedData encoding=\"raw\">\n_" << m_data << "\n</AppendedData>\n";
        m_out << "</VTKFile>\n";
    }
    void printFileFields() {
        if (m_mesh.fileFields.empty()) return;
        m_out << "<FieldData>\n";
        for (const auto& field : m_mesh.fileFields)
            fieldArray(field,
                       " NumberOfTuples=\"" + std::to_string(field.values.size() / field.components) + "\"");
        m_out << "</FieldData>\n";
    }
    void data(bool perCell) {
        const bool texture = !perCell && m_mesh.uv.cols();
        m_out << (perCell ? "<CellData" : "<PointData") << (texture ? " TCoords=\"uv\">\n" : ">\n");
        if (texture) array("uv", 2, std::span(m_mesh.uv.data(), static_cast<std::size_t>(m_mesh.uv.size())));
        for (const auto& field : m_fields)
            if (field.perCell == perCell) fieldArray(field, "");
        m_out << (perCell ? "</CellData>\n" : "</PointData>\n");
    }

    /// Prints a field in the type of the file that it comes from.
    void fieldArray(const MeshField& field, const std::string& more) {
        if (field.type == Scalar::Float64)
            return array<double>(field.name, field.components, field.values, more);
        if (const auto numbers = longNumbers<std::int64_t>(field); !numbers.empty())
            return longArray(field, std::span(numbers), more);
        if (const auto numbers = longNumbers<std::uint64_t>(field); !numbers.empty())
            return longArray(field, std::span(numbers), more);
        std::string bytes;
        for (const double value : field.values) appendReal(bytes, value, field.type, m_encoding.order);
        openArray(field.name, field.components, vtuScalarName(field.type), more);
        closeArray(std::span<const double>(field.values), field.components, bytes);
    }
    template <class Whole>
    void longArray(const MeshField& field, std::span<const Whole> numbers, const std::string& more) {
        std::string bytes;
        for (const Whole one : numbers)
            appendInteger(bytes, static_cast<std::int64_t>(one), field.type, m_encoding.order);
        openArray(field.name, field.components, vtuScalarName(field.type), more);
        closeArray(numbers, field.components, bytes);
    }
    template <class T>
    void array(const std::string& name, int components, std::span<const T> values,
               const std::string& more = "") {
        openArray(name, components, std::is_same_v<T, double> ? "Float64" : "Int64", more);
        closeArray(values, components, bytesOf(values));
    }
    void openArray(const std::string& name, int components, std::string_view type, const std::string& more) {
        m_out << "<DataArray type=\"" << type << "\" Name=\"" << asXml(name) << "\" NumberOfComponents=\""
              << components << '"' << more << " format=\""
              << (m_appended ? "appended"
                  : m_binary ? "binary"
                             : "ascii")
              << '"';
    }
    template <class T>
    void closeArray(std::span<const T> values, int components, const std::string& bytes) {
        if (m_appended) {
            m_out << " offset=\"" << m_data.size() << "\"/>\n";
            m_data += encodeVtuArray(bytes, m_encoding);
            return;
        }
        m_out << ">\n";
        if (m_binary)
            m_out << encodeVtuArray(bytes, m_encoding) << '\n';
        else
            text(values, components == 1 ? 12 : components);
        m_out << "</DataArray>\n";
    }
    template <class T>
    static std::string bytesOf(std::span<const T> values) {
        return std::string(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    template <class T>
    void text(std::span<const T> values, int perLine) {
        for (std::size_t i = 0; i < values.size(); ++i)
            m_out << values[i] << ((i + 1) % perLine && i + 1 < values.size() ? ' ' : '\n');
    }

    const MeshFile& m_mesh;
    std::vector<MeshField> m_fields;
    bool m_binary, m_appended;
    VtuEncoding m_encoding;
    std::string m_data;
    TextWriter m_out;
};

}  // namespace

std::vector<std::string> printVtu(const MeshFile& mesh, const MeshWriteOptions& options) {
    return {VtuPrinter(mesh, options).print()};
}

std::vector<std::string> printVtp(const MeshFile& mesh, const MeshWriteOptions& options) {
    std::vector<int> order(static_cast<std::size_t>(mesh.cells.size()));
    std::iota(order.begin(), order.end(), 0);
    const auto section = [&mesh](int c) {
        return polySectionOf(mesh.cells.kinds[static_cast<std::size_t>(c)]);
    };
    if (std::ranges::is_sorted(order, {}, section)) return {VtuPrinter(mesh, options).printPolyData()};
    std::ranges::stable_sort(order, {}, section);
    return {VtuPrinter(inOrder(mesh, order), options).printPolyData()};
}

}  // namespace wend::formats
