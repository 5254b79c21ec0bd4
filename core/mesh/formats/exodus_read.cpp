// Exodus II files are netCDF files of Sandia's solvers: blocks of elements of one type, sets of nodes and of
// the sides of elements, and values by steps of time.

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/mesh/formats/cell_split.h"
#include "core/mesh/formats/exodus.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/netcdf.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

using Numbers = std::vector<std::int64_t>;

std::string numbered(const char* name, std::size_t i) {
    return name + std::to_string(i + 1);
}

class ExodusReader {
  public:
    explicit ExodusReader(const std::string& bytes) : m_root(readNetcdf(bytes)) {}

    MeshFile read() {
        readPoints();
        readBlocks();
        const int elements = m_file.cells.size();
        readSideSets(elements);
        readNodeSets();
        readElementSets(elements);
        readFields();
        finishCells(m_file);
        return std::move(m_file);
    }

  private:
    const Hdf5Array* find(const std::string& name) const {
        const Hdf5Node* node = m_root.find(name);
        return node && !node->isGroup && node->data.kind != Hdf5Array::Kind::None ? &node->data : nullptr;
    }
    Numbers numbersOf(const std::string& name) const {
        const Hdf5Array* array = find(name);
        return array ? array->integers() : Numbers();
    }
    /// Returns the rows of a table of letters.
    std::vector<std::string> namesOf(const std::string& name) const {
        std::vector<std::string> names;
        const Hdf5Array* array = find(name);
        if (!array || array->shape.size() != 2 || array->shape[1] < 1) return names;
        std::string letters = array->bytes;
        for (const std::string& one : array->texts) letters += one.empty() ? '\0' : one[0];
        const auto width = static_cast<std::size_t>(array->shape[1]);
        for (std::size_t at = 0; at + width <= letters.size(); at += width) {
            std::string row = letters.substr(at, width);
            row.resize(std::min(row.size(), row.find('\0')));
            while (row.ends_with(' ')) row.pop_back();
            names.push_back(std::move(row));
        }
        return names;
    }

