#include <nlohmann/json.hpp>

#include "app/document/json_text.h"
#include "app/session/run.h"

namespace wend {

std::string reportJson(const RunFigures& figures) {
    using Json = nlohmann::ordered_json;
    const Distortion& distortion = figures.distortion;
    const Statistics& counts = figures.statistics;
    Json json{{"vertices", figures.vertices}, {"cells", figures.cells},     {"dimension", figures.dimension},
              {"time", figures.time},         {"backend", figures.backEnd}, {"device", figures.device}};
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
    json["restEnergy"] = figures.restEnergy;
    json["restForce"] = figures.restForce;
    json["seconds"] = {{"analyze", counts.analyze},     {"assemble", counts.assemble},
                       {"factor", counts.factor},       {"solve", counts.solve},
                       {"integrate", counts.integrate}, {"total", figures.total}};
    json["energy"] = counts.energy;
    return prettyJson(json);
}

}  // namespace wend
