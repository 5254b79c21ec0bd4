// An OBJ file describes more than the shape: texture points of corners, materials, and groups.

#include "core/mesh/formats/obj_skin.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/formats/text_writer.h"
#include "core/mesh/mesh_file.h"

namespace wend::formats {
namespace fs = std::filesystem;

namespace {

/// Returns the first word, which is taken off the line.
std::string_view takeWord(std::string_view& line) {
    line = trimmed(line);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    const auto word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

/// Calls `take` with every line; one that ends in a backslash is joined to the next.
template <class Take>
void eachLine(std::string_view bytes, const Take& take) {
    std::string whole;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        const std::string_view line = trimmed(bytes.substr(at, end - at));
        at = end + 1;
        if (!line.empty() && line.back() == '\\') {
            whole += std::string(line.substr(0, line.size() - 1)) + ' ';
            continue;
        }
        whole += line;
        take(std::string_view(whole));
        whole.clear();
    }
}

double numberOr(std::string_view word, double otherwise) {
    double value = 0;
    const auto done = std::from_chars(word.data(), word.data() + word.size(), value);
    return done.ec == std::errc() ? value : otherwise;
}

/// Returns the place of a number of the file, which counts from 1, or back from what precedes it; none is 0.
std::int64_t placeOf(std::string_view text, std::int64_t count) {
    const auto number = static_cast<std::int64_t>(numberOr(text, 0));
    return number < 0 ? count + number : number - 1;
}

/// Returns the file name in "map_Kd -s 1 1 1 wood.png": options precede the name, which may contain blanks if
/// there are none.
std::string textureName(std::string_view rest) {
    if (!rest.starts_with('-')) return std::string(rest);
    const auto blank = rest.find_last_of(" \t");
    return std::string(rest.substr(blank + 1));
}

fs::path materialPath(const std::string& obj, std::string_view name) {
    return fs::path(obj).parent_path() / std::string(name);
}

/// Returns the material files behind "mtllib": one whose name may contain blanks, or several.
std::vector<std::string> librariesIn(std::string_view names, const std::string& obj) {
    std::vector<std::string> libraries{std::string(names)};
    std::error_code error;
    if (fs::exists(materialPath(obj, names), error)) return libraries;
    std::vector<std::string> words;
    for (std::string_view rest = names; !rest.empty();) words.emplace_back(takeWord(rest));
    const bool anyThere = std::ranges::any_of(
        words, [&](const std::string& word) { return fs::exists(materialPath(obj, word), error); });
    return anyThere ? words : libraries;
}

/// Reads a material file. If it is missing, a warning is added to the skin.
void readMaterials(const fs::path& path, Skin& skin, std::map<std::string, int, std::less<>>& known) {
    std::string bytes;
    try {
        bytes = readInput(path.string());
    } catch (const InputError& error) {
        skin.warnings.push_back("the material file " + path.string() + " cannot be read: it " +
                                error.reason());
        return;
    }
    SkinMaterial* material = nullptr;
    eachLine(bytes, [&](std::string_view line) {
        const auto keyword = takeWord(line);
        if (keyword == "newmtl") {
            const std::string name(line);
            known.emplace(name, static_cast<int>(skin.materials.size()));
            skin.materials.push_back({name, {}, {}});
            material = &skin.materials.back();
            material->colour = {0.8F, 0.8F, 0.8F, 1};
        } else if (material && keyword == "Kd") {
            for (int k = 0; k < 3; ++k)
                material->colour[k] = static_cast<float>(numberOr(takeWord(line), material->colour[k]));
        } else if (material && keyword == "d") {
            material->colour[3] = static_cast<float>(numberOr(takeWord(line), 1));
        } else if (material && keyword == "map_Kd") {
            material->texture = (path.parent_path() / textureName(line)).string();
        }
    });
}

class LookReader {
  public:
    LookReader(const MeshFile& file, Skin& skin) : m_file(file), m_skin(skin) {}

    /// Reads all statements, and then distributes texture points and materials from polygons to their
    /// triangles.
    void read(const std::string& bytes) {
        eachLine(bytes, [this](std::string_view line) { statement(line.substr(0, line.find('#'))); });
        spreadOverTriangles();
        const bool textured = !m_skin.triangles.empty() && !m_withoutTexture;
        if (textured) {
            m_skin.uv = Eigen::Map<const Eigen::Matrix2Xd>(m_uv.data(), 2,
                                                           static_cast<Eigen::Index>(m_uv.size() / 2));
            m_skin.uvCorners = std::move(m_uvCorners);
        }
        if (!m_skin.materials.empty()) m_skin.materialOf = m_materialOf;
        takeLabels();
        for (const SkinMaterial& material : m_skin.materials)
            if (!material.texture.empty() && !fs::exists(material.texture))
                m_skin.warnings.push_back("the picture " + material.texture + " of the material " +
                                          inQuotes(material.name) + " does not exist");
    }

