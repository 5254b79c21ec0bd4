#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "app/engine/shape/inspection.h"
#include "app/engine/shape/stated_units.h"
#include "app/output/output_set.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/json_text.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/input_file.h"
#include "core/base/printable.h"
#include "core/base/same_file.h"
#include "core/mesh/file_cells.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/segments.h"
#include "warp/outline.h"
#include "warp/picture_format.h"
#include "warp/picture_metadata.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kListed = 20;  // numbers shown of a problem's cells in text; JSON has them all

// --- Information as JSON ---

Json outlineInfo(const Image& image) try {
    const Outline outline = outlineFromAlpha(image);
    Json parts = Json::array();
    for (const auto& loop : outline.loops)
        parts.push_back({{"corners", loop.size()}, {"area", std::abs(loopArea(loop))}});
    return {{"loops", outline.loops.size()}, {"each", parts}};
} catch (const InputError& error) {
    return {{"problem", error.reason()}};
}

/// Lists the layers of the picture, from front to back, as far as they are known.
Json layersInfo(const std::vector<PictureLayer>& layers) {
    Json list = Json::array();
    for (const PictureLayer& layer : layers) {
        Json one{{"name", printable(layer.name)}, {"x", layer.x}, {"y", layer.y}};
        if (layer.width > 0) one["width"] = layer.width, one["height"] = layer.height;
        if (!layer.blend.empty()) {
            one["opacity"] = layer.opacity;
            one["blend"] = layer.blend;
            one["visible"] = layer.visible;
            if (layer.clipped) one["clipped"] = true;
            if (!layer.unread.empty()) one["unread"] = layer.unread;
            if (!layer.leftOut.empty()) one["leftOut"] = layer.leftOut;
        }
        list.push_back(one);
    }
    return list;
}

/// Adds what the file has and the picture does not.
void addFileInfo(const std::string& path, const Image& image, Json& json) {
    const Image::Metadata& metadata = *image.metadata;
    if (const PixelBox& box = metadata.stored; box.width > 0)
        json["dataWindow"] = {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}};
    json["colourProfile"] = !metadata.iccProfile.empty();
    if (!metadata.leftOut.empty()) json["channelsLeftOut"] = metadata.leftOut;
    if (!metadata.pictures.empty()) json["pictures"] = metadata.pictures;
    std::vector<PictureLayer> layers = fileMetadata(image)->layers;
    const PictureFormat format = layers.empty() ? PictureFormat::Png : pictureFormat(InputFile(path));
    if (format == PictureFormat::Psd || format == PictureFormat::Tiff) std::ranges::reverse(layers);
    if (!layers.empty()) json["layers"] = layersInfo(layers);
}

Json pictureInfo(const std::string& path) {
    static const char* const types[] = {"8 bit", "16 bit", "half float", "float"};
    std::vector<Message> notices;
    const Image image = readImage(path, kMaxMegapixels, &notices);
    Json json{{"kind", "picture"},
              {"width", image.width},
              {"height", image.height},
              {"channels", image.channels},
              {"depth", types[static_cast<int>(image.type)]},
              {"alpha", image.alpha}};
    addFileInfo(path, image, json);
    if (image.alpha) json["outline"] = outlineInfo(image);
    if (!notices.empty()) json["notices"] = textsOf(notices);
    return json;
}

Json problemsInfo(const MeshInspection& inspection) {
    Json problems = Json::array();
    for (const MeshProblem& problem : inspection.problems) {
        Json one{{"what", problem.what}, {"count", problem.count()}, {"fatal", problem.fatal}};
        if (problem.count() == 0) one.erase("count");
        if (!problem.where.empty()) one["where"] = problem.where;
        if (!problem.pairs.empty()) one["where"] = problem.pairs;
        problems.push_back(one);
    }
    return problems;
}

Json fieldsInfo(const MeshFile& file) {
    Json fields = Json::array();
    for (const MeshField& field : fieldsOf(file))
        fields.push_back({{"name", field.name},
                          {"per", field.perCell ? "cell" : "vertex"},
                          {"components", field.components}});
    return fields;
}

