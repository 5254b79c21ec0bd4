#include "app/project/file/number_table.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/number_text.h"

namespace wend {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\"'");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\"'") - first + 1);
}

/// Blanks separate where nothing else does.
std::vector<std::string> cellsOf(std::string_view line) {
    std::vector<std::string> cells;
    char separator = ' ';
    for (const char one : {'\t', ';', ','})
        if (line.find(one) != std::string_view::npos) separator = one;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(separator, at), line.size());
        const std::string_view cell = trimmed(line.substr(at, end - at));
        if (separator != ' ' || !cell.empty()) cells.emplace_back(cell);
        at = end + 1;
    }
    if (!cells.empty() && cells.back().empty()) cells.pop_back();  // a separator at the end
    return cells;
}

std::string lowered(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

}  // namespace

std::optional<std::size_t> NumberTable::column(const std::vector<std::string>& names) const {
    const auto found = std::ranges::find_first_of(header, names);
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
}

void NumberTable::failAt(std::size_t row, const std::string& what) const {
    throw InputError(path, "line " + std::to_string(lines[row]) + ": " + what);
}

NumberTable readNumberTable(const std::string& path) {
    NumberTable table;
    table.path = path;
    const std::string text = readTextFile(path);
    std::string_view rest = text;
    if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view row = rest.substr(0, std::min(rest.find('#'), end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::vector<std::string> cells = cellsOf(row);
        if (cells.empty()) continue;
        if (table.rows.empty() && table.header.empty() && !parseNumber(cells.front())) {
            for (const std::string& cell : cells) table.header.push_back(lowered(cell));
            continue;
        }
        table.lines.push_back(line);
        std::vector<double>& numbers = table.rows.emplace_back();
        for (const std::string& cell : cells) {
            const auto number = parseNumber(cell);
            if (!number || !std::isfinite(*number))
                table.failAt(table.rows.size() - 1, "\"" + cell.substr(0, 30) + "\" is not a number");
            numbers.push_back(*number);
        }
        const std::size_t columns = table.header.empty() ? table.rows.front().size() : table.header.size();
        if (numbers.size() != columns)
            table.failAt(table.rows.size() - 1, "has " + std::to_string(numbers.size()) +
                                                    " columns instead of " + std::to_string(columns));
    }
    if (table.rows.empty()) throw InputError(path, "has no row of numbers");
    return table;
}

}  // namespace wend
