#include "app/document/file/named_places.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <set>

#include "app/document/design.h"
#include "app/document/domain.h"
#include "app/document/file/named_files.h"
#include "app/document/file/text_file.h"
#include "app/document/project.h"
#include "core/mesh/error.h"
#include "core/mesh/group_vertices.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPlace = "/at";

std::string* namedPlace(Extras& extras) {
    for (auto& [pointer, text] : extras)
        if (pointer == kPlace) return &text;
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

/// Of a surface that is repaired before it is meshed, whose vertices get other numbers.
template <int Dim>
std::vector<Vec<Dim>> placesOf(const std::vector<int>& vertices, const Eigen::Matrix3Xd& points) {
    std::set<std::array<double, 3>> known;
    std::vector<Vec<Dim>> places;
    for (const int v : vertices)
        if (known.insert({points(0, v), points(1, v), points(2, v)}).second)
            places.emplace_back(points.col(v).template head<Dim>());
    return places;
}

class PlaceFinder {
  public:
    PlaceFinder(const Domain& domain, const std::string& folder) : m_domain(domain), m_folder(folder) {}

    template <int Dim>
    std::optional<Placement<Dim>> find(const Json& name) {
        if (name.contains("vertices")) return readIds(pathIn(m_folder, name["vertices"].get<std::string>()));
        if (m_domain.kind == DomainKind::Image)
            throw InputError("`group` is for meshes and surfaces: a picture has no groups");
        if (!m_file && !readMesh()) return std::nullopt;
        std::optional<int> dimension;
        if (name.contains("dimension")) dimension = name["dimension"].get<int>();
        std::vector<int> vertices = groupVertices(*m_file, name["group"].get<std::string>(), dimension);
        if (m_domain.kind == DomainKind::Surface && (m_domain.repair || !m_domain.fixes.empty()))
            return placesOf<Dim>(vertices, pointsOf(*m_file));
        return vertices;
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
    const std::string& m_folder;
    std::shared_ptr<const MeshFile> m_file;
};

template <int Dim>
Json asJson(const Placement<Dim>& place) {
    if (const auto* ids = std::get_if<std::vector<int>>(&place)) return {{"vertices", *ids}};
    Json points = Json::array();
    if (const auto* all = std::get_if<std::vector<Vec<Dim>>>(&place))
        for (const Vec<Dim>& p : *all) points.push_back(std::vector<double>(p.begin(), p.end()));
    return {{"points", points}};
}

template <int Dim>
void findPlaces(Project& project, const std::string& folder) {
    PlaceFinder finder(project.domain, folder);
    auto& handles = designOf<Dim>(project).handles;
    for (std::size_t h = 0; h < handles.size(); ++h) {
        std::string* text = namedPlace(handles[h].extras);
        if (!text) continue;
        Json named = Json::parse(*text);
        try {
            if (const auto place = finder.find<Dim>(named["name"])) handles[h].at = *place;
        } catch (const InputError& error) {
            const std::string where = "handles[" + std::to_string(h) + "].at: ";
            throw InputError(where + (error.file().empty() ? "" : error.file() + ": ") + error.reason());
        }
        named["as"] = asJson<Dim>(handles[h].at);
        *text = named.dump();
    }
}

}  // namespace

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

void findNamedPlaces(Project& project, const std::string& folder) {
    project.dimension() == 2 ? findPlaces<2>(project, folder) : findPlaces<3>(project, folder);
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
    std::string* text = namedPlace(extras);
    if (!text) return;
    Json named = Json::parse(*text);
    if (!named["name"].contains("vertices")) return;
    named["name"]["vertices"] = rebased(named["name"]["vertices"].get<std::string>());
    *text = named.dump();
}

}  // namespace wend
