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

/// Writes a project as JSON: points have as many coordinates as the project.
class ProjectJson {
  public:
    explicit ProjectJson(const Project& project) : m_project(project), m_dimension(project.dimension()) {}

    Json whole() const;

  private:
    Json point(const Vec3& p) const {
        Json json = Json::array();
        for (int i = 0; i < m_dimension; ++i) json.push_back(numberJson(p[i]));
        return json;
    }
    Json points(const std::vector<Vec3>& all) const {
        Json json = Json::array();
        for (const Vec3& one : all) json.push_back(point(one));
        return json;
    }

    // --- Regions ---

    Json regionJson(const Region<3>& region) const {
        return std::visit(
            Overloaded{
                [this](const Polygon& polygon) {
                    Json corners = Json::array();
                    for (const Vec2& p : polygon.points) corners.push_back(point(inSpace(p)));
                    return Json{{"polygon", corners}};
                },
                [this](const Ball<3>& ball) {
                    const Json inside{{"centre", point(ball.centre)}, {"radius", numberJson(ball.radius)}};
                    return Json{{m_dimension == 2 ? "circle" : "sphere", inside}};
                },
                [this](const Box<3>& box) {
                    return Json{{"box", Json{{"min", point(box.min)}, {"max", point(box.max)}}}};
                },
                [this](const HalfSpace<3>& half) {
                    return Json{
                        {"halfspace", Json{{"point", point(half.point)}, {"normal", point(half.normal)}}}};
                },
                [this](const Blend<3>& blend) {
                    return Json{{"blend", Json{{"from", point(blend.from)}, {"to", point(blend.to)}}}};
                }},
            region);
    }

    // --- Domain ---

    /// Returns an object of settings only.
    Json groupJson(const char* group) const {
        Json json = Json::object();
        writeSettings(json, group, m_project);
        return json;
    }

    /// Returns the settings that differ from their defaults, or true if none does.
    Json switchedOn(const char* group) const {
        Json json = groupJson(group);
        return json.empty() ? Json(true) : json;
    }

    /// Adds the regions of layers, whose value has that key.
    void addLayers(Json& json, const char* list, const char* key, const ValueLayers& layers) const {
        for (const ValueLayer& layer : layers)
            for (const SoftRegion& region : layer.regions) {
                Json one = Json::object();
                if (!layer.name.empty()) one["name"] = layer.name;
                one["shape"] = regionJson(region.shape);
                if (region.feather != 0) one["feather"] = numberJson(region.feather);
                one[key] = numberJson(layer.value);
                if (!region.part.empty()) one["part"] = region.part;
                json[list].push_back(withExtras(std::move(one), region.extras));
            }
    }
    void addSizes(Json& json) const { addLayers(json, "sizes", "factor", m_project.domain.sizes); }

    void addSurfaceKeys(Json& json) const {
        const Domain& domain = m_project.domain;
        for (const SurfaceFix& fix : domain.fixes)
            json["fixes"].push_back({{kFixWords[static_cast<int>(fix.kind)], fix.ids}});
        if (domain.repair) json["repair"] = switchedOn("domain.repair");
        if (domain.fit == Fit::Cage) json["cage"] = switchedOn("domain.cage");
        if (domain.fit == Fit::Exact) json["cage"] = false;
        if (!domain.sizesFile.empty()) json["sizes"].push_back({{"values", domain.sizesFile}});
        addSizes(json);
    }

    Json domainJson() const {
        static const char* const kinds[] = {"image", "mesh", "surface"};
        const Domain& domain = m_project.domain;
        Json json = Json::object();
        if (domain.parts.empty())
            json[kinds[static_cast<int>(domain.kind)]] = domain.path;
        else
            json["parts"] = partsJson(domain);
        if (domain.kind == DomainKind::Image && domain.size[0] > 0) json["size"] = domain.size;
        if (domain.kind == DomainKind::Image) json["outline"] = outlineJson(m_project);
        if (domain.kind != DomainKind::Mesh && domain.edge <= 0 && domain.maxVolume <= 0)
            json["vertices"] = domain.vertices;
        writeSettings(json, "domain", m_project);
        if (domain.kind == DomainKind::Image) addSizes(json);
        if (domain.kind == DomainKind::Mesh && !domain.texture.empty()) json["image"] = domain.texture;
        if (domain.kind == DomainKind::Surface) addSurfaceKeys(json);
        if (domain.kind != DomainKind::Image && !domain.detail.empty()) json["detail"] = domain.detail;
        return json;
    }

