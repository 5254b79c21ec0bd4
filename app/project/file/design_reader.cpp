#include "app/project/file/design_reader.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/file/guide_file.h"
#include "app/project/file/matrix_numbers.h"
#include "app/project/file/named_places.h"
#include "app/project/file/nearest_word.h"
#include "app/project/file/rgb_text.h"
#include "app/project/file/setting_json.h"
#include "app/project/project_fwd.h"
#include "core/base/error.h"
#include "core/mesh/decompositions.h"

namespace wend {
namespace {

Vec3 readDirection(const JsonValue& value) {
    const Vec3 direction = value.point();
    if (!(direction.stableNorm() > 0)) value.fail("must not be the zero vector");
    return direction;
}

double readPositive(const JsonValue& value) {
    const double number = value.number();
    if (number <= 0) value.fail(shortNumber(number) + " is out of range: it must be in ]0, ∞[");
    return number;
}

std::pair<double, double> readWindow(const JsonValue& value) {
    const std::vector<double> times = value.numbers();
    if (times.size() != 2) value.fail("must be two times, [from, to]");
    if (times[0] >= times[1])
        value.fail("the window is reversed or empty: it goes from " + shortNumber(times[0]) + " to " +
                   shortNumber(times[1]));
    return {times[0], times[1]};
}

/// Reads a window whose ends may be null for open.
void readActive(const JsonValue& value, Pin& handle) {
    const std::vector<JsonValue> ends = value.elements();
    if (ends.size() != 2) value.fail("must be two times, [from, to]");
    if (!ends[0].json().is_null()) handle.activeFrom = ends[0].number();
    if (!ends[1].json().is_null()) handle.activeTo = ends[1].number();
    if (handle.activeFrom >= handle.activeTo)
        value.fail("the window is reversed or empty: it goes from " + shortNumber(handle.activeFrom) +
                   " to " + shortNumber(handle.activeTo));
}

// --- Regions ---

Polygon readPolygon(const JsonValue& value) {
    Polygon polygon{value.flatPoints()};
    if (polygon.points.size() < 3) value.fail("needs at least 3 points");
    return polygon;
}

Ball<3> readBall(const JsonValue& value) {
    JsonObject object(value);
    Ball<3> ball{object.require("centre").point(), readPositive(object.require("radius"))};
    object.finish();
    return ball;
}

Box<3> readBox(const JsonValue& value) {
    JsonObject object(value);
    Box<3> box{object.require("min").point(), object.require("max").point()};
    const auto d = value.dimension();
    if ((box.min.head(d).array() >= box.max.head(d).array()).any())
        value.fail("min must be less than max in every coordinate");
    object.finish();
    return box;
}

HalfSpace<3> readHalfSpace(const JsonValue& value) {
    JsonObject object(value);
    HalfSpace<3> half{object.require("point").point(), readDirection(object.require("normal"))};
    object.finish();
    return half;
}

Blend<3> readBlend(const JsonValue& value) {
    JsonObject object(value);
    Blend<3> blend{object.require("from").point(), object.require("to").point()};
    if (blend.from == blend.to) value.fail("from and to are the same point");
    object.finish();
    return blend;
}

Region<3> readShape(const std::string& kind, const JsonValue& value) {
    if (kind == "polygon") return readPolygon(value);
    if (kind == "circle" || kind == "sphere") return readBall(value);
    if (kind == "box") return readBox(value);
    if (kind == "halfspace") return readHalfSpace(value);
    return readBlend(value);
}

// --- Material ---

void readSmoothing(const JsonValue& value, Project& project) {
    JsonObject object(value);
    object.require("kind");
    readSettings(object, "material.smoothing", project);
    object.finish();
}

Stiffness readStiffness(const JsonValue& value) {
    JsonObject object(value);
    Stiffness stiffness;
    const JsonValue axis = object.require("axis");
    if (auto wall = readWall(axis, axis.dimension()))
        stiffness.axis = Vec3::UnitX(), stiffness.wall = *wall;
    else
        stiffness.axis = readDirection(axis);
    stiffness.ratio = object.require("ratio").number("material.regions[].stiffness.ratio");
    if (auto within = object.find("within")) {
        stiffness.within = readPositive(*within);
        if (stiffness.wall.empty())
            within->fail("is the distance from a wall: it needs `axis` \"normal of GROUP\"");
    }
    object.finish();
    return stiffness;
}

MaterialPictures readPictures(const JsonValue& value) {
    JsonObject object(value);
    MaterialPictures pictures;
    for (const auto& [key, file] : {std::pair{"phi", &pictures.phi},
                                    {"stiffness", &pictures.stiffness},
                                    {"direction", &pictures.direction}})
        if (auto found = object.find(key)) *file = found->text();
    if (auto up = object.find("up")) pictures.up = up->boolean();
    object.finish();
    return pictures;
}

/// Reads what all regions have; `name` is that of their layer. Returns the value of the shape.
JsonValue readSoftRegion(JsonObject& object, std::string& name, SoftRegion& region) {
    if (auto given = object.find("name")) name = given->text();
    const JsonValue shape = object.require("shape");
    region.shape = readRegion(shape);
    if (auto part = object.find("part")) region.part = part->text();
    return shape;
}

void readFeather(JsonObject& object, SoftRegion& region) {
    if (auto feather = object.find("feather")) region.feather = feather->number("material.regions[].feather");
}

/// Adds a region to the last layer if it has that name and value, else in a layer of its own.
void add(SoftRegion region, const std::string& name, double value, ValueLayers& layers) {
    const bool continues =
        !name.empty() && !layers.empty() && layers.back().name == name && layers.back().value == value;
    if (!continues) layers.push_back({name, value, {}});
    layers.back().regions.push_back(std::move(region));
}

MaterialRegion readMaterialRegion(const JsonValue& value, std::string& name) {
    MaterialRegion region;
    JsonObject object(value.ownedBy(region.extras));
    readSoftRegion(object, name, region);
    readFeather(object, region);
    if (auto phi = object.find("phi")) region.phi = readPhi(*phi, phi->dimension());
    if (auto stiffness = object.find("stiffness")) region.stiffness = readStiffness(*stiffness);
    if (auto pictures = value.dimension() == 2 ? object.find("pictures") : std::nullopt) {
        region.pictures = readPictures(*pictures);
        if (!std::holds_alternative<Box<3>>(region.shape)) pictures->fail("need a box, which they fill");
        if (region.phi || region.stiffness) pictures->fail("stand in the place of phi and stiffness");
    }
    if (auto hidden = object.find("hidden")) region.hidden = hidden->boolean();
    if (auto leaves = object.find("leaves")) region.leaves = leaves->number("material.regions[].leaves");
    if (region.erases()) region.phi.reset(), region.stiffness.reset();  // see materialRegionJson()
    if (region.erases() && region.pictures.any()) value.fail("erases, and has pictures");
    if (!region.phi && !region.stiffness && !region.pictures.any() && !region.erases())
        value.warn("has neither phi nor stiffness and changes nothing");
    object.finish();
    return region;
}

/// Reads the numbers of a matrix, in one list or in a list of its rows.
std::vector<double> readMatrixNumbers(const JsonValue& value) {
    if (!value.json().is_array() || value.json().empty() || !value.json().front().is_array())
        return value.numbers();
    std::vector<double> numbers;
    for (const JsonValue& row : value.elements()) {
        const std::vector<double> own = row.numbers();
        if (own.size() != static_cast<std::size_t>(row.dimension()))
            row.fail("has " + std::to_string(own.size()) + " numbers where a row has " +
                     std::to_string(row.dimension()));
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
}

/// Returns a symmetric positive definite matrix: see matrixFrom().
Mat3 checkedAnisotropy(const std::vector<double>& numbers, const JsonValue& value) {
    const int d = value.dimension();
    const std::size_t all = static_cast<std::size_t>(d * d), half = symmetricNumbers(d);
    if (numbers.size() != all && numbers.size() != half)
        value.fail("has " + std::to_string(numbers.size()) + " numbers where a matrix needs " +
                   std::to_string(all) + ", or " + std::to_string(half) + " as it is symmetric");
    const Mat3 B = matrixFrom(numbers, d);
    if ((B - B.transpose()).cwiseAbs().maxCoeff() > 1e-12 * B.cwiseAbs().maxCoeff())
        value.fail("B is not symmetric");
    const double least = d == 2 ? symmetricEigenvalues<2>(B.topLeftCorner<2, 2>()).minCoeff()
                                : symmetricEigenvalues<3>(B).minCoeff();
    if (!(least > 0)) value.fail("B is not positive definite: its least eigenvalue is " + shortNumber(least));
    return B;
}

/// Reads one matrix per cell, each a list or a list of rows, or the numbers of all in one list: full matrices
/// if their count allows it, else symmetric ones.
std::vector<Mat3> readAnisotropies(const JsonValue& value) {
    std::vector<Mat3> all;
    const bool isPlain = value.json().is_array() && !value.json().empty() && value.json().front().is_number();
    if (!isPlain) {
        for (const JsonValue& element : value.elements())
            all.push_back(checkedAnisotropy(readMatrixNumbers(element), element));
        return all;
    }
    const std::vector<double> numbers = value.numbers();
    const std::size_t whole = static_cast<std::size_t>(value.dimension() * value.dimension()),
                      half = symmetricNumbers(value.dimension());
    const std::size_t each = numbers.size() % whole == 0 ? whole : half;
    if (numbers.size() % each != 0)
        value.fail("has " + std::to_string(numbers.size()) + " numbers, which is no multiple of " +
                   std::to_string(whole) + " or " + std::to_string(half));
    for (std::size_t i = 0; i < numbers.size(); i += each)
        all.push_back(checkedAnisotropy({numbers.begin() + static_cast<std::ptrdiff_t>(i),
                                         numbers.begin() + static_cast<std::ptrdiff_t>(i + each)},
                                        value));
    return all;
}

// --- Handles ---

std::vector<int> readVertexIds(const JsonValue& value) {
    std::vector<int> ids;
    for (const JsonValue& element : value.elements()) {
        ids.push_back(element.integer());
        if (ids.back() < 0) element.fail("a vertex number cannot be negative");
    }
    if (ids.empty()) value.fail("names no vertex");
    return ids;
}

/// "all", a list of axes, {"normal": […]}, or {"slide": "rest" or a file}, which is read later.
void readHold(const JsonValue& value, Pin& handle) {
    constexpr std::string_view kAxes = "xyz";
    if (value.json().is_string()) {
        if (value.text() != "all")
            value.fail("unknown value \"" + value.text() +
                       "\"; known are all, a list of axes, a normal, and a surface to slide on");
    } else if (value.json().is_array()) {
        unsigned held = 0;
        for (const JsonValue& element : value.elements()) {
            const std::string axis = element.text();
            const auto place = axis.size() == 1 ? kAxes.find(axis) : std::string_view::npos;
            if (place >= static_cast<std::size_t>(value.dimension()))
                element.fail("\"" + axis + "\" is not an axis of this project");
            held |= 1U << place;
        }
        if (held == 0) value.fail("names no axis");
        handle.slides = ((1U << value.dimension()) - 1) & ~held;
    } else {
        JsonObject object(value);
        if (object.oneOf({"normal", "slide"}) == "normal") {
            handle.normal = readNamedDirection(object.require("normal"));
        } else {
            const JsonValue slide = object.require("slide");
            handle.slide = Slide<3>{slide.text() == kRestSurface ? "" : slide.text(), nullptr};
            if (slide.text().empty()) slide.fail("names no file");
        }
        object.finish();
    }
}

/// Fails if a region has the key of a place that is none, such as a group.
void requireRegion(const JsonValue& region) {
    const std::vector<std::string> shapes = {"polygon", "circle", "sphere", "box", "halfspace", "blend"},
                                   places = {"group", "vertices", "points"};
    if (!region.json().is_object()) return;
    for (const auto& entry : region.json().items()) {
        const std::string place = meantKey(entry.key(), places);
        if (place.empty() || !meantKey(entry.key(), shapes).empty()) continue;
        region.fail(entry.key() == place
                        ? "`" + place + "` stands in place of `region`, not in it"
                        : "`" + entry.key() + "` is not known; `" + place + "`, in place of `region`?");
    }
}

/// Reads a place; a named one is resolved later.
Placement<3> readPlacement(const JsonValue& value, Pin& handle) {
    JsonObject object(value);
    if (auto part = object.find("part")) handle.part = part->text();
    const std::string kind = object.oneOf({"vertices", "points", "region", "group"});
    if (readNamedPlace(object, handle.extras)) return std::vector<int>();
    const JsonValue at = object.require(kind);
    object.finish();
    if (kind == "vertices") return readVertexIds(at);
    if (kind == "points") {
        auto points = at.points();
        if (points.empty()) at.fail("has no point");
        return points;
    }
    requireRegion(at);
    Region<3> region = readRegion(at);
    if (std::holds_alternative<Blend<3>>(region)) at.fail("a blend has no inside that could be a handle");
    return region;
}

std::string readMotionFile(JsonObject& object) {
    const JsonValue file = object.require("file");
    const std::string name = file.text();
    if (name.empty()) file.fail("names no file");
    return name;
}

Translate<3> readTranslate(JsonObject& object) {
    return {object.require("by").point()};
}

Rotate<3> readRotate(JsonObject& object) {
    Rotate<3> rotate;
    rotate.centre = object.require("centre").point();
    const bool isFlat = object.value().dimension() == 2;
    if (isFlat && object.has("axis"))
        object.require("axis").fail("is for rotations in 3D; in 2D they are about the centre");
    rotate.axis = isFlat ? Vec3::UnitZ() : readNamedDirection(object.require("axis"));
    rotate.angle = object.require("angle").number();
    return rotate;
}

void requireEnoughPoints(const CurveMotion<3>& curve, const JsonValue& points) {
    const std::size_t count = curve.points.size();
    if (curve.interpolation == Interpolation::Bezier && (count < 4 || count % 3 != 1))
        points.fail("a bezier is a chain of cubics and needs 4, 7, 10 … points, not " +
                    std::to_string(count));
    if (count < 2) points.fail("a curve needs at least 2 points");
}

CurveMotion<3> readCurve(JsonObject& object) {
    CurveMotion<3> curve;
    curve.interpolation =
        object.require("interpolation").choice<Interpolation>("handles[].motion[].interpolation");
    const JsonValue points = object.require("points");
    curve.points = points.points();
    requireEnoughPoints(curve, points);
    if (auto frame = object.find("frame")) curve.frame = frame->choice<FrameKind>("handles[].motion[].frame");
    if (auto twist = object.find("twist")) {
        curve.twist = twist->number();
        if (twist->dimension() == 2 && curve.twist != 0) twist->fail("is for curves in 3D");
    }
    if (auto scale = object.find("scale")) curve.scale = scale->number("handles[].motion[].scale");
    return curve;
}

Recorded<3> readRecorded(JsonObject& object) {
    Recorded<3> stroke;
    const JsonValue times = object.require("times"), points = object.require("points");
    stroke.times = times.numbers();
    stroke.points = points.points();
    if (stroke.times.size() < 2) times.fail("a recorded motion needs at least 2 times");
    if (stroke.times.size() != stroke.points.size())
        points.fail("has " + std::to_string(stroke.points.size()) + " points for " +
                    std::to_string(stroke.times.size()) + " times");
    for (std::size_t i = 1; i < stroke.times.size(); ++i)
        if (stroke.times[i] <= stroke.times[i - 1])
            times.fail("must increase, but " + shortNumber(stroke.times[i]) + " follows " +
                       shortNumber(stroke.times[i - 1]));
    return stroke;
}

/// Reads a field. Without a file it has the displacements themselves: `vertices` and `by`.
FieldMotion<3> readField(JsonObject& object) {
    FieldMotion<3> field;
    if (object.oneOf({"file", "vertices"}) == "file") {
        field.file = readMotionFile(object);
        if (auto array = object.find("array")) field.array = array->text();
        return field;
    }
    const JsonValue by = object.require("by");
    const std::vector<int> vertices = readVertexIds(object.require("vertices"));
    const std::vector<Vec3> displacements = by.points();
    if (displacements.size() != vertices.size())
        by.fail("has " + std::to_string(displacements.size()) + " displacements for " +
                std::to_string(vertices.size()) + " vertices");
    Displacements<3> values;
    for (std::size_t i = 0; i < vertices.size(); ++i) values.emplace_back(vertices[i], displacements[i]);
    std::ranges::sort(values, {}, &Displacements<3>::value_type::first);
    field.values = std::make_shared<const Displacements<3>>(std::move(values));
    return field;
}

/// Reads poses. Without a file it has the poses themselves: rows of time, position and rotation vector.
PoseMotion<3> readPoses(JsonObject& object) {
    PoseMotion<3> motion;
    motion.hasOwnTimes = !object.has("time");
    if (object.oneOf({"file", "poses"}) == "file") {
        motion.file = readMotionFile(object);
        return motion;
    }
    const JsonValue rows = object.require("poses");
    const bool isFlat = rows.dimension() == 2;
    const std::size_t columns = isFlat ? 4 : 7;
    for (const JsonValue& row : rows.elements()) {
        const std::vector<double> numbers = row.numbers();
        if (numbers.size() != columns)
            row.fail("has " + std::to_string(numbers.size()) + " numbers where a pose needs " +
                     std::to_string(columns) + ": time, position and " +
                     (isFlat ? "angle" : "rotation vector"));
        if (!motion.times.empty() && numbers[0] <= motion.times.back())
            row.fail("its time does not come after that of the pose before");
        motion.times.push_back(numbers[0]);
        if (isFlat)
            motion.poses.push_back({{numbers[1], numbers[2], 0}, {0, 0, numbers[3]}});
        else
            motion.poses.push_back(
                {Eigen::Map<const Vec3>(&numbers[1]), Eigen::Map<const Vec3>(&numbers[4])});
    }
    if (motion.poses.size() < 2) rows.fail("at least 2 poses are needed");
    return motion;
}

PinMotion readMotion(const JsonValue& value, double end) {
    PinMotion motion;
    motion.end = end;
    JsonObject object(value.ownedBy(motion.extras));
    if (auto time = object.find("time")) std::tie(motion.start, motion.end) = readWindow(*time);
    if (auto ease = object.find("ease")) motion.ease = ease->choice<Ease>("handles[].motion[].ease");
    const std::string kind = object.require("kind").choice("handles[].motion[].kind");
    if (kind == "translate") motion.kind = readTranslate(object);
    if (kind == "rotate") motion.kind = readRotate(object);
    if (kind == "curve") motion.kind = readCurve(object);
    if (kind == "recorded") motion.kind = readRecorded(object);
    if (kind == "field") motion.kind = readField(object);
    if (kind == "poses") motion.kind = readPoses(object);
    if (const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind))
        if (poses->hasOwnTimes && !poses->times.empty())
            std::tie(motion.start, motion.end) = std::pair(poses->times.front(), poses->times.back());
    object.finish();
    return motion;
}

std::vector<PinMotion> readMotions(const JsonValue& value, double end) {
    std::vector<PinMotion> motions;
    for (const JsonValue& element : value.elements()) {
        motions.push_back(readMotion(element, end));
        const std::size_t i = motions.size() - 1;
        const auto waitsForFile = [](const PinMotion& motion) {
            const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind);
            return poses && poses->hasOwnTimes && poses->times.empty();
        };
        if (i > 0 && !waitsForFile(motions[i]) && !waitsForFile(motions[i - 1]) &&
            motions[i].start < motions[i - 1].end)
            element.fail("begins at " + shortNumber(motions[i].start) +
                         ", before the one in front of it ends at " + shortNumber(motions[i - 1].end));
    }
    return motions;
}

std::optional<unsigned> readColour(const JsonValue& value) {
    const std::string text = value.text();
    const auto colour = rgbOf(text);
    if (!colour) value.fail("must be a colour like \"#d9822b\", not \"" + text + '"');
    return colour;
}

PinTraits readTraits(JsonObject& object) {
    PinTraits traits;
    if (auto locked = object.find("locked")) traits.locked = locked->boolean();
    if (auto hidden = object.find("hidden")) traits.hidden = hidden->boolean();
    if (auto group = object.find("group")) traits.group = group->text();
    if (auto link = object.find("link")) traits.link = link->integer("handles[].link");
    if (auto colour = object.find("colour")) traits.colour = readColour(*colour);
    return traits;
}

}  // namespace

