#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/output/report.h"
#include "app/output/run.h"
#include "app/project/file/json_text.h"
#include "app/project/options/options.h"
#include "core/energy/distortion.h"
#include "core/mesh/cell_shape.h"
#include "core/motion/reach.h"

namespace wend {

using Json = nlohmann::ordered_json;

std::vector<HandleReach> reachedAt(const Design& design, double time) {
    std::vector<HandleReach> all;
    for (const Pin& handle : design.handles) all.push_back({handle.name, reachOf(handleIn<3>(handle), time)});
    return all;
}

std::string fallsShort(const Project& project) {
    constexpr double kRounding = 1e-9;
    const double end = endOf(project);
    const auto reached = reachedAt(designOf(project), end);
    const auto least = std::ranges::min_element(reached, {}, &HandleReach::share);
    if (least == reached.end() || least->share >= 1 - kRounding) return {};
    const auto others = std::ranges::count_if(
        reached, [](const HandleReach& handle) { return handle.share < 1 - kRounding; });
    const std::string name =
        least->name.empty() ? std::to_string(least - reached.begin()) : '"' + least->name + '"';
    const std::string more = others == 1 ? "" : ", and " + std::to_string(others - 1) + " more fall short";
    return "handle " + name + " reaches only " + shortNumber(std::floor(1000 * least->share) / 10) +
           " % of its motion, because the project ends at " + shortNumber(end) + " (time.end)" + more;
}

std::string reportJson(const RunFigures& figures) {
    const Distortion& distortion = figures.distortion;
    const Statistics& counts = figures.statistics;
    Json json{{"vertices", figures.vertices}, {"cells", figures.cells},     {"dimension", figures.dimension},
              {"time", figures.time},         {"backend", figures.backEnd}, {"device", figures.device}};
    json["solver"] = figures.solver;
    json["errors"] = {{"angle", distortion.totalAngle},
                      {"volume", distortion.totalVolume},
                      {"metric", distortion.totalMetric}};
    json["flips"] = distortion.flips;
    json["minDet"] = distortion.minDet;
    json["constraintError"] = counts.constraintError;
    json["steps"] = counts.steps;
    json["rejected"] = counts.rejected;
    json["evaluations"] = counts.evaluations;
    json["factorizations"] = counts.factorizations;
    json["solverIterations"] = counts.solverIterations;
    json["needs"] = counts.needed;
    json["restEnergy"] = figures.restEnergy;
    json["restForce"] = figures.restForce;
    json["seconds"] = {{"analyze", counts.analyze},     {"assemble", counts.assemble},
                       {"factor", counts.factor},       {"solve", counts.solve},
                       {"integrate", counts.integrate}, {"total", figures.total}};
    json["energy"] = counts.energy;
    json["errorEstimate"] = counts.errorEstimate > 0 ? Json(counts.errorEstimate) : Json();
    json["reached"] = Json::array();
    for (const HandleReach& handle : figures.reached)
        json["reached"].push_back({{"name", handle.name}, {"reached", handle.share}});
    json["notices"] = figures.notices;
    json["cellQuality"] = Json::parse(figures.quality);
    json.update(Json::parse(figures.faults));
    if (figures.cage) json["cage"] = Json::parse(cageJson(*figures.cage));
    if (figures.verdict) json["quality"] = Json::parse(verdictJson(*figures.verdict));
    if (const auto& canvas = figures.canvas) {
        json["canvas"] = {{"x", canvas->origin.x()},
                          {"y", canvas->origin.y()},
                          {"width", canvas->width},
                          {"height", canvas->height}};
        if (canvas->scale != 1) json["canvas"]["scale"] = 1 / canvas->scale;
    }
    return prettyJson(json);
}

std::string canvasText(const View& canvas) {
    return "the canvas of " + std::to_string(canvas.width) + " x " + std::to_string(canvas.height) +
           " pixels begins at x " + shortNumber(canvas.origin.x()) + ", y " + shortNumber(canvas.origin.y()) +
           " of the picture";
}

std::string verdictJson(const MeshVerdict& verdict) {
    const Json json{{"asked", verdict.asked},
                    {"got", std::isfinite(verdict.got) ? Json(verdict.got) : Json()},
                    {"worstCell", verdict.worstCell},
                    {"cellsAbove", verdict.cellsAbove},
                    {"facets", verdict.facets}};
    return json.dump();
}

std::string cageJson(const CageFacts& cage) {
    Json json{{"edge", cage.edge}, {"bodies", cage.bodies}, {"parts", cage.parts}, {"apart", cage.apart}};
    for (const ClosedGap& gap : cage.gaps)
        json["gaps"].push_back(
            {{"place", {gap.place.x(), gap.place.y(), gap.place.z()}}, {"width", gap.width}});
    if (!cage.why.isEmpty()) json["why"] = cage.why.text();
    return json.dump();
}

template <int Dim>
std::string faultsJson(const PoseFaults<Dim>& faults) {
    const auto at = [](const Vec<Dim>& p) { return std::vector<double>(p.begin(), p.end()); };
    Json first, worst;
    if (!faults.crossings.empty()) first = at(faults.crossings.front().at);
    if (!faults.blown.empty()) {
        const PosePlace<Dim>& place = faults.blown.front();
        worst = {{"cell", place.worstCell}, {"ratio", place.ratio}, {"at", at(place.at)}};
    }
    const Json json{
        {"selfCrossings", {{"places", faults.crossings.size()}, {"pairs", faults.pairs()}, {"first", first}}},
        {"blownUp",
         {{"factor", kBlownUp},
          {"cells", faults.cells()},
          {"places", faults.blown.size()},
          {"worst", worst}}}};
    return json.dump();
}
template std::string faultsJson<2>(const PoseFaults<2>&);
template std::string faultsJson<3>(const PoseFaults<3>&);

namespace {

/// Returns the worst value of one measure, its cell, and the mean. `sign` is 1 if small values are bad, −1 if
/// large ones are.
Json measureJson(const std::vector<CellShape>& shapes, double CellShape::*measure, double factor, int sign) {
    if (shapes.empty()) return {};
    const auto worst =
        std::ranges::min_element(shapes, {}, [&](const CellShape& shape) { return sign * (shape.*measure); });
    double sum = 0;
    for (const CellShape& shape : shapes) sum += factor * (shape.*measure);
    const auto finite = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
    return {{"worst", finite(factor * ((*worst).*measure))},
            {"cell", worst - shapes.begin()},
            {"mean", finite(sum / static_cast<double>(shapes.size()))}};
}

Json shapesJson(const std::vector<CellShape>& shapes) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    return {{"scaledJacobian", measureJson(shapes, &CellShape::scaledJacobian, 1, 1)},
            {"aspectRatio", measureJson(shapes, &CellShape::aspectRatio, 1, -1)},
            {"minAngle", measureJson(shapes, &CellShape::minAngle, kDegrees, 1)},
            {"maxAngle", measureJson(shapes, &CellShape::maxAngle, kDegrees, -1)}};
}

}  // namespace

template <int Dim>
std::string qualityJson(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    const Json json{{"before", shapesJson(cellShapes<Dim>(rest.points, rest.cells))},
                    {"after", shapesJson(cellShapes<Dim>(pose, rest.cells))}};
    return json.dump();
}
template std::string qualityJson<2>(const SimplicialMesh<2>&, const Points2&);
template std::string qualityJson<3>(const SimplicialMesh<3>&, const Points3&);

std::string summaryText(const Statistics& statistics, const IntegrationOptions& integration) {
    const std::string steps = std::to_string(statistics.steps) + (statistics.steps == 1 ? " step" : " steps");
    if (integration.steps > 0 || statistics.errorEstimate == 0) return steps;
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), statistics.errorEstimate,
                                   std::chars_format::scientific, 0);
    return steps + "; their errors add up to about " + std::string(digits.data(), end.ptr) +
           " of the size (the tolerance of " + shortNumber(integration.tolerance) + " is for one step)";
}

}  // namespace wend
