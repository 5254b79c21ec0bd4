#include "app/project/file/named_places.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <set>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/mesh/group_normal.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kPlace = "/at", *kAxis = "/axis", *kHeld = "/hold/normal";
constexpr std::string_view kNormalOf = "normal of ";

std::string* nameAt(Extras& extras, std::string_view at) {
    for (auto& [pointer, text] : extras)
        if (pointer == at) return &text;
    return nullptr;
}

/// Numbers between blanks or commas; # begins a comment.
std::vector<int> readIds(const std::string& path) {
    const std::string text = readTextFile(path);
    std::vector<int> ids;
    int line = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (c == ',' || c == ';' || static_cast<unsigned char>(c) <= ' ') {
            ++at;
        } else {
            const std::size_t end = std::min(text.find_first_of(" \t\r\n,;#", at), text.size());
            int id = -1;
            const auto done = std::from_chars(text.data() + at, text.data() + end, id);
            if (done.ec != std::errc() || done.ptr != text.data() + end || id < 0)
                throw InputError(path, "line " + std::to_string(line) + ": \"" +
                                           text.substr(at, std::min<std::size_t>(end - at, 20)) +
                                           "\" is not a vertex number");
            ids.push_back(id);
            at = end;
        }
    }
    if (ids.empty()) throw InputError(path, "names no vertex");
    return ids;
}

/// Returns the places of vertices of a surface that is repaired before it is meshed, because its vertices get
/// other numbers.
std::vector<Vec3> placesOf(const std::vector<int>& vertices, const Eigen::Matrix3Xd& points) {
    std::set<std::array<double, 3>> known;
    std::vector<Vec3> places;
    for (const int v : vertices)
        if (known.insert({points(0, v), points(1, v), points(2, v)}).second)
            places.emplace_back(points.col(v).head<3>());
    return places;
}

class PlaceFinder {
  public:
    PlaceFinder(const Project& project, const std::string& folder)
        : m_domain(project.domain), m_dimension(project.dimension()), m_folder(folder) {}

    int dimension() const { return m_dimension; }

    std::optional<Placement<3>> find(const Json& name) {
        if (name.contains("vertices")) return readIds(pathIn(m_folder, name["vertices"].get<std::string>()));
        if (m_domain.kind == DomainKind::Image)
            throw InputError("`group` is for meshes and surfaces: a picture has no groups");
        if (!m_file && !readMesh()) return std::nullopt;
        std::optional<int> dimension;
        if (name.contains("dimension")) dimension = name["dimension"].get<int>();
        std::vector<int> vertices = groupVertices(*m_file, name["group"].get<std::string>(), dimension);
        if (m_domain.kind == DomainKind::Surface && (m_domain.repair || !m_domain.fixes.empty()))
            return placesOf(vertices, pointsOf(*m_file));
        return vertices;
    }

    /// Returns the mean normal of a group.
    std::optional<Vec3> normalOf(const std::string& group) {
        if (m_domain.kind == DomainKind::Image)
            throw InputError("normals of groups are for meshes and surfaces: a picture has no groups");
        if (!m_file && !readMesh()) return std::nullopt;
        if (m_dimension == 2) return inSpace(groupNormal<2>(*m_file, group));
        return groupNormal<3>(*m_file, group);
    }

    /// Returns the facets of a group.
    std::shared_ptr<const GuideMesh<3>> wallOf(const std::string& group) {
        if (m_domain.kind == DomainKind::Image)
            throw InputError("normals of groups are for meshes and surfaces: a picture has no groups");
        if (!m_file && !readMesh()) return nullptr;
        auto wall = std::make_shared<GuideMesh<3>>();
        if (m_dimension == 2) {
            const GroupFacets<2> found = groupFacets<2>(*m_file, group);
            wall->points = Points3::Zero(3, found.points.cols());
            wall->points.topRows<2>() = found.points;
            wall->segments = found.facets;
        } else {
            const GroupFacets<3> found = groupFacets<3>(*m_file, group);
            wall->points = found.points;
            wall->triangles = found.facets;
        }
        return wall;
    }

  private:
    bool readMesh() {
        try {
            m_file = sharedMeshFile(pathIn(m_folder, m_domain.path));
        } catch (const InputError&) {
            return false;
        }
        return true;
    }

    const Domain& m_domain;
    int m_dimension;
    const std::string& m_folder;
    std::shared_ptr<const MeshFile> m_file;
};

Json asJson(const Placement<3>& place) {
    if (const auto* ids = std::get_if<std::vector<int>>(&place)) return {{"vertices", *ids}};
    Json points = Json::array();
    if (const auto* all = std::get_if<std::vector<Vec3>>(&place))
        for (const Vec3& p : *all) points.push_back(std::vector<double>(p.begin(), p.end()));  // of surfaces
    return {{"points", points}};
}

Json directionJson(const Vec3& p, int dimension) {
    return std::vector<double>(p.begin(), p.begin() + dimension);
}

/// Finds a direction whose name is in the extras.
void findDirection(Extras& extras, const char* pointer, PlaceFinder& finder, Vec3& direction) {
    std::string* text = nameAt(extras, pointer);
    if (!text) return;
    Json named = Json::parse(*text);
    const auto normal = finder.normalOf(named["name"].get<std::string>().substr(kNormalOf.size()));
    if (normal) direction = *normal;
    named["as"] = directionJson(direction, finder.dimension());
    *text = named.dump();
}

