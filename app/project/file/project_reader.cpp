#include <Eigen/Geometry>
#include <algorithm>

#include "app/project/file/design_reader.h"
#include "app/project/file/json_text.h"
#include "app/project/file/motion_files.h"
#include "app/project/file/named_files.h"
#include "app/project/file/named_places.h"
#include "app/project/file/part_json.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/setting_json.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

void checkFormat(JsonObject& root) {
    if (!root.has("format"))
        root.failWithout({"format"}, "is not a Wend project: the key `format` is missing");
    const std::string format = root.require("format").text();
    if (format != "wend") root.value().fail("is not a Wend project: its format is \"" + format + "\"");
    const JsonValue version = root.require("version");
    const int number = version.integer();
    if (number < 1) version.fail("there is no version " + std::to_string(number));
    if (number > kVersion)
        version.fail("the project is of version " + std::to_string(number) +
                     ", but this program reads versions up to " + std::to_string(kVersion) +
                     ": a newer Wend is needed");
}

// --- Domain ---

std::string readFileName(const JsonValue& value) {
    const std::string name = value.text();
    if (name.empty()) value.fail("names no file");
    return name;
}

void readImageDomain(JsonObject& object, Project& project) {
    Domain& domain = project.domain;
    domain.kind = DomainKind::Image;
    if (auto parts = object.find("parts"))
        readParts(*parts, domain);
    else
        domain.path = readFileName(object.require("image"));
    if (auto size = object.find("size")) {
        const std::vector<JsonValue> sides = size->elements();
        if (sides.size() != 2) size->fail("must be the picture's [width, height] in pixels");
        domain.size = {sides[0].integer(), sides[1].integer()};
        if (std::ranges::min(domain.size) < 1) size->fail("must be positive");
    }
    if (auto outline = object.find("outline")) readOutline(*outline, project);
    if (object.has("vertices") && object.has("edge")) object.value().fail("has both `vertices` and `edge`");
    if (auto sizes = object.find("sizes"))
        for (const JsonValue& element : sizes->elements()) readSize(element, domain.sizes);
}

/// {"values": FILE} must come first, then regions.
void readSizeField(const JsonValue& value, Domain& domain) {
    for (const JsonValue& element : value.elements()) {
        if (!element.json().is_object() || !element.json().contains("values")) {
            readSize(element.ofDimension(3), domain.sizes);
            continue;
        }
        JsonObject object(element);
        if (!domain.sizesFile.empty() || !domain.sizes.empty())
            element.fail("`values` may stand once only, as the first entry");
        domain.sizesFile = readFileName(object.require("values"));
        object.finish();
    }
}

/// Reads {"fill": [a, b]}, {"drop": [t, …]} or {"turn": [t, …]}.
SurfaceFix readFix(const JsonValue& value) {
    JsonObject object(value);
    const std::string kind = object.oneOf(kFixWords);
    SurfaceFix fix{static_cast<SurfaceFix::Kind>(std::ranges::find(kFixWords, kind) - kFixWords.begin()), {}};
    const JsonValue ids = object.require(kind);
    for (const JsonValue& id : ids.elements()) {
        fix.ids.push_back(id.integer());
        if (fix.ids.back() < 0) id.fail("must not be negative");
    }
    if (fix.kind == SurfaceFix::Kind::Fill && fix.ids.size() != 2)
        ids.fail("must be the two vertices of an edge");
    object.finish();
    return fix;
}

void readRepair(const JsonValue& value, Project& project) {
    if (!value.json().is_object()) {
        project.domain.repair = value.boolean();
        return;
    }
    project.domain.repair = true;
    JsonObject object(value);
    readSettings(object, "domain.repair", project);
    object.finish();
}

/// Reads the cage; `false` means the exact surface or none.
void readCage(const JsonValue& value, Project& project) {
    project.domain.fit = Fit::Cage;
    if (!value.json().is_object()) {
        if (!value.boolean()) project.domain.fit = Fit::Exact;
        return;
    }
    JsonObject object(value);
    readSettings(object, "domain.cage", project);
    object.finish();
}

