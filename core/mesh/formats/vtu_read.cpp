// VTK's XML unstructured grid and poly data: data arrays as text, base64 in place, or appended (base64 or
// raw), plain or compressed by zlib, LZ4 or LZMA, in one piece or several, which are put one behind the
// other.

#include <algorithm>
#include <optional>
#include <pugixml.hpp>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/vtk_cells.h"
#include "core/mesh/formats/vtu_array.h"

namespace wend::formats {
namespace {

/// Raw appended data is no XML: the text between <AppendedData …> and </AppendedData> is cut out before
/// parsing.
struct Split {
    std::string xml;
    std::optional<std::string_view> appended;  // what follows the underscore
};

/// Separates raw appended data from the XML, in which such bytes are not allowed.
Split split(std::string_view bytes) {
    const auto tag = bytes.find("<AppendedData");
    const auto start = tag == std::string_view::npos ? tag : bytes.find('>', tag);
    const auto end = bytes.rfind("</AppendedData>");
    if (start == std::string_view::npos || end == std::string_view::npos || end < start)
        return {std::string(bytes), std::nullopt};
    auto data = bytes.substr(start + 1, end - start - 1);
    const auto underscore = data.find('_');
    if (underscore == std::string_view::npos)
        throw InputError("the appended data does not begin with an underscore");
    std::string xml(bytes.substr(0, start + 1));
    xml += bytes.substr(end);
    return {std::move(xml), data.substr(underscore + 1)};
}

/// Compressed data can claim a thousand times its size, and as numbers eight times that. Meshes are not so
/// empty: all numbers together may take so many bytes, or so many for each of the file.
constexpr std::size_t kSmall = std::size_t(64) << 20;
constexpr std::size_t kExpansion = 400;

class VtuReader {
  public:
    VtuReader(std::string_view bytes, bool isPolyData)
        : m_isPolyData(isPolyData), m_parts(split(bytes)), m_room(kSmall + kExpansion * bytes.size()) {}

