// Wavefront OBJ: "v x y z", "vt u v" and "f" with corners v, v/vt, v//vn or v/vt/vn; negative numbers count
// from the end.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/colours.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/turned_normals.h"

namespace wend::formats {
namespace {

/// Keywords that say nothing about positions, normals, colours, texture coordinates, cells or groups.
constexpr std::string_view passedOver[] = {
    "vp",       "s",     "mg",         "mtllib",    "usemap", "maplib", "bevel", "c_interp",
    "d_interp", "lod",   "shadow_obj", "trace_obj", "cstype", "deg",    "bmat",  "step",
    "curv",     "curv2", "surf",       "parm",      "trim",   "hole",   "scrv",  "sp",
    "end",      "con",   "call",       "csh",       "ctech",  "stech"};

struct Corner {
    std::int64_t vertex, texture, normal;  // counted from 0; −1 if there is none
    std::size_t offset;                    // in the file, for errors: a face may precede its vertices
};

class ObjReader {
  public:
    explicit ObjReader(std::string_view bytes) : m_scanner(bytes, '#') { m_scanner.joinLines(); }

    MeshFile read() {
        while (!m_scanner.atEnd()) statement();
        m_file.points = Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3, vertexCount());
        addCells();
        addTexture();
        addVertexColours();
        addNormals();
        if (!m_replaced.empty())
            m_file.notices.push_back(m_replaced.size() == 1
                                         ? "its object " + inQuotes(*m_replaced.begin())
                                         : "its " + std::to_string(m_replaced.size()) + " objects");
        for (MeshGroup& group : m_groups)
            if (!group.cells.empty()) m_file.groups.push_back(std::move(group));
        finishCells(m_file, [this](int cell) {
            return m_scanner.placeOf(m_offsets[static_cast<std::size_t>(cell)]);
        });
        return std::move(m_file);
    }

  private:
    std::int64_t vertexCount() const { return static_cast<std::int64_t>(m_points.size() / 3); }
    std::int64_t textureCount() const { return static_cast<std::int64_t>(m_textures.size() / 2); }

