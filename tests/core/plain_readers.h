#pragma once

#include <QXmlStreamReader>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// Readers of text files as another program would write them from the formats' descriptions: they share no
// line with Wend's own.

namespace wend::samples {

struct PlainMesh {
    struct Cell {
        std::vector<int> corners;
        int physical = 0, entity = 0;
    };
    std::vector<std::vector<double>> points;
    std::vector<Cell> cells;
    std::map<std::string, std::vector<double>> cellData, pointData;
    std::map<std::string, std::pair<int, int>> groups;  // name → (dimension, tag)
    std::vector<std::string> complaints;                // what contradicts itself
};

namespace plain {

inline std::vector<double> numbers(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> values;
    std::string word;
    while (in >> word) values.push_back(std::strtod(word.c_str(), nullptr));
    return values;
}

inline std::map<std::string, std::string> sections(const std::string& text) {
    std::map<std::string, std::string> found;
    for (std::size_t at = 0; (at = text.find('$', at)) != std::string::npos;) {
        const auto lineEnd = text.find('\n', at);
        const std::string name = text.substr(at + 1, lineEnd - at - 1);
        const auto end = text.find("$End" + name, lineEnd);
        if (end == std::string::npos) break;
        std::string key = name;
        while (found.contains(key)) key += '+';
        found[key] = text.substr(lineEnd + 1, end - lineEnd - 1);
        at = text.find('\n', end);
        if (at == std::string::npos) break;
    }
    return found;
}

inline void data(const std::string& body, bool perCell, std::size_t items, PlainMesh& mesh) {
    const auto open = body.find('"'), close = body.find('"', open + 1);
    const std::string name = body.substr(open + 1, close - open - 1);
    const auto rest = numbers(body.substr(close + 1));  // 1, time, 3, step, components, count, then rows
    const auto components = static_cast<std::size_t>(rest[4]), count = static_cast<std::size_t>(rest[5]);
    if (count != items) mesh.complaints.push_back(name + " has values for another number of items");
    auto& values = (perCell ? mesh.cellData : mesh.pointData)[name];
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t row = 6 + i * (components + 1);
        if (rest.at(row) != static_cast<double>(i + 1)) mesh.complaints.push_back(name + " skips an item");
        values.insert(values.end(), rest.begin() + row + 1, rest.begin() + row + 1 + components);
    }
}

}  // namespace plain

/// Gmsh 2.2 and 4.1, text.
inline PlainMesh plainMsh(const std::string& text) {
    PlainMesh mesh;
    const auto all = plain::sections(text);
    const bool version4 = all.at("MeshFormat").starts_with("4.1 0 8");
    std::map<std::pair<int, int>, std::vector<int>> physicalOf;
    if (all.contains("PhysicalNames")) {
        std::istringstream in(all.at("PhysicalNames"));
        int count = 0, dimension = 0, tag = 0;
        in >> count;
        for (std::string name; in >> dimension >> tag && std::getline(in, name);)
            mesh.groups[name.substr(name.find('"') + 1, name.rfind('"') - name.find('"') - 1)] = {dimension,
                                                                                                  tag};
        if (static_cast<int>(mesh.groups.size()) != count) mesh.complaints.push_back("group names");
    }
    const auto nodes = plain::numbers(all.at("Nodes")), elements = plain::numbers(all.at("Elements"));
    std::size_t at = 0;
    const auto next = [&at](const std::vector<double>& from) { return static_cast<int>(from.at(at++)); };
    if (version4) {
        const auto entities = plain::numbers(all.at("Entities"));
        at = 0;
        int counts[4];
        for (int& count : counts) count = next(entities);
        for (int dimension = 0; dimension < 4; ++dimension)
            for (int e = 0; e < counts[dimension]; ++e) {
                const int tag = next(entities);
                at += dimension == 0 ? 3 : 6;
                for (int k = next(entities); k > 0; --k)
                    physicalOf[{dimension, tag}].push_back(next(entities));
                if (dimension > 0) at += static_cast<std::size_t>(entities.at(at)) + 1;
            }
        at = 2;
        const int total = static_cast<int>(nodes[1]);
        for (at = 4; static_cast<int>(mesh.points.size()) < total;) {
            at += 3;
            const int count = next(nodes);
            at += count;
            for (int v = 0; v < count; ++v, at += 3)
                mesh.points.push_back({nodes.at(at), nodes.at(at + 1), nodes.at(at + 2)});
        }
        at = 4;
        for (int block = 0; block < static_cast<int>(elements[0]); ++block) {
            const int dimension = next(elements), entity = next(elements), type = next(elements);
            for (int k = next(elements); k > 0; --k) {
                ++at;
                PlainMesh::Cell cell;
                for (int corner = 0; corner < (type == 4 ? 4 : 3); ++corner)
                    cell.corners.push_back(next(elements) - 1);
                const auto& groups = physicalOf[{dimension, entity}];
                if (groups.size() != 1) mesh.complaints.push_back("an entity is in no group, or in several");
                cell.physical = groups.empty() ? 0 : groups[0];
                cell.entity = entity;
                mesh.cells.push_back(cell);
            }
        }
    } else {
        for (at = 1; at < nodes.size(); at += 4)
            mesh.points.push_back({nodes[at + 1], nodes[at + 2], nodes[at + 3]});
        for (at = 1; at < elements.size();) {
            ++at;
            const int type = next(elements), tags = next(elements);
            PlainMesh::Cell cell;
            cell.physical = next(elements);
            cell.entity = next(elements);
            at += tags - 2;
            for (int corner = 0; corner < (type == 4 ? 4 : 3); ++corner)
                cell.corners.push_back(next(elements) - 1);
            mesh.cells.push_back(cell);
        }
    }
    for (const auto& [name, body] : all) {
        if (name.starts_with("ElementData")) plain::data(body, true, mesh.cells.size(), mesh);
        if (name.starts_with("NodeData")) plain::data(body, false, mesh.points.size(), mesh);
    }
    return mesh;
}

