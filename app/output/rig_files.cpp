#include "app/output/rig_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/output/output_set.h"
#include "app/output/rig.h"
#include "app/project/file/text_file.h"
#include "core/base/file_name.h"
#include "core/base/temporary_folder.h"
#include "core/mesh/gltf.h"
#include "warp/convert.h"

namespace wend {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kDragonBones = "_ske.json";
constexpr int kDragonBonesOffsets = 65536;

/// Returns a number of pixels with four decimals, which keeps files small.
double rounded(double pixels) {
    return std::round(pixels * 1e4) / 1e4 + 0.0;
}

/// Returns coordinates one after another; `up` is 1 where y is down, and −1 where it is up.
Json flat(const Points2& points, const std::vector<int>& vertices, double up) {
    Json values = Json::array();
    for (const int v : vertices) {
        values.push_back(rounded(points(0, v)));
        values.push_back(rounded(up * points(1, v)));
    }
    return values;
}

Json texturePointsOf(const Rig& rig, const RigPart& part) {
    Json values = Json::array();
    for (const int v : part.vertices) {
        values.push_back(rig.texturePoints(0, v) / rig.texture->width);
        values.push_back(rig.texturePoints(1, v) / rig.texture->height);
    }
    return values;
}

Json trianglesOf(const RigPart& part) {
    Json values = Json::array();
    for (const Cell<2>& triangle : part.triangles)
        for (const int vertex : triangle) values.push_back(vertex);
    return values;
}

/// Returns the edges of the outline: pairs of vertices, each multiplied by `factor`.
Json hullEdges(const RigPart& part, int factor) {
    Json values = Json::array();
    for (int k = 0; k < part.hull; ++k) {
        values.push_back(factor * k);
        values.push_back(factor * ((k + 1) % part.hull));
    }
    return values;
}

Points2 yUp(const Points2& points, int height) {
    Points2 turned = points;
    turned.row(1) = height - points.row(1).array();
    return turned;
}

std::string stemOf(const std::string& path) {
    std::string name = fs::path(path).filename().string();
    const std::string_view extension =
        name.ends_with(kDragonBones) ? kDragonBones : std::string_view(".json");
    name.resize(name.size() - extension.size());
    return name;
}

std::string beside(const std::string& path, const std::string& ending) {
    return (fs::path(path).parent_path() / (stemOf(path) + ending)).string();
}

void writeTexture(const std::string& file, const Rig& rig) {
    writeImage(file, converted(*rig.texture, {PixelType::UInt8, 4, true, true}));
}

// ---- Spine: esotericsoftware.com/spine-json-format and spine-atlas-format ----

Json spineSkeleton(const Rig& rig, const std::string& region) {
    Json slots = Json::array(), attachments = Json::object(), keys = Json::object();
    const Points2 rest = yUp(rig.rest, rig.height);
    for (const RigPart& part : rig.parts) {
        Json slot = {{"name", part.name}, {"bone", "root"}, {"attachment", part.name}};
        if (part.blend != BlendMode::Normal)
            slot["blend"] = part.blend == BlendMode::Add ? "additive" : blendWord(part.blend);
        slots.push_back(slot);
        attachments[part.name][part.name] = {{"type", "mesh"},
                                             {"path", region},
                                             {"uvs", texturePointsOf(rig, part)},
                                             {"triangles", trianglesOf(part)},
                                             {"vertices", flat(rest, part.vertices, 1)},
                                             {"hull", part.hull},
                                             {"edges", hullEdges(part, 2)},
                                             {"width", rig.texture->width},
                                             {"height", rig.texture->height}};
        Json deform = Json::array();
        for (std::size_t k = 0; k < rig.poses.size(); ++k)
            deform.push_back({{"time", static_cast<double>(k) / rig.framesPerSecond},
                              {"vertices", flat(rig.poses[k] - rig.rest, part.vertices, -1)}});
        keys[part.name][part.name]["deform"] = deform;
    }
    Json animation = {{"attachments", {{"default", keys}}}};
    for (const std::size_t k : changesOfOrder(rig)) {
        Json key = {{"time", static_cast<double>(k) / rig.framesPerSecond}};
        for (const auto& [part, by] : offsetsOf(rig.orders[k]))
            key["offsets"].push_back(
                {{"slot", rig.parts[static_cast<std::size_t>(part)].name}, {"offset", by}});
        animation["drawOrder"].push_back(key);
    }
    return {{"skeleton",
             {{"spine", "4.1.24"},
              {"x", 0},
              {"y", 0},
              {"width", rig.width},
              {"height", rig.height},
              {"fps", rig.framesPerSecond},
              {"images", "./"}}},
            {"bones", Json::array({{{"name", "root"}}})},
            {"slots", slots},
            {"skins", Json::array({{{"name", "default"}, {"attachments", attachments}}})},
            {"animations", {{"deformation", animation}}}};
}

void writeSpine(const std::string& path, const Rig& rig, OutputSet& files) {
    const std::string region = stemOf(path) + "-atlas";
    const std::string size = std::to_string(rig.texture->width) + ", " + std::to_string(rig.texture->height);
    const std::string atlas = region + ".png\nsize: " + size + "\nfilter: Linear, Linear\npma: false\n" +
                              region + "\nbounds: 0, 0, " + size + "\n";
    files.add(path, ".json",
              [&](const std::string& file) { writeTextFile(file, spineSkeleton(rig, region).dump()); });
    files.add(beside(path, ".atlas"), "", [&](const std::string& file) { writeTextFile(file, atlas); });
    files.add(beside(path, "-atlas.png"), "", [&](const std::string& file) { writeTexture(file, rig); });
}

// ---- DragonBones 5.5 ----

Json dragonBonesKeys(const Rig& rig, const RigPart& part) {
    Json frames = Json::array();
    for (std::size_t k = 0; k < rig.poses.size(); ++k) {
        const bool isLast = k + 1 == rig.poses.size();
        Json frame = {{"duration", isLast ? 0 : 1},
                      {"vertices", flat(rig.poses[k] - rig.rest, part.vertices, 1)}};
        if (!isLast) frame["tweenEasing"] = 0;  // linear
        frames.push_back(frame);
    }
    return {{"name", part.name}, {"slot", part.name}, {"skin", ""}, {"frame", frames}};
}

/// Returns keys of the order, each of which holds until the next.
Json dragonBonesOrder(const Rig& rig) {
    std::vector<std::size_t> keys = changesOfOrder(rig);
    keys.insert(keys.begin(), 0);
    Json frames = Json::array();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::size_t end = i + 1 < keys.size() ? keys[i + 1] : rig.poses.size() - 1;
        Json offsets = Json::array();
        for (const auto& [part, by] : offsetsOf(rig.orders[keys[i]])) {
            offsets.push_back(part);
            offsets.push_back(by);
        }
        frames.push_back({{"duration", end - keys[i]}, {"zOrder", offsets}});
    }
    return {{"frame", frames}};
}