  private:
    /// Handles one statement: a texture point, a face, a material file, a material or a group.
    void statement(std::string_view line) {
        const auto keyword = takeWord(line);
        if (keyword == "vt") {
            m_uv.push_back(numberOr(takeWord(line), 0));
            m_uv.push_back(numberOr(takeWord(line), 0));
        } else if (keyword == "f") {
            face(line);
        } else if (keyword == "mtllib") {
            for (const std::string& name : librariesIn(line, m_skin.path))
                readMaterials(materialPath(m_skin.path, name), m_skin, m_known);
        } else if (keyword == "usemtl") {
            const auto [entry, isNew] =
                m_known.try_emplace(std::string(line), static_cast<int>(m_skin.materials.size()));
            if (isNew) m_skin.materials.push_back({std::string(line), {0.8F, 0.8F, 0.8F, 1}, {}});
            m_material = entry->second;
        } else if (keyword == "g" || keyword == "o") {
            m_group =
                m_groups.try_emplace(std::string(line), static_cast<int>(m_groupNames.size())).first->second;
            if (m_group == static_cast<int>(m_groupNames.size())) m_groupNames.emplace_back(line);
        }
    }
    void face(std::string_view line) {
        Face face{{}, m_material, m_group};
        while (!line.empty()) face.textures.push_back(textureOf(takeWord(line)));
        m_faces.push_back(std::move(face));
    }
    /// The triangles that readObj has split each face into.
    void spreadOverTriangles() {
        std::vector<std::size_t> faceOf(static_cast<std::size_t>(m_file.cells.size()), 0);
        std::size_t face = 0;
        for (int c = 0; c < m_file.cells.size(); ++c)
            if (m_file.cells.dimension(c) == 2) faceOf[static_cast<std::size_t>(c)] = face++;
        for (std::size_t t = 0; t < m_skin.triangles.size(); ++t) {
            const int cell = m_file.cellOfTriangle[t];
            const Face& one = m_faces[faceOf[static_cast<std::size_t>(cell)]];
            const auto nodes = m_file.cells[cell];
            std::array<int, 3> textures;
            for (int k = 0; k < 3; ++k)
                textures[k] = one.textures[static_cast<std::size_t>(
                    std::ranges::find(nodes, m_skin.triangles[t][k]) - nodes.begin())];
            m_uvCorners.push_back(textures);
            m_materialOf.push_back(one.material);
            m_groupOf.push_back(one.group);
        }
    }
    int textureOf(std::string_view corner) {
        const auto slash = corner.find('/');
        const auto text = slash == std::string_view::npos
                              ? std::string_view()
                              : corner.substr(slash + 1, corner.find('/', slash + 1) - slash - 1);
        if (numberOr(text, 0) == 0) m_withoutTexture = true;
        return static_cast<int>(placeOf(text, std::ssize(m_uv) / 2));
    }
    void takeLabels() {
        const bool byMaterial = m_skin.materials.size() > 1;
        const auto& of = byMaterial ? m_materialOf : m_groupOf;
        if (!byMaterial && m_groupNames.size() < 2) return;
        for (int index : of) m_skin.labels.push_back(index + 1);
        for (const SkinMaterial& material : m_skin.materials)
            if (byMaterial) m_skin.labelNames.push_back(material.name);
        if (!byMaterial) m_skin.labelNames = m_groupNames;
    }

    struct Face {
        std::vector<int> textures;  // of the corners
        int material, group;
    };