void readSurfaceDomain(JsonObject& object, Project& project) {
    project.domain.kind = DomainKind::Surface;
    project.domain.path = readFileName(object.require("surface"));
    if (auto fixes = object.find("fixes"))
        for (const JsonValue& element : fixes->elements()) project.domain.fixes.push_back(readFix(element));
    if (auto repair = object.find("repair")) readRepair(*repair, project);
    if (auto cage = object.find("cage")) readCage(*cage, project);
    if (auto sizes = object.find("sizes")) readSizeField(*sizes, project.domain);
}

void readDomain(const JsonValue& value, Project& project) {
    Domain& domain = project.domain;
    JsonObject object(value);
    const bool textured = object.has("mesh") && object.has("image");
    const std::string kind = textured ? "mesh" : object.oneOf({"image", "parts", "mesh", "surface"});
    if (textured && object.has("surface")) object.oneOf({"mesh", "surface"});
    if (kind == "image" || kind == "parts") readImageDomain(object, project);
    if (kind == "surface") readSurfaceDomain(object, project);
    if (kind == "mesh") {
        domain.kind = DomainKind::Mesh;
        domain.path = readFileName(object.require("mesh"));
        if (auto texture = object.find("image")) domain.texture = readFileName(*texture);
    } else if (auto vertices = object.find("vertices")) {
        domain.vertices = vertices->integer("domain.vertices");
    }
    if (domain.kind != DomainKind::Image)
        if (auto detail = object.find("detail")) domain.detail = readFileName(*detail);
    readSettings(object, "domain", project);
    object.finish();
}

// --- Dimension ---

/// Returns the length of the first coordinates in the design, or 0.
int coordinateCount(const Json& json) {
    static const std::vector<std::string> notCoordinates{"time", "times", "active", "vertices", "phi", "B"};
    if (json.is_array() && !json.empty() && json.front().is_number())
        return json.size() == 2 || json.size() == 3 ? static_cast<int>(json.size()) : 0;
    if (!json.is_structured()) return 0;
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (json.is_object() && std::ranges::count(notCoordinates, it.key()) > 0) continue;
        if (const int count = coordinateCount(*it)) return count;
    }
    return 0;
}

int guessDimension(const Json& root) {
    for (const char* key : {"handles", "material"})
        if (root.contains(key))
            if (const int count = coordinateCount(root[key])) return count;
    return 2;
}

int meshDimension(const std::string& file, const Json& root) {
    const std::string extension = lowerExtension(file);
    // these cannot hold tetrahedra and need not be read twice
    for (const char* planar : {".obj", ".off", ".stl"})
        if (extension == planar) return 2;
    try {
        return dimensionOfMesh(file);
    } catch (const InputError&) {
        return guessDimension(root);
    }
}

int dimensionOf(const Domain& domain, const std::string& folder, const Json& root) {
    if (domain.kind == DomainKind::Image) return 2;
    if (domain.kind == DomainKind::Surface) return 3;
    return meshDimension(pathIn(folder, domain.path), root);
}

// --- The rest ---

/// Reads an object of settings only.
void readGroup(JsonObject& root, const std::string& group, Project& project) {
    if (const auto value = root.find(group)) {
        JsonObject object(*value);
        readSettings(object, group, project);
        object.finish();
    }
}

std::array<double, 2> readCycle(const JsonValue& value) {
    const std::vector<double> times = value.numbers();
    if (times.size() != 2) value.fail("must be two times, [from, to]");
    if (times[0] < 0 || times[0] >= times[1])
        value.fail("must be two times from 0 on, the first before the second");
    return {times[0], times[1]};
}

std::vector<TimeMarker> readMarkers(const JsonValue& value) {
    std::vector<TimeMarker> markers;
    for (const JsonValue& element : value.elements()) {
        TimeMarker& marker = markers.emplace_back();
        JsonObject object(element.ownedBy(marker.extras));
        marker.at = object.require("at").number("time.markers[].at");
        if (auto name = object.find("name")) marker.name = name->text();
        object.finish();
    }
    std::ranges::stable_sort(markers, {}, &TimeMarker::at);
    return markers;
}

