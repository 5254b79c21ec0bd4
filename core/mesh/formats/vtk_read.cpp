// VTK's legacy format: UNSTRUCTURED_GRID and POLYDATA, text and binary (big endian), in the cell layouts of
// version 4 (a size before each cell's corners) and of version 5 (OFFSETS and CONNECTIVITY).

#include <algorithm>
#include <optional>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/vtk_cells.h"

namespace wend::formats {
namespace {

struct VtkType {
    Scalar scalar = Scalar::Float32;
    bool bits = false;  // packed, eight in a byte
};

std::optional<VtkType> typeNamed(std::string_view name) {
    constexpr std::pair<std::string_view, Scalar> names[] = {{"char", Scalar::Int8},
                                                             {"signed_char", Scalar::Int8},
                                                             {"unsigned_char", Scalar::UInt8},
                                                             {"short", Scalar::Int16},
                                                             {"unsigned_short", Scalar::UInt16},
                                                             {"int", Scalar::Int32},
                                                             {"unsigned_int", Scalar::UInt32},
                                                             {"vtkIdType", Scalar::Int32},
                                                             {"long", Scalar::Int64},
                                                             {"unsigned_long", Scalar::UInt64},
                                                             {"vtktypeint64", Scalar::Int64},
                                                             {"vtktypeuint64", Scalar::UInt64},
                                                             {"float", Scalar::Float32},
                                                             {"double", Scalar::Float64}};
    if (sameWord(name, "bit")) return VtkType{Scalar::UInt8, true};
    for (const auto& [known, scalar] : names)
        if (sameWord(known, name)) return VtkType{scalar, false};
    return std::nullopt;
}

/// Names may hold %20 and the like.
std::string decoded(std::string_view name) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool escaped =
            name[i] == '%' && i + 2 < name.size() && digit(name[i + 1]) >= 0 && digit(name[i + 2]) >= 0;
        text += escaped ? static_cast<char>(16 * digit(name[i + 1]) + digit(name[i + 2])) : name[i];
        if (escaped) i += 2;
    }
    return text;
}

class VtkReader {
  public:
    explicit VtkReader(std::string_view bytes) : m_scanner(bytes) {}