Json groupsInfo(const MeshFile& file) {
    static const char* const kinds[] = {"vertices", "lines", "surface cells", "volume cells"};
    Json groups = Json::array();
    for (const GroupFacts& group : groupFacts(file)) {
        Json one{{"name", group.name},
                 {"number", group.tag},
                 {"of", kinds[group.dimension]},
                 {"count", group.count}};
        if (group.name.empty()) one.erase("name");
        if (group.tag == 0) one.erase("number");
        groups.push_back(one);
    }
    return groups;
}

/// Counts in steps from a value on; text shows them as bars.
template <std::size_t N>
Json histogram(double from, double step, const std::array<int, N>& counts, bool doubling = false) {
    return {{"from", from}, {doubling ? "factor" : "step", step}, {"counts", counts}};
}

/// Angles in degrees: between edges in the plane, between faces in space.
Json qualityInfo(const QualitySummary& quality) {
    const double degrees = 180 / std::numbers::pi;
    return {{"leastAngle", quality.minAngle * degrees},
            {"meanOfLeastAngles", quality.meanMinAngle * degrees},
            {"greatestRadiusEdgeRatio",
             std::isfinite(quality.maxRadiusEdgeRatio) ? Json(quality.maxRadiusEdgeRatio) : Json()},
            {"smallestCell", quality.minMeasure},
            {"largestCell", quality.maxMeasure},
            {"worstCell", quality.worstCell},
            {"leastAngles", histogram(0, 5, quality.angleHistogram)},
            {"greatestAngle", quality.maxAngle * degrees},
            {"angles", histogram(0, 5, quality.allAngles)},
            {"radiusEdgeRatios", histogram(0.5, 0.25, quality.ratios)},
            {"cellSizesToTheMean", histogram(std::ldexp(1.0, -8), 2, quality.measures, true)}};
}

void saveSuspects(const MeshFile& file, const MeshInspection& inspection, const std::string& path) {
    if (path.empty()) return;
    if (inspection.suspects.empty()) return Terminal::error(path + " was not written: there are no problems");
    OutputSet files;
    files.add(path, ".vtu", [&](const std::string& name) { writeSuspects(name, file, inspection); });
    files.commit();
}