    void readPoints() {
        std::array<std::vector<double>, 3> rows;
        if (const Hdf5Array* all = find("coord"); all && all->shape.size() == 2 && all->shape[0] <= 3) {
            const std::vector<double> values = all->reals();
            const auto count = static_cast<std::size_t>(all->shape[1]);
            for (std::size_t k = 0; k < static_cast<std::size_t>(all->shape[0]); ++k)
                rows[k].assign(values.begin() + static_cast<std::ptrdiff_t>(k * count),
                               values.begin() + static_cast<std::ptrdiff_t>((k + 1) * count));
        } else {
            for (std::size_t k = 0; k < 3; ++k)
                if (const Hdf5Array* row = find(std::string("coord") + "xyz"[k])) rows[k] = row->reals();
        }
        if (rows[0].empty()) throw InputError("has no coordinates: no Exodus file");
        m_file.points = Eigen::Matrix3Xd::Zero(3, std::ssize(rows[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            if (rows[k].empty()) continue;
            if (rows[k].size() != rows[0].size()) throw InputError("has coordinates of different numbers");
            for (std::size_t v = 0; v < rows[k].size(); ++v)
                m_file.points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) = rows[k][v];
        }
    }

    void readBlocks() {
        const Numbers ids = numbersOf("eb_prop1");
        const std::vector<std::string> names = namesOf("eb_names");
        for (std::size_t b = 0; b < std::max<std::size_t>(ids.size(), 1); ++b) {
            m_blocks.push_back(m_file.cells.size());
            const Hdf5Node* node = m_root.find(numbered("connect", b));
            if (!node) continue;  // an empty block
            readBlock(*node);
            addGroup(b < names.size() ? names[b] : "", b < ids.size() ? ids[b] : 0,
                     rangeOf(m_blocks.back(), m_file.cells.size()));
        }
        m_blocks.push_back(m_file.cells.size());
    }
    static std::vector<int> rangeOf(int first, int end) {
        std::vector<int> cells;
        for (int c = first; c < end; ++c) cells.push_back(c);
        return cells;
    }
    void readBlock(const Hdf5Node& node) {
        const Numbers nodes = node.data.integers();
        const Hdf5Array* named = node.attribute("elem_type");
        const std::string name = named ? named->text() : "";
        const auto size = static_cast<std::size_t>(node.data.shape.size() == 2 ? node.data.shape[1] : 0);
        const ExodusType* type = exodusTypeNamed(name, size);
        if (!type)
            throw InputError("elements of the type " + inQuotes(name) + " with " + std::to_string(size) +
                             " nodes are not read");
        std::vector<int> cell(size);
        for (std::size_t at = 0; at + size <= nodes.size(); at += size) {
            for (std::size_t k = 0; k < size; ++k)
                cell[k] = nodeOf(
                    m_file, nodes[at + (type->order.empty() ? k : static_cast<std::size_t>(type->order[k]))]);
            m_file.cells.add(type->kind, cell);
        }
    }
    /// Adds cells to the group of that name, or number if there is no name, one for each dimension.
    void addGroup(const std::string& name, std::int64_t id, const std::vector<int>& cells) {
        for (const int c : cells) {
            MeshGroup& group = groupOf(name, id, m_file.cells.dimension(c));
            group.cells.push_back(c);
        }
    }
    MeshGroup& groupOf(const std::string& name, std::int64_t id, int dimension) {
        for (MeshGroup& group : m_file.groups)
            if (group.vertices.empty() && group.dimension == dimension &&
                (name.empty() ? group.name.empty() && group.tag == id : group.name == name))
                return group;
        m_file.groups.push_back({name, dimension, static_cast<long>(id), {}, {}, false});
        return m_file.groups.back();
    }

    /// Makes cells of the sides of every set, with the corners of the elements they belong to; each exists
    /// once.
    void readSideSets(int elements) {
        const Numbers ids = numbersOf("ss_prop1");
        const std::vector<std::string> names = namesOf("ss_names");
        std::map<std::vector<int>, int> known;  // by their corners
        for (std::size_t s = 0; s < ids.size(); ++s) {
            const Numbers of = numbersOf(numbered("elem_ss", s)), sides = numbersOf(numbered("side_ss", s));
            std::vector<int> cells;
            int ofShells = 0;
            for (std::size_t i = 0; i < std::min(of.size(), sides.size()); ++i) {
                if (of[i] < 1 || of[i] > elements)
                    throw InputError("side set " + std::to_string(ids[s]) + " names element " +
                                     std::to_string(of[i]) + ", which is not there");
                const int element = static_cast<int>(of[i] - 1);
                const auto all = exodusSidesOf(m_file.cells.kinds[static_cast<std::size_t>(element)]);
                if (sides[i] < 1 || sides[i] > std::ssize(all)) {
                    if (m_file.cells.dimension(element) != 2)
                        throw InputError("side set " + std::to_string(ids[s]) + " names side " +
                                         std::to_string(sides[i]) + " of an element that has " +
                                         std::to_string(all.size()));
                    ++ofShells;
                    continue;
                }
                std::vector<int> corners;
                for (const int k : all[static_cast<std::size_t>(sides[i] - 1)])
                    corners.push_back(m_file.cells[element][static_cast<std::size_t>(k)]);
                std::vector<int> key = corners;
                std::ranges::sort(key);
                const auto [entry, isNew] = known.try_emplace(key, m_file.cells.size());
                if (isNew && corners.size() == 2)
                    m_file.cells.add(CellKind::Line, corners);
                else if (isNew)
                    m_file.cells.addFace(corners);
                cells.push_back(entry->second);
            }
            if (ofShells > 0)
                m_file.notices.push_back("the " + std::to_string(ofShells) +
                                         " sides of shells in its side set " + std::to_string(ids[s]));
            std::ranges::sort(cells);
            cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
            addGroup(s < names.size() ? names[s] : "", ids[s], cells);
        }
    }
    void readNodeSets() {
        const Numbers ids = numbersOf("ns_prop1");
        const std::vector<std::string> names = namesOf("ns_names");
        for (std::size_t s = 0; s < ids.size(); ++s) {
            MeshGroup group;
            group.name = s < names.size() ? names[s] : "";
            group.tag = static_cast<long>(ids[s]);
            group.dimension = 0;
            for (const std::int64_t number : numbersOf(numbered("node_ns", s)))
                group.vertices.push_back(nodeOf(m_file, number));
            std::ranges::sort(group.vertices);
            if (!group.vertices.empty()) m_file.groups.push_back(std::move(group));
        }
    }
    void readElementSets(int elements) {
        const Numbers ids = numbersOf("els_prop1");
        const std::vector<std::string> names = namesOf("els_names");
        for (std::size_t s = 0; s < ids.size(); ++s) {
            std::vector<int> cells;
            for (const std::int64_t number : numbersOf(numbered("elem_els", s))) {
                if (number < 1 || number > elements)
                    throw InputError("element set " + std::to_string(ids[s]) + " names element " +
                                     std::to_string(number) + ", which is not there");
                cells.push_back(static_cast<int>(number - 1));
            }
            std::ranges::sort(cells);
            addGroup(s < names.size() ? names[s] : "", ids[s], cells);
        }
    }

    /// Returns the values of the last step; empty if there are none.
    std::vector<double> lastOf(const std::string& name, std::size_t variable, std::size_t variables) const {
        const Hdf5Array* array = find(name);
        if (!array || array->shape.empty() || array->shape[0] < 1) return {};
        std::vector<double> values = array->reals();
        std::size_t size = values.size() / static_cast<std::size_t>(array->shape[0]);
        const std::size_t begin = values.size() - size;
        if (variables > 1) size /= variables;
        const auto first =
            values.begin() + static_cast<std::ptrdiff_t>(begin + (variables > 1 ? variable * size : 0));
        return {first, first + static_cast<std::ptrdiff_t>(size)};
    }
    void readFields() {
        if (const Hdf5Array* times = find("time_whole"); times && times->size() > 1)
            m_file.notices.push_back("its " + std::to_string(times->size() - 1) + " earlier steps");
        const auto ofNodes = namesOf("name_nod_var"), ofCells = namesOf("name_elem_var"),
                   ofFile = namesOf("name_glo_var");
        for (std::size_t i = 0; i < ofNodes.size(); ++i) {
            const bool isOne = find("vals_nod_var");  // of older files
            addField(ofNodes[i], false,
                     isOne ? lastOf("vals_nod_var", i, ofNodes.size())
                           : lastOf(numbered("vals_nod_var", i), 0, 1));
        }
        for (std::size_t i = 0; i < ofCells.size(); ++i) {
            std::vector<double> values(static_cast<std::size_t>(m_file.cells.size()),
                                       std::numeric_limits<double>::quiet_NaN());
            for (std::size_t b = 0; b + 1 < m_blocks.size(); ++b) {
                const std::vector<double> own =
                    lastOf(numbered("vals_elem_var", i) + numbered("eb", b), 0, 1);
                if (own.size() == static_cast<std::size_t>(m_blocks[b + 1] - m_blocks[b]))
                    std::ranges::copy(own, values.begin() + m_blocks[b]);
            }
            addField(ofCells[i], true, std::move(values));
        }
        joinVectors(m_file, "_", "xyz");
        for (std::size_t i = 0; i < ofFile.size(); ++i)
            if (const auto all = lastOf("vals_glo_var", 0, 1); i < all.size())
                m_file.fileFields.push_back({ofFile[i], false, 1, {all[i]}});
    }
    void addField(const std::string& name, bool perCell, std::vector<double> values) {
        const auto count = static_cast<std::size_t>(perCell ? m_file.cells.size() : m_file.points.cols());
        if (values.size() == count)
            m_file.fields.push_back({name, perCell, 1, std::move(values)});
        else
            m_file.notices.push_back("its field " + inQuotes(name));
    }

    Hdf5Node m_root;
    MeshFile m_file;
    std::vector<int> m_blocks;  // the first cell of each, and the end
};

}  // namespace

MeshFile readExodus(std::span<const MeshSource> files) {
    return ExodusReader(files[0].bytes).read();
}

}  // namespace wend::formats
