#include "app/project/file/part_json.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/project/domain.h"
#include "app/project/file/design_reader.h"
#include "app/project/file/json_text.h"
#include "app/project/file/setting_json.h"
#include "app/project/project_fwd.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

/// The outline of a cut for which the file gives none.
const PartOutline kCutOutline{OutlineKind::Alpha, {}, {}};

Json pointJson(const Vec2& p) {
    return Json::array({numberJson(p.x()), numberJson(p.y())});
}

Json polygonsJson(const Outline& outline) {
    Json json = Json::array();
    for (const auto& loop : outline.loops) {
        Json points = Json::array();
        for (const Vec2& p : loop) points.push_back(pointJson(p));
        json.push_back(points);
    }
    return json;
}

std::string readText(const JsonValue& value, const char* problem) {
    std::string text = value.text();
    if (text.empty()) value.fail(problem);
    return text;
}

/// Reads and writes an outline by the settings of a whole picture, which has the same.
PartOutline readPartOutline(const JsonValue& value) {
    const auto scratch = newProject();
    readOutline(value, *scratch);
    const Domain& domain = domainOf(*scratch);
    return {domain.outline, domain.alpha, domain.polygons};
}

Json partOutlineJson(const PartOutline& outline) {
    const auto scratch = newProject();
    Domain& domain = domainOf(*scratch);
    domain.outline = outline.kind;
    domain.alpha = outline.alpha;
    domain.polygons = outline.polygons;
    return outlineJson(*scratch);
}

void readLayer(const JsonValue& value, PicturePart& part) {
    JsonObject object(value);
    part.path = readText(object.require("file"), "names no file");
    part.layer = readText(object.require("name"), "names no layer");
    object.finish();
}

void readCut(const JsonValue& value, PicturePart& part) {
    JsonObject object(value);
    part.cutFrom = object.require("from").text();
    part.cut = readPolygons(object.require("polygons"));
    if (auto feather = object.find("feather")) part.feather = feather->number("material.regions[].feather");
    if (auto fill = object.find("fill")) part.fill = fill->boolean();
    object.finish();
}

void readSource(JsonObject& object, PicturePart& part) {
    const std::string kind = object.oneOf({"image", "layer", "cut"});
    if (kind == "image") {
        part.path = readText(object.require("image"), "names no file");
        part.name = std::filesystem::path(part.path).stem().string();
    } else if (kind == "layer") {
        readLayer(object.require("layer"), part);
        part.name = part.layer;
    } else {
        readCut(object.require("cut"), part);
        part.outline = kCutOutline;
    }
}

BlendMode readBlendMode(const JsonValue& value) {
    constexpr std::array kModes{BlendMode::Normal, BlendMode::Multiply, BlendMode::Screen, BlendMode::Add};
    const std::string word = value.text();
    const auto mode = std::ranges::find(kModes, word, blendWord);
    if (mode == kModes.end()) value.fail("must be \"normal\", \"multiply\", \"screen\" or \"add\"");
    return *mode;
}

Joint readJoint(const JsonValue& value) {
    Joint joint;
    JsonObject object(value.ownedBy(joint.extras));
    joint.to = object.require("to").text();
    joint.at = object.require("at").flatPoint();
    if (auto radius = object.find("radius")) {
        joint.radius = radius->number();
        if (joint.radius < 0) radius->fail("must not be negative");
    }
    object.finish();
    return joint;
}

std::vector<PartOrder> readOrder(const JsonValue& value) {
    std::vector<PartOrder> order;
    for (const JsonValue& element : value.elements()) {
        JsonObject object(element);
        order.push_back({object.require("time").number(), object.require("place").number()});
        object.finish();
        if (order.size() > 1 && order[order.size() - 2].time >= order.back().time)
            element.fail("must be later than the one before");
    }
    return order;
}

PicturePart readPart(const JsonValue& value) {
    PicturePart part;
    JsonObject object(value.ownedBy(part.extras));
    readSource(object, part);
    if (auto name = object.find("name")) part.name = name->text();
    if (part.name.empty()) value.fail("has no name");
    if (auto outline = object.find("outline")) part.outline = readPartOutline(*outline);
    if (auto vertices = object.find("vertices")) part.vertices = vertices->integer("domain.vertices");
    if (auto at = object.find("at")) part.at = at->flatPoint();
    if (auto opacity = object.find("opacity")) {
        part.opacity = opacity->number();
        if (!(part.opacity >= 0 && part.opacity <= 1)) opacity->fail("must be in [0, 1]");
    }
    if (auto hidden = object.find("hidden")) part.hidden = hidden->boolean();
    if (auto locked = object.find("locked")) part.locked = locked->boolean();
    if (auto blend = object.find("blend")) part.blend = readBlendMode(*blend);
    if (auto order = object.find("order")) part.order = readOrder(*order);
    if (auto joints = object.find("joints"))
        for (const JsonValue& joint : joints->elements()) part.joints.push_back(readJoint(joint));
    if (auto rides = object.find("ridesOn")) part.ridesOn = rides->text();
    object.finish();
    return part;
}