Json dragonBonesSkeleton(const Rig& rig, const std::string& name) {
    const double rate = rig.framesPerSecond;
    Json slots = Json::array(), meshes = Json::array(), keys = Json::array();
    for (const RigPart& part : rig.parts) {
        Json slot = {{"name", part.name}, {"parent", "root"}};
        if (part.blend != BlendMode::Normal) slot["blendMode"] = blendWord(part.blend);
        slots.push_back(slot);
        const Json mesh = {{"type", "mesh"},
                           {"name", part.name},
                           {"path", name},
                           {"width", rig.texture->width},
                           {"height", rig.texture->height},
                           {"vertices", flat(rig.rest, part.vertices, 1)},
                           {"uvs", texturePointsOf(rig, part)},
                           {"triangles", trianglesOf(part)},
                           {"edges", hullEdges(part, 1)},
                           {"userEdges", Json::array()}};
        meshes.push_back({{"name", part.name}, {"display", Json::array({mesh})}});
        keys.push_back(dragonBonesKeys(rig, part));
    }
    Json animation = {
        {"name", "deformation"}, {"duration", rig.poses.size() - 1}, {"playTimes", 0}, {"ffd", keys}};
    if (!changesOfOrder(rig).empty()) animation["zOrder"] = dragonBonesOrder(rig);
    const Json armature = {{"type", "Armature"},
                           {"name", name},
                           {"frameRate", rate},
                           {"aabb", {{"x", 0}, {"y", 0}, {"width", rig.width}, {"height", rig.height}}},
                           {"bone", Json::array({{{"name", "root"}}})},
                           {"slot", slots},
                           {"skin", Json::array({{{"name", ""}, {"slot", meshes}}})},
                           {"animation", Json::array({animation})},
                           {"defaultActions", Json::array({{{"gotoAndPlay", "deformation"}}})}};
    return {{"name", name},
            {"version", "5.5"},
            {"compatibleVersion", "5.5"},
            {"frameRate", rate},
            {"armature", Json::array({armature})}};
}

