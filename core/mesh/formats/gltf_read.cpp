// Binary glTF 2.0 (.glb) consists of a chunk of JSON and one with the bytes of its accessors. Triangles,
// lines and points that are drawn become cells, placed by the nodes of the scene. As in STL, equal points of
// a node become one, because glTF doubles vertices where texture points or normals meet. In glTF the y axis
// points up, here it is z.

#include "core/mesh/formats/gltf_read.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/colours.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

using Json = nlohmann::json;
using Transform = Eigen::Matrix4d;

constexpr int kDeepestJson = 64;  // copies of deeper texts would exhaust the stack

/// Parses JSON. Throws InputError if it is nested deeper than any glTF file needs.
Json shallowJson(std::string_view text) {
    return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
        if (depth > kDeepestJson) throw InputError("its JSON is nested too deep");
        return true;
    });
}

struct Chunks {
    std::string_view json, binary;
};

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= std::uint32_t(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return word;
}

/// Returns the chunks of JSON and of bytes. Throws InputError for other versions of glTF, and for a damaged
/// header.
Chunks chunksOf(std::string_view bytes) {
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    if (!bytes.starts_with("glTF") || bytes.size() < kHeader)
        throw InputError("does not begin with 'glTF': no .glb file");
    if (wordAt(bytes, 4) != 2)
        throw InputError("is glTF of version " + std::to_string(wordAt(bytes, 4)) + "; 2 is read");
    Chunks chunks;
    for (std::size_t at = kHeader; at + kChunkHeader <= bytes.size();) {
        const std::size_t size = wordAt(bytes, at);
        const std::string_view kind = bytes.substr(at + 4, 4);
        at += kChunkHeader;
        if (size > bytes.size() - at)
            throw InputError("is cut off: a chunk of " + std::to_string(size) + " bytes begins at " +
                             std::to_string(at));
        if (kind == "JSON" && chunks.json.empty()) chunks.json = bytes.substr(at, size);
        if (kind == std::string_view("BIN\0", 4) && chunks.binary.empty())
            chunks.binary = bytes.substr(at, size);
        at += (size + 3) / 4 * 4;
    }
    if (chunks.json.empty()) throw InputError("has no JSON chunk");
    return chunks;
}

/// The kinds of components of an accessor.
enum class Component { Int8 = 5120, UInt8, Int16, UInt16, UInt32 = 5125, Float = 5126 };

std::size_t sizeOf(Component type) {
    switch (type) {
        case Component::Int8:
        case Component::UInt8:
            return 1;
        case Component::Int16:
        case Component::UInt16:
            return 2;
        case Component::UInt32:
        case Component::Float:
            return 4;
    }
    return 0;
}

/// Returns the greatest value of an integer type, for normalized ones.
double greatestOf(Component type) {
    return type == Component::Int8    ? 127
           : type == Component::UInt8 ? 255
           : type == Component::Int16 ? 32767
                                      : 65535;
}

/// A table of numbers in the binary chunk.
class Accessor {
  public:
    /// Takes an accessor: a typed view of some of the bytes. Throws InputError if it reaches beyond them.
    Accessor(const Json& gltf, std::size_t index, std::string_view binary) {
        const Json& json = gltf.at("accessors").at(index);
        if (json.contains("sparse"))
            throw InputError("accessor " + std::to_string(index) + " is sparse, which is not read");
        m_count = json.at("count").get<std::size_t>();
        m_type = static_cast<Component>(json.at("componentType").get<int>());
        const std::size_t size = sizeOf(m_type);
        if (size == 0)
            throw InputError("accessor " + std::to_string(index) + " has an unknown type of numbers");
        m_normalized = json.value("normalized", false);
        const std::string type = json.at("type").get<std::string>();
        m_width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
        const Json& view = gltf.at("bufferViews").at(json.at("bufferView").get<std::size_t>());
        const Json& buffer = gltf.at("buffers").at(view.at("buffer").get<std::size_t>());
        if (buffer.contains("uri") || view.at("buffer").get<std::size_t>() != 0)
            throw InputError("keeps its numbers in another file, which is not read");
        const auto begin = view.value("byteOffset", std::size_t(0)),
                   length = view.at("byteLength").get<std::size_t>(),
                   offset = json.value("byteOffset", std::size_t(0));
        m_stride = view.value("byteStride", m_width * size);
        if (begin > binary.size() || length > binary.size() - begin || offset > length ||
            m_stride > 252 + m_width * size ||
            (m_count > 0 &&
             (m_count - 1 > length || (m_count - 1) * m_stride + m_width * size > length - offset)))
            throw InputError("accessor " + std::to_string(index) + " reaches beyond the file");
        m_bytes = binary.substr(begin + offset, length - offset);
    }