    /// Reads one statement. Statements of an OBJ file that mean nothing here are skipped; others are errors.
    void statement() {
        const auto keyword = m_scanner.word("a keyword");
        if (keyword == "v")
            vertex();
        else if (keyword == "vt")
            textureCoordinates();
        else if (keyword == "vn")
            numbers(m_normals, {"x", "y", "z"});
        else if (keyword == "f" || keyword == "l" || keyword == "p")
            cell(keyword[0]);
        else if (keyword == "g" || keyword == "o" || keyword == "usemtl")
            group(keyword);
        else if (std::find(std::begin(passedOver), std::end(passedOver), keyword) == std::end(passedOver))
            m_scanner.fail(inQuotes(keyword) + " is no keyword of an OBJ file");
        m_scanner.line();
    }
    /// A colour may follow as three numbers, or a weight as one.
    void vertex() {
        numbers(m_points, {"x", "y", "z"});
        std::vector<double> more;
        while (more.size() < 4 && !m_scanner.atLineEnd()) more.push_back(m_scanner.real("a colour"));
        if (more.size() == 4) more.erase(more.begin());
        if (more.size() == 3) m_colours.insert(m_colours.end(), more.begin(), more.end());
    }
    /// "g" names all groups that follow, the others one: names with blanks. Groups replace an object.
    void group(std::string_view keyword) {
        const bool material = keyword == "usemtl";
        if (keyword == "g" && !m_object.empty()) m_replaced.insert(m_object);
        if (!material) m_object.clear();
        std::erase_if(m_current, [&](const auto& current) { return current.first == material; });
        while (!m_scanner.atLineEnd()) {
            const auto name = keyword == "g" ? m_scanner.word("a group") : trimmedLine();
            m_current.emplace_back(material, std::string(name));
            if (keyword == "o") m_object = m_current.back().second;
            groupOf(m_current.back(), 2);
            if (keyword != "g") return m_scanner.seek(m_scanner.offset() - 1);
        }
    }
    /// Returns the group of that name for cells of a dimension.
    MeshGroup& groupOf(const std::pair<bool, std::string>& key, int dimension) {
        const auto [entry, isNew] = m_known.try_emplace({key, dimension}, m_groups.size());
        if (isNew) m_groups.push_back({key.second, dimension, 0, {}, {}, key.first});
        return m_groups[entry->second];
    }
    /// Returns the rest of the line, and moves the scanner behind its end.
    std::string_view trimmedLine() {
        auto text = m_scanner.line();
        return text.substr(0, text.find('#'));
    }
    void numbers(std::vector<double>& values, std::initializer_list<const char*> names) {
        for (const char* name : names) {
            if (m_scanner.atLineEnd()) m_scanner.wordOnLine(name);
            values.push_back(m_scanner.finite(name));
        }
    }
    void textureCoordinates() {
        numbers(m_textures, {"u"});
        m_textures.push_back(m_scanner.atLineEnd() ? 0 : m_scanner.finite("v"));
    }
    void cell(char kind) {
        const auto first = m_corners.size();
        m_offsets.push_back(m_scanner.offset());
        while (!m_scanner.atLineEnd()) m_corners.push_back(corner(m_scanner.word("a corner")));
        m_sizes.push_back(m_corners.size() - first);
        m_kinds.push_back(kind);
        if (kind == 'f' && m_sizes.back() < 3) m_scanner.fail("a face needs three corners");
        if (kind == 'l' && m_sizes.back() < 2) m_scanner.fail("a line needs two points");
        for (const auto& current : m_current)
            groupOf(current, kind == 'f'   ? 2
                             : kind == 'l' ? 1
                                           : 0)
                .cells.push_back(static_cast<int>(m_sizes.size()) - 1);
    }
    Corner corner(std::string_view word) const {
        const auto slash = word.find('/');
        Corner corner{resolved(word.substr(0, slash), vertexCount()), -1, -1,
                      m_scanner.offset() - word.size()};
        if (slash == std::string_view::npos) return corner;
        const auto texture = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
        if (!texture.empty()) corner.texture = resolved(texture, textureCount());
        const auto second = word.find('/', slash + 1);
        if (second != std::string_view::npos && second + 1 < word.size())
            corner.normal = normalNamed(word.substr(second + 1));
        return corner;
    }
    /// Returns −1 for a number that names no normal, which is no reason to refuse a file.
    std::int64_t normalNamed(std::string_view text) const {
        const auto count = static_cast<std::int64_t>(m_normals.size() / 3);
        const double number = parseNumber(text).value_or(0);
        if (!(std::abs(number) < 2147483647)) return -1;
        const auto whole = static_cast<std::int64_t>(number);
        return std::max<std::int64_t>(whole < 0 ? count + whole : whole - 1, -1);
    }
    std::int64_t resolved(std::string_view text, std::int64_t countSoFar) const {
        const auto number = m_scanner.integerFrom(text, "a vertex number");
        if (number == 0) m_scanner.fail("vertices are counted from 1, there is no number 0");
        const auto index = number < 0 ? countSoFar + number : number - 1;
        if (index < 0) m_scanner.fail(std::to_string(number) + " counts back beyond the first");
        return index;
    }

