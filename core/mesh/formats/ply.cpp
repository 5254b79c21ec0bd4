// Stanford PLY: a header that declares elements and their properties, then their values as text or bytes of
// either order. Single properties of vertices and faces beyond position and texture coordinates are fields.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

struct Property {
    std::string name;
    Scalar type = Scalar::Float32;
    std::optional<Scalar> countType;  // a list if there is one
    std::vector<double> values;       // of single properties: one per item

    bool isCorners() const { return countType && (name == "vertex_indices" || name == "vertex_index"); }
    bool isTexture() const { return countType && name == "texcoord"; }
};

struct Element {
    std::string name;
    std::int64_t count = 0;
    std::vector<Property> properties;

    const Property* find(std::string_view wanted) const {
        for (const auto& property : properties)
            if (!property.countType && property.name == wanted) return &property;
        return nullptr;
    }
};

constexpr std::string_view kTakenElements[] = {"vertex", "face", "tristrips", "edge"};

struct Polygons {
    std::vector<std::int64_t> corners;  // of all faces, one behind the other
    std::vector<int> sizes;
    std::vector<double> texture;    // "texcoord": u and v of each corner
    std::vector<int> textureSizes;  // how many of these numbers each face has
};

std::optional<Scalar> scalarNamed(std::string_view name) {
    constexpr std::pair<std::string_view, Scalar> names[] = {
        {"char", Scalar::Int8},      {"int8", Scalar::Int8},       {"uchar", Scalar::UInt8},
        {"uint8", Scalar::UInt8},    {"short", Scalar::Int16},     {"int16", Scalar::Int16},
        {"ushort", Scalar::UInt16},  {"uint16", Scalar::UInt16},   {"int", Scalar::Int32},
        {"int32", Scalar::Int32},    {"uint", Scalar::UInt32},     {"uint32", Scalar::UInt32},
        {"float", Scalar::Float32},  {"float32", Scalar::Float32}, {"double", Scalar::Float64},
        {"float64", Scalar::Float64}};
    for (const auto& [known, type] : names)
        if (known == name) return type;
    return std::nullopt;
}

class PlyReader {
  public:
    explicit PlyReader(std::string_view bytes) : m_scanner(bytes) {}

    /// Reads all elements of the header in their order, and then takes vertices, faces, edges and other
    /// values from them.
    MeshFile read() {
        readHeader();
        NumberReader numbers(m_scanner, m_binary, m_order);
        if (m_binary) m_scanner.placesAreOffsets();
        for (auto& element : m_elements) readElement(element, numbers);
        m_scanner.requireEnd("the header");
        MeshFile file;
        takeVertices(file);
        takeFaces(file);
        takeStrips(file);
        takeEdges(file);
        takeTexture(file);
        for (const Element& other : m_elements)
            if (other.count > 0 && std::ranges::count(kTakenElements, other.name) == 0)
                file.notices.push_back("the " + std::to_string(other.count) + " items of its element " +
                                       inQuotes(other.name));
        addGroupsOfFields(file);
        finishCells(file, [](int cell) { return "face " + std::to_string(cell); });
        return file;
    }