    /// Reads all pieces of the grid or of the polygonal data.
    MeshFile read() {
        parse();
        const auto root = m_document.child("VTKFile");
        if (!root)
            throw InputError(std::string("there is no element VTKFile: no ") +
                             (m_isPolyData ? ".vtp" : ".vtu") + " file");
        readEncoding(root);
        const auto grid = child(root, m_isPolyData ? "PolyData" : "UnstructuredGrid");
        child(grid, "Piece");
        for (const auto piece : grid.children("Piece")) readPiece(piece);
        readFileFields(grid.child("FieldData"));
        addGroupsOfFields(m_file);
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    struct Count {
        std::int64_t tuples;
        int components;
    };

    void parse() {
        const auto result = m_document.load_buffer(m_parts.xml.data(), m_parts.xml.size());
        if (!result) throw InputError(lineOf(result.offset) + ": not valid XML: " + result.description());
    }
    std::string lineOf(std::ptrdiff_t offset) const {
        const auto before =
            m_parts.xml.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
        return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
    }
    [[noreturn]] void fail(pugi::xml_node node, const std::string& what) const {
        const std::string name = node.attribute("Name").value();
        throw InputError(lineOf(node.offset_debug()) + ": <" + node.name() +
                         (name.empty() ? "" : " " + inQuotes(name)) + ">: " + what);
    }
    pugi::xml_node child(pugi::xml_node parent, const char* name) const {
        const auto node = parent.child(name);
        if (!node) fail(parent, std::string("there is no <") + name + "> in it");
        return node;
    }
    std::int64_t attribute(pugi::xml_node node, const char* name) const {
        if (!node.attribute(name)) fail(node, std::string("the attribute ") + name + " is missing");
        try {
            return Scanner(node.attribute(name).value()).integer(name);
        } catch (const InputError&) {
            fail(node, std::string(name) + " is no whole number");
        }
    }

    /// Reads byte order, compressor and type of headers from the root element.
    void readEncoding(pugi::xml_node root) {
        const std::string_view kind = root.attribute("type").value();
        const char* const wanted = m_isPolyData ? "PolyData" : "UnstructuredGrid";
        if (kind != wanted) fail(root, "it holds " + inQuotes(kind) + " instead of " + inQuotes(wanted));
        const std::string_view order = root.attribute("byte_order").as_string("LittleEndian");
        m_encoding.order = order == "BigEndian" ? std::endian::big : std::endian::little;
        const std::string_view header = root.attribute("header_type").as_string("UInt32");
        if (header != "UInt32" && header != "UInt64") fail(root, inQuotes(header) + " is no header_type");
        m_encoding.header = header == "UInt64" ? Scalar::UInt64 : Scalar::UInt32;
        const std::string_view compressor = root.attribute("compressor").value();
        using enum VtuEncoding::Compressor;
        m_encoding.compressor = compressor == "vtkZLibDataCompressor"   ? Zlib
                                : compressor == "vtkLZ4DataCompressor"  ? Lz4
                                : compressor == "vtkLZMADataCompressor" ? Lzma
                                                                        : None;
        if (m_encoding.compressor == None && !compressor.empty())
            fail(root, "it is compressed by " + inQuotes(compressor) + ", which is not read");
        const std::string_view appended =
            root.child("AppendedData").attribute("encoding").as_string("base64");
        m_appendedRaw = appended == "raw";
    }
    /// Reads a piece and appends it to those before it.
    void readPiece(pugi::xml_node piece) {
        const auto pointCount = attribute(piece, "NumberOfPoints");
        const auto firstPoint = m_file.points.cols();
        readPoints(piece, pointCount);
        const VtkCells cells =
            m_isPolyData ? readPolyCells(piece) : readCells(piece, attribute(piece, "NumberOfCells"));
        const auto cellCount = static_cast<std::int64_t>(cells.types.size());
        collect(cells, static_cast<long>(pointCount), static_cast<int>(firstPoint), m_file.cells);
        const bool first = firstPoint == 0 && m_file.fields.empty();
        std::vector<MeshField> fields;
        readFields(piece.child("PointData"), false, pointCount, fields);
        readFields(piece.child("CellData"), true, cellCount, fields);
        if (first)
            m_file.fields = std::move(fields);
        else
            appendFields(piece, fields);
    }
    /// Pieces have the same arrays.
    void appendFields(pugi::xml_node piece, const std::vector<MeshField>& fields) {
        bool same = fields.size() == m_file.fields.size();
        for (std::size_t f = 0; same && f < fields.size(); ++f) {
            MeshField& field = m_file.fields[f];
            same = field.name == fields[f].name && field.perCell == fields[f].perCell &&
                   field.components == fields[f].components;
            appendBeyond(field, fields[f]);
            field.values.insert(field.values.end(), fields[f].values.begin(), fields[f].values.end());
        }
        if (!same) fail(piece, "has other arrays than the piece before it");
    }
    static void appendBeyond(MeshField& field, const MeshField& next) {
        if (field.beyond.empty() && next.beyond.empty()) return;
        field.beyond.resize(field.values.size(), 0);
        field.beyond.insert(field.beyond.end(), next.beyond.begin(), next.beyond.end());
        field.beyond.resize(field.values.size() + next.values.size(), 0);
    }
    static void dropZeros(std::vector<std::int16_t>& beyond) {
        if (std::ranges::all_of(beyond, [](std::int16_t one) { return one == 0; })) beyond.clear();
    }
    static auto valuesInto(std::vector<std::int16_t>& beyond) {
        return [&beyond](auto& reader, Scalar type) { return reader.real(type, "a number", beyond); };
    }
    /// Reads the fields of the file as a whole. Texts are left out, with a notice.
    void readFileFields(pugi::xml_node data) {
        for (const auto array : data.children("DataArray")) {
            const std::string name = array.attribute("Name").value();
            if (std::string_view(array.attribute("type").value()) == "String") {
                m_file.notices.push_back("the text " + inQuotes(name));
                continue;
            }
            const int components = componentsOf(array);
            MeshField field{name, false, components, {}, {}, scalarOf(array)};
            field.values = numbersOf<double>(array, std::nullopt, valuesInto(field.beyond));
            dropZeros(field.beyond);
            if (field.values.size() % static_cast<std::size_t>(components))
                fail(array, "a part of a tuple is left over");
            m_file.fileFields.push_back(std::move(field));
        }
    }

    Scalar scalarOf(pugi::xml_node array) const {
        const std::string_view name = array.attribute("type").value();
        const auto type = vtuScalarNamed(name);
        if (!type) fail(array, inQuotes(name) + " is no type of numbers");
        return *type;
    }
    /// Returns the text from the beginning of a binary array on.
    std::string_view startOf(pugi::xml_node array, bool appended) const {
        if (!appended) return trimmed(array.text().get());
        const auto offset = attribute(array, "offset");
        if (!m_parts.appended) throw InputError("there is no <AppendedData> in the file");
        if (offset < 0 || static_cast<std::size_t>(offset) >= m_parts.appended->size())
            throw InputError("its offset is beyond the appended data");
        return m_parts.appended->substr(static_cast<std::size_t>(offset));
    }
    /// Returns the bytes of a binary array, once their number is known to be right.
    std::string bytesOf(pugi::xml_node array, bool appended, Scalar type, std::optional<Count> wanted) {
        auto encoding = m_encoding;
        encoding.base64 = !appended || !m_appendedRaw;
        const std::string_view start = startOf(array, appended);
        const std::size_t size = vtuArraySize(start, encoding), numbers = size / sizeOf(type);
        if (size % sizeOf(type)) throw InputError("a part of a number is left over");
        if (wanted) requireCount(numbers, *wanted);
        if (8 * numbers > m_room) throw InputError("it claims more numbers than such a file can hold");
        m_room -= 8 * numbers;
        return decodeVtuArray(start, encoding);
    }
    static std::string_view trimmed(std::string_view text) {
        const auto first = text.find_first_not_of(" \t\r\n");
        return first == std::string_view::npos ? std::string_view() : text.substr(first);
    }
    /// Returns all numbers of an array, each made by take(reader, type).
    template <class T, class Take>
    std::vector<T> numbersOf(pugi::xml_node array, std::optional<Count> wanted, const Take& take) {
        const auto type = scalarOf(array);
        const std::string_view format = array.attribute("format").as_string("ascii");
        std::vector<T> numbers;
        try {
            const bool binary = format != "ascii";
            const std::string bytes =
                binary ? bytesOf(array, format == "appended", type, wanted) : array.text().get();
            Scanner scanner(bytes);
            NumberReader reader(scanner, binary, m_encoding.order);
            if (binary) numbers.reserve(bytes.size() / sizeOf(type));
            while (binary ? scanner.remaining() > 0 : !scanner.atEnd()) numbers.push_back(take(reader, type));
            if (wanted) requireCount(numbers.size(), *wanted);
        } catch (const InputError& error) {
            fail(array, error.reason());
        }
        return numbers;
    }
    std::vector<double> reals(pugi::xml_node array, Count wanted) {
        return numbersOf<double>(array, wanted,
                                 [](auto& reader, Scalar type) { return reader.real(type, "a number"); });
    }
    std::vector<std::int64_t> integers(pugi::xml_node array, std::optional<Count> wanted) {
        return numbersOf<std::int64_t>(
            array, wanted, [](auto& reader, Scalar type) { return reader.integer(type, "a whole number"); });
    }
    static void requireCount(std::size_t found, Count wanted) {
        const auto [tuples, components] = wanted;
        if (tuples < 0 || found % components || found / components != static_cast<std::size_t>(tuples))
            throw InputError("has " + std::to_string(found) + " numbers where " + std::to_string(tuples) +
                             " times " + std::to_string(components) + " are needed");
    }
    pugi::xml_node namedArray(pugi::xml_node parent, const char* name) const {
        const auto array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) fail(parent, std::string("there is no DataArray '") + name + "' in it");
        return array;
    }