    std::size_t count() const { return m_count; }
    std::size_t width() const { return m_width; }
    double number(std::size_t item, std::size_t k) const {
        const std::size_t at = item * m_stride + k * sizeOf(m_type);
        const double value = plain(at);
        return m_normalized && m_type != Component::Float ? std::max(value / greatestOf(m_type), -1.0)
                                                          : value;
    }

  private:
    double plain(std::size_t at) const {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < sizeOf(m_type); ++k)
            word |= std::uint32_t(static_cast<unsigned char>(m_bytes[at + k])) << (8 * k);
        if (m_type == Component::Float) return std::bit_cast<float>(word);
        if (m_type == Component::Int8) return static_cast<std::int8_t>(word);
        if (m_type == Component::Int16) return static_cast<std::int16_t>(word);
        return word;
    }

    std::string_view m_bytes;
    std::size_t m_count = 0, m_width = 1, m_stride = 0;
    Component m_type = Component::Float;
    bool m_normalized = false;
};

class GltfReader {
  public:
    explicit GltfReader(std::string_view bytes) : m_chunks(chunksOf(bytes)) {}

    /// Reads the nodes of the default scene, which is the first one if none is named.
    void read() try {
        m_gltf = shallowJson(m_chunks.json);
        requireReadable();
        const auto scenes = m_gltf.value("scenes", Json::array());
        const auto scene = m_gltf.value("scene", std::size_t(0));
        if (scene < scenes.size()) readNodes(scenes[scene].value("nodes", Json::array()));
        collectPoints();
        addGroups();
        addNotices();
    } catch (const Json::exception& error) {
        throw InputError(std::string("its JSON is not that of a glTF file: ") + error.what());
    }

    MeshFile& file() { return m_file; }
    /// Texture points of the corners of the triangles, if all have some.
    bool hasTexture() const { return m_hasTexture && !m_textureCorners.empty(); }
    const std::vector<double>& textureNumbers() const { return m_texture; }
    const std::vector<std::array<int, 3>>& textureCorners() const { return m_textureCorners; }
    const std::vector<int>& materialOfTriangle() const { return m_materialOfTriangle; }
    std::vector<SkinMaterial> materials() const {
        std::vector<SkinMaterial> materials;
        for (const Json& one : m_gltf.value("materials", Json::array())) {
            SkinMaterial material;
            material.name = one.value("name", std::string());
            const Json surface = one.value("pbrMetallicRoughness", Json::object());
            const auto colour = surface.value("baseColorFactor", std::vector<float>{1, 1, 1, 1});
            if (colour.size() == 4) std::copy(colour.begin(), colour.end(), material.colour.begin());
            materials.push_back(std::move(material));
        }
        return materials;
    }

  private:
    void requireReadable() const {
        for (const Json& one : m_gltf.value("extensionsRequired", Json::array()))
            if (const auto name = one.get<std::string>(); name.find("compression") != std::string::npos)
                throw InputError("is compressed by " + inQuotes(name) + ", which is not read");
    }

    /// Returns the transform of a node, which is a matrix, or a translation, a rotation and a scale.
    static Transform transformOf(const Json& node) {
        if (node.contains("matrix")) {
            const auto numbers = node["matrix"].get<std::vector<double>>();
            if (numbers.size() != 16)
                throw InputError("a node has a matrix of " + std::to_string(numbers.size()) + " numbers");
            return Eigen::Map<const Transform>(numbers.data());
        }
        const auto numbers = [&](const char* key, std::vector<double> otherwise) {
            auto values = node.value(key, otherwise);
            if (values.size() != otherwise.size()) throw InputError(std::string("a node has a wrong ") + key);
            return values;
        };
        const auto t = numbers("translation", {0, 0, 0}), r = numbers("rotation", {0, 0, 0, 1}),
                   s = numbers("scale", {1, 1, 1});
        Transform transform = Transform::Identity();
        transform.topLeftCorner<3, 3>() =
            Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized().toRotationMatrix() *
            Eigen::Vector3d(s[0], s[1], s[2]).asDiagonal();
        transform.topRightCorner<3, 1>() << t[0], t[1], t[2];
        return transform;
    }

