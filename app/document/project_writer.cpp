#include <cmath>
#include <filesystem>

#include "app/document/json_text.h"
#include "app/document/options.h"
#include "app/document/project.h"
#include "app/document/text_file.h"
#include "core/mesh/error.h"

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

/// Puts the unknown keys back where they were, unless the object that they were in has gone.
Json withExtras(Json json, const Extras& extras) {
    for (const auto& [pointer, text] : extras) {
        const Json::json_pointer place(pointer);
        const Json::json_pointer parent = place.parent_pointer();
        if (json.contains(parent) && json[parent].is_object()) json[place] = Json::parse(text);
    }
    return json;
}

/// Whole numbers are written without ".0".
Json number(double value) {
    if (!std::isfinite(value)) throw InputError("a number is not finite and cannot be written");
    return value;
}

template <class Vector>
Json point(const Vector& v) {
    Json json = Json::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) json.push_back(number(v[i]));
    return json;
}

template <class Vector>
Json points(const std::vector<Vector>& all) {
    Json json = Json::array();
    for (const Vector& one : all) json.push_back(point(one));
    return json;
}

Json phiJson(double phi, int dim) {
    const std::string name = nameOfPhi(phi, dim);
    return name.empty() ? number(phi) : Json(name);
}

// --- Regions ---