    // --- Material ---

    static Json picturesJson(const MaterialPictures& pictures) {
        Json json = Json::object();
        for (const auto& [key, file] : {std::pair{"phi", &pictures.phi},
                                        {"stiffness", &pictures.stiffness},
                                        {"direction", &pictures.direction}})
            if (!file->empty()) json[key] = *file;
        if (pictures.up) json["up"] = true;
        return json;
    }

    Json stiffnessJson(const Stiffness& stiffness) const {
        Json json{{"axis", point(stiffness.axis)}, {"ratio", numberJson(stiffness.ratio)}};
        if (!stiffness.wall.empty()) json["axis"] = wallText(stiffness.wall);
        if (std::isfinite(stiffness.within)) json["within"] = numberJson(stiffness.within);
        return json;
    }

    /// Readers without erasers apply the material that holds everywhere.
    Json materialRegionJson(const std::string& name, MaterialRegion region, double everywhere) const {
        if (region.erases()) {
            region.phi = everywhere;
            region.stiffness = Stiffness{Vec3::UnitX(), 1};
        }
        Json json = Json::object();
        if (!name.empty()) json["name"] = name;
        json["shape"] = regionJson(region.shape);
        if (region.feather != 0) json["feather"] = numberJson(region.feather);
        if (region.phi) json["phi"] = phiJson(*region.phi, m_dimension);
        if (region.stiffness) json["stiffness"] = stiffnessJson(*region.stiffness);
        if (region.pictures.any()) json["pictures"] = picturesJson(region.pictures);
        if (region.hidden) json["hidden"] = true;
        if (region.erases()) json["leaves"] = numberJson(region.leaves);
        if (!region.part.empty()) json["part"] = region.part;
        return withExtras(std::move(json), region.extras);
    }

    Json cellsJson(const MaterialSpec& spec) const {
        Json json = Json::object();
        for (double phi : spec.cellPhi) json["phi"].push_back(numberJson(phi));
        for (const Mat3& B : spec.cellB) {
            Json& rows = json["B"].emplace_back(Json::array());
            for (int i = 0; i < m_dimension; ++i)
                for (int j = 0; j < m_dimension; ++j) rows.push_back(numberJson(B(i, j)));
        }
        return json;
    }

    /// Names the file and its fields.
    static Json cellFieldsJson(const MaterialSpec& spec) {
        Json json{{"file", spec.cellsFile}};
        if (!spec.cellsPhi.empty()) json["phi"] = spec.cellsPhi;
        if (!spec.cellsB.empty()) json["B"] = spec.cellsB;
        return json;
    }

    Json materialJson() const {
        const MaterialSpec& spec = m_project.design.material;
        Json json = groupJson("material");
        json["smoothing"] = groupJson("material.smoothing");
        for (const MaterialLayer& layer : spec.layers)
            for (const MaterialRegion& region : layer.regions)
                json["regions"].push_back(materialRegionJson(layer.name, region, spec.phi));
        if (!spec.cellsFile.empty() && spec.cellsPhi.empty() && spec.cellsB.empty())
            json["cells"] = spec.cellsFile;
        else if (!spec.cellsFile.empty())
            json["cells"] = cellFieldsJson(spec);
        else if (!spec.cellPhi.empty() || !spec.cellB.empty())
            json["cells"] = cellsJson(spec);
        return json;
    }

    // --- Handles ---

    Json placementJson(const Placement<3>& at) const {
        return std::visit(Overloaded{[](const std::vector<int>& ids) {
                                         return Json{{"vertices", ids}};
                                     },
                                     [this](const std::vector<Vec3>& all) {
                                         return Json{{"points", points(all)}};
                                     },
                                     [this](const Region<3>& region) {
                                         return Json{{"region", regionJson(region)}};
                                     }},
                          at);
    }

