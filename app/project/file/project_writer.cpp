#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/project/file/guide_file.h"
#include "app/project/file/json_text.h"
#include "app/project/file/motion_files.h"
#include "app/project/file/named_places.h"
#include "app/project/file/part_json.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/setting_json.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/base/error.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

template <class Vector>
Json point(const Vector& v) {
    Json json = Json::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) json.push_back(numberJson(v[i]));
    return json;
}

template <class Vector>
Json points(const std::vector<Vector>& all) {
    Json json = Json::array();
    for (const Vector& one : all) json.push_back(point(one));
    return json;
}

// --- Regions ---

template <int Dim>
Json regionJson(const Region<Dim>& region) {
    return std::visit(
        Overloaded{[](const Polygon& polygon) {
                       return Json{{"polygon", points(polygon.points)}};
                   },
                   [](const Ball<Dim>& ball) {
                       const Json inside{{"centre", point(ball.centre)}, {"radius", numberJson(ball.radius)}};
                       return Json{{Dim == 2 ? "circle" : "sphere", inside}};
                   },
                   [](const Box<Dim>& box) {
                       return Json{{"box", Json{{"min", point(box.min)}, {"max", point(box.max)}}}};
                   },
                   [](const HalfSpace<Dim>& half) {
                       return Json{
                           {"halfspace", Json{{"point", point(half.point)}, {"normal", point(half.normal)}}}};
                   },
                   [](const Blend<Dim>& blend) {
                       return Json{{"blend", Json{{"from", point(blend.from)}, {"to", point(blend.to)}}}};
                   }},
        region);
}

// --- Domain ---

/// An object that holds nothing but settings.
Json groupJson(const char* group, const Project& project) {
    Json json = Json::object();
    writeSettings(json, group, project);
    return json;
}

/// The settings if there is something to say, or else true.
Json switchedOn(const char* group, const Project& project) {
    Json json = groupJson(group, project);
    return json.empty() ? Json(true) : json;
}

template <int Dim>
void addSizes(Json& json, const std::vector<SizeRegionIn<Dim>>& sizes) {
    for (const SizeRegionIn<Dim>& region : sizes) {
        Json one = Json::object();
        if (!region.name.empty()) one["name"] = region.name;
        one["shape"] = regionJson<Dim>(region.shape);
        if (region.feather != 0) one["feather"] = numberJson(region.feather);
        one["factor"] = numberJson(region.factor);
        if (!region.part.empty()) one["part"] = region.part;
        json["sizes"].push_back(withExtras(std::move(one), region.extras));
    }
}

void addSurfaceKeys(Json& json, const Project& project) {
    const Domain& domain = project.domain;
    for (const SurfaceFix& fix : domain.fixes)
        json["fixes"].push_back({{kFixWords[static_cast<int>(fix.kind)], fix.ids}});
    if (domain.repair) json["repair"] = switchedOn("domain.repair", project);
    if (domain.fit == Fit::Cage) json["cage"] = switchedOn("domain.cage", project);
    if (domain.fit == Fit::Exact) json["cage"] = false;
    if (!domain.sizesFile.empty()) json["sizes"].push_back({{"values", domain.sizesFile}});
    addSizes<3>(json, domain.sizes);
}

Json domainJson(const Project& project) {
    static const char* const kinds[] = {"image", "mesh", "surface"};
    const Domain& domain = project.domain;
    Json json = Json::object();
    if (domain.parts.empty())
        json[kinds[static_cast<int>(domain.kind)]] = domain.path;
    else
        json["parts"] = partsJson(domain);
    if (domain.kind == DomainKind::Image && domain.size[0] > 0) json["size"] = domain.size;
    if (domain.kind == DomainKind::Image) json["outline"] = outlineJson(project);
    if (domain.kind != DomainKind::Mesh && domain.edge <= 0 && domain.maxVolume <= 0)
        json["vertices"] = domain.vertices;
    writeSettings(json, "domain", project);
    if (domain.kind == DomainKind::Image) addSizes<2>(json, domain.flatSizes);
    if (domain.kind == DomainKind::Mesh && !domain.texture.empty()) json["image"] = domain.texture;
    if (domain.kind == DomainKind::Surface) addSurfaceKeys(json, project);
    if (domain.kind != DomainKind::Image && !domain.detail.empty()) json["detail"] = domain.detail;
    return json;
}

// --- Material ---

Json picturesJson(const MaterialPictures& pictures) {
    Json json = Json::object();
    for (const auto& [key, file] : {std::pair{"phi", &pictures.phi},
                                    {"stiffness", &pictures.stiffness},
                                    {"direction", &pictures.direction}})
        if (!file->empty()) json[key] = *file;
    if (pictures.up) json["up"] = true;
    return json;
}