    const MeshFile& m_file;
    Skin& m_skin;
    std::vector<double> m_uv;
    std::vector<Face> m_faces;
    std::vector<std::array<int, 3>> m_uvCorners;
    bool m_withoutTexture = false;
    std::map<std::string, int, std::less<>> m_known;  // materials
    std::map<std::string, int, std::less<>> m_groups;
    std::vector<std::string> m_groupNames;
    std::vector<int> m_materialOf, m_groupOf;
    int m_material = -1, m_group = -1;
};

/// The normals of a file, turned with the vertices that have them: each pair of a vertex and a normal gets
/// one of its own, in the order of use.
class TurnedNormals {
  public:
    TurnedNormals(const std::string& bytes, std::vector<Eigen::Quaterniond> turns)
        : m_turns(std::move(turns)) {
        eachLine(bytes, [this](std::string_view line) {
            if (takeWord(line) != "vn") return;
            Eigen::Vector3d normal;
            for (double& part : normal) part = numberOr(takeWord(line), 0);
            m_normals.push_back(normal);
        });
    }
    /// Returns whether none has turned: then all stay as they are.
    bool areKept() const {
        return std::ranges::all_of(m_turns, [](const auto& turn) { return turn.vec().isZero(); });
    }
    /// Passes a line with a normal: later ones may count back from it.
    void pass() { ++m_passed; }
    /// Returns a corner with its new number, and prints its normal if it is new. `vertices` precede it.
    std::string corner(std::string_view word, std::int64_t vertices, TextWriter& out) {
        const auto first = word.find('/');
        const auto second = first == word.npos ? word.npos : word.find('/', first + 1);
        if (second == word.npos) return std::string(word);
        const std::string_view before = word.substr(0, second == first + 1 ? first : second);
        const auto vertex = placeOf(word.substr(0, first), vertices),
                   normal = placeOf(word.substr(second + 1), m_passed);
        if (vertex < 0 || vertex >= std::ssize(m_turns) || normal < 0 || normal >= std::ssize(m_normals))
            return std::string(before);
        const auto [known, isNew] = m_numbers.try_emplace({vertex, normal}, m_numbers.size() + 1);
        if (isNew) {
            const Eigen::Quaterniond& turn = m_turns[static_cast<std::size_t>(vertex)];
            const Eigen::Vector3d& old = m_normals[static_cast<std::size_t>(normal)];
            const Eigen::Vector3d turned = turn.vec().isZero() ? old : Eigen::Vector3d(turn * old);
            out << "vn " << turned.x() << ' ' << turned.y() << ' ' << turned.z() << '\n';
        }
        return std::string(before) + (second == first + 1 ? "//" : "/") + std::to_string(known->second);
    }

  private:
    std::vector<Eigen::Quaterniond> m_turns;
    std::vector<Eigen::Vector3d> m_normals;
    std::int64_t m_passed = 0;
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> m_numbers;
};

std::string renamed(const std::string& file, const std::string& oldFolder, const std::string& newFolder) {
    const fs::path whole = fs::absolute(fs::path(oldFolder) / file).lexically_normal();
    const fs::path relative = whole.lexically_relative(fs::absolute(fs::path(newFolder)).lexically_normal());
    return relative.empty() ? whole.string() : relative.generic_string();
}

}  // namespace

void addObjLook(const std::string& bytes, const MeshFile& file, Skin& skin) {
    LookReader(file, skin).read(bytes);
}

std::vector<std::string> objLookFiles(const std::string& bytes, const std::string& path) {
    std::vector<std::string> files;
    Skin skin;
    std::map<std::string, int, std::less<>> known;
    eachLine(bytes, [&](std::string_view line) {
        line = line.substr(0, line.find('#'));
        if (takeWord(line) != "mtllib") return;
        for (const std::string& name : librariesIn(line, path)) {
            const fs::path materials = materialPath(path, name);
            files.push_back(materials.string());
            readMaterials(materials, skin, known);
        }
    });
    for (const SkinMaterial& material : skin.materials)
        if (!material.texture.empty()) files.push_back(material.texture);
    return files;
}

std::string withVertices(const std::string& bytes, const Skin& skin, const Points3& points,
                         const std::string& newFolder) {
    const std::string oldFolder = fs::path(skin.path).parent_path().string();
    TextWriter out;
    TurnedNormals normals(bytes, turnsOf(skin.points, points, skin.triangles));
    const bool kept = normals.areKept();
    Eigen::Index vertex = 0;
    eachLine(bytes, [&](std::string_view line) {
        std::string_view rest = line;
        const auto keyword = takeWord(rest);
        if (keyword == "vn" && !kept) return normals.pass();
        if (keyword == "v" && vertex < points.cols()) {
            for (int k = 0; k < 3; ++k) takeWord(rest);
            out << "v " << points(0, vertex) << ' ' << points(1, vertex) << ' ' << points(2, vertex);
            if (!rest.empty()) out << ' ' << rest;  // a weight or a colour
            ++vertex;
        } else if (keyword == "f") {
            std::string corners = "f";
            while (!rest.empty() && rest.front() != '#')
                corners +=
                    ' ' + (kept ? std::string(takeWord(rest)) : normals.corner(takeWord(rest), vertex, out));
            out << corners;
        } else if (keyword == "mtllib") {
            out << "mtllib";
            for (const std::string& name : librariesIn(rest, skin.path))
                out << ' ' << renamed(name, oldFolder, newFolder);
        } else {
            out << line;
        }
        out << '\n';
    });
    return std::move(out.text());
}

}  // namespace wend::formats