  private:
    /// Reads the header: format, elements and their properties, and comments.
    void readHeader() {
        if (m_scanner.word("the word ply") != "ply") m_scanner.fail("does not begin with 'ply': no PLY file");
        m_scanner.line();
        bool hasFormat = false;
        for (;;) {
            const auto keyword = m_scanner.word("a line of the header");
            if (keyword == "end_header") break;
            if (keyword == "format") {
                readFormat();
                hasFormat = true;
            } else if (keyword == "element") {
                readElementLine();
            } else if (keyword == "property") {
                readPropertyLine();
            } else if (keyword != "comment" && keyword != "obj_info") {
                m_scanner.fail(inQuotes(keyword) + " is no keyword of a PLY header");
            }
            m_scanner.line();
        }
        if (!hasFormat) m_scanner.fail("the header says no format");
        m_scanner.line();
    }
    void readFormat() {
        const auto name = m_scanner.wordOnLine("a format");
        m_binary = name != "ascii";
        m_order = name == "binary_big_endian" ? std::endian::big : std::endian::little;
        if (m_binary && name != "binary_big_endian" && name != "binary_little_endian")
            m_scanner.fail(inQuotes(name) + " is no PLY format");
    }
    void readElementLine() {
        Element element;
        element.name = m_scanner.wordOnLine("the name of an element");
        element.count = m_scanner.integerFrom(m_scanner.wordOnLine("a number of items"), "a number of items");
        m_elements.push_back(std::move(element));
    }
    Scalar readType() {
        const auto name = m_scanner.wordOnLine("a type");
        const auto type = scalarNamed(name);
        if (!type) m_scanner.fail(inQuotes(name) + " is no type of a PLY file");
        return *type;
    }
    /// Reads a property of the last element, which may be a list.
    void readPropertyLine() {
        if (m_elements.empty()) m_scanner.fail("a property stands before any element");
        Property property;
        if (m_scanner.nextIs("list")) {
            m_scanner.word("list");
            property.countType = readType();
        }
        property.type = readType();
        property.name = m_scanner.wordOnLine("the name of a property");
        m_elements.back().properties.push_back(std::move(property));
    }

    std::size_t smallestItem(const Element& element) const {
        std::size_t bytes = 0;
        for (const auto& p : element.properties) bytes += m_binary ? sizeOf(p.countType.value_or(p.type)) : 2;
        return std::max<std::size_t>(bytes, 1);  // an item of nothing is a damaged header
    }
    /// Reads all items of an element, property by property.
    void readElement(Element& element, NumberReader& numbers) {
        const std::string items = "items '" + element.name + "'";
        const int count = m_scanner.checkedCount(element.count, items.c_str(), smallestItem(element));
        for (auto& property : element.properties)
            if (!property.countType) property.values.reserve(count);
        for (int i = 0; i < count; ++i)
            for (auto& property : element.properties)
                if (const auto countType = property.countType)
                    readList(property, *countType, element.name, numbers);
                else
                    property.values.push_back(numbers.real(property.type, property.name.c_str()));
    }
    /// Reads a list: the corners of a face or strip, the texture coordinates of a face, or another one, which
    /// is skipped.
    void readList(const Property& property, Scalar countType, std::string_view of, NumberReader& numbers) {
        const int size = numbers.count(countType, "list entries", 1, property.type);
        const bool ofFace = of == "face", texture = ofFace && property.isTexture();
        const bool wanted = property.isCorners() && (ofFace || of == "tristrips");
        Polygons& polygons = ofFace ? m_polygons : m_strips;
        if (wanted) polygons.sizes.push_back(size);
        if (texture) polygons.textureSizes.push_back(size);
        for (int k = 0; k < size; ++k) {
            if (texture)
                m_polygons.texture.push_back(numbers.real(property.type, "a texture coordinate"));
            else if (!wanted)
                numbers.real(property.type, "a list entry");
            else
                polygons.corners.push_back(numbers.integer(property.type, "a vertex number"));
        }
    }