Region<3> readRegion(const JsonValue& value) {
    JsonObject object(value);
    const std::string kind = value.dimension() == 2
                                 ? object.oneOf({"polygon", "circle", "box", "halfspace", "blend"})
                                 : object.oneOf({"sphere", "box", "halfspace", "blend"});
    const JsonValue shape = object.require(kind);
    object.finish();
    return readShape(kind, shape);
}

Outline readPolygons(const JsonValue& value) {
    Outline outline;
    for (const JsonValue& loop : value.elements()) {
        outline.loops.push_back(loop.flatPoints());
        if (outline.loops.back().size() < 3) loop.fail("needs at least 3 points");
    }
    if (outline.loops.empty()) value.fail("has no polygon");
    return outline;
}

void readSize(const JsonValue& value, ValueLayers& sizes) {
    std::string name;
    SoftRegion region;
    JsonObject object(value.ownedBy(region.extras));
    readSoftRegion(object, name, region);
    readFeather(object, region);
    const double factor = object.require("factor").number("domain.sizes[].factor");
    object.finish();
    add(std::move(region), name, factor, sizes);
}

void readDepth(const JsonValue& value, ValueLayers& depth) {
    std::string name;
    SoftRegion region;
    JsonObject object(value.ownedBy(region.extras));
    const JsonValue shape = readSoftRegion(object, name, region);
    if (std::holds_alternative<Blend<3>>(region.shape))
        shape.fail("a blend has no inside that could lie in front or behind");
    const double order = object.require("order").number("depth[].order");
    object.finish();
    add(std::move(region), name, order, depth);
}

