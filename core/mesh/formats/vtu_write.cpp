#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/formats/vtk_fields.h"
#include "core/mesh/formats/vtu_array.h"

namespace wend::formats {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (char c : text) {
        if (c == '&' || c == '<' || c == '>' || c == '"')
            result += "&#" + std::to_string(static_cast<int>(c)) + ";";
        else
            result += static_cast<unsigned char>(c) < ' ' ? '_' : c;
    }
    return result;
}

class VtuPrinter {
  public:
    VtuPrinter(const MeshFile& mesh, const MeshWriteOptions& options)
        : m_mesh(mesh),
          m_fields(vtkFieldsOf(mesh)),
          m_binary(options.binary()),
          m_appended(options.binary() && options.appended) {
        m_encoding.order = std::endian::native;
        m_encoding.header = Scalar::UInt64;
        m_encoding.compressed = options.encoding == MeshWriteOptions::Encoding::Compressed;
        m_encoding.base64 = !m_appended;
    }

    std::string print() {
        const auto cells = vtkCellsOf(m_mesh);
        open(cells.types.size());
        m_out << "<Points>\n";
        array("Points", 3, std::span(m_mesh.points.data(), static_cast<std::size_t>(m_mesh.points.size())));
        m_out << "</Points>\n<Cells>\n";
        array<std::int64_t>("connectivity", 1, cells.connectivity);
        array<std::int64_t>("offsets", 1, std::span(cells.offsets).subspan(1));
        array<std::int64_t>("types", 1, cells.types);
        m_out << "</Cells>\n";
        data(false);
        data(true);
        close();
        return std::move(m_out.text());
    }

  private:
    void open(std::size_t cellCount) {
        const bool little = m_encoding.order == std::endian::little;
        m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
              << (little ? "LittleEndian" : "BigEndian") << "\" header_type=\"UInt64\""
              << (m_encoding.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "")
              << ">\n<UnstructuredGrid>\n"
              << "<Piece NumberOfPoints=\"" << m_mesh.points.cols() << "\" NumberOfCells=\"" << cellCount
              << "\">\n";
    }
    void close() {
        m_out << "</Piece>\n</UnstructuredGrid>\n";
        if (m_appended) m_out << "<AppendedData encoding=\"raw\">\n_" << m_data << "\n</AppendedData>\n";
        m_out << "</VTKFile>\n";
    }
    void data(bool perCell) {
        const bool texture = !perCell && m_mesh.uv.cols();
        m_out << (perCell ? "<CellData" : "<PointData") << (texture ? " TCoords=\"uv\">\n" : ">\n");
        if (texture) array("uv", 2, std::span(m_mesh.uv.data(), static_cast<std::size_t>(m_mesh.uv.size())));
        for (const auto& field : m_fields)
            if (field.perCell == perCell) array<double>(field.name, field.components, field.values);
        m_out << (perCell ? "</CellData>\n" : "</PointData>\n");
    }

    template <class T>
    void array(const std::string& name, int components, std::span<const T> values) {
        constexpr bool real = std::is_same_v<T, double>;
        const char* format = m_appended ? "appended" : m_binary ? "binary" : "ascii";
        m_out << "<DataArray type=\"" << (real ? "Float64" : "Int64") << "\" Name=\"" << escaped(name)
              << "\" NumberOfComponents=\"" << components << "\" format=\"" << format << '"';
        if (m_appended) {
            m_out << " offset=\"" << m_data.size() << "\"/>\n";
            m_data += encodeVtuArray(bytesOf(values), m_encoding);
            return;
        }
        m_out << ">\n";
        if (m_binary)
            m_out << encodeVtuArray(bytesOf(values), m_encoding) << '\n';
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

}  // namespace wend::formats