    Json curveJson(const CurveMotion<3>& curve) const {
        Json json{{"kind", "curve"},
                  {"interpolation", wordOf("handles[].motion[].interpolation", curve.interpolation)},
                  {"points", points(curve.points)},
                  {"frame", wordOf("handles[].motion[].frame", curve.frame)}};
        if (curve.twist != 0) json["twist"] = numberJson(curve.twist);
        if (curve.scale != 1) json["scale"] = numberJson(curve.scale);
        return json;
    }

    Json rotateJson(const Rotate<3>& rotate) const {
        Json json{{"kind", "rotate"}, {"centre", point(rotate.centre)}};
        if (m_dimension == 3) json["axis"] = point(rotate.axis);
        json["angle"] = numberJson(rotate.angle);
        return json;
    }

    Json recordedJson(const Recorded<3>& stroke) const {
        Json times = Json::array();
        for (double time : stroke.times) times.push_back(numberJson(time));
        return {{"kind", "recorded"}, {"times", times}, {"points", points(stroke.points)}};
    }

    Json fieldJson(const FieldMotion<3>& field) const {
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

    Json posesJson(const PoseMotion<3>& motion) const {
        Json json{{"kind", "poses"}};
        if (!motion.file.empty()) {
            json["file"] = motion.file;
            return json;
        }
        for (std::size_t i = 0; i < motion.poses.size(); ++i) {
            Json row = Json::array({numberJson(motion.times[i])});
            for (const Json& number : point(motion.poses[i].position)) row.push_back(number);
            const Vec3& rotation = motion.poses[i].rotation;
            for (int k = m_dimension == 2 ? 2 : 0; k < 3; ++k) row.push_back(numberJson(rotation[k]));
            json["poses"].push_back(row);
        }
        return json;
    }

    /// Returns whether the times of the motion are those of its poses, and need not be written.
    static bool hasTimesOfPoses(const PinMotion& motion) {
        const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind);
        return poses && poses->hasOwnTimes &&
               (poses->times.empty() ||
                (motion.start == poses->times.front() && motion.end == poses->times.back()));
    }

    Json motionJson(const PinMotion& motion) const {
        Json json = std::visit(Overloaded{[this](const Translate<3>& move) {
                                              return Json{{"kind", "translate"}, {"by", point(move.by)}};
                                          },
                                          [this](const Rotate<3>& rotate) { return rotateJson(rotate); },
                                          [this](const CurveMotion<3>& curve) { return curveJson(curve); },
                                          [this](const Recorded<3>& stroke) { return recordedJson(stroke); },
                                          [this](const FieldMotion<3>& field) { return fieldJson(field); },
                                          [this](const PoseMotion<3>& poses) { return posesJson(poses); }},
                               motion.kind);
        if (!hasTimesOfPoses(motion))
            json["time"] = Json::array({numberJson(motion.start), numberJson(motion.end)});
        if (motion.ease != Ease::Linear) json["ease"] = wordOf("handles[].motion[].ease", motion.ease);
        putNamedDirection(json, motion.extras, "/axis");
        return withExtras(std::move(json), withoutNames(motion.extras));
    }

    /// Writes an open end as null.
    static Json activeJson(double from, double to) {
        return Json::array(
            {std::isfinite(from) ? Json(from) : Json(), std::isfinite(to) ? Json(to) : Json()});
    }