template <int Dim>
Json stiffnessJson(const Stiffness<Dim>& stiffness) {
    Json json{{"axis", point(stiffness.axis)}, {"ratio", numberJson(stiffness.ratio)}};
    if (!stiffness.wall.empty()) json["axis"] = wallText(stiffness.wall);
    if (std::isfinite(stiffness.within)) json["within"] = numberJson(stiffness.within);
    return json;
}

/// Readers without erasers apply the material that holds everywhere.
template <int Dim>
Json materialRegionJson(MaterialRegion<Dim> region, double everywhere) {
    if (region.erases()) {
        region.phi = everywhere;
        region.stiffness = Stiffness<Dim>{Vec<Dim>::UnitX(), 1};
    }
    Json json = Json::object();
    if (!region.name.empty()) json["name"] = region.name;
    json["shape"] = regionJson<Dim>(region.shape);
    if (region.feather != 0) json["feather"] = numberJson(region.feather);
    if (region.phi) json["phi"] = phiJson(*region.phi, Dim);
    if (region.stiffness) json["stiffness"] = stiffnessJson<Dim>(*region.stiffness);
    if (region.pictures.any()) json["pictures"] = picturesJson(region.pictures);
    if (region.hidden) json["hidden"] = true;
    if (region.erases()) json["leaves"] = numberJson(region.leaves);
    if (!region.part.empty()) json["part"] = region.part;
    return withExtras(std::move(json), region.extras);
}

template <int Dim>
Json cellsJson(const MaterialSpec<Dim>& spec) {
    Json json = Json::object();
    for (double phi : spec.cellPhi) json["phi"].push_back(numberJson(phi));
    for (const Mat<Dim>& B : spec.cellB) {
        const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor> rows = B;
        json["B"].push_back(point(Eigen::Map<const Eigen::Matrix<double, Dim * Dim, 1>>(rows.data())));
    }
    return json;
}

/// Names the file and its fields.
template <int Dim>
Json cellFieldsJson(const MaterialSpec<Dim>& spec) {
    Json json{{"file", spec.cellsFile}};
    if (!spec.cellsPhi.empty()) json["phi"] = spec.cellsPhi;
    if (!spec.cellsB.empty()) json["B"] = spec.cellsB;
    return json;
}

template <int Dim>
Json materialJson(const Project& project) {
    const MaterialSpec<Dim>& spec = std::get<Design<Dim>>(project.design).material;
    Json json = groupJson("material", project);
    json["smoothing"] = groupJson("material.smoothing", project);
    for (const auto& region : spec.regions)
        json["regions"].push_back(materialRegionJson<Dim>(region, spec.phi));
    if (!spec.cellsFile.empty() && spec.cellsPhi.empty() && spec.cellsB.empty())
        json["cells"] = spec.cellsFile;
    else if (!spec.cellsFile.empty())
        json["cells"] = cellFieldsJson<Dim>(spec);
    else if (!spec.cellPhi.empty() || !spec.cellB.empty())
        json["cells"] = cellsJson(spec);
    return json;
}

// --- Handles ---

template <int Dim>
Json placementJson(const Placement<Dim>& at) {
    return std::visit(Overloaded{[](const std::vector<int>& ids) {
                                     return Json{{"vertices", ids}};
                                 },
                                 [](const std::vector<Vec<Dim>>& all) {
                                     return Json{{"points", points(all)}};
                                 },
                                 [](const Region<Dim>& region) {
                                     return Json{{"region", regionJson<Dim>(region)}};
                                 }},
                      at);
}

template <int Dim>
Json curveJson(const CurveMotion<Dim>& curve) {
    Json json{{"kind", "curve"},
              {"interpolation", wordOf("handles[].motion[].interpolation", curve.interpolation)},
              {"points", points(curve.points)},
              {"frame", wordOf("handles[].motion[].frame", curve.frame)}};
    if (curve.twist != 0) json["twist"] = numberJson(curve.twist);
    if (curve.scale != 1) json["scale"] = numberJson(curve.scale);
    return json;
}

template <int Dim>
Json rotateJson(const Rotate<Dim>& rotate) {
    Json json{{"kind", "rotate"}, {"centre", point(rotate.centre)}};
    if (Dim == 3) json["axis"] = point(rotate.axis);
    json["angle"] = numberJson(rotate.angle);
    return json;
}

template <int Dim>
Json recordedJson(const Recorded<Dim>& stroke) {
    Json times = Json::array();
    for (double time : stroke.times) times.push_back(numberJson(time));
    return {{"kind", "recorded"}, {"times", times}, {"points", points(stroke.points)}};
}