/// Follows one kind of reference from part to part, which has to end.
void requireEnd(const std::vector<PicturePart>& parts, std::string PicturePart::*reference, const char* key,
                const std::vector<JsonValue>& values) {
    const auto place = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(parts, name, &PicturePart::name) - parts.begin());
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::size_t steps = 0;
        for (std::size_t at = i; !(parts[at].*reference).empty(); ++steps) {
            at = place(parts[at].*reference);
            if (at == parts.size())
                values[i].fail("`" + std::string(key) + "`: there is no part \"" + parts[i].*reference + '"');
            if (steps > parts.size())
                values[i].fail("`" + std::string(key) + "` leads back to the part \"" + parts[i].name + '"');
        }
    }
}

void requireJoints(const std::vector<PicturePart>& parts, const PicturePart& part, const JsonValue& value) {
    for (const Joint& joint : part.joints) {
        const auto to = std::ranges::find(parts, joint.to, &PicturePart::name);
        if (to == parts.end()) value.fail("`joints`: there is no part \"" + joint.to + '"');
        if (joint.to == part.name) value.fail("`joints`: \"" + part.name + "\" would be joined to itself");
        for (const PicturePart* one : {&part, &*to})
            if (!one->ridesOn.empty())
                value.fail("`joints`: \"" + one->name + "\" rides on another part and has no mesh");
    }
}

Json sourceJson(const PicturePart& part) {
    if (!part.cutFrom.empty()) {
        Json cut{{"from", part.cutFrom}, {"polygons", polygonsJson(part.cut)}};
        if (part.feather != 0) cut["feather"] = numberJson(part.feather);
        if (part.fill) cut["fill"] = true;
        return {{"cut", cut}};
    }
    if (part.layer.empty()) return {{"image", part.path}};
    return {{"layer", {{"file", part.path}, {"name", part.layer}}}};
}

Json partJson(const PicturePart& part) {
    Json json{{"name", part.name}};
    json.update(sourceJson(part));
    if (part.outline && (part.cutFrom.empty() || *part.outline != kCutOutline))
        json["outline"] = partOutlineJson(*part.outline);
    if (part.vertices > 0) json["vertices"] = part.vertices;
    if (part.at) json["at"] = pointJson(*part.at);
    if (part.opacity != 1) json["opacity"] = numberJson(part.opacity);
    if (part.hidden) json["hidden"] = true;
    if (part.locked) json["locked"] = true;
    if (part.blend) json["blend"] = blendWord(*part.blend);
    for (const PartOrder& order : part.order)
        json["order"].push_back({{"time", numberJson(order.time)}, {"place", numberJson(order.place)}});
    for (const Joint& joint : part.joints) {
        Json one{{"to", joint.to}, {"at", pointJson(joint.at)}};
        if (joint.radius > 0) one["radius"] = numberJson(joint.radius);
        json["joints"].push_back(withExtras(std::move(one), joint.extras));
    }
    if (!part.ridesOn.empty()) json["ridesOn"] = part.ridesOn;
    return withExtras(std::move(json), part.extras);
}

}  // namespace

void readOutline(const JsonValue& value, Project& project) {
    JsonObject object(value);
    Domain& domain = domainOf(project);
    if (object.oneOf({"from", "polygons"}) == "polygons") {
        domain.outline = OutlineKind::Polygons;
        domain.polygons = readPolygons(object.require("polygons"));
    } else {
        domain.outline = object.require("from").choice<OutlineKind>("domain.outline.from");
    }
    readSettings(object, "domain.outline", project);
    object.finish();
}

Json outlineJson(const Project& project) {
    Json json = Json::object();
    writeSettings(json, "domain.outline", project);
    const Domain& domain = domainOf(project);
    if (domain.outline == OutlineKind::Polygons)
        json["polygons"] = polygonsJson(domain.polygons);
    else
        json["from"] = wordOf("domain.outline.from", domain.outline);
    return json;
}

void readParts(const JsonValue& value, Domain& domain) {
    const std::vector<JsonValue> values = value.elements();
    if (values.empty()) value.fail("has no part");
    for (const JsonValue& element : values) {
        PicturePart part = readPart(element);
        if (std::ranges::find(domain.parts, part.name, &PicturePart::name) != domain.parts.end())
            element.fail("a part before it has the name \"" + part.name + "\", too");
        domain.parts.push_back(std::move(part));
    }
    requireEnd(domain.parts, &PicturePart::cutFrom, "cut", values);
    requireEnd(domain.parts, &PicturePart::ridesOn, "ridesOn", values);
    for (std::size_t i = 0; i < values.size(); ++i) requireJoints(domain.parts, domain.parts[i], values[i]);
    if (std::ranges::none_of(domain.parts, [](const PicturePart& part) { return part.ridesOn.empty(); }))
        value.fail("no part has a mesh: all ride on others");
}

Json partsJson(const Domain& domain) {
    Json json = Json::array();
    for (const PicturePart& part : domain.parts) json.push_back(partJson(part));
    return json;
}

}  // namespace wend
