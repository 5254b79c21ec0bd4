// 3MF: a ZIP archive with XML. The items of the build are placed as they say, with the parts that they are
// made of, which may be in other files of the archive. Every item is a group. Numbers are the file's own, in
// its unit (see statedUnits).

#include <pugixml.hpp>

#include <Eigen/LU>
#include <iterator>
#include <map>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/zip_archive.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

constexpr int kDeepest = 32;  // components of components

/// Returns the name of an element or attribute without its namespace.
std::string_view localName(const char* name) {
    const std::string_view whole(name);
    const auto colon = whole.find(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

pugi::xml_node childNamed(pugi::xml_node parent, std::string_view name) {
    for (const auto child : parent.children())
        if (localName(child.name()) == name) return child;
    return {};
}

std::string_view attributeNamed(pugi::xml_node node, std::string_view name) {
    for (const auto attribute : node.attributes())
        if (localName(attribute.name()) == name) return attribute.value();
    return {};
}

class ThreeMfReader {
  public:
    explicit ThreeMfReader(const std::string& path) : m_archive(path) {}

    /// Reads the objects that the build names, each at its place.
    MeshFile read() {
        m_root = rootName();
        const pugi::xml_node build = childNamed(model(m_root), "build");
        int number = 0;
        for (const auto item : build.children()) {
            if (localName(item.name()) != "item") continue;
            const int first = m_file.cells.size();
            m_name = {};
            addObject(pathOf(item, m_root), attributeNamed(item, "objectid"), placeOf(item), 0);
            addGroup(item, first, ++number);
        }
        if (m_file.groups.size() == 1) m_file.groups.clear();
        addNotices();
        m_file.points = Eigen::Map<const Eigen::Matrix3Xd>(m_points.data(), 3,
                                                           static_cast<Eigen::Index>(m_points.size() / 3));
        finishCells(m_file);
        return std::move(m_file);
    }

    /// Returns the unit of the coordinates, which the head of the model gives. Its rest, which may be large,
    /// is not read: pugixml keeps what precedes the cut.
    std::string unit() const {
        constexpr std::uint64_t kHead = 4096;
        const auto head = m_archive.file(rootName(), kHead);
        if (!head) return {};
        pugi::xml_document document;
        document.load_buffer(head->data(), head->size());
        if (!document.document_element()) return {};
        const std::string_view named = attributeNamed(document.document_element(), "unit");
        return std::string(named.empty() ? "millimeter" : named);
    }

  private:
    /// p ↦ p A + b, with A above b.
    using Place = Eigen::Matrix<double, 4, 3>;

    /// Returns the name of the model in the archive's relations.
    std::string rootName() const {
        constexpr const char* kUsual = "3D/3dmodel.model";
        const auto relations = m_archive.file("_rels/.rels");
        if (!relations) return kUsual;
        pugi::xml_document document;
        if (!document.load_buffer(relations->data(), relations->size())) return kUsual;
        for (const auto relation : document.document_element().children())
            if (attributeNamed(relation, "Type").ends_with("/3dmodel"))
                return withoutSlash(attributeNamed(relation, "Target"));
        return kUsual;
    }
    static std::string withoutSlash(std::string_view name) {
        return std::string(name.substr(name.starts_with('/') ? 1 : 0));
    }
    static std::string pathOf(pugi::xml_node node, const std::string& otherwise) {
        const std::string_view path = attributeNamed(node, "path");
        return path.empty() ? otherwise : withoutSlash(path);
    }

    /// Returns the root element of a model in the archive, which is parsed when it is named first.
    pugi::xml_node model(const std::string& name) {
        const auto [found, isNew] = m_documents.try_emplace(name);
        if (isNew) {
            const auto text = m_archive.file(name);
            if (!text) throw InputError("has no " + inQuotes(name) + " in it");
            const auto result = found->second.load_buffer(text->data(), text->size());
            if (!result) throw InputError(name + ": not valid XML: " + result.description());
        }
        return found->second.document_element();
    }
    pugi::xml_node objectNamed(const std::string& path, std::string_view id) {
        for (const auto object : childNamed(model(path), "resources").children())
            if (localName(object.name()) == "object" && attributeNamed(object, "id") == id) return object;
        throw InputError(path + ": there is no object " + inQuotes(id));
    }

    double numberOf(std::string_view text, const char* what) const {
        const auto number = parseNumber(text);
        if (!number) throw InputError(std::string(what) + ": " + inQuotes(text) + " is not a number");
        return *number;
    }
    Place placeOf(pugi::xml_node node) const {
        Place place = Place::Zero();
        place.topRows<3>().setIdentity();
        const std::string_view text = attributeNamed(node, "transform");
        if (text.empty()) return place;
        Scanner scanner(text);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 3; ++column)
                place(row, column) = scanner.finite("a number of a transform");
        return place;
    }

    /// Adds an object: its mesh, or its components, each at its place.
    void addObject(const std::string& path, std::string_view id, const Place& place, int depth) {
        if (depth > kDeepest) throw InputError(path + ": the components are nested too deep");
        const pugi::xml_node object = objectNamed(path, id);
        if (depth == 0) m_name = attributeNamed(object, "name");
        if (const auto mesh = childNamed(object, "mesh")) addMesh(path, mesh, place);
        for (const auto component : childNamed(object, "components").children()) {
            const Place own = placeOf(component);
            Place both;
            both.topRows<3>() = own.topRows<3>() * place.topRows<3>();
            both.row(3) = own.row(3) * place.topRows<3>() + place.row(3);
            addObject(pathOf(component, path), attributeNamed(component, "objectid"), both, depth + 1);
        }
    }

    /// Adds the mesh of an object, with its vertices transformed. Triangles that the transform mirrors are
    /// turned over, so that they face outwards again.
    void addMesh(const std::string& path, pugi::xml_node mesh, const Place& place) {
        const int first = static_cast<int>(m_points.size() / 3);
        for (const auto vertex : childNamed(mesh, "vertices").children()) {
            if (localName(vertex.name()) != "vertex") continue;
            Eigen::RowVector3d p;
            for (int k = 0; k < 3; ++k)
                p[k] = numberOf(attributeNamed(vertex, std::string_view("xyz").substr(k, 1)), "a vertex");
            const bool isMoved = place != unmoved();
            const Eigen::RowVector3d q =
                isMoved ? Eigen::RowVector3d(p * place.topRows<3>() + place.row(3)) : p;
            m_points.insert(m_points.end(), q.data(), q.data() + 3);
        }
        const int count = static_cast<int>(m_points.size() / 3) - first;
        const bool isMirrored = place.topRows<3>().determinant() < 0;
        for (const auto triangle : childNamed(mesh, "triangles").children()) {
            if (localName(triangle.name()) != "triangle") continue;
            std::array<int, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double v = numberOf(attributeNamed(triangle, k == 0   ? "v1"
                                                                   : k == 1 ? "v2"
                                                                            : "v3"),
                                          "a triangle");
                if (!(v >= 0 && v < count))
                    throw InputError(path + ": a triangle names vertex " +
                                     std::to_string(static_cast<long>(v)) + ", but there are only " +
                                     std::to_string(count) + " (counted from 0)");
                corners[k] = first + static_cast<int>(v);
            }
            if (isMirrored) std::swap(corners[1], corners[2]);
            m_file.cells.add(CellKind::Triangle, corners);
        }
    }
    static Place unmoved() {
        Place place = Place::Zero();
        place.topRows<3>().setIdentity();
        return place;
    }

    void addGroup(pugi::xml_node item, int first, int number) {
        MeshGroup group;
        group.name = m_name.empty() ? attributeNamed(item, "partnumber") : m_name;
        if (group.name.empty()) group.tag = number;
        for (int c = first; c < m_file.cells.size(); ++c) group.cells.push_back(c);
        if (!group.cells.empty()) m_file.groups.push_back(std::move(group));
    }

    /// Adds notices of the models' colours and pictures, which are not read.
    void addNotices() {
        std::size_t colours = 0, pictures = 0;
        for (const auto& [name, document] : m_documents)
            for (const auto resource : childNamed(document.document_element(), "resources").children()) {
                const std::string_view kind = localName(resource.name());
                if (kind == "basematerials" || kind == "colorgroup")
                    colours += static_cast<std::size_t>(
                        std::distance(resource.children().begin(), resource.children().end()));
                pictures += kind == "texture2d";
            }
        if (colours > 0)
            m_file.notices.push_back(colours == 1 ? "its colour"
                                                  : "its " + std::to_string(colours) + " colours");
        if (pictures > 0)
            m_file.notices.push_back(pictures == 1 ? "its picture"
                                                   : "its " + std::to_string(pictures) + " pictures");
    }

    ZipArchive m_archive;
    std::string m_root;
    std::map<std::string, pugi::xml_document> m_documents;
    MeshFile m_file;
    std::vector<double> m_points;
    std::string m_name;  // of the item's object
};

}  // namespace

MeshFile readThreeMf(std::span<const MeshSource> files) {
    return ThreeMfReader(files[0].path).read();
}

}  // namespace wend::formats

namespace wend {

std::string unitOfThreeMf(const std::string& path) try {
    return formats::ThreeMfReader(path).unit();
} catch (const InputError&) {  // reported when the mesh is needed
    return {};
}

}  // namespace wend
