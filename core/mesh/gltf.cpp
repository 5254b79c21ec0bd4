#include "core/mesh/gltf.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/safe_file.h"
#include "core/mesh/formats/colours.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsigned = 5125;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;

/// The binary chunk with its views and accessors (glTF 2.0, 3.6).
class Buffer {
  public:
    explicit Buffer(Json& gltf) : m_gltf(gltf) {}

    int view(const void* data, std::size_t bytes, int target) {
        m_bytes.resize((m_bytes.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes}};
        if (target != 0) view["target"] = target;
        m_gltf["bufferViews"].push_back(view);
        m_bytes.append(static_cast<const char*>(data), bytes);
        return static_cast<int>(m_gltf["bufferViews"].size()) - 1;
    }

    int floats(const std::vector<float>& values, int components, int target, bool range) {
        static constexpr std::array<const char*, 5> kTypes = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        Json accessor = {{"bufferView", view(values.data(), values.size() * sizeof(float), target)},
                         {"componentType", kFloat},
                         {"count", values.size() / components},
                         {"type", kTypes[components]}};
        if (range) addRange(accessor, values, components);
        m_gltf["accessors"].push_back(accessor);
        return static_cast<int>(m_gltf["accessors"].size()) - 1;
    }

    int indices(const std::vector<std::array<int, 3>>& triangles) {
        std::vector<std::uint32_t> flat;
        for (const auto& t : triangles) flat.insert(flat.end(), t.begin(), t.end());
        m_gltf["accessors"].push_back({{"bufferView", view(flat.data(), flat.size() * 4, kElementBuffer)},
                                       {"componentType", kUnsigned},
                                       {"count", flat.size()},
                                       {"type", "SCALAR"}});
        return static_cast<int>(m_gltf["accessors"].size()) - 1;
    }

    const std::string& bytes() const { return m_bytes; }

  private:
    /// Least and largest value per component: required for positions and animation times.
    static void addRange(Json& accessor, const std::vector<float>& values, int components) {
        std::vector<float> low(values.begin(), values.begin() + components), high = low;
        for (std::size_t i = 0; i < values.size(); ++i) {
            low[i % components] = std::min(low[i % components], values[i]);
            high[i % components] = std::max(high[i % components], values[i]);
        }
        accessor["min"] = low;
        accessor["max"] = high;
    }

    Json& m_gltf;
    std::string m_bytes;
};

std::vector<float> flatten(const Points3& points, bool zUp) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(points.size()));
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec3 p = points.col(i);
        const Vec3 turned = zUp ? Vec3(p.x(), p.z(), -p.y()) : p;
        for (double x : turned) values.push_back(static_cast<float>(x));
    }
    return values;
}

/// glTF's v runs down from the top left corner.
std::vector<float> flattenUv(const Eigen::Matrix2Xd& uv) {
    std::vector<float> values;
    for (Eigen::Index i = 0; i < uv.cols(); ++i) {
        values.push_back(static_cast<float>(uv(0, i)));
        values.push_back(static_cast<float>(1 - uv(1, i)));
    }
    return values;
}

/// Returns colours of vertices as light, which glTF has them in.
std::vector<float> flattenColours(const std::vector<std::array<double, 4>>& colours) {
    std::vector<float> values;
    for (const auto& colour : colours) {
        for (std::size_t k = 0; k < 3; ++k) values.push_back(static_cast<float>(formats::lightOf(colour[k])));
        values.push_back(static_cast<float>(colour[3]));
    }
    return values;
}

bool isPng(const std::string& bytes) {
    return bytes.rfind("\x89PNG", 0) == 0;
}
bool isJpeg(const std::string& bytes) {
    return bytes.rfind("\xFF\xD8\xFF", 0) == 0;
}

std::string bytesOrNone(const std::string& path) try { return readInput(path); } catch (const InputError&) {
    return {};
}

/// Textures by the path of their picture.
using Textures = std::map<std::string, int>;