void readCellValues(JsonObject& object, MaterialSpec& spec) {
    if (auto phi = object.find("phi"))
        for (const JsonValue& element : phi->elements())
            spec.cellPhi.push_back(readPhi(element, element.dimension()));
    if (auto matrices = object.find("B")) spec.cellB = readAnisotropies(*matrices);
    object.finish();
}

namespace {

/// Reads a file's name, one with the names of its fields, or the values themselves.
void readCellsKey(const JsonValue& value, MaterialSpec& spec) {
    if (value.json().is_string()) {
        spec.cellsFile = value.text();
        return;
    }
    JsonObject object(value);
    const auto file = object.find("file");
    if (!file) return readCellValues(object, spec);
    spec.cellsFile = file->text();
    if (auto phi = object.find("phi")) spec.cellsPhi = phi->text();
    if (auto B = object.find("B")) spec.cellsB = B->text();
    object.finish();
}

}  // namespace

void readMaterial(const JsonValue& value, Project& project) {
    MaterialSpec& spec = designOf(project).material;
    JsonObject object(value);
    readSettings(object, "material", project);
    if (auto smoothing = object.find("smoothing")) readSmoothing(*smoothing, project);
    if (auto regions = object.find("regions"))
        for (const JsonValue& element : regions->elements()) {
            std::string name;
            MaterialRegion region = readMaterialRegion(element, name);
            if (spec.layers.empty() || spec.layers.back().name != name) spec.layers.push_back({name, {}});
            spec.layers.back().regions.push_back(std::move(region));
        }
    if (auto cells = object.find("cells")) readCellsKey(*cells, spec);
    object.finish();
}

Pin readHandle(const JsonValue& value, double end) {
    Pin handle;
    JsonObject object(value.ownedBy(handle.extras));
    if (auto name = object.find("name")) handle.name = name->text();
    handle.at = readPlacement(object.require("at"), handle);
    if (auto active = object.find("active")) readActive(*active, handle);
    if (auto motion = object.find("motion")) handle.motions = readMotions(*motion, end);
    if (auto hold = object.find("hold")) readHold(*hold, handle);
    handle.traits = readTraits(object);
    object.finish();
    return handle;
}

}  // namespace wend
