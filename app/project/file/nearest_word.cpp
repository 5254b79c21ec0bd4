#include "app/project/file/nearest_word.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace wend {
namespace {

std::string plain(const std::string& text) {
    std::string letters;
    for (const char c : text)
        if (c != '_' && c != '-' && c != ' ')
            letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return letters;
}

/// The names that other programs give to keys, in small letters.
constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {
    {"label", "group"},      {"labels", "group"},    {"physical", "group"},  {"physicalname", "group"},
    {"tag", "group"},        {"ref", "group"},       {"reference", "group"}, {"set", "group"},
    {"nset", "group"},       {"elset", "group"},     {"sideset", "group"},   {"nodeset", "group"},
    {"patch", "group"},      {"boundary", "group"},  {"material", "group"},  {"surface", "group"},
    {"solid", "group"},      {"usemtl", "group"},    {"marker", "group"},    {"attribute", "group"},
    {"nodes", "vertices"},   {"node", "vertices"},   {"ids", "vertices"},    {"id", "vertices"},
    {"indices", "vertices"}, {"position", "points"}, {"at", "points"},       {"coordinates", "points"},
    {"ball", "sphere"},      {"ball", "circle"},     {"circle", "sphere"},   {"sphere", "circle"},
    {"disc", "circle"},      {"disk", "circle"},     {"rect", "box"},        {"rectangle", "box"},
    {"cube", "box"},         {"cuboid", "box"},      {"square", "box"},      {"plane", "halfspace"},
    {"picture", "image"},    {"texture", "image"},   {"model", "mesh"},      {"volume", "mesh"},
    {"stl", "surface"},      {"move", "motion"},     {"motions", "motion"},  {"path", "points"},
    {"offset", "by"},        {"vector", "by"},       {"displacement", "by"}, {"degrees", "angle"},
    {"radians", "angle"},    {"position", "centre"}, {"origin", "centre"},   {"pivot", "centre"},
    {"direction", "axis"},   {"filename", "file"},   {"easing", "ease"},     {"duration", "end"},
    {"type", "kind"},        {"r", "radius"},        {"layers", "parts"},    {"fps", "frameRate"}};

constexpr std::size_t kLongestKey = 40;  // of a key that is compared
constexpr std::size_t kLeastPrefix = 3;  // letters

}  // namespace

int editDistance(const std::string& a, const std::string& b) {
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

std::string nearestWord(const std::string& text, const std::vector<std::string>& words) {
    const std::string meant = plain(text);
    std::string nearest;
    int least = std::numeric_limits<int>::max();
    if (meant.empty() || meant.size() > kLongestKey) return nearest;
    for (const std::string& word : words) {
        const std::string known = plain(word);
        const int longer = static_cast<int>(std::max(meant.size(), known.size()));
        const bool begins = meant.size() >= kLeastPrefix && known.starts_with(meant);
        const int distance = editDistance(meant, known);
        if ((3 * distance > longer && !begins) || distance >= least) continue;
        least = distance;
        nearest = word;
    }
    return nearest;
}

std::string meantKey(const std::string& text, const std::vector<std::string>& keys) {
    if (std::string near = nearestWord(text, keys); !near.empty()) return near;
    const std::string name = plain(text);
    for (const auto& [other, key] : kOtherNames)
        if (other == name && std::ranges::count(keys, key) > 0) return std::string(key);
    return {};
}

}  // namespace wend
