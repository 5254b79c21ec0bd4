#include <algorithm>
#include <array>
#include <charconv>

#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/nastran.h"
#include "core/mesh/formats/text_writer.h"

namespace wend::formats {
namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

/// Returns a deck with other points in its GRID entries, in their order.
std::string bulkWithPoints(const std::string& deck, const Eigen::Matrix3Xd& points) {
    std::string out;
    Eigen::Index v = 0;
    for (std::size_t at = 0; at < deck.size();) {
        const std::size_t begin = at;
        const NastranCard card = takeNastranCard(deck, at);
        if (card.name == "ENDDATA") return out + deck.substr(begin);
        if (card.name == "GRID" && v < points.cols())
            out += nastranGrid(card, points.col(v++).data()) + deck.substr(card.end, at - card.end);
        else
            out += deck.substr(begin, at - begin);
    }
    return out;
}

/// Prints an element with its number, property and nodes in Nastran's order, in lines of eight fields.
void printElement(TextWriter& out, const MeshFile& mesh, int c, long property) {
    const auto kind = std::ranges::find(nastranElements(), mesh.cells.kinds[static_cast<std::size_t>(c)],
                                        &NastranElement::kind);
    std::vector<int> nodes(mesh.cells[c].begin(), mesh.cells[c].end());
    for (std::size_t k = 0; k < kind->order.size(); ++k)
        nodes[static_cast<std::size_t>(kind->order[k])] = mesh.cells[c][k];
    out << padded(std::string(kind->name), 8) << padded(std::to_string(c + 1), 8)
        << padded(std::to_string(property), 8);
    int onLine = 2;
    for (const int v : nodes) {
        if (onLine == 8) {
            out << "+\n+       ";
            onLine = 0;
        }
        out << padded(std::to_string(v + 1), 8);
        ++onLine;
    }
    out << '\n';
}

}  // namespace

const std::vector<NastranElement>& nastranElements() {
    static const std::vector<NastranElement> elements = {
        {"CROD", CellKind::Line, {}},
        {"CBAR", CellKind::Line, {}},
        {"CBEAM", CellKind::Line, {}},
        {"CONROD", CellKind::Line, {}},
        {"PLOTEL", CellKind::Line, {}},
        {"CTRIA3", CellKind::Triangle, {}},
        {"CTRIAR", CellKind::Triangle, {}},
        {"CTRIA6", CellKind::Triangle6, {}},
        {"CQUAD4", CellKind::Quad, {}},
        {"CQUADR", CellKind::Quad, {}},
        {"CQUAD8", CellKind::Quad8, {}},
        {"CTETRA", CellKind::Tetrahedron, {}},
        {"CTETRA", CellKind::Tetrahedron10, {}},
        {"CPYRAM", CellKind::Pyramid, {}},
        {"CPYRAM", CellKind::Pyramid13, {}},
        {"CPENTA", CellKind::Wedge, {}},
        {"CPENTA", CellKind::Wedge15, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
        {"CHEXA", CellKind::Hexahedron, {}},
        {"CHEXA", CellKind::Hexahedron20, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                           10, 11, 16, 17, 18, 19, 12, 13, 14, 15}}};
    return elements;
}

/// A point is needed; the E of an exponent is not.
std::string nastranNumber(double value) {
    for (int digits = 17; digits > 0; --digits) {
        std::array<char, 40> text;
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits)
                .ptr;
        std::string number(text.data(), end);
        const auto exponent = number.find('e');
        if (number.find('.') == std::string::npos) number.insert(std::min(exponent, number.size()), ".");
        if (const auto e = number.find('e'); e != std::string::npos) {
            number.erase(e, 1);
            while (e + 1 < number.size() && number[e + 1] == '0') number.erase(e + 1, 1);
        }
        if (number.size() <= 16) return number;
    }
    return "0.";
}

std::string nastranGrid(const NastranCard& old, const double* point) {
    const auto field = [&](std::size_t k) { return padded(k < old.fields.size() ? old.fields[k] : "", 16); };
    std::string text = "GRID*   " + field(0) + field(1) + padded(nastranNumber(point[0]), 16) +
                       padded(nastranNumber(point[1]), 16) + "\n*       " +
                       padded(nastranNumber(point[2]), 16);
    for (std::size_t k = 5; k < 8; ++k) text += field(k);
    text.resize(text.find_last_not_of(' ') + 1);
    return text + '\n';
}

/// Prints bulk data. A mesh from a .bdf file is that file with other points.
std::vector<std::string> printNastran(const MeshFile& mesh, const MeshWriteOptions&) {
    if (mesh.deck && mesh.deckFormat == ".bdf") return {bulkWithPoints(*mesh.deck, mesh.points)};
    TextWriter out;
    out << "BEGIN BULK\n";
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
        out << nastranGrid({"GRID", {std::to_string(v + 1)}, 0, 0}, mesh.points.col(v).data());
    const std::vector<long> numbers = groupNumbers(mesh);
    long highest = 0;
    for (const long number : numbers) highest = std::max(highest, number);
    for (int c = 0; c < mesh.cells.size(); ++c) {
        const long own = numbers[static_cast<std::size_t>(c)];
        printElement(out, mesh, c, own > 0 ? own : highest + 1);
    }
    out << "ENDDATA\n";
    return {std::move(out.text())};
}

}  // namespace wend::formats