void writeDragonBones(const std::string& path, const Rig& rig, OutputSet& files) {
    const std::string name = stemOf(path);
    const int width = rig.texture->width, height = rig.texture->height;
    const Json region = {{"name", name}, {"x", 0}, {"y", 0}, {"width", width}, {"height", height}};
    const Json atlas = {{"name", name},
                        {"imagePath", name + "_tex.png"},
                        {"width", width},
                        {"height", height},
                        {"SubTexture", Json::array({region})}};
    files.add(path, ".json",
              [&](const std::string& file) { writeTextFile(file, dragonBonesSkeleton(rig, name).dump()); });
    files.add(beside(path, "_tex.json"), "",
              [&](const std::string& file) { writeTextFile(file, atlas.dump()); });
    files.add(beside(path, "_tex.png"), "", [&](const std::string& file) { writeTexture(file, rig); });
}

// ---- glTF 2.0 ----

constexpr double kPixelsPerUnit = 1000;

/// Returns vertices part by part in space, for an order of the parts.
Points3 layered(const Rig& rig, const Points2& pose, const std::vector<int>& order) {
    const double step = std::max(rig.width, rig.height) / 1000.0;
    std::vector<double> heights(rig.parts.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        heights[static_cast<std::size_t>(order[k])] = step * static_cast<double>(k);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < rig.parts.size(); ++i)
        for (const int v : rig.parts[i].vertices)
            points.emplace_back(pose(0, v), rig.height - pose(1, v), heights[i]);
    Points3 all(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = points[i];
    return all / kPixelsPerUnit;
}

GltfScene sceneOf(const Rig& rig, const std::string& texture) {
    GltfScene scene;
    scene.isUnlit = true;
    scene.points = layered(rig, rig.rest, rig.orders.front());
    scene.uv.resize(2, scene.points.cols());
    int first = 0;
    for (const RigPart& part : rig.parts) {
        for (std::size_t k = 0; k < part.vertices.size(); ++k) {
            const Vec2 at = rig.texturePoints.col(part.vertices[k]);
            scene.uv.col(first + static_cast<Eigen::Index>(k)) =
                Vec2(at.x() / rig.texture->width, 1 - at.y() / rig.texture->height);
        }
        for (const Cell<2>& t : part.triangles) {  // reflected by y up
            scene.triangles.push_back({first + t[0], first + t[2], first + t[1]});
            scene.materialOf.push_back(static_cast<int>(scene.materials.size()));
        }
        scene.materials.push_back({part.name, {0.8F, 0.8F, 0.8F, 1}, texture});
        first += static_cast<int>(part.vertices.size());
    }
    for (std::size_t k = 0; k < rig.poses.size(); ++k) {
        scene.times.push_back(static_cast<double>(k) / rig.framesPerSecond);
        scene.poses.push_back(layered(rig, rig.poses[k], rig.orders[k]));
    }
    return scene;
}

void writeGltfRig(const std::string& path, const Rig& rig, OutputSet& files) {
    TemporaryFolder folder(scratchFolder());
    const std::string texture = folder.newName(".png");
    writeTexture(texture, rig);
    const GltfScene scene = sceneOf(rig, texture);
    files.add(path, ".glb", [&](const std::string& file) { writeGltf(file, scene, false); });
}

}  // namespace

bool isRigFile(const std::string& path) {
    const std::string extension = lowerExtension(path);
    return (extension == ".glb" || extension == ".json") && path.find('#') == std::string::npos;
}

std::vector<std::string> filesBesideRig(const std::string& path) {
    if (lowerExtension(path) != ".json") return {};
    if (path.ends_with(kDragonBones)) return {beside(path, "_tex.json"), beside(path, "_tex.png")};
    return {beside(path, ".atlas"), beside(path, "-atlas.png")};
}

void writeRig(const std::string& path, const Rig& rig, OutputSet& files) {
    if (lowerExtension(path) == ".glb") return writeGltfRig(path, rig, files);
    if (path.ends_with(kDragonBones)) return writeDragonBones(path, rig, files);
    writeSpine(path, rig, files);
}

std::string lostInRig(const std::string& path, const Rig& rig) {
    const bool isBlended =
        std::ranges::any_of(rig.parts, [](const RigPart& part) { return part.blend != BlendMode::Normal; });
    if (lowerExtension(path) == ".glb" && isBlended) return "the format holds no blend modes of parts";
    if (!path.ends_with(kDragonBones)) return {};
    std::size_t begin = 0, last = 0;
    for (const RigPart& part : rig.parts) {
        begin += std::exchange(last, 2 * part.vertices.size() * rig.poses.size());
    }
    if (begin < kDragonBonesOffsets) return {};
    return "players of DragonBones read the keys of all parts but the last only up to " +
           std::to_string(kDragonBonesOffsets) + " numbers, and these are " + std::to_string(begin) +
           ": take fewer vertices or frames";
}

}  // namespace wend