    /// Reads the nodes of these numbers, each followed by its children. A list stands for recursion: chains
    /// may be as long as the file.
    void readNodes(const Json& roots) {
        std::vector<std::pair<std::size_t, Transform>> waiting;
        const auto append = [&](const Json& numbers, const Transform& parent) {
            const auto end = static_cast<std::ptrdiff_t>(waiting.size());
            for (const Json& number : numbers) waiting.emplace_back(number.get<std::size_t>(), parent);
            std::reverse(waiting.begin() + end, waiting.end());
        };
        append(roots, Transform::Identity());
        while (!waiting.empty()) {
            const auto [index, parent] = waiting.back();
            waiting.pop_back();
            const Json& node = m_gltf.at("nodes").at(index);
            const Transform transform = parent * transformOf(node);
            readNode(index, node, transform);
            append(node.value("children", Json::array()), transform);
        }
    }
    /// Reads a node's mesh with the node's transform.
    void readNode(std::size_t index, const Json& node, const Transform& transform) {
        if (!m_visited.insert(index).second)
            throw InputError("node " + std::to_string(index) + " is in the scene twice");
        if (!node.contains("mesh")) return;
        const auto mesh = node["mesh"].get<std::size_t>();
        m_places.clear();
        const int first = m_file.cells.size();
        for (const Json& primitive : m_gltf.at("meshes").at(mesh).at("primitives"))
            readPrimitive(primitive, transform);
        std::string name = node.value("name", std::string());
        if (name.empty()) name = m_gltf["meshes"][mesh].value("name", std::string());
        m_nodes.push_back({std::move(name), first, m_file.cells.size()});
    }

    /// Reads a primitive: its points, its cells, its texture points and its material. Triangles that the
    /// transform mirrors are turned over, so that they face outwards again (glTF 2.0, 3.7.4).
    void readPrimitive(const Json& primitive, const Transform& transform) {
        const Json& attributes = primitive.at("attributes");
        if (!attributes.contains("POSITION")) return;
        const Accessor positions(m_gltf, attributes["POSITION"].get<std::size_t>(), m_chunks.binary);
        if (positions.width() != 3)
            throw InputError("has positions of " + std::to_string(positions.width()) + " coordinates");
        std::vector<int> vertexOf;
        for (std::size_t i = 0; i < positions.count(); ++i)
            vertexOf.push_back(vertexAt(
                transform, {positions.number(i, 0), positions.number(i, 1), positions.number(i, 2)}));
        const std::vector<std::size_t> order = orderOf(primitive, positions.count());
        const int firstCell = m_file.cells.size(), firstTexture = static_cast<int>(m_texture.size() / 2);
        const bool textured = readTexture(attributes, positions.count());
        readColours(attributes, vertexOf);
        const bool isMirrored = transform.topLeftCorner<3, 3>().determinant() < 0;
        for (auto& [kind, corners] : cellsOf(primitive.value("mode", 4), order)) {
            if (isMirrored && kind == CellKind::Triangle) std::swap(corners[1], corners[2]);
            std::vector<int> cell;
            for (const std::size_t corner : corners) cell.push_back(vertexOf[corner]);
            m_file.cells.add(kind, cell);
            if (kind != CellKind::Triangle) continue;
            m_materialOfTriangle.push_back(primitive.value("material", -1));
            m_hasTexture = m_hasTexture && textured;
            m_isTextured.push_back(textured);
            m_textureCorners.push_back({firstTexture + static_cast<int>(corners[0]),
                                        firstTexture + static_cast<int>(corners[1]),
                                        firstTexture + static_cast<int>(corners[2])});
        }
        if (primitive.contains("material"))
            for (int c = firstCell; c < m_file.cells.size(); ++c)
                m_cellsOfMaterial[primitive["material"].get<int>()].push_back(c);
    }

    /// Equal points of one node are one vertex.
    int vertexAt(const Transform& transform, const Vec3& p) {
        const Vec3 q = transform.topLeftCorner<3, 3>() * p + transform.topRightCorner<3, 1>();
        const std::array<double, 3> place{q.x(), -q.z(), q.y()};
        const auto [found, isNew] = m_places.try_emplace(place, static_cast<int>(m_points.size() / 3));
        if (isNew) m_points.insert(m_points.end(), place.begin(), place.end());
        return found->second;
    }