    const Element* element(std::string_view name) const {
        const auto at = std::ranges::find(m_elements, name, &Element::name);
        return at != m_elements.end() ? &*at : nullptr;
    }
    /// Takes the points from x, y and, if present, z, and the first pair of texture coordinates; all other
    /// properties become fields.
    void takeVertices(MeshFile& file) {
        if (!element("vertex")) m_scanner.fail("the header declares no element 'vertex'");
        const Element& vertices = *element("vertex");
        const auto *x = vertices.find("x"), *y = vertices.find("y"), *z = vertices.find("z");
        if (!x || !y) m_scanner.fail("the vertices have no x and y");
        file.points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(x->values.size()));
        std::vector<const Property*> taken = {x, y, z};
        for (int k = 0; k < 3; ++k)
            for (std::size_t v = 0; taken[k] && v < x->values.size(); ++v)
                file.points(k, v) = taken[k]->values[v];
        for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
            const auto *first = vertices.find(u), *second = vertices.find(v);
            if (!first || !second || file.uv.cols()) continue;
            file.uv.resize(2, file.points.cols());
            for (Eigen::Index i = 0; i < file.uv.cols(); ++i)
                file.uv.col(i) << first->values[i], second->values[i];
            taken.insert(taken.end(), {first, second});
        }
        for (const auto& property : vertices.properties)
            if (property.countType)
                file.notices.push_back("the lists " + inQuotes(property.name) + " of its vertices");
            else if (std::find(taken.begin(), taken.end(), &property) == taken.end())
                file.fields.push_back({property.name, false, 1, property.values, {}, property.type});
    }
    /// Takes the faces, which may be polygons.
    void takeFaces(MeshFile& file) {
        if (!element("face")) return;  // points alone
        const Element& faces = *element("face");
        std::vector<int> polygon;
        std::size_t at = 0;
        for (std::size_t f = 0; f < m_polygons.sizes.size(); ++f) {
            polygon.clear();
            for (int k = 0; k < m_polygons.sizes[f]; ++k)
                polygon.push_back(corner(m_polygons.corners[at++], "face", f, file));
            if (polygon.size() >= 3)
                file.cells.addFace(polygon);
            else
                file.cells.add(polygon.size() == 2 ? CellKind::Line : CellKind::PolyVertex, polygon);
        }
        if (static_cast<std::int64_t>(m_polygons.sizes.size()) != faces.count)
            m_scanner.fail("the faces have no list of vertex_indices, or several");
        for (const auto& property : faces.properties)
            if (!property.countType)
                file.fields.push_back({property.name, true, 1, property.values, {}, property.type});
            else if (!property.isCorners() && (file.uv.cols() > 0 || !isTaken(property)))
                file.notices.push_back("the lists " + inQuotes(property.name) + " of its faces");
    }
    /// Returns whether a list of faces is one of texture points, for some faces at least.
    bool isTaken(const Property& property) const {
        if (!property.isTexture() || m_polygons.textureSizes.size() != m_polygons.sizes.size()) return false;
        for (std::size_t f = 0; f < m_polygons.sizes.size(); ++f)
            if (const int size = m_polygons.textureSizes[f]; size != 0 && size != 2 * m_polygons.sizes[f])
                return false;
        return true;
    }
    /// Takes the triangle strips, as scanners write them: −1 ends a strip within a list.
    void takeStrips(MeshFile& file) {
        const int faces = file.cells.size();
        std::vector<int> strip;
        const auto endStrip = [&] {
            if (strip.size() >= 3) file.cells.add(CellKind::TriangleStrip, strip);
            strip.clear();
        };
        std::size_t at = 0;
        for (std::size_t s = 0; s < m_strips.sizes.size(); ++s) {
            for (int k = 0; k < m_strips.sizes[s]; ++k)
                if (const std::int64_t next = m_strips.corners[at++]; next == -1)
                    endStrip();
                else
                    strip.push_back(corner(next, "strip", s, file));
            endStrip();
        }
        lengthenFields(file, file.cells.size() - faces);
        const Element* element = this->element("tristrips");
        if (!element) return;
        const auto corners = std::ranges::find_if(element->properties, &Property::isCorners);
        nameOthers(*element, {corners == element->properties.end() ? nullptr : &*corners}, "strips", file);
    }
    /// Names the properties of an element that are not among those taken.
    static void nameOthers(const Element& element, const std::vector<const Property*>& taken,
                           const char* things, MeshFile& file) {
        for (const Property& property : element.properties)
            if (element.count > 0 && std::ranges::count(taken, &property) == 0)
                file.notices.push_back("the values " + inQuotes(property.name) + " of its " + things);
    }
    /// Takes the texture points of the corners of faces, unless vertices have some.
    void takeTexture(MeshFile& file) const {
        const bool fits = m_polygons.textureSizes.size() == m_polygons.sizes.size();
        if (file.uv.cols() > 0 || m_polygons.texture.empty() || !fits) return;
        std::vector<double> uv(2 * file.cells.nodes.size(), std::numeric_limits<double>::quiet_NaN());
        std::size_t at = 0, texture = 0;
        for (std::size_t f = 0; f < m_polygons.sizes.size(); ++f) {
            const auto corners = 2 * static_cast<std::size_t>(m_polygons.sizes[f]),
                       own = static_cast<std::size_t>(m_polygons.textureSizes[f]);
            for (std::size_t k = 0; own == corners && k < corners; ++k)
                uv[at + k] = m_polygons.texture[texture + k];
            at += corners;
            texture += own;
        }
        setCornerUv(file, std::move(uv));
    }
    /// Lines between vertices.
    void takeEdges(MeshFile& file) {
        const Element* edges = element("edge");
        if (!edges || edges->count == 0) return;
        const auto *first = edges->find("vertex1"), *second = edges->find("vertex2");
        if (!first || !second) m_scanner.fail("the edges have no vertex1 and vertex2");
        nameOthers(*edges, {first, second}, "edges", file);
        for (std::size_t e = 0; e < first->values.size(); ++e)
            file.cells.add(CellKind::Line, std::array{corner(whole(first->values[e]), "edge", e, file),
                                                      corner(whole(second->values[e]), "edge", e, file)});
        lengthenFields(file, static_cast<int>(first->values.size()));
    }
    /// Gives cells without values zeros in the fields of the faces.
    static void lengthenFields(MeshFile& file, int cells) {
        for (MeshField& field : file.fields)
            if (field.perCell) field.values.resize(field.values.size() + static_cast<std::size_t>(cells), 0);
    }
    static std::int64_t whole(double value) {
        return std::abs(value) < 4e9 ? static_cast<std::int64_t>(value) : -1;
    }
    int corner(std::int64_t index, const char* item, std::size_t number, const MeshFile& file) const {
        if (index < 0 || index >= file.points.cols())
            throw InputError(item + (' ' + std::to_string(number)) + " names vertex " +
                             std::to_string(index) + ", but there are only " +
                             std::to_string(file.points.cols()) + " (counted from 0)");
        return static_cast<int>(index);
    }

    Scanner m_scanner;
    bool m_binary = false;
    std::endian m_order = std::endian::little;
    std::vector<Element> m_elements;
    Polygons m_polygons, m_strips;
};