template <int Dim>
Json fieldJson(const FieldMotion<Dim>& field) {
    Json json{{"kind", "field"}};
    if (!field.file.empty()) {
        json["file"] = field.file;
        if (!field.array.empty()) json["array"] = field.array;
        return json;
    }
    for (const auto& [vertex, displacement] : *field.values) {
        json["vertices"].push_back(vertex);
        json["by"].push_back(point(displacement));
    }
    return json;
}

template <int Dim>
Json posesJson(const PoseMotion<Dim>& motion) {
    Json json{{"kind", "poses"}};
    if (!motion.file.empty()) {
        json["file"] = motion.file;
        return json;
    }
    for (std::size_t i = 0; i < motion.poses.size(); ++i) {
        Json row = Json::array({numberJson(motion.times[i])});
        for (const Json& number : point(motion.poses[i].position)) row.push_back(number);
        for (const Json& number : point(motion.poses[i].rotation)) row.push_back(number);
        json["poses"].push_back(row);
    }
    return json;
}

/// The times of the motion are those of its poses, and need not be written.
template <int Dim>
bool hasTimesOfPoses(const Motion<Dim>& motion) {
    const auto* poses = std::get_if<PoseMotion<Dim>>(&motion.kind);
    return poses && poses->hasOwnTimes &&
           (poses->times.empty() ||
            (motion.start == poses->times.front() && motion.end == poses->times.back()));
}

template <int Dim>
Json motionJson(const Motion<Dim>& motion) {
    Json json = std::visit(Overloaded{[](const Translate<Dim>& move) {
                                          return Json{{"kind", "translate"}, {"by", point(move.by)}};
                                      },
                                      [](const Rotate<Dim>& rotate) { return rotateJson(rotate); },
                                      [](const CurveMotion<Dim>& curve) { return curveJson(curve); },
                                      [](const Recorded<Dim>& stroke) { return recordedJson(stroke); },
                                      [](const FieldMotion<Dim>& field) { return fieldJson(field); },
                                      [](const PoseMotion<Dim>& poses) { return posesJson(poses); }},
                           motion.kind);
    if (!hasTimesOfPoses(motion))
        json["time"] = Json::array({numberJson(motion.start), numberJson(motion.end)});
    if (motion.ease != Ease::Linear) json["ease"] = wordOf("handles[].motion[].ease", motion.ease);
    putNamedDirection(json, motion.extras, "/axis");
    return withExtras(std::move(json), withoutNames(motion.extras));
}

/// An end that is open is null.
Json activeJson(double from, double to) {
    return Json::array({std::isfinite(from) ? Json(from) : Json(), std::isfinite(to) ? Json(to) : Json()});
}

std::string colourText(unsigned colour) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[colour >> shift & 0xF];
    return text;
}

template <int Dim>
Json holdJson(const Handle<Dim>& handle) {
    if (handle.slide) return {{"slide", handle.slide->file.empty() ? kRestSurface : handle.slide->file}};
    if (handle.normal) return {{"normal", point(*handle.normal)}};
    Json axes = Json::array();
    for (int k = 0; k < Dim; ++k)
        if ((handle.slides >> k & 1U) == 0) axes.push_back(std::string(1, "xyz"[k]));
    return axes;
}

void addTraits(Json& json, const HandleTraits& traits) {
    if (traits.locked) json["locked"] = true;
    if (traits.hidden) json["hidden"] = true;
    if (!traits.group.empty()) json["group"] = traits.group;
    if (traits.link > 0) json["link"] = traits.link;
    if (traits.colour) json["colour"] = colourText(*traits.colour);
}

template <int Dim>
Json handleJson(const Handle<Dim>& handle) {
    Json json = Json::object();
    if (!handle.name.empty()) json["name"] = handle.name;
    json["at"] = placementJson<Dim>(handle.at);
    if (!handle.part.empty()) json["at"]["part"] = handle.part;
    if (const auto name = nameOfPlace(handle.extras, json["at"])) json["at"] = *name;
    if (std::isfinite(handle.activeFrom) || std::isfinite(handle.activeTo))
        json["active"] = activeJson(handle.activeFrom, handle.activeTo);
    for (const auto& motion : handle.motions) json["motion"].push_back(motionJson(motion));
    if (handle.isPartlyHeld()) json["hold"] = holdJson(handle);
    addTraits(json, handle.traits);
    putNamedDirection(json, handle.extras, "/hold/normal");
    return withExtras(std::move(json), withoutNames(handle.extras));
}

template <int Dim>
void addDesign(Json& json, const Design<Dim>& design, const Project& project) {
    json["material"] = materialJson<Dim>(project);
    json["handles"] = Json::array();
    for (const auto& handle : design.handles) json["handles"].push_back(handleJson(handle));
}