    /// Returns the vertices of a primitive in their order, which may be given by indices.
    std::vector<std::size_t> orderOf(const Json& primitive, std::size_t count) const {
        std::vector<std::size_t> order;
        if (!primitive.contains("indices")) {
            for (std::size_t i = 0; i < count; ++i) order.push_back(i);
            return order;
        }
        const Accessor indices(m_gltf, primitive["indices"].get<std::size_t>(), m_chunks.binary);
        for (std::size_t i = 0; i < indices.count(); ++i) {
            const double index = indices.number(i, 0);
            if (!(index >= 0 && index < static_cast<double>(count)))
                throw InputError("a triangle names vertex " + std::to_string(static_cast<long>(index)) +
                                 ", but there are only " + std::to_string(count));
            order.push_back(static_cast<std::size_t>(index));
        }
        return order;
    }

    /// v runs down from the top there.
    bool readTexture(const Json& attributes, std::size_t count) {
        const bool has = attributes.contains("TEXCOORD_0");
        if (has) {
            const Accessor uv(m_gltf, attributes["TEXCOORD_0"].get<std::size_t>(), m_chunks.binary);
            if (uv.count() != count || uv.width() != 2)
                throw InputError("has a wrong number of texture coordinates");
            for (std::size_t i = 0; i < count; ++i)
                m_texture.insert(m_texture.end(), {uv.number(i, 0), 1 - uv.number(i, 1)});
        } else {
            m_texture.resize(m_texture.size() + 2 * count, 0);
        }
        return has;
    }

    /// Reads the colours of vertices, which are light; where equal points have several, the first one counts.
    void readColours(const Json& attributes, const std::vector<int>& vertexOf) {
        if (!attributes.contains("COLOR_0")) return;
        const Accessor colours(m_gltf, attributes["COLOR_0"].get<std::size_t>(), m_chunks.binary);
        if (colours.count() != vertexOf.size() || colours.width() < 3)
            throw InputError("has a wrong number of colours");
        for (std::size_t i = 0; i < vertexOf.size(); ++i) {
            Colour colour{1, 1, 1, 1};
            for (std::size_t k = 0; k < colours.width(); ++k)
                colour[k] =
                    k < 3 ? shownOf(std::clamp(colours.number(i, k), 0.0, 1.0)) : colours.number(i, k);
            m_colours.try_emplace(vertexOf[i], colour);
        }
    }