/// A property per component; blanks would end the name.
std::string propertyName(const MeshField& field, int component) {
    std::string name = field.name.empty() ? "field" : field.name;
    for (char& c : name)
        if (c <= ' ') c = '_';
    return field.components == 1 ? name : name + "_" + std::to_string(component);
}

/// PLY has no whole numbers of eight bytes.
Scalar typeHeld(Scalar type) {
    return type == Scalar::Int64 || type == Scalar::UInt64 ? Scalar::Float64 : type;
}

std::string_view nameInPly(Scalar type) {
    switch (typeHeld(type)) {
        case Scalar::Int8:
            return "char";
        case Scalar::UInt8:
            return "uchar";
        case Scalar::Int16:
            return "short";
        case Scalar::UInt16:
            return "ushort";
        case Scalar::Int32:
            return "int";
        case Scalar::UInt32:
            return "uint";
        case Scalar::Float32:
            return "float";
        default:
            return "double";
    }
}

class PlyPrinter {
  public:
    PlyPrinter(const MeshFile& mesh, const MeshWriteOptions& options)
        : m_mesh(mesh),
          m_binary(options.binary()),
          m_order(options.bigEndian ? std::endian::big : std::endian::little) {
        const std::size_t most = mesh.hasCornerUv() ? 127 : 255;
        for (int c = 0; c < mesh.cells.size(); ++c)
            m_manyCorners = m_manyCorners || mesh.cells[c].size() > most;
    }

