// Wavefront OBJ: "v x y z", "vt u v" and "f" with corners v, v/vt, v//vn or v/vt/vn; negative numbers count
// from the end.

#include <algorithm>

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

/// Keywords that say nothing about positions, texture coordinates or faces.
constexpr std::string_view passedOver[] = {
    "vn",     "vp",     "g",      "o",     "s",        "mg",       "l",    "p",          "usemtl",
    "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj",
    "cstype", "deg",    "bmat",   "step",  "curv",     "curv2",    "surf", "parm",       "trim",
    "hole",   "scrv",   "sp",     "end",   "con",      "call",     "csh",  "ctech",      "stech"};

struct Corner {
    std::int64_t vertex, texture;  // counted from 0; texture is −1 if there is none
    std::size_t offset;            // in the file, for errors: a face may stand before its vertices
};

class ObjReader {
  public:
    explicit ObjReader(std::string_view bytes) : m_scanner(bytes, '#') {}

    MeshFile read() {
        while (!m_scanner.atEnd()) statement();
        MeshFile file;
        file.points = Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3, vertexCount());
        addFaces(file);
        addTexture(file);
        return file;
    }

  private:
    std::int64_t vertexCount() const { return static_cast<std::int64_t>(m_points.size() / 3); }
    std::int64_t textureCount() const { return static_cast<std::int64_t>(m_textures.size() / 2); }

    void statement() {
        const auto keyword = m_scanner.word("a keyword");
        if (keyword == "v")
            numbers(m_points, {"x", "y", "z"});
        else if (keyword == "vt")
            textureCoordinates();
        else if (keyword == "f")
            face();
        else if (std::find(std::begin(passedOver), std::end(passedOver), keyword) == std::end(passedOver))
            m_scanner.fail(inQuotes(keyword) + " is no keyword of an OBJ file");
        m_scanner.line();
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
    void face() {
        const auto first = m_corners.size();
        while (!m_scanner.atLineEnd()) {
            const auto word = m_scanner.word("a corner");
            if (word == "\\")  // the line goes on below
                m_scanner.line();
            else
                m_corners.push_back(corner(word));
        }
        m_sizes.push_back(m_corners.size() - first);
        if (m_sizes.back() < 3) m_scanner.fail("a face needs three corners");
    }
    Corner corner(std::string_view word) const {
        const auto slash = word.find('/');
        Corner corner{resolved(word.substr(0, slash), vertexCount()), -1, m_scanner.offset() - word.size()};
        if (slash == std::string_view::npos) return corner;
        const auto texture = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
        if (!texture.empty()) corner.texture = resolved(texture, textureCount());
        return corner;
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
    void addFaces(MeshFile& file) {
        CellCollector cells;
        std::vector<int> polygon;
        auto corner = m_corners.begin();
        for (std::size_t f = 0; f < m_sizes.size(); ++f) {
            polygon.clear();
            for (std::size_t k = 0; k < m_sizes[f]; ++k, ++corner) {
                requireDefined(corner->vertex, vertexCount(), *corner, " vertices");
                requireDefined(corner->texture, textureCount(), *corner, " texture coordinates");
                polygon.push_back(static_cast<int>(corner->vertex));
            }
            cells.polygon(polygon, static_cast<int>(f));
        }
        cells.moveInto(file);
    }
    /// Only if every corner has one. Vertices without a face get (0, 0).
    void addTexture(MeshFile& file) const {
        const bool everywhere =
            std::all_of(m_corners.begin(), m_corners.end(), [](auto& c) { return c.texture >= 0; });
        if (!everywhere || m_corners.empty()) return;
        file.uv = Eigen::Matrix2Xd::Zero(2, vertexCount());
        for (auto corner = m_corners.rbegin(); corner != m_corners.rend();
             ++corner)  // backwards: the first one stays
            file.uv.col(corner->vertex) << m_textures[2 * corner->texture],
                m_textures[2 * corner->texture + 1];
    }

    Scanner m_scanner;
    std::vector<double> m_points, m_textures;
    std::vector<Corner> m_corners;
    std::vector<std::size_t> m_sizes;  // corners of each face
};

}  // namespace

MeshFile readObj(std::span<const MeshSource> files) {
    return ObjReader(files[0].bytes).read();
}

std::vector<std::string> printObj(const MeshFile& mesh, const MeshWriteOptions&) {
    TextWriter out;
    for (const auto& p : mesh.points.colwise()) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& uv : mesh.uv.colwise()) out << "vt " << uv.x() << ' ' << uv.y() << '\n';
    for (const auto& triangle : mesh.triangles) {
        out << 'f';
        for (int v : triangle) {
            out << ' ' << v + 1;
            if (mesh.uv.cols()) out << '/' << v + 1;
        }
        out << '\n';
    }
    return {std::move(out.text())};
}

}  // namespace wend::formats
