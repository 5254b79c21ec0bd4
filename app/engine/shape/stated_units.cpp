#include "app/engine/shape/stated_units.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/file_name.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

constexpr int kHead = 4096;  // bytes; comments further down are about something else

std::string headOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string head(kHead, '\0');
    in.read(head.data(), kHead);
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

/// Returns the line in lower case, with a blank for everything that is no letter.
std::string wordsOf(const std::string& line) {
    std::string words = line;
    for (char& c : words) {
        const auto byte = static_cast<unsigned char>(c);
        c = std::isalpha(byte) || byte >= 128 ? static_cast<char>(std::tolower(byte)) : ' ';
    }
    return words;
}

bool isComment(const std::string& line, const std::string& extension) {
    if (extension == ".ply") return line.starts_with("comment") || line.starts_with("obj_info");
    return line.starts_with('#');
}

/// Returns the first word of a unit after the word "unit" or "units".
std::string unitIn(const std::string& line) {
    static const std::map<std::string, std::string> names{{"mm", "mm"},
                                                          {"millimeter", "mm"},
                                                          {"millimeters", "mm"},
                                                          {"millimetre", "mm"},
                                                          {"millimetres", "mm"},
                                                          {"cm", "cm"},
                                                          {"centimeter", "cm"},
                                                          {"centimeters", "cm"},
                                                          {"centimetre", "cm"},
                                                          {"centimetres", "cm"},
                                                          {"m", "m"},
                                                          {"meter", "m"},
                                                          {"meters", "m"},
                                                          {"metre", "m"},
                                                          {"metres", "m"},
                                                          {"in", "in"},
                                                          {"inch", "in"},
                                                          {"inches", "in"},
                                                          {"ft", "ft"},
                                                          {"foot", "ft"},
                                                          {"feet", "ft"},
                                                          {"um", "µm"},
                                                          {"µm", "µm"},
                                                          {"micron", "µm"},
                                                          {"microns", "µm"},
                                                          {"micrometer", "µm"},
                                                          {"micrometers", "µm"}};
    std::istringstream words(wordsOf(line));
    bool behind = false;
    for (std::string word; words >> word;) {
        if (behind)
            if (const auto known = names.find(word); known != names.end()) return known->second;
        behind = behind || word == "unit" || word == "units";
    }
    return {};
}

}  // namespace

std::string statedUnits(const std::string& path) {
    const std::string extension = lowerExtension(path);
    if (extension == ".3mf") return unitIn("unit " + unitOfThreeMf(path));
    const std::string head = headOf(path);
    if (extension == ".stl") return unitIn(head.substr(0, std::min<std::size_t>(80, head.find('\n'))));
    std::istringstream lines(head);
    for (std::string line; std::getline(lines, line);)
        if (isComment(line, extension))
            if (std::string unit = unitIn(line); !unit.empty()) return unit;
    return {};
}

}  // namespace wend