    /// Prints header, vertices, faces and edges, as text or bytes.
    std::string print() {
        header();
        for (Eigen::Index v = 0; v < m_mesh.points.cols(); ++v) {
            for (double x : m_mesh.points.col(v)) number(x);
            for (Eigen::Index k = 0; hasVertexUv() && k < 2; ++k) number(m_mesh.uv(k, v));
            endItem(false, static_cast<std::size_t>(v));
        }
        for (const bool lines : {false, true})
            for (int c = 0; c < m_mesh.cells.size(); ++c) {
                if ((m_mesh.cells.dimension(c) == 1) != lines) continue;
                if (!lines)
                    whole(static_cast<int>(m_mesh.cells[c].size()),
                          m_manyCorners ? Scalar::Int32 : Scalar::UInt8);
                for (const int v : m_mesh.cells[c]) whole(v, Scalar::Int32);
                if (!lines && m_mesh.hasCornerUv()) cornerTexture(c);
                if (lines)
                    endLine();
                else
                    endItem(true, static_cast<std::size_t>(c));
            }
        return std::move(m_out.text());
    }

  private:
    bool hasVertexUv() const { return m_mesh.uv.cols() > 0 && !m_mesh.hasCornerUv(); }
    void header() {
        const char* binary = m_order == std::endian::big ? "binary_big_endian" : "binary_little_endian";
        m_out << "ply\nformat " << (m_binary ? binary : "ascii") << " 1.0\nelement vertex "
              << m_mesh.points.cols() << '\n';
        for (const char* name : {"x", "y", "z"}) m_out << "property double " << name << '\n';
        if (hasVertexUv()) m_out << "property double s\nproperty double t\n";
        fieldNames(false);
        const auto lines = std::ranges::count(m_mesh.cells.kinds, CellKind::Line);
        m_out << "element face " << m_mesh.cells.size() - lines << "\nproperty list "
              << (m_manyCorners ? "int" : "uchar") << " int vertex_indices\n";
        if (m_mesh.hasCornerUv())
            m_out << "property list " << (m_manyCorners ? "int" : "uchar") << " double texcoord\n";
        fieldNames(true);
        if (lines > 0) m_out << "element edge " << lines << "\nproperty int vertex1\nproperty int vertex2\n";
        m_out << "end_header\n";
    }
    /// Prints the texture points of the corners of a face; none if a corner has none.
    void cornerTexture(int c) {
        const auto first = 2 * static_cast<std::size_t>(m_mesh.cells.begins[static_cast<std::size_t>(c)]);
        const std::span all(m_mesh.cornerUv);
        auto uv = all.subspan(first, 2 * m_mesh.cells[c].size());
        if (std::ranges::any_of(uv, [](double x) { return std::isnan(x); })) uv = uv.first(0);
        whole(static_cast<int>(uv.size()), m_manyCorners ? Scalar::Int32 : Scalar::UInt8);
        for (const double x : uv) number(x);
    }
    void fieldNames(bool perCell) {
        for (const auto& field : m_mesh.fields)
            for (int k = 0; field.perCell == perCell && k < field.components; ++k)
                m_out << "property " << nameInPly(field.type) << ' ' << propertyName(field, k) << '\n';
    }
    void endItem(bool perCell, std::size_t item) {
        for (const auto& field : m_mesh.fields)
            for (int k = 0; field.perCell == perCell && k < field.components; ++k)
                value((perCell ? field.ofCells : field.values)[item * field.components + k], field.type);
        endLine();
    }
    void endLine() {
        if (!m_binary) m_out.text().back() = '\n';
    }
    void value(double value, Scalar type) {
        if (m_binary)
            appendReal(m_out.text(), value, typeHeld(type), m_order);
        else
            m_out << value << ' ';
    }
    void number(double value) {
        if (m_binary)
            appendReal(m_out.text(), value, Scalar::Float64, m_order);
        else
            m_out << value << ' ';
    }
    void whole(int value, Scalar type) {
        if (m_binary)
            appendInteger(m_out.text(), value, type, m_order);
        else
            m_out << value << ' ';
    }

    const MeshFile& m_mesh;
    bool m_binary;
    std::endian m_order;
    bool m_manyCorners = false;  // more than a byte counts
    TextWriter m_out;
};

}  // namespace

MeshFile readPly(std::span<const MeshSource> files) {
    return PlyReader(files[0].bytes).read();
}

std::vector<std::string> printPly(const MeshFile& mesh, const MeshWriteOptions& options) {
    return {PlyPrinter(mesh, options).print()};
}

}  // namespace wend::formats