void findDirections(Pin& handle, const std::string& where, PlaceFinder& finder) {
    std::string key = "hold.normal";
    try {
        if (handle.normal) findDirection(handle.extras, kHeld, finder, *handle.normal);
        for (std::size_t m = 0; m < handle.motions.size(); ++m) {
            key = "motion[" + std::to_string(m) + "].axis";
            if (auto* rotate = std::get_if<Rotate<3>>(&handle.motions[m].kind))
                findDirection(handle.motions[m].extras, kAxis, finder, rotate->axis);
        }
    } catch (const InputError& error) {
        throw InputError(where + "." + key + ": " + error.message());
    }
}

void findWalls(std::vector<MaterialLayer>& layers, PlaceFinder& finder) {
    int place = -1;  // in the file's list
    for (MaterialRegion& region : regionsOf(layers)) {
        ++place;
        if (!region.stiffness || region.stiffness->wall.empty()) continue;
        try {
            region.stiffness->facets = finder.wallOf(region.stiffness->wall);
        } catch (const InputError& error) {
            throw InputError("material.regions[" + std::to_string(place) +
                             "].stiffness.axis: " + error.message());
        }
    }
}

}  // namespace

void findNamedPlaces(Project& project, const std::string& folder) {
    PlaceFinder finder(project, folder);
    findWalls(designOf(project).material.layers, finder);
    auto& handles = designOf(project).handles;
    for (std::size_t h = 0; h < handles.size(); ++h) {
        const std::string where = "handles[" + std::to_string(h) + "]";
        findDirections(handles[h], where, finder);
        std::string* text = nameAt(handles[h].extras, kPlace);
        if (!text) continue;
        Json named = Json::parse(*text);
        try {
            if (const auto place = finder.find(named["name"])) handles[h].at = *place;
        } catch (const InputError& error) {
            throw InputError(where + ".at: " + (error.file().empty() ? "" : error.file() + ": ") +
                             error.message());
        }
        named["as"] = asJson(handles[h].at);
        *text = named.dump();
    }
}

namespace {

[[noreturn]] void failAsDirection(const JsonValue& value, int dimension) {
    value.fail("must be a direction, such as " + std::string(dimension == 2 ? "[0, 1]" : "[0, 0, 1]") +
               ", or \"normal of GROUP\"");
}

}  // namespace

std::optional<std::string> readWall(const JsonValue& value, int dimension) {
    if (!value.json().is_string()) return std::nullopt;
    const std::string name = value.text();
    if (!name.starts_with(kNormalOf) || name.size() == kNormalOf.size()) failAsDirection(value, dimension);
    return name.substr(kNormalOf.size());
}

std::string wallText(const std::string& group) {
    return std::string(kNormalOf) + group;
}

Vec3 readNamedDirection(const JsonValue& value) {
    if (const auto group = readWall(value, value.dimension())) {
        value.keepName({{"name", wallText(*group)}});
        return Vec3::Zero();
    }
    if (!value.json().is_array()) failAsDirection(value, value.dimension());
    const Vec3 direction = value.point();
    if (!(direction.stableNorm() > 0)) value.fail("must not be the zero vector");
    return direction;
}

void putNamedDirection(Json& json, const Extras& extras, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    if (!json.contains(place)) return;
    for (const auto& [at, text] : extras) {
        if (at != pointer) continue;
        const Json named = Json::parse(text);
        if (named.is_object() && named.contains("as") && named["as"] == json[place])
            json[place] = named["name"];
    }
}

void placeOnGroup(Pin& handle, const std::string& group, int dimension, const std::vector<int>& vertices) {
    handle.at = vertices;
    const Json named{{"name", {{"group", group}, {"dimension", dimension}}}, {"as", asJson(handle.at)}};
    handle.extras.emplace_back(kPlace, named.dump());
}

Extras withoutNames(Extras extras) {
    std::erase_if(extras, [](const auto& extra) {
        if (extra.first == kPlace || extra.first == kHeld) return true;
        const Json value = extra.first == kAxis ? Json::parse(extra.second) : Json();
        return value.is_object() && value.contains("name");  // and no unknown key of that name
    });
    return extras;
}

bool readNamedPlace(JsonObject& at, Extras& extras) {
    Json name;
    if (auto group = at.find("group")) {
        name["group"] =
            group->json().is_number_integer() ? std::to_string(group->json().get<long>()) : group->text();
        if (auto dimension = at.find("dimension")) {
            const int number = dimension->integer();
            if (number < 0 || number > 3)
                dimension->fail("must be 0 (vertices), 1 (lines), 2 (surfaces) or 3 (volumes)");
            name["dimension"] = number;
        }
    } else if (at.has("vertices") && at.value().json()["vertices"].is_string()) {
        name["vertices"] = at.require("vertices").text();
    } else {
        return false;
    }
    at.finish();
    extras.emplace_back(kPlace, Json{{"name", name}}.dump());
    return true;
}

std::optional<Json> nameOfPlace(const Extras& extras, const Json& place) {
    for (const auto& [pointer, text] : extras) {
        if (pointer != kPlace) continue;
        const Json named = Json::parse(text);
        if (named.contains("as") && named["as"] == place) return named["name"];
    }
    return std::nullopt;
}

void rebaseNamedPlaces(Extras& extras, const std::function<std::string(const std::string&)>& rebased) {
    std::string* text = nameAt(extras, kPlace);
    if (!text) return;
    Json named = Json::parse(*text);
    if (!named["name"].contains("vertices")) return;
    named["name"]["vertices"] = rebased(named["name"]["vertices"].get<std::string>());
    *text = named.dump();
}

}  // namespace wend