template <int Dim>
Json regionJson(const Region<Dim>& region) {
    return std::visit(
        Overloaded{[](const Polygon& polygon) {
                       return Json{{"polygon", points(polygon.points)}};
                   },
                   [](const Ball<Dim>& ball) {
                       const Json inside{{"centre", point(ball.centre)}, {"radius", number(ball.radius)}};
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

Json outlineJson(const Domain& domain) {
    if (domain.outline == OutlineKind::Frame) return {{"from", "frame"}};
    if (domain.outline == OutlineKind::Polygons) {
        Json loops = Json::array();
        for (const auto& loop : domain.polygons.loops) loops.push_back(points(loop));
        return {{"polygons", loops}};
    }
    const AlphaOutlineOptions defaults;
    Json json{{"from", "alpha"},
              {"threshold", number(domain.alpha.threshold)},
              {"margin", number(domain.alpha.margin)}};
    if (domain.alpha.gap != defaults.gap) json["gap"] = number(domain.alpha.gap);
    if (domain.alpha.smallest != defaults.smallest) json["smallest"] = number(domain.alpha.smallest);
    if (domain.alpha.simplify != defaults.simplify) json["simplify"] = number(domain.alpha.simplify);
    return json;
}

void addCage(Json& json, const Domain& domain) {
    const Domain defaults;
    if (domain.fit == Fit::Automatic) return;
    Json cage = Json::object();
    if (domain.cageDetail != defaults.cageDetail) cage["detail"] = number(domain.cageDetail);
    if (domain.cageOffset != defaults.cageOffset) cage["offset"] = number(domain.cageOffset);
    json["cage"] = domain.fit == Fit::Cage && !cage.empty() ? cage : Json(domain.fit == Fit::Cage);
}

template <int Dim>
void addSizes(Json& json, const std::vector<SizeRegionIn<Dim>>& sizes) {
    for (const SizeRegionIn<Dim>& region : sizes) {
        Json one = Json::object();
        if (!region.name.empty()) one["name"] = region.name;
        one["shape"] = regionJson<Dim>(region.shape);
        if (region.feather != 0) one["feather"] = number(region.feather);
        one["factor"] = number(region.factor);
        json["sizes"].push_back(withExtras(std::move(one), region.extras));
    }
}

void addSurfaceKeys(Json& json, const Domain& domain) {
    const Domain defaults;
    if (domain.refineSurface) json["refineSurface"] = true;
    if (domain.repair && domain.largestHole != defaults.largestHole)
        json["repair"] = {{"largestHole", domain.largestHole}};
    else if (domain.repair)
        json["repair"] = true;
    addCage(json, domain);
    if (!domain.sizesFile.empty()) json["sizes"].push_back({{"values", domain.sizesFile}});
    addSizes<3>(json, domain.sizes);
}

Json domainJson(const Domain& domain) {
    Json json = Json::object();
    if (domain.kind == DomainKind::Image) {
        json["image"] = domain.path;
        json["outline"] = outlineJson(domain);
        if (domain.edge > 0)
            json["edge"] = number(domain.edge);
        else
            json["vertices"] = domain.vertices;
        addSizes<2>(json, domain.flatSizes);
        static const char* const borders[] = {"free", "fixed", "slide"};
        if (domain.border != Border::Free) json["border"] = borders[static_cast<int>(domain.border)];
    } else if (domain.kind == DomainKind::Mesh) {
        json["mesh"] = domain.path;
        if (!domain.texture.empty()) json["image"] = domain.texture;
    } else {
        json["surface"] = domain.path;
        json["quality"] = number(domain.quality);
        if (domain.maxVolume > 0)
            json["maxVolume"] = number(domain.maxVolume);
        else
            json["vertices"] = domain.vertices;
        addSurfaceKeys(json, domain);
    }
    if (domain.kind != DomainKind::Image && !domain.detail.empty()) json["detail"] = domain.detail;
    return json;
}

// --- Material ---

Json smoothingJson(const Smoothing& smoothing) {
    if (smoothing.kind == SmoothingKind::Paper)
        return {{"kind", "paper"}, {"lambda", number(smoothing.lambda)}};
    if (smoothing.kind == SmoothingKind::None) return {{"kind", "none"}};
    return {{"kind", "invariant"}, {"length", number(smoothing.length)}};
}

template <int Dim>
Json materialRegionJson(const MaterialRegion<Dim>& region) {
    Json json = Json::object();
    if (!region.name.empty()) json["name"] = region.name;
    json["shape"] = regionJson<Dim>(region.shape);
    if (region.feather != 0) json["feather"] = number(region.feather);
    if (region.phi) json["phi"] = phiJson(*region.phi, Dim);
    if (region.stiffness)
        json["stiffness"] = {{"axis", point(region.stiffness->axis)},
                             {"ratio", number(region.stiffness->ratio)}};
    return withExtras(std::move(json), region.extras);
}

template <int Dim>
Json cellsJson(const MaterialSpec<Dim>& spec) {
    Json json = Json::object();
    for (double phi : spec.cellPhi) json["phi"].push_back(number(phi));
    for (const Mat<Dim>& B : spec.cellB) {
        const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor> rows = B;
        json["B"].push_back(point(Eigen::Map<const Eigen::Matrix<double, Dim * Dim, 1>>(rows.data())));
    }
    return json;
}

template <int Dim>
Json materialJson(const MaterialSpec<Dim>& spec) {
    Json json{{"phi", phiJson(spec.phi, Dim)}, {"smoothing", smoothingJson(spec.smoothing)}};
    if (spec.memory != 0) json["memory"] = number(spec.memory);
    for (const auto& region : spec.regions) json["regions"].push_back(materialRegionJson(region));
    if (!spec.cellsFile.empty())
        json["cells"] = spec.cellsFile;
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
    static const char* const interpolations[] = {"bezier", "spline", "polyline"};
    static const char* const frames[] = {"none", "frenet", "minimal"};
    Json json{{"kind", "curve"},
              {"interpolation", interpolations[static_cast<int>(curve.interpolation)]},
              {"points", points(curve.points)},
              {"frame", frames[static_cast<int>(curve.frame)]}};
    if (curve.twist != 0) json["twist"] = number(curve.twist);
    if (curve.scale != 1) json["scale"] = number(curve.scale);
    return json;
}

template <int Dim>
Json rotateJson(const Rotate<Dim>& rotate) {
    Json json{{"kind", "rotate"}, {"centre", point(rotate.centre)}};
    if (Dim == 3) json["axis"] = point(rotate.axis);
    json["angle"] = number(rotate.angle);
    return json;
}

template <int Dim>
Json recordedJson(const Recorded<Dim>& stroke) {
    Json times = Json::array();
    for (double time : stroke.times) times.push_back(number(time));
    return {{"kind", "recorded"}, {"times", times}, {"points", points(stroke.points)}};
}

template <int Dim>
Json motionJson(const Motion<Dim>& motion) {
    static const char* const eases[] = {"linear", "in", "out", "inOut"};
    Json json = std::visit(Overloaded{[](const Translate<Dim>& move) {
                                          return Json{{"kind", "translate"}, {"by", point(move.by)}};
                                      },
                                      [](const Rotate<Dim>& rotate) { return rotateJson(rotate); },
                                      [](const CurveMotion<Dim>& curve) { return curveJson(curve); },
                                      [](const Recorded<Dim>& stroke) { return recordedJson(stroke); }},
                           motion.kind);
    json["time"] = Json::array({number(motion.start), number(motion.end)});
    if (motion.ease != Ease::Linear) json["ease"] = eases[static_cast<int>(motion.ease)];
    return withExtras(std::move(json), motion.extras);
}

/// An end that is open is null.
Json activeJson(double from, double to) {
    return Json::array({std::isfinite(from) ? Json(from) : Json(), std::isfinite(to) ? Json(to) : Json()});
}

template <int Dim>
Json handleJson(const Handle<Dim>& handle) {
    Json json = Json::object();
    if (!handle.name.empty()) json["name"] = handle.name;
    json["at"] = placementJson<Dim>(handle.at);
    if (std::isfinite(handle.activeFrom) || std::isfinite(handle.activeTo))
        json["active"] = activeJson(handle.activeFrom, handle.activeTo);
    for (const auto& motion : handle.motions) json["motion"].push_back(motionJson(motion));
    return withExtras(std::move(json), handle.extras);
}

template <int Dim>
void addDesign(Json& json, const Design<Dim>& design) {
    json["material"] = materialJson(design.material);
    json["handles"] = Json::array();
    for (const auto& handle : design.handles) json["handles"].push_back(handleJson(handle));
}

Json depthJson(const DepthRegion& region) {
    Json json = Json::object();
    if (!region.name.empty()) json["name"] = region.name;
    json["shape"] = regionJson<2>(region.shape);
    json["order"] = number(region.order);
    return withExtras(std::move(json), region.extras);
}

Json integrationJson(const IntegrationOptions& options) {
    static const char* const methods[] = {"dopri5", "rk4", "midpoint", "adams"};
    const IntegrationOptions defaults;
    Json json{{"method", methods[static_cast<int>(options.method)]},
              {"tolerance", number(options.tolerance)}};
    if (options.steps > 0) json["steps"] = options.steps;
    if (options.smallestStep != defaults.smallestStep) json["smallestStep"] = number(options.smallestStep);
    return json;
}

// --- Files ---

/// The file, which is named from folder `from`, as named from folder `to`.
std::string rebased(const std::string& file, const fs::path& from, const fs::path& to) {
    if (file.empty()) return file;
    const fs::path absolute = fs::absolute(from / file).lexically_normal();
    const fs::path relative = absolute.lexically_relative(fs::absolute(to).lexically_normal());
    return relative.empty() ? absolute.string() : relative.generic_string();
}

template <int Dim>
void rebaseCells(Design<Dim>& design, const fs::path& from, const fs::path& to) {
    design.material.cellsFile = rebased(design.material.cellsFile, from, to);
}

Project rebased(Project project, const std::string& path, const std::string& folder) {
    fs::path to = fs::path(path).parent_path();
    if (to.empty()) to = ".";
    const fs::path from = folder.empty() ? to : fs::path(folder);
    project.domain.path = rebased(project.domain.path, from, to);
    project.domain.texture = rebased(project.domain.texture, from, to);
    project.domain.sizesFile = rebased(project.domain.sizesFile, from, to);
    project.domain.detail = rebased(project.domain.detail, from, to);
    std::visit([&](auto& design) { rebaseCells(design, from, to); }, project.design);
    return project;
}

}  // namespace

std::string toJson(const Project& project) {
    Json json{{"format", "wend"}, {"version", 1}, {"domain", domainJson(project.domain)}};
    std::visit([&](const auto& design) { addDesign(json, design); }, project.design);
    for (const DepthRegion& region : project.depth) json["depth"].push_back(depthJson(region));
    for (const SettleWindow& window : project.settle)
        json["settle"].push_back({{"time", Json::array({number(window.start), number(window.end)})}});
    json["time"] = {{"end", number(project.end)}};
    json["integration"] = integrationJson(project.integration);
    return prettyJson(withExtras(std::move(json), project.extras));
}

void writeProject(const std::string& path, const Project& project, const std::string& folder) try {
    writeTextFile(path, toJson(rebased(project, path, folder)));
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