void readTime(const JsonValue& value, Project& project) {
    JsonObject object(value);
    readSettings(object, "time", project);
    if (auto cycle = object.find("cycle")) project.cycle = readCycle(*cycle);
    if (auto markers = object.find("markers")) project.markers = readMarkers(*markers);
    if (auto audio = object.find("audio")) project.audio = audio->text();
    object.finish();
}

void readDesign(JsonObject& root, Project& project) {
    Design& design = project.design;
    if (auto material = root.find("material")) readMaterial(*material, project);
    if (auto handles = root.find("handles"))
        for (const JsonValue& element : handles->elements())
            design.handles.push_back(readHandle(element, project.end));
}

/// Reads the windows of settling, which extend the end of time where necessary.
void readSettling(const JsonValue& value, Project& project) {
    for (const JsonValue& element : value.elements()) {
        JsonObject object(element);
        const std::vector<double> times = object.require("time").numbers();
        if (times.size() != 2) element.fail("`time` must be two times, [from, to]");
        object.finish();
        appendSettling(project, times[0], times[1] - times[0]);
        project.settle.back().end = times[1];
    }
    if (const std::string problem = problemOf(project.settle); !problem.empty()) value.fail(problem);
}

SavedCamera readCamera(const JsonValue& value) {
    SavedCamera camera;
    JsonObject object(value);
    camera.position = object.require("position").point();
    camera.target = object.require("target").point();
    camera.up = object.require("up").point();
    if (auto pivot = object.find("pivot")) camera.pivot = pivot->point();
    if (auto parallel = object.find("parallel")) camera.parallel = parallel->boolean();
    object.finish();
    const Vec3 way = camera.target - camera.position;
    if (way.norm() == 0) value.fail("`position` and `target` are one point");
    if (way.cross(camera.up).norm() <= 1e-9 * way.norm() * camera.up.norm())
        value.fail("`up` gives no direction across the view");
    return camera;
}

void readView(const JsonValue& value, Project& project) {
    JsonObject object(value.ownedBy(project.view.extras));
    readSettings(object, "view", project);
    if (auto camera = object.find("camera")) project.view.camera = readCamera(*camera);
    object.finish();
}

LoadedProject readRoot(const Json& json, const std::string& folder) {
    LoadedProject loaded{newProject(), {}};
    Project& project = *loaded.project;
    JsonObject root(JsonValue(json, "", project.extras, loaded.warnings));
    checkFormat(root);
    readDomain(root.require("domain"), project);
    if (auto time = root.find("time")) readTime(*time, project);
    readGroup(root, "integration", project);
    project.design.dimension = dimensionOf(project.domain, folder, json);
    root.setDimension(project.dimension());
    readDesign(root, project);
    findNamedPlaces(project, folder);
    readHandleFiles(project, folder);
    project.endIsGiven = root.has("time") && root.value().json()["time"].contains("end");
    if (!project.endIsGiven) project.end = endOfMotions(project);
    if (project.dimension() == 2)
        if (auto depth = root.find("depth"))
            for (const JsonValue& element : depth->elements()) readDepth(element, project.depth);
    if (project.dimension() == 3)
        if (auto view = root.find("view")) readView(*view, project);
    if (auto settle = root.find("settle")) readSettling(*settle, project);
    root.finish();
    return loaded;
}

}  // namespace

LoadedProject parseProject(const std::string& text, const std::string& path) try {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos &&
        std::string_view("{[\"\xef").find(text[first]) == std::string_view::npos)
        throw InputError(path, sentence("Core", "is no project of Wend, which is JSON and begins with {"));
    return readRoot(parseJson(text, path), folderOf(path));
} catch (const InputError& error) {
    throw error.named(path);
}

LoadedProject readProject(const std::string& path) {
    return parseProject(readTextFile(path), path);
}

}  // namespace wend