    struct GltfCell {
        CellKind kind;
        std::vector<std::size_t> corners;
    };
    /// Returns the cells of a primitive's mode: points, lines, or triangles, which may be in strips or fans.
    static std::vector<GltfCell> cellsOf(int mode, const std::vector<std::size_t>& order) {
        enum { Points, Lines, LineLoop, LineStrip, Triangles, Strip, Fan };
        std::vector<GltfCell> cells;
        const std::size_t n = order.size();
        const auto line = [&](std::size_t a, std::size_t b) {
            cells.push_back({CellKind::Line, {order[a], order[b]}});
        };
        const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
            cells.push_back({CellKind::Triangle, {order[a], order[b], order[c]}});
        };
        if (mode == Points)
            for (std::size_t i = 0; i < n; ++i) cells.push_back({CellKind::Vertex, {order[i]}});
        if (mode == Lines)
            for (std::size_t i = 0; i + 1 < n; i += 2) line(i, i + 1);
        if (mode == LineLoop || mode == LineStrip)
            for (std::size_t i = 0; i + 1 < n; ++i) line(i, i + 1);
        if (mode == LineLoop && n > 2) line(n - 1, 0);
        if (mode == Triangles)
            for (std::size_t i = 0; i + 2 < n; i += 3) triangle(i, i + 1, i + 2);
        if (mode == Strip)
            for (std::size_t i = 0; i + 2 < n; ++i)  // one with a corner twice only leads the strip on
                if (order[i] != order[i + 1] && order[i + 1] != order[i + 2] && order[i] != order[i + 2])
                    triangle(i, i + 1 + i % 2, i + 2 - i % 2);
        if (mode == Fan)
            for (std::size_t i = 1; i + 1 < n; ++i) triangle(i, i + 1, 0);
        return cells;
    }

    /// Collects the points with their colours, and the texture points of corners.
    void collectPoints() {
        m_file.points = Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3,
                                                           static_cast<Eigen::Index>(m_points.size() / 3));
        if (!m_colours.empty()) {
            std::vector<Colour> colours(m_points.size() / 3, Colour{1, 1, 1, 1});
            for (const auto& [vertex, colour] : m_colours) colours[static_cast<std::size_t>(vertex)] = colour;
            addColours(m_file, colours, false);
        }
        if (m_textureCorners.empty() || m_texture.empty()) return;
        std::vector<double> uv(2 * m_file.cells.nodes.size(), std::numeric_limits<double>::quiet_NaN());
        std::size_t t = 0;
        for (int c = 0; c < m_file.cells.size(); ++c) {
            if (m_file.cells.kinds[static_cast<std::size_t>(c)] != CellKind::Triangle) continue;
            const auto first = 2 * static_cast<std::size_t>(m_file.cells.begins[static_cast<std::size_t>(c)]);
            for (std::size_t k = 0; k < 3 && m_isTextured[t]; ++k)
                for (std::size_t j = 0; j < 2; ++j)
                    uv[first + 2 * k + j] =
                        m_texture[static_cast<std::size_t>(2 * m_textureCorners[t][k]) + j];
            ++t;
        }
        setCornerUv(m_file, std::move(uv));
    }

    /// Adds groups for the nodes, if there are several, and for the materials.
    void addGroups() {
        if (m_nodes.size() > 1)
            for (const Node& node : m_nodes) {
                MeshGroup group{node.name, 2, 0, {}, {}};
                if (node.name.empty()) group.tag = static_cast<long>(&node - m_nodes.data()) + 1;
                for (int c = node.first; c < node.end; ++c)
                    if (m_file.cells.dimension(c) == 2) group.cells.push_back(c);
                if (!group.cells.empty()) m_file.groups.push_back(std::move(group));
            }
        const std::vector<SkinMaterial> all = materials();
        for (auto& [number, cells] : m_cellsOfMaterial) {
            std::erase_if(cells, [&](int c) { return m_file.cells.dimension(c) != 2; });
            const bool isNamed = number >= 0 && number < static_cast<int>(all.size()) &&
                                 !all[static_cast<std::size_t>(number)].name.empty();
            if (isNamed && !cells.empty())
                m_file.groups.push_back({all[static_cast<std::size_t>(number)].name, 2, 0, cells, {}, true});
        }
    }

    void addNotices() {
        for (const auto& [key, one, many] : {std::tuple{"images", "its picture", " pictures"},
                                             {"animations", "its animation", " animations"},
                                             {"skins", "its skeleton", " skeletons"},
                                             {"cameras", "its camera", " cameras"}}) {
            const std::size_t count = m_gltf.value(key, Json::array()).size();
            if (count > 0) m_file.notices.push_back(count == 1 ? one : "its " + std::to_string(count) + many);
        }
    }

    struct Node {
        std::string name;
        int first, end;  // its cells
    };
    const Chunks m_chunks;
    Json m_gltf;
    MeshFile m_file;
    std::set<std::size_t> m_visited;
    std::vector<Node> m_nodes;
    std::map<std::array<double, 3>, int> m_places;  // of the node's vertices
    std::map<int, Colour> m_colours;                // of vertices
    std::vector<double> m_points, m_texture;
    bool m_hasTexture = true;
    std::vector<std::array<int, 3>> m_textureCorners;
    std::vector<char> m_isTextured;  // of the triangles
    std::vector<int> m_materialOfTriangle;
    std::map<int, std::vector<int>> m_cellsOfMaterial;
};

}  // namespace

MeshFile readGltf(std::span<const MeshSource> files) {
    GltfReader reader(files[0].bytes);
    reader.read();
    finishCells(reader.file());
    return std::move(reader.file());
}

void addGltfLook(std::string_view bytes, Skin& skin) {
    GltfReader reader(bytes);
    reader.read();
    const auto triangles = reader.materialOfTriangle().size();
    if (triangles != skin.triangles.size()) return;
    skin.materials = reader.materials();
    if (!skin.materials.empty()) skin.materialOf = reader.materialOfTriangle();
    for (int& material : skin.materialOf)
        if (material >= static_cast<int>(skin.materials.size())) material = -1;
    if (!reader.hasTexture()) return;
    const auto& numbers = reader.textureNumbers();
    skin.uv =
        Eigen::Map<const Eigen::Matrix2Xd>(numbers.data(), 2, static_cast<Eigen::Index>(numbers.size() / 2));
    skin.uvCorners = reader.textureCorners();
}

}  // namespace wend::formats