/// .vtu with ascii data.
inline PlainMesh plainVtu(const std::string& text) {
    PlainMesh mesh;
    std::vector<double> connectivity, offsets, points;
    QXmlStreamReader xml(QByteArray::fromStdString(text));
    QString within;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto tag = xml.name();
        if (tag != QStringLiteral("DataArray")) {
            within = tag.toString();
            continue;
        }
        const std::string name = xml.attributes().value("Name").toString().toStdString();
        const auto values = plain::numbers(xml.readElementText().toStdString());
        if (within == "Points") points = values;
        if (within == "Cells" && name == "connectivity") connectivity = values;
        if (within == "Cells" && name == "offsets") offsets = values;
        if (within == "CellData") mesh.cellData[name] = values;
        if (within == "PointData") mesh.pointData[name] = values;
    }
    if (xml.hasError()) mesh.complaints.push_back(xml.errorString().toStdString());
    for (std::size_t i = 0; i < points.size(); i += 3)
        mesh.points.push_back({points[i], points[i + 1], points[i + 2]});
    std::size_t at = 0;
    for (const double end : offsets) {
        PlainMesh::Cell cell;
        for (; at < static_cast<std::size_t>(end); ++at)
            cell.corners.push_back(static_cast<int>(connectivity.at(at)));
        mesh.cells.push_back(cell);
    }
    return mesh;
}

/// Legacy .vtk, text, with fields as Wend writes them.
inline PlainMesh plainVtk(const std::string& text) {
    PlainMesh mesh;
    std::istringstream in(text);
    std::string word;
    bool perCell = false;
    while (in >> word) {
        int count = 0;
        if (word == "POINTS") {
            in >> count >> word;
            for (int v = 0; v < count; ++v) {
                std::vector<double> p(3);
                in >> p[0] >> p[1] >> p[2];
                mesh.points.push_back(p);
            }
        } else if (word == "CELLS") {
            in >> count >> word;
            for (int c = 0; c < count; ++c) {
                int corners = 0;
                in >> corners;
                PlainMesh::Cell cell;
                cell.corners.resize(static_cast<std::size_t>(corners));
                for (int& corner : cell.corners) in >> corner;
                mesh.cells.push_back(cell);
            }
        } else if (word == "CELL_DATA" || word == "POINT_DATA") {
            perCell = word == "CELL_DATA";
        } else if (word == "FIELD") {
            in >> word >> count;
            for (int f = 0; f < count; ++f) {
                std::string name;
                std::size_t components = 0, items = 0;
                in >> name >> components >> items >> word;
                auto& values = (perCell ? mesh.cellData : mesh.pointData)[name];
                for (std::size_t i = 0; i < components * items; ++i) {
                    in >> word;
                    values.push_back(std::strtod(word.c_str(), nullptr));
                }
            }
        }
    }
    return mesh;
}

/// AVS UCD .inp, text, as the format's description has it; the numbers of nodes and cells are to count
/// from 1.
inline PlainMesh plainUcd(const std::string& text) {
    PlainMesh mesh;
    std::istringstream in(text);
    std::size_t nodes = 0, cells = 0, ofNodes = 0, ofCells = 0, number = 0;
    std::string word;
    in >> nodes >> cells >> ofNodes >> ofCells >> word;
    for (std::size_t v = 0; v < nodes; ++v) {
        std::vector<double> p(3);
        in >> number >> p[0] >> p[1] >> p[2];
        if (number != v + 1) mesh.complaints.push_back("node " + std::to_string(number));
        mesh.points.push_back(p);
    }
    for (std::size_t c = 0; c < cells; ++c) {
        PlainMesh::Cell cell;
        in >> number >> cell.physical >> word;
        if (number != c + 1 || (word != "tri" && word != "tet")) mesh.complaints.push_back("cell " + word);
        cell.corners.resize(word == "tet" ? 4 : 3);
        for (int& corner : cell.corners) {
            in >> corner;
            --corner;
        }
        mesh.cells.push_back(cell);
    }
    const auto data = [&](std::size_t items, std::size_t total,
                          std::map<std::string, std::vector<double>>& into) {
        if (total == 0) return;
        std::size_t fields = 0, sum = 0;
        in >> fields;
        std::vector<std::size_t> components(fields);
        for (std::size_t& count : components) {
            in >> count;
            sum += count;
        }
        if (sum != total) mesh.complaints.push_back("components");
        std::vector<std::string> names(fields);
        in >> std::ws;
        for (std::string& name : names) {
            std::getline(in, name);
            name.resize(std::min(name.find(','), name.size()));
        }
        for (std::size_t i = 0; i < items; ++i) {
            in >> number;
            if (number != i + 1) mesh.complaints.push_back("values of " + std::to_string(number));
            for (std::size_t f = 0; f < fields; ++f)
                for (std::size_t k = 0; k < components[f]; ++k) {
                    in >> word;
                    into[names[f]].push_back(std::strtod(word.c_str(), nullptr));
                }
        }
    };
    data(nodes, ofNodes, mesh.pointData);
    data(cells, ofCells, mesh.cellData);
    if (!in || in >> word) mesh.complaints.push_back("the end");
    return mesh;
}

}  // namespace wend::samples