    void requireDefined(std::int64_t index, std::int64_t count, const Corner& corner, const char* things) {
        if (index < count) return;
        m_scanner.seek(corner.offset);
        m_scanner.fail(std::to_string(index + 1) + " is named, but there are only " + std::to_string(count) +
                       things);
    }
    /// Makes cells of the faces, lines and points, whose vertices may be defined after them.
    void addCells() {
        std::vector<int> nodes;
        auto corner = m_corners.begin();
        for (std::size_t f = 0; f < m_sizes.size(); ++f) {
            nodes.clear();
            for (std::size_t k = 0; k < m_sizes[f]; ++k, ++corner) {
                requireDefined(corner->vertex, vertexCount(), *corner, " vertices");
                requireDefined(corner->texture, textureCount(), *corner, " texture coordinates");
                nodes.push_back(static_cast<int>(corner->vertex));
            }
            addCell(m_kinds[f], nodes);
        }
    }
    void addCell(char kind, const std::vector<int>& nodes) {
        CellList& cells = m_file.cells;
        if (kind == 'f') return cells.addFace(nodes);
        if (kind == 'l') return cells.add(nodes.size() == 2 ? CellKind::Line : CellKind::PolyLine, nodes);
        cells.add(nodes.size() == 1 ? CellKind::Vertex : CellKind::PolyVertex, nodes);
    }
    /// Only if every vertex has one.
    void addVertexColours() {
        if (m_colours.empty() || m_colours.size() != m_points.size()) return;
        std::vector<Colour> colours;
        for (std::size_t at = 0; at < m_colours.size(); at += 3)
            colours.push_back({m_colours[at], m_colours[at + 1], m_colours[at + 2], 1});
        addColours(m_file, colours, false);
    }
    /// Adds the normals of vertices, (0, 0, 0) where there is none, unless the corners of one have several.
    void addNormals() {
        const auto count = static_cast<std::int64_t>(m_normals.size() / 3);
        std::vector<std::int64_t> normalOf(static_cast<std::size_t>(vertexCount()), -1);
        bool single = true, has = false;
        for (const Corner& corner : m_corners) {
            if (corner.normal < 0) continue;
            std::int64_t& known = normalOf[static_cast<std::size_t>(corner.vertex)];
            single = single && corner.normal < count && (known < 0 || known == corner.normal);
            known = corner.normal;
            has = true;
        }
        if (has && !single) m_file.notices.emplace_back("its list of normals of corners");
        if (!has || !single) return;
        for (std::size_t k = 0; k < 3; ++k) {
            MeshField field{kNormalNames[k], false, 1, {}};
            for (const std::int64_t normal : normalOf)
                field.values.push_back(normal < 0 ? 0 : m_normals[3 * static_cast<std::size_t>(normal) + k]);
            m_file.fields.push_back(std::move(field));
        }
    }
    /// Takes the texture points of corners of faces.
    void addTexture() {
        if (m_textures.empty()) return;
        std::vector<double> uv;
        std::size_t at = 0;
        for (std::size_t c = 0; c < m_sizes.size(); ++c)
            for (std::size_t k = 0; k < m_sizes[c]; ++k) {
                const std::int64_t texture = m_kinds[c] == 'f' ? m_corners[at].texture : -1;
                ++at;
                for (std::size_t j = 0; j < 2; ++j)
                    uv.push_back(texture < 0 ? std::numeric_limits<double>::quiet_NaN()
                                             : m_textures[2 * static_cast<std::size_t>(texture) + j]);
            }
        setCornerUv(m_file, std::move(uv));
    }

    Scanner m_scanner;
    MeshFile m_file;
    std::vector<double> m_points, m_colours, m_textures, m_normals;
    std::vector<Corner> m_corners;
    std::vector<std::size_t> m_sizes, m_offsets;  // of each cell its corners and its place
    std::vector<char> m_kinds;                    // and its keyword
    std::vector<MeshGroup> m_groups;
    /// By whether it is a material, its name, and the dimension of its cells.
    std::map<std::pair<std::pair<bool, std::string>, int>, std::size_t> m_known;
    std::vector<std::pair<bool, std::string>> m_current;  // groups of the cells that follow
    std::string m_object;                                 // among them
    std::set<std::string> m_replaced;                     // objects with groups instead
};

/// The lines that name the groups of each cell, where they change.
class GroupLines {
  public:
    explicit GroupLines(const MeshFile& bag)
        : m_names(static_cast<std::size_t>(bag.cells.size())), m_materials(m_names.size()) {
        for (const MeshGroup& group : bag.groups)
            for (const int c : group.cells) {
                auto& names = (group.material ? m_materials : m_names)[static_cast<std::size_t>(c)];
                if (group.material && !names.empty()) continue;
                names += (names.empty() ? "" : " ") + nameOf(group);
            }
    }
    void print(int cell, TextWriter& out) {
        change("g ", m_names[static_cast<std::size_t>(cell)], m_name, out);
        change("usemtl ", m_materials[static_cast<std::size_t>(cell)], m_material, out);
    }