Json vectorOf(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

/// Adds the known facts of this surface.
void addFacts(const SurfaceFacts& facts, Json& json) {
    json["box"] = {{"low", vectorOf(facts.low)},
                   {"high", vectorOf(facts.high)},
                   {"size", vectorOf(facts.high - facts.low)}};
    json["area"] = facts.area;
    if (facts.sides > 0) json["sides"] = facts.sides;
    if (facts.genus) json["genus"] = *facts.genus;
    if (facts.deepest > 1) json["shellsDeep"] = facts.deepest;
    json["boundaryLoops"] = facts.boundaryLoops;
    json["edges"] = {{"count", facts.edges},
                     {"shortest", facts.shortestEdge},
                     {"mean", facts.meanEdge},
                     {"longest", facts.longestEdge}};
}

/// Returns how `wend mesh` fills the surface: itself, or by a cage around it.
std::string fitOf(const MeshInspection& inspection) {
    const bool exact = std::ranges::none_of(inspection.problems, &MeshProblem::fatal);
    return exact ? "exact surface" : "cage";
}

Json meshInfo(const std::string& path, const std::string& problemsFile) {
    const auto file = sharedMeshFile(path);
    const MeshInspection inspection = inspect(*file);
    saveSuspects(*file, inspection, problemsFile);
    const int dimension = inspection.dimension;
    Json json{{"kind", dimension == 3   ? "volume mesh"
                       : dimension == 2 ? "planar mesh"
                                        : "surface"},
              {"vertices", inspection.vertices}};
    if (dimension > 0) json["cells"] = inspection.cells;
    for (const auto& [kind, count] : cellCounts(*file)) json["fileCells"][kind] = count;
    if (dimension != 2) json["triangles"] = inspection.triangles;
    json["parts"] = inspection.parts;
    json["diagonal"] = inspection.diagonal;
    if (const std::string units = statedUnits(path); !units.empty()) json["units"] = units;
    if (inspection.facts) addFacts(*inspection.facts, json);
    if (dimension > 0) {
        json[dimension == 2 ? "area" : "volume"] = inspection.quality.totalMeasure;
        json["quality"] = qualityInfo(inspection.quality);
    }
    if (inspection.volume > 0) json["volume"] = inspection.volume;
    if (dimension == 0 && inspection.facts) json["fit"] = fitOf(inspection);
    if (inspection.intersectingPairs) json["intersectingPairs"] = *inspection.intersectingPairs;
    json["uv"] = uvOf(*file).cols() > 0;
    if (!fieldsOf(*file).empty()) json["fields"] = fieldsInfo(*file);
    if (!groupFacts(*file).empty()) json["groups"] = groupsInfo(*file);
    json["problems"] = problemsInfo(inspection);
    return json;
}

Json handlesInfo(const Design& design) {
    static const char* const places[] = {"vertices", "points", "region"};
    static const char* const kinds[] = {"translate", "rotate", "curve", "recorded", "field", "poses"};
    Json handles = Json::array();
    for (const Pin& handle : design.handles) {
        Json motions = Json::array();
        for (const PinMotion& motion : handle.motions) motions.push_back(kinds[motion.kind.index()]);
        handles.push_back({{"name", handle.name}, {"at", places[handle.at.index()]}, {"motion", motions}});
    }
    return handles;
}

void addDesign(Json& json, const Design& design) {
    const std::string name = nameOfPhi(design.material.phi, design.dimension);
    json["phi"] = name.empty() ? Json(design.material.phi) : Json(name);
    json["regions"] = std::ranges::distance(regionsOf(design.material.layers));
    json["handles"] = handlesInfo(design);
}

/// Lists the parts of a picture, from front to back.
Json partsInfo(const Domain& domain) {
    Json list = Json::array();
    for (const PicturePart& part : domain.parts) {
        Json json{{"name", part.name}};
        if (!part.path.empty()) json["file"] = part.path;
        if (!part.layer.empty()) json["layer"] = part.layer;
        if (!part.cutFrom.empty()) json["cutFrom"] = part.cutFrom;
        if (!part.ridesOn.empty()) json["ridesOn"] = part.ridesOn;
        for (const Joint& joint : part.joints) json["joinedTo"].push_back(joint.to);
        if (part.hidden) json["hidden"] = true;
        if (part.blend) json["blend"] = blendWord(*part.blend);
        list.push_back(std::move(json));
    }
    return list;
}

/// Tells of files that the domain names and that are not there.
void addMissing(const Domain& domain, const std::string& folder, Json& json) {
    std::vector<std::string> files{domain.path};
    for (const PicturePart& part : domain.parts)
        if (std::ranges::find(files, part.path) == files.end()) files.push_back(part.path);
    std::error_code error;
    for (const std::string& file : files)
        if (const std::string path = pathIn(folder, file);
            !(file.empty() && !domain.parts.empty()) && !std::filesystem::exists(path, error))
            json["problems"].push_back(
                {{"what", "the domain's file " + path + " does not exist"}, {"fatal", true}});
}

/// Describes the input file, and the options of its mesh if Wend makes that.
Json domainInfo(const Domain& domain) {
    static const char* const kinds[] = {"image", "mesh", "surface"};
    Json json{{"kind", kinds[static_cast<int>(domain.kind)]}, {"file", domain.path}};
    if (!domain.parts.empty()) json = {{"kind", "parts"}, {"parts", partsInfo(domain)}};
    if (domain.kind != DomainKind::Mesh) {
        if (domain.edge > 0)
            json["edge"] = domain.edge;
        else if (domain.maxVolume > 0)
            json["maxVolume"] = domain.maxVolume;
        else
            json["vertices"] = domain.vertices;
    }
    if (!domain.texture.empty()) json["texture"] = domain.texture;
    if (!domain.detail.empty()) json["detail"] = domain.detail;
    return json;
}

Json projectInfo(const std::string& path) {
    const LoadedProject loaded = readProject(path);
    const Project& project = *loaded.project;
    const Domain& domain = domainOf(project);
    Json json{{"kind", "project"},
              {"dimension", dimensionOf(project)},
              {"domain", domainInfo(domain)},
              {"end", endOf(project)}};
    addDesign(json, designOf(project));
    json["warnings"] = loaded.warnings;
    addMissing(domain, folderOf(path), json);
    return json;
}

Json infoOf(const std::string& path, const std::string& problemsFile) {
    const std::string extension = lowerExtension(path);
    if (extension == ".wend" && problemsFile.empty()) return projectInfo(path);
    for (const std::string& known : readableMeshExtensions())
        if (extension == known) return meshInfo(path, problemsFile);
    if (!problemsFile.empty()) throw UsageError("--problems is for meshes and surfaces");
    return pictureInfo(path);
}

// --- As text ---

std::string text(const Json& value) {
    if (value.is_string()) return printable(value.get<std::string>());
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    return value.is_number_float() ? shortNumber(value.get<double>()) : value.dump();
}

/// "medianOfLeastAngles" → "median of least angles"
std::string words(const std::string& key) {
    std::string text;
    for (char c : key)
        text += c >= 'A' && c <= 'Z' ? " " + std::string(1, static_cast<char>(c + 32)) : std::string(1, c);
    return text;
}

std::string numbers(const Json& list) {
    std::string text;
    for (std::size_t i = 0; i < std::min(list.size(), kListed); ++i)
        text += (i > 0 ? ", " : "") + list[i].dump();
    return text + (list.size() > kListed ? ", … (all with --json)" : "");
}

std::string asText(const Json& json, const std::string& indent);

/// Returns a line with a bar for each step from the first to the last that is not empty.
std::string barsText(const Json& histogram, const std::string& indent) {
    const std::vector<int> counts = histogram["counts"];
    const bool doubling = histogram.contains("factor");
    const auto holds = [](int count) { return count > 0; };
    const auto first = std::ranges::find_if(counts, holds);
    const auto last = std::find_if(counts.rbegin(), counts.rend(), holds).base();
    const double most = counts.empty() ? 0 : std::ranges::max(counts);
    std::string lines;
    for (auto it = first; it < last; ++it) {
        const double i = static_cast<double>(it - counts.begin());
        const double from = histogram["from"];
        const double low = doubling ? from * std::pow(2.0, i) : from + i * histogram["step"].get<double>();
        std::string label = shortNumber(low), number = std::to_string(*it);
        label.insert(0, label.size() < 12 ? 12 - label.size() : 0, ' ');
        number.insert(0, number.size() < 9 ? 9 - number.size() : 0, ' ');
        lines += indent + label + number + " ";
        for (int k = 0; k < std::lround(40 * *it / most); ++k) lines += "█";
        lines += "\n";
    }
    return lines;
}

std::string entryText(const Json& value, const std::string& indent) {
    if (value.is_object() && value.contains("counts")) return "\n" + barsText(value, indent);
    if (value.is_object()) return "\n" + asText(value, indent + "  ");
    if (!value.is_array()) return " " + text(value) + "\n";
    if (value.empty()) return " none\n";
    if (value.front().is_number() || value.front().is_array()) return " " + numbers(value) + "\n";
    std::string lines = "\n";
    for (const Json& element : value) {
        if (!element.is_object()) {
            lines += indent + "  - " + text(element) + "\n";
            continue;
        }
        std::string entry = asText(element, indent + "    ");
        entry.replace(indent.size() + 2, 1, "-");
        lines += entry;
    }
    return lines;
}

std::string asText(const Json& json, const std::string& indent) {
    std::string lines;
    for (const auto& [key, value] : json.items())
        lines += indent + printable(words(key)) + ":" + entryText(value, indent);
    return lines;
}

}  // namespace

ExitCode runInfo(const Arguments& arguments) {
    const std::string path = onlyFile(arguments, "file"), problems = arguments.text("--problems");
    requireFile(path);
    if (sameFile(path, problems))
        throw UsageError(problems + ": would replace " + path + ", which is read here");
    const Json json = infoOf(path, problems);
    return print(arguments.has("--json") ? prettyJson(json) : asText(json, ""));
}

}  // namespace wend