/// Adds the picture as a texture and returns its number; −1 if it is missing or of another format.
int addTexture(Json& gltf, Buffer& buffer, Textures& textures, const std::string& path) {
    if (const auto known = textures.find(path); known != textures.end()) return known->second;
    const std::string bytes = bytesOrNone(path);
    if (!isPng(bytes) && !isJpeg(bytes)) return textures[path] = -1;
    gltf["images"].push_back({{"bufferView", buffer.view(bytes.data(), bytes.size(), 0)},
                              {"mimeType", isPng(bytes) ? "image/png" : "image/jpeg"}});
    gltf["textures"].push_back({{"source", gltf["images"].size() - 1}});
    return textures[path] = static_cast<int>(gltf["textures"].size()) - 1;
}

void addMaterial(Json& gltf, Buffer& buffer, Textures& textures, const SkinMaterial& material, bool isUnlit) {
    Json surface = {{"metallicFactor", 0.0}, {"roughnessFactor", 0.8}};
    const int texture = material.texture.empty() ? -1 : addTexture(gltf, buffer, textures, material.texture);
    if (texture >= 0)
        surface["baseColorTexture"] = {{"index", texture}};
    else if (material.colour != SkinMaterial().colour)
        surface["baseColorFactor"] = material.colour;
    Json json = {{"name", material.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}};
    if (material.colour[3] < 1 || isUnlit) json["alphaMode"] = "BLEND";
    if (isUnlit) json["extensions"]["KHR_materials_unlit"] = Json::object();
    gltf["materials"].push_back(json);
}

/// Returns the triangles by material, in the order of the materials; those without one get the first.
std::vector<std::vector<std::array<int, 3>>> trianglesByMaterial(const GltfScene& scene) {
    std::vector<std::vector<std::array<int, 3>>> parts(std::max<std::size_t>(scene.materials.size(), 1));
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const int material = scene.materialOf.empty() ? 0 : std::max(0, scene.materialOf[t]);
        parts[static_cast<std::size_t>(material)].push_back(scene.triangles[t]);
    }
    return parts;
}

/// Adds one morph target per pose, with weights that interpolate linearly.
void addAnimation(Json& gltf, Buffer& buffer, Json& mesh, const GltfScene& scene, bool zUp) {
    if (scene.poses.empty()) return;
    const std::size_t count = scene.poses.size();
    Json targets = Json::array();
    const Points3 normals = scene.smooth ? vertexNormals(scene.points, scene.triangles) : Points3();
    for (const auto& pose : scene.poses) {
        Json target = {{"POSITION", buffer.floats(flatten(pose - scene.points, zUp), 3, kArrayBuffer, true)}};
        if (scene.smooth) {
            const Points3 turned = vertexNormals(pose, scene.triangles) - normals;
            target["NORMAL"] = buffer.floats(flatten(turned, zUp), 3, kArrayBuffer, false);
        }
        targets.push_back(target);
    }
    for (Json& primitive : mesh["primitives"]) primitive["targets"] = targets;
    mesh["weights"] = std::vector<float>(count, 0.0F);
    std::vector<float> weights(count * count, 0.0F);
    for (std::size_t i = 0; i < count; ++i) weights[i * count + i] = 1;
    const std::vector<float> times(scene.times.begin(), scene.times.end());
    const Json sampler = {{"input", buffer.floats(times, 1, 0, true)},
                          {"output", buffer.floats(weights, 1, 0, false)},
                          {"interpolation", "LINEAR"}};
    const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
    gltf["animations"] = Json::array({{{"name", "deformation"},
                                       {"samplers", Json::array({sampler})},
                                       {"channels", Json::array({channel})}}});
}

void appendWord(std::string& out, std::uint32_t word) {
    for (int k = 0; k < 4; ++k) out += static_cast<char>((word >> (8 * k)) & 0xFF);
}

/// Returns a file: header, JSON chunk (padded with spaces), binary chunk (padded with zeros): glTF 2.0,
/// section 4.4.
std::string container(const Json& gltf, const std::string& bytes) {
    std::string text = gltf.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = bytes;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string out = "glTF";
    appendWord(out, 2);
    appendWord(out, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
    appendWord(out, static_cast<std::uint32_t>(text.size()));
    out += "JSON" + text;
    appendWord(out, static_cast<std::uint32_t>(binary.size()));
    out += std::string("BIN\0", 4) + binary;
    return out;
}

}  // namespace