  private:
    static std::string nameOf(const MeshGroup& group) {
        std::string name = group.name.empty() ? "ref_" + std::to_string(group.tag) : group.name;
        for (char& c : name)
            if (static_cast<unsigned char>(c) <= ' ' && !group.material) c = '_';
        return name;
    }
    static void change(const char* keyword, const std::string& names, std::string& current, TextWriter& out) {
        if (names == current) return;
        current = names;
        out << keyword << (names.empty() ? "default" : names) << '\n';
    }

    std::vector<std::string> m_names, m_materials;
    std::string m_name, m_material;
};

/// Prints the normals of vertices, and returns whether there are some.
bool printNormals(const MeshFile& mesh, TextWriter& out) {
    const auto parts = normalFieldsOf(mesh);
    if (!parts[0]) return false;
    for (std::size_t v = 0; v < parts[0]->values.size(); ++v)
        out << "vn " << parts[0]->values[v] << ' ' << parts[1]->values[v] << ' ' << parts[2]->values[v]
            << '\n';
    return true;
}

/// Prints texture points, and returns the number of that of each node of the cells, 0 where there is none;
/// nothing if no node has one.
std::vector<int> printTexture(const MeshFile& mesh, TextWriter& out) {
    std::vector<int> numbers;
    if (!mesh.hasCornerUv()) {
        for (const auto& uv : mesh.uv.colwise()) out << "vt " << uv.x() << ' ' << uv.y() << '\n';
        if (mesh.uv.cols() > 0)
            for (const int v : mesh.cells.nodes) numbers.push_back(v + 1);
        return numbers;
    }
    std::map<std::pair<double, double>, int> known;
    for (std::size_t at = 0; at < mesh.cornerUv.size(); at += 2) {
        const std::pair uv(mesh.cornerUv[at], mesh.cornerUv[at + 1]);
        if (std::isnan(uv.first) || std::isnan(uv.second)) {
            numbers.push_back(0);
            continue;
        }
        const auto [found, isNew] = known.try_emplace(uv, static_cast<int>(known.size()) + 1);
        if (isNew) out << "vt " << uv.first << ' ' << uv.second << '\n';
        numbers.push_back(found->second);
    }
    return numbers;
}

}  // namespace

MeshFile readObj(std::span<const MeshSource> files) {
    return ObjReader(files[0].bytes).read();
}

std::vector<std::string> printObj(const MeshFile& mesh, const MeshWriteOptions&) {
    TextWriter out;
    const std::vector<Colour> colours = coloursOf(mesh, false);
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
        const auto p = mesh.points.col(v);
        out << "v " << p.x() << ' ' << p.y() << ' ' << p.z();
        for (std::size_t k = 0; !colours.empty() && k < 3; ++k)
            out << ' ' << colours[static_cast<std::size_t>(v)][k];
        out << '\n';
    }
    const std::vector<int> textures = printTexture(mesh, out);
    const bool normals = printNormals(mesh, out);
    GroupLines groups(mesh);
    for (int c = 0; c < mesh.cells.size(); ++c) {
        groups.print(c, out);
        const int dimension = mesh.cells.dimension(c);
        out << (dimension == 2 ? 'f' : dimension == 1 ? 'l' : 'p');
        auto at = static_cast<std::size_t>(mesh.cells.begins[static_cast<std::size_t>(c)]);
        for (const int v : mesh.cells[c]) {
            const int texture = textures.empty() || dimension != 2 ? 0 : textures[at];
            ++at;
            out << ' ' << v + 1;
            if (texture > 0) out << '/' << texture;
            if (normals && dimension == 2) out << (texture > 0 ? "/" : "//") << v + 1;
        }
        out << '\n';
    }
    return {std::move(out.text())};
}

}  // namespace wend::formats
