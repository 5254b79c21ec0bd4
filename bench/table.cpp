#include "bench/table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/project/file/json_text.h"

namespace wend {
namespace {

std::string printed(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string duration(double seconds) {
    if (seconds < 0.1) return printed("%9.3f ms", 1e3 * seconds);
    return seconds < 10 ? printed("%9.1f ms", 1e3 * seconds) : printed("%9.2f s ", seconds);
}

/// Filled up to a width in characters, of which UTF-8 may take several bytes.
std::string padded(std::string text, std::size_t width) {
    const auto characters =
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    const auto count = static_cast<std::size_t>(characters);
    return text + std::string(count < width ? width - count : 1, ' ');
}

std::string columns(const std::string& what, int threads) {
    return padded("  " + what, 40) + padded(threads == 1 ? "1 thread" : "all", 9);
}

}  // namespace

std::vector<Growth> growthOf(const BenchTable& table) {
    struct Series {
        std::vector<double> vertices, seconds;
    };
    std::map<std::tuple<int, std::string, int>, Series> series;
    for (const BenchCase& one : table.cases) {
        if (one.vertices == 0) continue;
        for (const BenchRow& row : one.rows) {
            Series& s = series[{one.dimension, row.what, row.threads}];
            s.vertices.push_back(one.vertices);
            s.seconds.push_back(row.time.median);
        }
    }
    std::vector<Growth> growth;
    for (const auto& [key, s] : series) {
        // Shapes of one size give no growth.
        const auto [minimum, most] = std::minmax_element(s.vertices.begin(), s.vertices.end());
        if (*most < 1.5 * *minimum) continue;
        const auto& [dimension, what, threads] = key;
        growth.push_back({dimension, what, threads, growthExponent(s.vertices, s.seconds)});
    }
    return growth;
}

std::string headingOf(const BenchCase& one) {
    if (one.vertices == 0) return one.name;
    return one.name + ": " + std::to_string(one.vertices) + " vertices, " + std::to_string(one.cells) +
           (one.dimension == 2 ? " triangles" : " tetrahedra");
}

std::string textOf(const BenchRow& row) {
    std::string text = columns(row.what, row.threads) + duration(row.time.median);
    for (const auto& [figure, value] : row.figures) text += "   " + figure + printed(" %.3g", value);
    return text;
}

std::string textOf(const BenchClaim& claim) {
    std::string text = padded(claim.holds ? "  holds:" : "  FAILS:", 9) + claim.what;
    const char* before = ": ";
    for (const auto& [name, value] : claim.values) {
        text += before + name + printed(" %.3g", value);
        before = claim.holds ? " < " : ", ";
    }
    return text;
}

std::string textOf(const std::vector<Growth>& growth) {
    if (growth.empty()) return {};
    std::string text = "Growth with the number of vertices n, time ~ n^p:\n";
    for (const Growth& one : growth)
        text += columns(std::to_string(one.dimension) + "D " + one.what, one.threads) +
                printed("p = %.2f\n", one.exponent);
    return text;
}

std::string jsonOf(const BenchTable& table) {
    using Json = nlohmann::ordered_json;
    Json json{
        {"machine", table.machine}, {"cores", table.cores}, {"simd", table.simd}, {"cases", Json::array()}};
    for (const BenchCase& one : table.cases) {
        Json rows = Json::array();
        for (const BenchRow& row : one.rows) {
            Json entry{{"what", row.what},
                       {"threads", row.threads == 0 ? table.cores : row.threads},
                       {"seconds", row.time.median},
                       {"least", row.time.minimum},
                       {"maximum", row.time.maximum},
                       {"processorSeconds", row.time.processor},
                       {"repeats", row.time.repeats}};
            for (const auto& [figure, value] : row.figures) entry["figures"][figure] = value;
            rows.push_back(std::move(entry));
        }
        json["cases"].push_back({{"name", one.name},
                                 {"dimension", one.dimension},
                                 {"vertices", one.vertices},
                                 {"cells", one.cells},
                                 {"rows", std::move(rows)}});
    }
    for (const BenchClaim& claim : table.claims) {
        json["claims"].push_back({{"what", claim.what}, {"holds", claim.holds}});
        for (const auto& [name, value] : claim.values) json["claims"].back()["values"][name] = value;
    }
    for (const Growth& one : growthOf(table))
        json["growth"].push_back({{"dimension", one.dimension},
                                  {"what", one.what},
                                  {"threads", one.threads == 0 ? table.cores : one.threads},
                                  {"exponent", one.exponent}});
    return prettyJson(json);
}

std::string processorName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return {};
}

}  // namespace wend