    static std::string colourText(unsigned colour) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        std::string text = "#";
        for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[colour >> shift & 0xF];
        return text;
    }

    Json holdJson(const Pin& handle) const {
        if (handle.slide) return {{"slide", handle.slide->file.empty() ? kRestSurface : handle.slide->file}};
        if (handle.normal) return {{"normal", point(*handle.normal)}};
        Json axes = Json::array();
        for (int k = 0; k < m_dimension; ++k)
            if ((handle.slides >> k & 1U) == 0) axes.push_back(std::string(1, "xyz"[k]));
        return axes;
    }

    static void addTraits(Json& json, const PinTraits& traits) {
        if (traits.locked) json["locked"] = true;
        if (traits.hidden) json["hidden"] = true;
        if (!traits.group.empty()) json["group"] = traits.group;
        if (traits.link > 0) json["link"] = traits.link;
        if (traits.colour) json["colour"] = colourText(*traits.colour);
    }

    Json handleJson(const Pin& handle) const {
        Json json = Json::object();
        if (!handle.name.empty()) json["name"] = handle.name;
        json["at"] = placementJson(handle.at);
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

    void addDesign(Json& json) const {
        json["material"] = materialJson();
        json["handles"] = Json::array();
        for (const Pin& handle : m_project.design.handles) json["handles"].push_back(handleJson(handle));
    }

    // --- View ---

    static Json cameraJson(const SavedCamera& camera) {
        const auto place = [](const Vec3& p) {
            return Json::array({numberJson(p[0]), numberJson(p[1]), numberJson(p[2])});
        };
        Json json{
            {"position", place(camera.position)}, {"target", place(camera.target)}, {"up", place(camera.up)}};
        if (camera.pivot) json["pivot"] = place(*camera.pivot);
        if (camera.parallel) json["parallel"] = true;
        return json;
    }

    Json viewJson() const {
        Json json = groupJson("view");
        if (m_project.view.camera) json["camera"] = cameraJson(*m_project.view.camera);
        return withExtras(std::move(json), m_project.view.extras);
    }

    Json timeJson() const {
        const Project& project = m_project;
        Json json = groupJson("time");
        if (project.cycle)
            json["cycle"] = {numberJson(project.cycle->at(0)), numberJson(project.cycle->at(1))};
        for (const TimeMarker& marker : project.markers) {
            Json one{{"at", numberJson(marker.at)}};
            if (!marker.name.empty()) one["name"] = marker.name;
            json["markers"].push_back(withExtras(std::move(one), marker.extras));
        }
        if (!project.audio.empty()) json["audio"] = project.audio;
        return json;
    }

    /// Takes the end of time out, and the object around it if nothing else is in it.
    void leaveEndOut(Json& json) const {
        json["time"].erase("end");
        const bool hasMore = std::ranges::any_of(
            m_project.extras, [](const auto& extra) { return extra.first.starts_with("/time/"); });
        if (json["time"].empty() && !hasMore) json.erase("time");
    }

    const Project& m_project;
    int m_dimension;
};

Json ProjectJson::whole() const {
    Json json{{"format", "wend"}, {"version", 1}, {"domain", domainJson()}};
    addDesign(json);
    addLayers(json, "depth", "order", m_project.depth);
    for (const SettleWindow& window : m_project.settle)
        json["settle"].push_back({{"time", Json::array({numberJson(window.start), numberJson(window.end)})}});
    json["time"] = timeJson();
    json["integration"] = groupJson("integration");
    if (!m_project.endIsGiven && m_project.end == endOfMotions(m_project)) leaveEndOut(json);
    if (Json view = viewJson(); !view.empty()) json["view"] = std::move(view);
    return withExtras(std::move(json), m_project.extras);
}

// --- Files ---

/// Returns the file, which is named relative to folder `from`, as named relative to folder `to`.
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
    for (Pin& handle : project.design.handles)
        rebaseNamedPlaces(handle.extras, [&](const std::string& file) { return rebased(file, from, to); });
    return project;
}

}  // namespace

std::vector<std::string*> filesOf(Project& project) {
    Domain& domain = project.domain;
    std::vector<std::string*> files{&domain.path, &domain.texture, &domain.sizesFile, &domain.detail};
    files.push_back(&project.audio);
    for (PicturePart& part : domain.parts) files.push_back(&part.path);
    Design& design = project.design;
    files.push_back(&design.material.cellsFile);
    for (Pin& handle : design.handles) {
        if (handle.slide) files.push_back(&handle.slide->file);
        for (PinMotion& motion : handle.motions)
            if (std::string* file = fileOf(motion.kind)) files.push_back(file);
    }
    for (MaterialRegion& region : regionsOf(design.material.layers))
        for (std::string* file :
             {&region.pictures.phi, &region.pictures.stiffness, &region.pictures.direction})
            files.push_back(file);
    return files;
}

std::string toJson(const Project& project) {
    return prettyJson(ProjectJson(project).whole());
}

void writeProject(const std::string& path, const Project& project, const std::string& folder) try {
    writeTextFile(path, toJson(rebased(project, path, folder)));
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
