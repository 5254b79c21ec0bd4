#include "app/output/point_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/number_text.h"
#include "core/mesh/formats/scanner.h"

namespace wend {
namespace {

constexpr std::string_view kBlanks = " \t\r", kMark = "\xef\xbb\xbf";  // a byte order mark

std::string lowered(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

/// Returns which coordinate a column of that name holds.
std::optional<int> axisOf(const std::string& name) {
    for (int k = 0; k < 3; ++k)
        for (const std::string& known :
             {std::string(1, "xyz"[k]), "points:" + std::to_string(k), "points_" + std::to_string(k)})
            if (name == known) return k;
    return std::nullopt;
}

}  // namespace

/// Goes through the lines of the text.
class PointTable::Reader {
  public:
    explicit Reader(PointTable& table) : m_table(table), m_text(table.m_text) {}

    void read() {
        std::size_t at = m_text.starts_with(kMark) ? kMark.size() : 0;
        for (; at < m_text.size(); ++m_line) {
            const std::size_t end = std::min(m_text.find('\n', at), m_text.size());
            if (!isCommentOfXyz()) readLine({at, end});
            at = end + 1;
        }
        if (m_values.empty())
            throw InputError(std::string("has no row of ") +
                             (m_table.m_dimension == 2 ? "2 numbers (x, y)" : "3 numbers (x, y, z)"));
        const auto count = static_cast<Eigen::Index>(m_values.size()) / m_table.m_dimension;
        m_table.m_points = Points<3>::Zero(3, count);
        m_table.m_points.topRows(m_table.m_dimension) =
            Eigen::Map<const Eigen::MatrixXd>(m_values.data(), m_table.m_dimension, count);
    }

  private:
    std::string_view view(const Field& field) const {
        return std::string_view(m_text).substr(field.begin, field.end - field.begin);
    }
    /// Returns a field without blanks and quotes around it.
    Field trimmed(Field field, std::string_view without = " \t\r\"'") const {
        while (field.begin < field.end && without.find(m_text[field.begin]) != std::string_view::npos)
            ++field.begin;
        while (field.begin < field.end && without.find(m_text[field.end - 1]) != std::string_view::npos)
            --field.end;
        return field;
    }
    bool isCommentOfXyz() const { return m_line == 2 && m_countsAtoms; }

    void readLine(Field line) {
        line = trimmed(line, kBlanks);
        const std::string_view text = view(line);
        const std::size_t mark = text.starts_with("//") ? 2 : text.starts_with('#') || text.starts_with('%');
        line.begin += mark;
        const std::vector<Field> fields = fieldsOf(line);
        if (fields.empty()) return;
        if (m_values.empty() && readHeader(fields)) return;
        if (mark > 0) return;
        m_countsAtoms = m_line == 1 && fields.size() == 1 && isCount(view(fields[0]));
        if (m_columns.empty() && !findColumns(fields)) return;
        takePoint(fields);
    }
    static bool isCount(std::string_view text) {
        return text.find_first_not_of("0123456789") == std::string_view::npos;
    }

    /// Blanks separate where nothing else does.
    std::vector<Field> fieldsOf(const Field& line) const {
        char separator = ' ';
        for (const char one : {'\t', ',', ';'})
            if (view(line).find(one) != std::string_view::npos) separator = one;
        std::vector<Field> fields;
        for (std::size_t at = line.begin; at < line.end;) {
            const std::size_t end = std::min(m_text.find(separator, at), line.end);
            const Field field = trimmed({at, end});
            if (separator != ' ' || field.begin < field.end) fields.push_back(field);
            at = end + 1;
        }
        return fields;
    }

    bool readHeader(const std::vector<Field>& fields) {
        std::array<int, 3> columns{-1, -1, -1};
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (const auto axis = axisOf(lowered(view(fields[k])))) columns[*axis] = static_cast<int>(k);
        if (std::any_of(columns.begin(), columns.begin() + m_table.m_dimension,
                        [](int column) { return column < 0; }))
            return false;
        m_columns.assign(columns.begin(), columns.begin() + m_table.m_dimension);
        return true;
    }

    /// Takes the first numbers of a row that has enough of them.
    bool findColumns(const std::vector<Field>& fields) {
        std::vector<int> columns;
        for (std::size_t k = 0; k < fields.size(); ++k)
            if (parseNumber(view(fields[k]))) columns.push_back(static_cast<int>(k));
        if (static_cast<int>(columns.size()) < m_table.m_dimension) return false;
        columns.resize(static_cast<std::size_t>(m_table.m_dimension));
        m_columns = columns;
        return true;
    }

    void takePoint(const std::vector<Field>& fields) {
        for (const int column : m_columns) {
            if (column >= static_cast<int>(fields.size()))
                fail("has " + std::to_string(fields.size()) + " columns, where at least " +
                     std::to_string(1 + *std::ranges::max_element(m_columns)) + " are needed");
            const Field& field = fields[static_cast<std::size_t>(column)];
            const auto number = parseNumber(view(field));
            if (!number || !std::isfinite(*number)) fail(formats::inQuotes(view(field)) + " is not a number");
            m_values.push_back(*number);
            m_table.m_fields.push_back(field);
        }
        m_table.m_furtherColumns =
            std::max(m_table.m_furtherColumns, static_cast<int>(fields.size() - m_columns.size()));
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("line " + std::to_string(m_line) + ": " + what);
    }

    PointTable& m_table;
    const std::string& m_text;
    int m_line = 1;
    bool m_countsAtoms = false;
    std::vector<int> m_columns;  // of the coordinates
    std::vector<double> m_values;
};

PointTable::PointTable(std::string text, int dimension) : m_text(std::move(text)), m_dimension(dimension) {
    Reader(*this).read();
}

std::string PointTable::withPoints(const Points<3>& points) const {
    std::string text;
    text.reserve(m_text.size() + 8 * m_fields.size());
    std::size_t at = 0;
    // A row names its coordinates in any order, such as z before x.
    std::vector<std::size_t> order(m_fields.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [this](std::size_t k) { return m_fields[k].begin; });
    for (const std::size_t k : order) {
        text.append(m_text, at, m_fields[k].begin - at);
        const auto point = static_cast<Eigen::Index>(k) / m_dimension;
        appendNumber(text, points(static_cast<Eigen::Index>(k) % m_dimension, point));
        at = m_fields[k].end;
    }
    return text.append(m_text, at);
}

bool isPointTable(const std::string& path) {
    const std::string extension = lowerExtension(path);
    constexpr std::array kKnown{".csv", ".tsv", ".txt", ".xyz", ".dat"};
    return std::ranges::find(kKnown, extension) != kKnown.end();
}

std::string pointTableText(const Points<3>& points, int dimension, bool commas) {
    std::string text;
    if (commas) text = dimension == 2 ? "x,y\n" : "x,y,z\n";
    for (Eigen::Index i = 0; i < points.cols(); ++i)
        for (int k = 0; k < dimension; ++k) {
            appendNumber(text, points(k, i));
            text += k + 1 == dimension ? '\n' : commas ? ',' : ' ';
        }
    return text;
}

}  // namespace wend