GltfScene gltfScene(const Skin& skin, const std::vector<Points3>& poses, std::vector<double> times) {
    const UnfoldedSkin one = unfolded(skin);
    const auto doubled = [&](const Points3& points) { return Points3(points(Eigen::all, one.vertices)); };
    GltfScene scene;
    scene.triangles = one.triangles;
    scene.points = doubled(poses.front());
    scene.uv = one.uv;
    if (!skin.colours.empty())
        for (const int v : one.vertices) scene.colours.push_back(skin.colours[static_cast<std::size_t>(v)]);
    scene.materialOf = skin.materialOf;
    scene.materials = skin.materials;
    scene.smooth = true;
    if (poses.size() < 2) return scene;
    scene.times = std::move(times);
    for (const auto& pose : poses) scene.poses.push_back(doubled(pose));
    return scene;
}

GltfScene gltfScene(const Skin& skin, const Points3& points) {
    return gltfScene(skin, std::vector<Points3>{points}, {});
}

namespace {

/// Returns the place of the node. For a shape far from the origin, floats of seven digits would hold little
/// more than that place. It is itself a float, so that readers lose nothing of it, and zero if the shape is
/// near the origin.
Vec3 nodePlace(const Points3& points) {
    if (points.cols() == 0) return Vec3::Zero();
    const Vec3 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff(),
               middle = low + (high - low) / 2;
    if (middle.norm() <= (high - low).norm()) return Vec3::Zero();
    return middle.cast<float>().cast<double>();
}

}  // namespace

/// Writes the scene as one node with one primitive per material; poses become morph targets, one of which is
/// active at each time.
void writeGltf(const std::string& path, const GltfScene& scene, bool zUp) {
    if (scene.times.size() != scene.poses.size()) throw InputError(path, "one time per pose is needed");
    Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "Wend"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", {0}}}})},
                 {"nodes", Json::array({{{"mesh", 0}, {"name", scene.name}}})}};
    const Vec3 place = nodePlace(scene.points);
    if (place != Vec3::Zero()) gltf["nodes"][0]["translation"] = flatten(place, zUp);
    Buffer buffer(gltf);
    const Points3 relative = scene.points.colwise() - place;
    Json attributes = {{"POSITION", buffer.floats(flatten(relative, zUp), 3, kArrayBuffer, true)}};
    if (scene.uv.cols() > 0)
        attributes["TEXCOORD_0"] = buffer.floats(flattenUv(scene.uv), 2, kArrayBuffer, false);
    if (!scene.colours.empty())
        attributes["COLOR_0"] = buffer.floats(flattenColours(scene.colours), 4, kArrayBuffer, false);
    if (scene.smooth)
        attributes["NORMAL"] =
            buffer.floats(flatten(vertexNormals(scene.points, scene.triangles), zUp), 3, kArrayBuffer, false);
    Json mesh = {{"name", scene.name}, {"primitives", Json::array()}};
    int material = 0;
    for (const auto& part : trianglesByMaterial(scene)) {
        if (!part.empty())
            mesh["primitives"].push_back(
                {{"attributes", attributes}, {"indices", buffer.indices(part)}, {"material", material}});
        ++material;
    }
    std::vector<SkinMaterial> materials = scene.materials;
    if (materials.empty()) materials.push_back({"surface", {0.8F, 0.8F, 0.8F, 1}, scene.texture});
    Textures textures;
    for (const SkinMaterial& one : materials) addMaterial(gltf, buffer, textures, one, scene.isUnlit);
    if (std::ranges::any_of(scene.colours, [](const auto& colour) { return colour[3] < 1; }))
        for (Json& one : gltf["materials"]) one["alphaMode"] = "BLEND";
    if (scene.isUnlit) gltf["extensionsUsed"] = {"KHR_materials_unlit"};
    addAnimation(gltf, buffer, mesh, scene, zUp);
    gltf["meshes"] = Json::array({mesh});
    gltf["buffers"] = Json::array({{{"byteLength", buffer.bytes().size()}}});
    writeWhole(path, container(gltf, buffer.bytes()));
}

}  // namespace wend