Json depthJson(const DepthRegion& region) {
    Json json = Json::object();
    if (!region.name.empty()) json["name"] = region.name;
    json["shape"] = regionJson<2>(region.shape);
    json["order"] = numberJson(region.order);
    if (!region.part.empty()) json["part"] = region.part;
    return withExtras(std::move(json), region.extras);
}

// --- View ---

Json cameraJson(const SavedCamera& camera) {
    Json json{
        {"position", point(camera.position)}, {"target", point(camera.target)}, {"up", point(camera.up)}};
    if (camera.pivot) json["pivot"] = point(*camera.pivot);
    if (camera.parallel) json["parallel"] = true;
    return json;
}

Json viewJson(const Project& project) {
    Json json = groupJson("view", project);
    if (project.view.camera) json["camera"] = cameraJson(*project.view.camera);
    return withExtras(std::move(json), project.view.extras);
}

// --- Files ---

/// The file, which is named from folder `from`, as named from folder `to`.
std::string rebased(const std::string& file, const fs::path& from, const fs::path& to) {
    if (file.empty()) return file;
    const fs::path absolute = fs::absolute(from / file).lexically_normal();
    const fs::path relative = absolute.lexically_relative(fs::absolute(to).lexically_normal());
    return relative.empty() ? absolute.string() : relative.generic_string();
}

Project rebased(Project project, const std::string& path, const std::string& folder) {
    fs::path to = fs::path(path).parent_path();
    if (to.empty()) to = ".";
    const fs::path from = folder.empty() ? to : fs::path(folder);
    for (std::string* file : filesOf(project)) *file = rebased(*file, from, to);
    std::visit(
        [&](auto& design) {
            for (auto& handle : design.handles)
                rebaseNamedPlaces(handle.extras,
                                  [&](const std::string& file) { return rebased(file, from, to); });
        },
        project.design);
    return project;
}

Json timeJson(const Project& project) {
    Json json = groupJson("time", project);
    if (project.cycle) json["cycle"] = {numberJson(project.cycle->at(0)), numberJson(project.cycle->at(1))};
    for (const TimeMarker& marker : project.markers) {
        Json one{{"at", numberJson(marker.at)}};
        if (!marker.name.empty()) one["name"] = marker.name;
        json["markers"].push_back(withExtras(std::move(one), marker.extras));
    }
    if (!project.audio.empty()) json["audio"] = project.audio;
    return json;
}

/// Takes the end of time out, and the object around it if nothing else is in it.
void leaveEndOut(Json& json, const Extras& extras) {
    json["time"].erase("end");
    const bool hasMore =
        std::ranges::any_of(extras, [](const auto& extra) { return extra.first.starts_with("/time/"); });
    if (json["time"].empty() && !hasMore) json.erase("time");
}

}  // namespace

std::vector<std::string*> filesOf(Project& project) {
    Domain& domain = project.domain;
    std::vector<std::string*> files{&domain.path, &domain.texture, &domain.sizesFile, &domain.detail};
    files.push_back(&project.audio);
    for (PicturePart& part : domain.parts) files.push_back(&part.path);
    std::visit(
        [&](auto& design) {
            files.push_back(&design.material.cellsFile);
            for (auto& handle : design.handles) {
                if (handle.slide) files.push_back(&handle.slide->file);
                for (auto& motion : handle.motions)
                    if (std::string* file = fileOf(motion.kind)) files.push_back(file);
            }
            for (auto& region : design.material.regions)
                for (std::string* file :
                     {&region.pictures.phi, &region.pictures.stiffness, &region.pictures.direction})
                    files.push_back(file);
        },
        project.design);
    return files;
}

std::string toJson(const Project& project) {
    Json json{{"format", "wend"}, {"version", 1}, {"domain", domainJson(project)}};
    std::visit([&](const auto& design) { addDesign(json, design, project); }, project.design);
    for (const DepthRegion& region : project.depth) json["depth"].push_back(depthJson(region));
    for (const SettleWindow& window : project.settle)
        json["settle"].push_back({{"time", Json::array({numberJson(window.start), numberJson(window.end)})}});
    json["time"] = timeJson(project);
    json["integration"] = groupJson("integration", project);
    if (!project.endIsGiven && project.end == endOfMotions(project)) leaveEndOut(json, project.extras);
    if (Json view = viewJson(project); !view.empty()) json["view"] = std::move(view);
    return prettyJson(withExtras(std::move(json), project.extras));
}

void writeProject(const std::string& path, const Project& project, const std::string& folder) try {
    writeTextFile(path, toJson(rebased(project, path, folder)));
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
