#include "bench/paper_scenes.h"

namespace wend {
namespace {

using Variants = std::vector<PaperScene::Variant>;

const Variants kEnergies{{"EQUIA", "{'phi': 'equia'}"},
                         {"METR", "{'phi': 'metr'}"},
                         {"AKVF", "{'phi': 'akvf'}"},
                         {"CONF", "{'phi': 'conf'}"}};
const Variants kSmoothings{{"none", "{'phi': 'metr', 'smoothing': {'kind': 'none'}}"},
                           {"the paper's", "{'phi': 'metr', 'smoothing': {'kind': 'paper', 'lambda': 0.1}}"},
                           {"invariant", "{'phi': 'metr'}"}};
// φ along the strip: from Area at the left end to Angle at the right one.
const Variants kBlend{{"EQUIA to CONF",
                       "{'phi': 'equia', 'regions': [{'shape': {'blend': {'from': [0, 0.5], 'to': [4, "
                       "0.5]}}, 'phi': 'conf'}]}"}};
const Variants kStiffness{
    {"plain", "{'phi': 'metr'}"},
    {"lengthwise",
     "{'phi': 'metr', 'regions': [{'shape': {'box': {'min': [1.333, -1], 'max': [2.667, 2]}}, "
     "'stiffness': {'axis': [1, 0], 'ratio': 20}}]}"},
    {"across",
     "{'phi': 'metr', 'regions': [{'shape': {'box': {'min': [1.333, -1], 'max': [2.667, 2]}}, "
     "'stiffness': {'axis': [0, 1], 'ratio': 20}}]}"}};

// The middle line of the strip or bar moves to a circle: half of one, or a quarter.
const std::string
    kFlatEnds =
        "{'name': 'left', 'at': {'region': {'box': {'min': [-1, -1], 'max': [1e-6, 2]}}}}, "
        "{'name': 'right', 'at': {'region': {'box': {'min': [3.999999, -1], 'max': [5, 2]}}}, ",
    kSolidEnds =
        "{'name': 'left', 'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [1e-6, 2, 2]}}}}, "
        "{'name': 'right', 'at': {'region': {'box': {'min': [3.999999, -1, -1], 'max': [5, 2, 2]}}}, ";
const std::string kHalfCircle =
                      "[" + kFlatEnds +
                      "'motion': [{'kind': 'rotate', 'centre': [2, 1.7732395], 'angle': 3.14159265}]}]",
                  kStretch = "[" + kFlatEnds + "'motion': [{'kind': 'translate', 'by': [2, 0]}]}]",
                  kTwist = "[" + kSolidEnds +
                           "'motion': [{'kind': 'rotate', 'centre': [4, 0.5, 0.5], 'axis': [1, 0, 0], "
                           "'angle': 3.14159265}]}]",
                  kQuarterCircle =
                      "[" + kSolidEnds +
                      "'motion': [{'kind': 'rotate', 'centre': [2, 1.0464791, 0.5], 'axis': [0, 0, 1], "
                      "'angle': 1.57079633}]}]";
const std::string kOnePoint =
    "[{'name': 'left', 'at': {'region': {'box': {'min': [-1, -1], 'max': [1e-6, 2]}}}}, "
    "{'name': 'pulled', 'at': {'points': [[0.75, 0.5]]}, 'motion': [{'kind': 'translate', 'by': [0.12, "
    "0.16]}]}]";
const std::string kOneSolidPoint =
    "[{'name': 'left', 'at': {'region': {'box': {'min': [-1, -1, -1], 'max': [1e-6, 2, 2]}}}}, "
    "{'name': 'pulled', 'at': {'points': [[0.75, 0.5, 0.5]]}, 'motion': [{'kind': 'translate', 'by': [0.1, "
    "0.15, "
    "0.05]}]}]";
// Anywhere in the strip, not at vertices; on a line, a curve and an arc.
const std::string kPins =
    "[{'name': 'left', 'at': {'points': [[0.21, 0.33], [0.17, 0.71]]}}, "
    "{'name': 'first', 'at': {'points': [[1.4, 0.43]]}, 'motion': [{'kind': 'translate', 'by': [0.1, "
    "-0.5]}]}, "
    "{'name': 'second', 'at': {'points': [[2.63, 0.57]]}, 'motion': [{'kind': 'curve', 'interpolation': "
    "'bezier', 'points': [[2.63, 0.57], "
    "[2.6, 0.9], [2.5, 1.2], [2.3, 1.3]]}]}, "
    "{'name': 'third', 'at': {'points': [[3.77, 0.39]]}, 'motion': [{'kind': 'rotate', 'centre': [2.9, 0.5], "
    "'angle': 1.1}]}]";
const std::string kArms =
    "[{'name': 'feet', 'at': {'region': {'box': {'min': [-2, -2], 'max': [2, -0.95]}}}}, "
    "{'name': 'arm', 'at': {'region': {'circle': {'centre': [1.38, 0.45], 'radius': 0.3}}}, 'motion': "
    "[{'kind': "
    "'rotate', 'centre': [0.45, 0.15], 'angle': 1.3}]}, "
    "{'name': 'head', 'at': {'region': {'circle': {'centre': [0, 1.45], 'radius': 0.3}}}, 'motion': "
    "[{'kind': "
    "'rotate', 'centre': [0, 0.4], 'angle': 0.9}]}]";
const std::string kLiftedArms =
    "[{'name': 'feet', 'at': {'region': {'box': {'min': [-2, -2, -1], 'max': [2, -0.95, 2]}}}}, "
    "{'name': 'arm', 'at': {'region': {'sphere': {'centre': [1.38, 0.45, 0.25], 'radius': 0.4}}}, 'motion': "
    "[{'kind': "
    "'rotate', 'centre': [0.45, 0.15, 0.25], 'axis': [0.31, -0.95, 0], 'angle': 1.4}]}, "
    "{'name': 'head', 'at': {'region': {'sphere': {'centre': [0, 1.45, 0.25], 'radius': 0.4}}}, 'motion': "
    "[{'kind': "
    "'rotate', 'centre': [0, 0.4, 0.25], 'axis': [0, 1, 0], 'angle': 1.6}]}]";

std::vector<std::string> all(const std::string& scene, const std::vector<std::string>& variants) {
    std::vector<std::string> rows;
    for (const std::string& variant : variants) rows.push_back(scene + "/" + variant);
    return rows;
}

std::vector<PaperClaim> makeClaims() {
    std::vector<PaperClaim> claims;
    const auto claim = [&](const std::string& what, const std::string& figure,
                           const std::vector<std::string>& rising) {
        claims.push_back({what, figure, rising});
    };
    for (const char* scene : {"strip", "star", "bent bar", "thick star"}) {
        claim("of the four energies EQUIA keeps measures best and CONF least", "volume",
              all(scene, {"EQUIA", "METR", "AKVF", "CONF"}));
        claim("CONF keeps angles best and EQUIA least", "angle",
              all(scene, {"CONF", "AKVF", "METR", "EQUIA"}));
        for (const char* other : {"EQUIA", "AKVF", "CONF"})
            claim("METR keeps lengths best", "metric", all(scene, {"METR", other}));
    }
    claim("of the four energies EQUIA keeps measures best and CONF least", "volume",
          all("twisted bar", {"EQUIA", "METR", "AKVF", "CONF"}));
    claim("a twist is nearly the same for all but EQUIA, which pays in angles", "angle",
          all("twisted bar", {"CONF", "METR", "EQUIA"}));
    for (const char* scene : {"square", "cube"})
        for (const char* kind : {"the paper's", "invariant"})
            claim("smoothness spreads the error about a point", "worst 1 %", all(scene, {kind, "none"}));
    claim("blended φ lies between its ends", "volume",
          {"strip/EQUIA", "blended strip/EQUIA to CONF", "strip/CONF"});
    claim("blended φ lies between its ends", "angle",
          {"strip/CONF", "blended strip/EQUIA to CONF", "strip/EQUIA"});
    claim("a middle that is stiff lengthwise is not stretched, one that is stiff across is",
          "metric, middle third", all("stretched strip", {"lengthwise", "plain", "across"}));
    // A twist changes no volume to first order: what is left is the mesh.
    for (const char* scene : {"bent bar", "thick star"})
        for (const char* other : {"METR", "AKVF", "CONF"})
            claim("EQUIA keeps the volume of the whole best", "whole measure's change",
                  all(scene, {"EQUIA", other}));
    return claims;
}

}  // namespace

const std::vector<PaperScene>& paperScenes() {
    static const std::vector<PaperScene> scenes{
        {"strip", "figures 1 and 5", "strip", 2, kHalfCircle, kEnergies},
        {"star", "figure 5", "star", 2, kArms, kEnergies},
        {"square", "figure 3", "square", 2, kOnePoint, kSmoothings},
        {"cube", "figure 3", "cube", 3, kOneSolidPoint, kSmoothings},
        {"pinned strip", "figure 6", "strip", 2, kPins, kEnergies},
        {"blended strip", "figure 7", "strip", 2, kHalfCircle, kBlend},
        {"stretched strip", "figure 7", "strip", 2, kStretch, kStiffness, true},
        {"twisted bar", "figures 8 to 10", "bar", 3, kTwist, kEnergies},
        {"bent bar", "figures 8 to 10", "bar", 3, kQuarterCircle, kEnergies},
        {"thick star", "figures 8 to 10", "thick star", 3, kLiftedArms, kEnergies}};
    return scenes;
}

const std::vector<PaperClaim>& paperClaims() {
    static const std::vector<PaperClaim> claims = makeClaims();
    return claims;
}

}  // namespace wend