    void readPoints(pugi::xml_node piece, std::int64_t count) {
        if (count == 0 && m_isPolyData && !piece.child("Points").child("DataArray")) return;
        const auto array = child(child(piece, "Points"), "DataArray");
        const auto coordinates = reals(array, Count{count, 3});
        const auto first = m_file.points.cols();
        m_file.points.conservativeResize(3, first + static_cast<Eigen::Index>(count));
        m_file.points.rightCols(count) =
            Eigen::Map<const Eigen::Matrix3Xd>(coordinates.data(), 3, static_cast<Eigen::Index>(count));
    }
    VtkCells readCells(pugi::xml_node piece, std::int64_t count) {
        const auto node = child(piece, "Cells");
        VtkCells cells;
        cells.offsets = integers(namedArray(node, "offsets"), Count{count, 1});
        cells.types = integers(namedArray(node, "types"), Count{count, 1});
        cells.connectivity = integers(namedArray(node, "connectivity"), std::nullopt);
        cells.offsets.insert(cells.offsets.begin(), 0);
        return cells;
    }
    /// Reads vertices, lines, strips and polygons in the order of their values.
    VtkCells readPolyCells(pugi::xml_node piece) {
        VtkCells all;
        all.offsets.push_back(0);
        for (const PolySection& section : kPolySections) {
            if (!piece.attribute(section.count)) continue;
            const auto count = attribute(piece, section.count);
            if (count > 0) addPolyCells(child(piece, section.name), count, section, all);
        }
        return all;
    }
    /// Adds the cells of one section of a .vtp file, whose types follow from their numbers of nodes.
    void addPolyCells(pugi::xml_node node, std::int64_t count, const PolySection& section, VtkCells& all) {
        const auto offsets = integers(namedArray(node, "offsets"), Count{count, 1});
        const auto connectivity = integers(namedArray(node, "connectivity"), std::nullopt);
        const auto first = static_cast<std::int64_t>(all.connectivity.size());
        std::int64_t before = 0;
        for (const std::int64_t end : offsets) {
            if (end < before || end > static_cast<std::int64_t>(connectivity.size()))
                fail(node, "an offset is outside the connectivity");
            all.types.push_back(section.typeOf(end - before));
            all.offsets.push_back(first + end);
            before = end;
        }
        if (before != static_cast<std::int64_t>(connectivity.size()))
            fail(node, "the offsets end before the connectivity does");
        all.connectivity.insert(all.connectivity.end(), connectivity.begin(), connectivity.end());
    }
    /// Reads the fields of vertices or cells. Their texture points become uv.
    void readFields(pugi::xml_node data, bool perCell, std::int64_t tuples, std::vector<MeshField>& fields) {
        const std::string_view texture = data.attribute("TCoords").value();
        for (const auto array : data.children("DataArray")) {
            const std::string name = array.attribute("Name").value();
            if (std::string_view(array.attribute("type").value()) == "String") {
                m_file.notices.push_back("the text " + inQuotes(name));
                continue;
            }
            const int components = componentsOf(array);
            MeshField field{name, perCell, components, {}, {}, scalarOf(array)};
            field.values = numbersOf<double>(array, Count{tuples, components}, valuesInto(field.beyond));
            dropZeros(field.beyond);
            if (!perCell && !texture.empty() && field.name == texture && components == 2)
                addTexture(field);
            else
                fields.push_back(std::move(field));
        }
    }
    void addTexture(const MeshField& field) {
        const auto count = static_cast<Eigen::Index>(field.values.size() / 2);
        const auto first = m_file.points.cols() - count;
        if (m_file.uv.cols() != first) return;
        m_file.uv.conservativeResize(2, first + count);
        m_file.uv.rightCols(count) = Eigen::Map<const Eigen::Matrix2Xd>(field.values.data(), 2, count);
    }
    int componentsOf(pugi::xml_node array) const {
        if (!array.attribute("NumberOfComponents")) return 1;
        const auto components = attribute(array, "NumberOfComponents");
        if (components < 1 || components > 1000000) fail(array, "the number of components makes no sense");
        return static_cast<int>(components);
    }

    const bool m_isPolyData;  // a .vtp file
    Split m_parts;
    std::size_t m_room;  // bytes that binary arrays may still take as numbers
    pugi::xml_document m_document;
    VtuEncoding m_encoding;
    bool m_appendedRaw = false;
    MeshFile m_file;
};

}  // namespace

MeshFile readVtu(std::span<const MeshSource> files) {
    return VtuReader(files[0].bytes, false).read();
}

MeshFile readVtp(std::span<const MeshSource> files) {
    return VtuReader(files[0].bytes, true).read();
}

}  // namespace wend::formats
