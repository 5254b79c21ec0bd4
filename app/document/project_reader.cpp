#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <map>
#include <sstream>

#include "app/document/design_reader.h"
#include "app/document/json_text.h"
#include "app/document/project.h"
#include "app/document/text_file.h"
#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/mesh_file.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

void checkFormat(JsonObject& root) {
    if (!root.has("format")) root.value().fail("is not a Wend project: the key `format` is missing");
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

void readPolygons(const JsonValue& value, Domain& domain) {
    domain.outline = OutlineKind::Polygons;
    for (const JsonValue& loop : value.elements()) {
        domain.polygons.loops.push_back(loop.points<2>());
        if (domain.polygons.loops.back().size() < 3) loop.fail("needs at least 3 points");
    }
    if (domain.polygons.loops.empty()) value.fail("has no polygon");
}

void readAlpha(JsonObject& object, AlphaOutlineOptions& alpha) {
    if (auto value = object.find("threshold")) alpha.threshold = value->number("domain.outline.threshold");
    if (auto value = object.find("margin")) alpha.margin = value->number("domain.outline.margin");
    if (auto value = object.find("gap")) alpha.gap = value->number("domain.outline.gap");
    if (auto value = object.find("smallest")) alpha.smallest = value->number("domain.outline.smallest");
    if (auto value = object.find("simplify")) alpha.simplify = value->number("domain.outline.simplify");
}

void readOutline(const JsonValue& value, Domain& domain) {
    JsonObject object(value);
    if (object.oneOf({"from", "polygons"}) == "polygons") {
        readPolygons(object.require("polygons"), domain);
    } else if (object.require("from").choice("domain.outline.from") == "alpha") {
        domain.outline = OutlineKind::Alpha;
        readAlpha(object, domain.alpha);
    }
    object.finish();
}

std::string readFileName(const JsonValue& value) {
    const std::string name = value.text();
    if (name.empty()) value.fail("names no file");
    return name;
}

template <int Dim>
SizeRegionIn<Dim> readSizeRegion(const JsonValue& owner) {
    SizeRegionIn<Dim> region;
    JsonObject object(owner.ownedBy(region.extras));
    if (auto name = object.find("name")) region.name = name->text();
    region.shape = readRegion<Dim>(object.require("shape"));
    if (auto feather = object.find("feather")) region.feather = feather->number("material.regions[].feather");
    region.factor = object.require("factor").number("domain.sizes[].factor");
    object.finish();
    return region;
}

void readImageDomain(JsonObject& object, Domain& domain) {
    domain.kind = DomainKind::Image;
    domain.path = readFileName(object.require("image"));
    if (auto outline = object.find("outline")) readOutline(*outline, domain);
    if (object.has("vertices") && object.has("edge")) object.value().fail("has both `vertices` and `edge`");
    if (auto vertices = object.find("vertices")) domain.vertices = vertices->integer("domain.vertices");
    if (auto edge = object.find("edge")) domain.edge = edge->number("domain.edge");
    static const std::map<std::string, Border> borders{
        {"free", Border::Free}, {"fixed", Border::Fixed}, {"slide", Border::Slide}};
    if (auto sizes = object.find("sizes"))
        for (const JsonValue& element : sizes->elements())
            domain.flatSizes.push_back(readSizeRegion<2>(element));
    if (auto border = object.find("border")) domain.border = borders.at(border->choice("domain.border"));
}

/// {"values": FILE} stands first; then regions.
void readSizeField(const JsonValue& value, Domain& domain) {
    for (const JsonValue& element : value.elements()) {
        if (!element.json().is_object() || !element.json().contains("values")) {
            domain.sizes.push_back(readSizeRegion<3>(element));
            continue;
        }
        JsonObject object(element);
        if (!domain.sizesFile.empty() || !domain.sizes.empty())
            element.fail("`values` may stand once only, as the first entry");
        domain.sizesFile = readFileName(object.require("values"));
        object.finish();
    }
}

void readRepair(const JsonValue& value, Domain& domain) {
    if (!value.json().is_object()) {
        domain.repair = value.boolean();
        return;
    }
    domain.repair = true;
    JsonObject object(value);
    if (auto hole = object.find("largestHole"))
        domain.largestHole = hole->integer("domain.repair.largestHole");
    object.finish();
}

/// false: the exact surface or none.
void readCage(const JsonValue& value, Domain& domain) {
    domain.fit = Fit::Cage;
    if (!value.json().is_object()) {
        if (!value.boolean()) domain.fit = Fit::Exact;
        return;
    }
    JsonObject object(value);
    if (auto detail = object.find("detail")) domain.cageDetail = detail->number("domain.cage.detail");
    if (auto offset = object.find("offset")) domain.cageOffset = offset->number("domain.cage.offset");
    object.finish();
}

void readSurfaceDomain(JsonObject& object, Domain& domain) {
    domain.kind = DomainKind::Surface;
    domain.path = readFileName(object.require("surface"));
    if (auto refine = object.find("refineSurface")) domain.refineSurface = refine->boolean();
    if (auto repair = object.find("repair")) readRepair(*repair, domain);
    if (auto cage = object.find("cage")) readCage(*cage, domain);
    if (auto sizes = object.find("sizes")) readSizeField(*sizes, domain);
    if (auto quality = object.find("quality")) domain.quality = quality->number("domain.quality");
    if (auto volume = object.find("maxVolume")) domain.maxVolume = volume->number("domain.maxVolume");
    if (auto vertices = object.find("vertices")) domain.vertices = vertices->integer("domain.vertices");
}

Domain readDomain(const JsonValue& value) {
    Domain domain;
    JsonObject object(value);
    const bool textured = object.has("mesh") && object.has("image");
    const std::string kind = textured ? "mesh" : object.oneOf({"image", "mesh", "surface"});
    if (textured && object.has("surface")) object.oneOf({"mesh", "surface"});
    if (kind == "image") readImageDomain(object, domain);
    if (kind == "surface") readSurfaceDomain(object, domain);
    if (kind == "mesh") {
        domain.kind = DomainKind::Mesh;
        domain.path = readFileName(object.require("mesh"));
        if (auto texture = object.find("image")) domain.texture = readFileName(*texture);
    }
    if (kind != "image")
        if (auto detail = object.find("detail")) domain.detail = readFileName(*detail);
    object.finish();
    return domain;
}

// --- Dimension ---

/// The length of the first coordinates that stand in the design, or 0.
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
    for (const char* planar : {".obj", ".off", ".stl"})  // can hold no tetrahedra: not worth reading twice
        if (extension == planar) return 2;
    try {
        return isVolume(readMeshFile(file)) ? 3 : 2;
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

void readIntegration(const JsonValue& value, IntegrationOptions& options) {
    static const std::map<std::string, Method> methods{{"dopri5", Method::DormandPrince},
                                                       {"rk4", Method::RungeKutta4},
                                                       {"midpoint", Method::Midpoint},
                                                       {"adams", Method::Adams}};
    JsonObject object(value);
    if (auto method = object.find("method"))
        options.method = methods.at(method->choice("integration.method"));
    if (auto tolerance = object.find("tolerance"))
        options.tolerance = tolerance->number("integration.tolerance");
    if (auto steps = object.find("steps")) options.steps = steps->integer("integration.steps");
    if (auto least = object.find("smallestStep"))
        options.smallestStep = least->number("integration.smallestStep");
    object.finish();
}

template <int Dim>
Design<Dim> readDesign(JsonObject& root, double end) {
    Design<Dim> design;
    if (auto material = root.find("material")) design.material = readMaterial<Dim>(*material);
    if (auto handles = root.find("handles"))
        for (const JsonValue& element : handles->elements())
            design.handles.push_back(readHandle<Dim>(element, end));
    return design;
}

void readTime(const JsonValue& value, Project& project) {
    JsonObject time(value);
    if (auto end = time.find("end")) project.end = end->number("time.end");
    time.finish();
}

/// The end of time covers them.
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

LoadedProject readRoot(const Json& json, const std::string& folder) {
    LoadedProject loaded;
    Project& project = loaded.project;
    JsonObject root(JsonValue(json, "", project.extras, loaded.warnings));
    checkFormat(root);
    project.domain = readDomain(root.require("domain"));
    if (auto time = root.find("time")) readTime(*time, project);
    if (auto integration = root.find("integration")) readIntegration(*integration, project.integration);
    if (dimensionOf(project.domain, folder, json) == 2)
        project.design = readDesign<2>(root, project.end);
    else
        project.design = readDesign<3>(root, project.end);
    if (project.dimension() == 2)
        if (auto depth = root.find("depth")) project.depth = readDepth(*depth);
    if (auto settle = root.find("settle")) readSettling(*settle, project);
    root.finish();
    return loaded;
}

}  // namespace

std::string folderOf(const std::string& path) {
    return std::filesystem::path(path).parent_path().string();
}

std::string pathIn(const std::string& folder, const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
}

LoadedProject parseProject(const std::string& text, const std::string& path) try {
    return readRoot(parseJson(text, path), folderOf(path));
} catch (const InputError& error) {
    throw error.named(path);
}

LoadedProject readProject(const std::string& path) {
    return parseProject(readTextFile(path), path);
}

template <int Dim>
void readCells(const std::string& path, MaterialSpec<Dim>& spec) try {
    const Json json = parseJson(readTextFile(path), path);
    Extras extras;
    std::vector<std::string> warnings;
    JsonObject object(JsonValue(json, "", extras, warnings));
    readCellValues<Dim>(object, spec);
} catch (const InputError& error) {
    throw error.named(path);
}

std::vector<double> readSizes(const std::string& path, int count) try {
    std::istringstream text(readTextFile(path));
    std::vector<double> sizes;
    for (std::string word; text >> word;) {
        double size = 0;
        const auto done = std::from_chars(word.data(), word.data() + word.size(), size);
        const std::string place = "value " + std::to_string(sizes.size()) + ": ";
        if (done.ec != std::errc() || done.ptr != word.data() + word.size())
            throw InputError(place + "\"" + word.substr(0, 20) + "\" is not a number");
        if (const auto problem = rangeProblem(option("domain.sizes[].factor"), size); !problem.empty())
            throw InputError(place + problem);
        sizes.push_back(size);
    }
    if (static_cast<int>(sizes.size()) != count)
        throw InputError("has " + std::to_string(sizes.size()) + " values, but the surface has " +
                         std::to_string(count) + " vertices");
    return sizes;
} catch (const InputError& error) {
    throw error.named(path);
}

Outline readOutlineFile(const std::string& path) try {
    const Json json = parseJson(readTextFile(path), path);
    Domain domain;
    std::vector<std::string> warnings;
    Extras extras;
    JsonObject object(JsonValue(json, "", extras, warnings));
    readPolygons(object.require("polygons"), domain);
    return domain.polygons;
} catch (const InputError& error) {
    throw error.named(path);
}

template void readCells<2>(const std::string&, MaterialSpec<2>&);
template void readCells<3>(const std::string&, MaterialSpec<3>&);

}  // namespace wend