    /// Reads all statements, and collects the cells of polygonal data in the order of their values.
    MeshFile read() {
        readHeader();
        while (!m_scanner.atEnd()) statement();
        // the data of POLYDATA counts the cells in this order
        for (const auto* part : {&m_vertices, &m_lines, &m_cells, &m_strips})
            if (!part->offsets.empty()) collect(*part, m_file.points.cols(), 0, m_file.cells);
        takeFields(m_file.cells.size());
        addGroupsOfFields(m_file);
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    enum class Data { None, Points, Cells };
    struct FieldOfElements {
        MeshField field;
        std::size_t tuples;
    };

    /// Reads the first lines: version, title and encoding.
    void readHeader() {
        if (!m_scanner.line().starts_with("# vtk DataFile"))
            m_scanner.fail("does not begin with '# vtk DataFile': no VTK legacy file");
        m_scanner.line();  // the title
        const auto encoding = m_scanner.word("ASCII or BINARY");
        const bool binary = sameWord(encoding, "BINARY");
        if (!binary && !sameWord(encoding, "ASCII"))
            m_scanner.fail(inQuotes(encoding) + " is neither ASCII nor BINARY");
        if (binary) m_scanner.placesAreOffsets();
        m_numbers = NumberReader(m_scanner, binary, std::endian::big);
    }

    /// Reads the part of the file that a keyword begins.
    void statement() {
        const auto keyword = m_scanner.word("a keyword");
        if (sameWord(keyword, "DATASET"))
            requireDataset();
        else if (sameWord(keyword, "POINTS"))
            readPoints();
        else if (sameWord(keyword, "CELLS"))
            readCells(m_cells, 0);
        else if (sameWord(keyword, "CELL_TYPES"))
            readCellTypes();
        else if (sameWord(keyword, "VERTICES"))
            readCells(m_vertices, 2);
        else if (sameWord(keyword, "LINES"))
            readCells(m_lines, 4);
        else if (sameWord(keyword, "POLYGONS"))
            readCells(m_cells, 7);
        else if (sameWord(keyword, "TRIANGLE_STRIPS"))
            readCells(m_strips, 6);
        else if (sameWord(keyword, "METADATA"))
            passOverMetadata();
        else
            dataStatement(keyword);
    }
    /// It ends with an empty line.
    void passOverMetadata() {
        m_scanner.line();
        while (m_scanner.remaining() && !m_scanner.line().empty()) {
        }
    }
    void requireDataset() {
        const auto kind = m_scanner.word("the kind of data set");
        if (!sameWord(kind, "UNSTRUCTURED_GRID") && !sameWord(kind, "POLYDATA"))
            m_scanner.fail(inQuotes(kind) + ": only UNSTRUCTURED_GRID and POLYDATA are read");
    }

    VtkType type() {
        const auto name = m_scanner.wordOnLine("a type");
        const auto known = typeNamed(name);
        if (!known) m_scanner.fail(inQuotes(name) + " is no type that is read");
        return *known;
    }
    /// Values begin on the next line; after binary ones a line end follows, which counts as a blank.
    std::vector<double> values(std::size_t count, VtkType type, std::vector<std::int16_t>* beyond = nullptr) {
        if (m_numbers.binary()) m_scanner.line();
        std::vector<double> numbers;
        if (type.bits && m_numbers.binary()) {
            const auto packed = m_scanner.raw((count + 7) / 8, "bits");
            for (std::size_t i = 0; i < count; ++i) numbers.push_back((packed[i / 8] >> (7 - i % 8)) & 1);
            return numbers;
        }
        numbers.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            numbers.push_back(beyond ? m_numbers.real(type.scalar, "a value", *beyond)
                                     : m_numbers.real(type.scalar, "a value"));
        return numbers;
    }
    std::vector<std::int64_t> wholeNumbers(std::size_t count, Scalar scalar) {
        if (m_numbers.binary()) m_scanner.line();
        std::vector<std::int64_t> numbers;
        numbers.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            numbers.push_back(m_numbers.integer(scalar, "a whole number"));
        return numbers;
    }
    int count(const char* things, std::size_t numbersEach, VtkType type) {
        return m_numbers.checkedCount(wholeOnLine(things), things, type.bits ? 0 : numbersEach, type.scalar);
    }
    std::int64_t wholeOnLine(const char* what) {
        return m_scanner.integerFrom(m_scanner.wordOnLine(what), what);
    }

    void readPoints() {
        if (m_file.points.cols()) m_scanner.fail("there are points a second time");
        const auto declared = wholeOnLine("the number of points");
        const auto scalar = type().scalar;
        const int pointCount = m_numbers.checkedCount(declared, "points", 3, scalar);
        const auto coordinates = values(3 * static_cast<std::size_t>(pointCount), {scalar, false});
        m_file.points = Eigen::Map<const Eigen::Matrix3Xd>(coordinates.data(), 3, pointCount);
    }
    /// `type` is that of all cells, or 0 if CELL_TYPES says it.
    void readCells(VtkCells& cells, int cellType) {
        if (!cells.offsets.empty()) m_scanner.fail("there are cells of one kind a second time");
        const auto declared = wholeOnLine("the number of cells"), size = wholeOnLine("a size");
        const bool byOffsets = m_scanner.nextIs("OFFSETS");
        if (byOffsets)
            readByOffsets(cells, declared, size);
        else
            readBySizes(cells, m_numbers.checkedCount(declared, "cells", 1, Scalar::Int32),
                        m_numbers.checkedCount(size, "numbers", 1, Scalar::Int32));
        if (cellType) cells.types.assign(cells.offsets.size() - 1, cellType);
    }
    /// Reads cells as newer files hold them: offsets and connectivity.
    void readByOffsets(VtkCells& cells, std::int64_t offsetCount, std::int64_t cornerCount) {
        m_scanner.word("OFFSETS");
        auto scalar = type().scalar;
        cells.offsets = wholeNumbers(m_numbers.checkedCount(offsetCount, "offsets", 1, scalar), scalar);
        if (cells.offsets.empty()) cells.offsets = {0};
        if (!sameWord(m_scanner.word("CONNECTIVITY"), "CONNECTIVITY"))
            m_scanner.fail("CONNECTIVITY is expected");
        scalar = type().scalar;
        cells.connectivity = wholeNumbers(m_numbers.checkedCount(cornerCount, "corners", 1, scalar), scalar);
    }
    /// Reads cells as they are in old files: for each the number of its corners, and these.
    void readBySizes(VtkCells& cells, int cellCount, int size) {
        const auto numbers = wholeNumbers(size, Scalar::Int32);
        cells.offsets = {0};
        std::size_t at = 0;
        for (int c = 0; c < cellCount; ++c) {
            const auto corners = at < numbers.size() ? numbers[at] : -1;
            if (corners < 0 || corners > static_cast<std::int64_t>(numbers.size() - at - 1))
                m_scanner.fail("cell " + std::to_string(c) + " has corners beyond the section's " +
                               std::to_string(size) + " numbers");
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            cells.connectivity.insert(cells.connectivity.end(), first, first + corners);
            cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
            at += 1 + corners;
        }
        if (at != numbers.size())
            m_scanner.fail("the cells take " + std::to_string(at) + " numbers instead of " +
                           std::to_string(size));
    }
    void readCellTypes() {
        const int typeCount = count("cell types", 1, {Scalar::Int32, false});
        m_cells.types = wholeNumbers(typeCount, Scalar::Int32);
        if (m_cells.offsets.size() != m_cells.types.size() + 1)
            m_scanner.fail("there are " + std::to_string(typeCount) +
                           " cell types for another number of cells");
    }

    void dataStatement(std::string_view keyword) {
        if (sameWord(keyword, "POINT_DATA"))
            startData(Data::Points, "points");
        else if (sameWord(keyword, "CELL_DATA"))
            startData(Data::Cells, "cells");
        else if (sameWord(keyword, "FIELD"))
            readFieldData();
        else if (m_data == Data::None)
            m_scanner.fail(inQuotes(keyword) + " is no keyword that is expected here");
        else
            attribute(keyword);
    }
    void startData(Data data, const char* things) {
        m_data = data;
        m_tuples = count(things, 0, {});
        if (data == Data::Points && m_tuples != static_cast<std::size_t>(m_file.points.cols()))
            m_scanner.fail("there is data of " + std::to_string(m_tuples) + " points, but the mesh has " +
                           std::to_string(m_file.points.cols()));
    }
    /// Reads one attribute of points or cells: scalars, colours, vectors, normals, texture points or tensors.
    void attribute(std::string_view keyword) {
        const bool colours = sameWord(keyword, "COLOR_SCALARS"), scalars = sameWord(keyword, "SCALARS");
        const std::string name = decoded(m_scanner.wordOnLine("the name of the data"));
        if (sameWord(keyword, "LOOKUP_TABLE")) {
            const auto size = wholeOnLine("the number of colours");
            readArray(name, 4, m_numbers.checkedCount(size, "colours", 1, Scalar::UInt8), colourType(),
                      false);  // of the way to look at data, in the section of some
        } else if (colours) {
            const auto components = wholeOnLine("the number of components");
            readArray(name, components, m_tuples, colourType(), true);
        } else if (scalars) {
            const auto valueType = type();
            const auto components = m_scanner.atLineEnd() ? 1 : wholeOnLine("the number of components");
            skipLookupTable();
            readArray(name, components, m_tuples, valueType, true);
        } else if (sameWord(keyword, "TEXTURE_COORDINATES")) {
            const auto components = wholeOnLine("the number of components");
            readTexture(name, components);
        } else {
            const int components = componentsOf(keyword);
            readArray(name, components, m_tuples, type(), true);
        }
    }
    /// Colours are bytes in a binary file and numbers from 0 to 1 in a text.
    VtkType colourType() const { return {m_numbers.binary() ? Scalar::UInt8 : Scalar::Float32, false}; }
    int componentsOf(std::string_view keyword) {
        for (const auto& [known, components] : {std::pair{"VECTORS", 3},
                                                {"NORMALS", 3},
                                                {"TENSORS", 9},
                                                {"TENSORS6", 6},
                                                {"GLOBAL_IDS", 1},
                                                {"PEDIGREE_IDS", 1}})
            if (sameWord(keyword, known)) return components;
        m_scanner.fail(inQuotes(keyword) + " is no keyword that is expected here");
    }
    void skipLookupTable() {
        if (!m_scanner.nextIs("LOOKUP_TABLE")) return;
        m_scanner.word("LOOKUP_TABLE");
        m_scanner.wordOnLine("the name of a table");
    }
    void readTexture(const std::string& name, std::int64_t components) {
        readArray(name, components, m_tuples, type(), true);
        if (m_data != Data::Points || components != 2 || m_file.uv.cols()) return;
        const auto& values = m_fields.back().field.values;
        m_file.uv = Eigen::Map<const Eigen::Matrix2Xd>(values.data(), 2, m_file.points.cols());
        m_fields.pop_back();
    }
    /// Reads a FIELD section, whose arrays name their own size and type.
    void readFieldData() {
        m_scanner.wordOnLine("the name of the field");
        const auto arrays = count("arrays", 0, {});
        for (int a = 0; a < arrays; ++a) {
            const std::string name = decoded(m_scanner.word("the name of an array"));
            if (name == "NULL_ARRAY") continue;
            const auto components = wholeOnLine("the number of components");
            const auto tuples = wholeOnLine("the number of tuples");
            if (tuples < 0) m_scanner.fail("there is a negative number of tuples");
            readArray(name, components, static_cast<std::size_t>(tuples), type(), m_data != Data::None);
            if (m_scanner.nextIs("METADATA")) statement();
        }
    }
    /// Reads an array of some tuples, and keeps it as a field if wanted. Its size is checked against the rest
    /// of the file first.
    void readArray(const std::string& name, std::int64_t components, std::size_t tuples, VtkType valueType,
                   bool keep) {
        const std::int64_t most = static_cast<std::int64_t>(8 * m_scanner.bytes().size());
        if (components < 1 || components > most) m_scanner.fail("the number of components makes no sense");
        const auto things = "tuples of the data " + inQuotes(name);
        const std::size_t bits = valueType.bits && m_numbers.binary() ? 8 : 1;
        const std::int64_t packed = static_cast<std::int64_t>((tuples + bits - 1) / bits);
        m_numbers.checkedCount(packed, things.c_str(), static_cast<std::size_t>(components),
                               valueType.scalar);
        MeshField field{name, m_data == Data::Cells, static_cast<int>(components), {}, {}, valueType.scalar};
        field.values = values(tuples * components, valueType, &field.beyond);
        if (std::ranges::all_of(field.beyond, [](std::int16_t one) { return one == 0; }))
            field.beyond.clear();
        if (keep) m_fields.push_back({std::move(field), tuples});
        if (!keep && m_data == Data::None) m_file.fileFields.push_back(std::move(field));
    }
    void takeFields(int elementCount) {
        for (auto& [field, tuples] : m_fields) {
            const auto needed = field.perCell ? static_cast<std::size_t>(elementCount) : m_file.points.cols();
            if (tuples != static_cast<std::size_t>(needed))
                m_scanner.fail("the data " + inQuotes(field.name) + " has " + std::to_string(tuples) +
                               " tuples where " + std::to_string(needed) + " are needed");
            m_file.fields.push_back(std::move(field));
        }
    }

    Scanner m_scanner;
    NumberReader m_numbers{m_scanner, false, std::endian::big};
    MeshFile m_file;
    VtkCells m_vertices, m_lines, m_cells, m_strips;
    Data m_data = Data::None;
    std::size_t m_tuples = 0;
    std::vector<FieldOfElements> m_fields;
};

}  // namespace

MeshFile readVtk(std::span<const MeshSource> files) {
    return VtkReader(files[0].bytes).read();
}

}  // namespace wend::formats
