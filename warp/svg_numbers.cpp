#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "warp/svg_path.h"

namespace wend {

// --- Scanning ---

void NumberScanner::skipBlanks() {
    while (!m_text.empty() && std::string_view(" \t\r\n\f,").find(m_text.front()) != std::string_view::npos)
        m_text.remove_prefix(1);
}

bool NumberScanner::number(double& value) {
    skipBlanks();
    std::string_view text = m_text;
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || std::string_view("0123456789.-").find(text.front()) == std::string_view::npos)
        return false;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range) value = 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    m_text = text;
    return std::isfinite(value);
}

bool NumberScanner::flag(double& value) {
    skipBlanks();
    if (m_text.empty() || (m_text.front() != '0' && m_text.front() != '1')) return false;
    value = m_text.front() - '0';
    m_text.remove_prefix(1);
    return true;
}

bool NumberScanner::skip(char c) {
    skipBlanks();
    if (!m_text.starts_with(c)) return false;
    m_text.remove_prefix(1);
    return true;
}

char NumberScanner::letter() {
    skipBlanks();
    if (m_text.empty() || std::isalpha(static_cast<unsigned char>(m_text.front())) == 0) return 0;
    const char letter = m_text.front();
    m_text.remove_prefix(1);
    return letter;
}

std::string_view NumberScanner::word() {
    skipBlanks();
    std::size_t length = 0;
    while (length < m_text.size() && std::isalpha(static_cast<unsigned char>(m_text[length])) != 0) ++length;
    const std::string_view word = m_text.substr(0, length);
    m_text.remove_prefix(length);
    return word;
}

bool NumberScanner::atEnd() {
    skipBlanks();
    return m_text.empty();
}

// --- Transforms ---

namespace {

constexpr double kRadians = std::numbers::pi / 180;

Affine rotation(double radians) {
    Affine turn;
    turn.A << std::cos(radians), -std::sin(radians), std::sin(radians), std::cos(radians);
    return turn;
}

bool oneTransform(std::string_view name, const std::vector<double>& n, Affine& one) {
    const std::size_t count = n.size();
    if (name == "matrix" && count == 6) {
        one.A << n[0], n[2], n[1], n[3];
        one.b = {n[4], n[5]};
    } else if (name == "translate" && (count == 1 || count == 2)) {
        one.b = {n[0], count == 2 ? n[1] : 0};
    } else if (name == "scale" && (count == 1 || count == 2)) {
        one.A = Vec2(n[0], n.back()).asDiagonal();
    } else if (name == "rotate" && (count == 1 || count == 3)) {
        const Vec2 centre = count == 3 ? Vec2(n[1], n[2]) : Vec2(0, 0);
        one = rotation(n[0] * kRadians);
        one.b = centre - one.A * centre;
    } else if (name == "skewX" && count == 1) {
        one.A(0, 1) = std::tan(n[0] * kRadians);
    } else if (name == "skewY" && count == 1) {
        one.A(1, 0) = std::tan(n[0] * kRadians);
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool readTransform(std::string_view text, Affine& transform) {
    NumberScanner scanner(text);
    while (!scanner.atEnd()) {
        const std::string_view name = scanner.word();
        if (name.empty() || !scanner.skip('(')) return false;
        std::vector<double> numbers;
        for (double value = 0; scanner.number(value);) numbers.push_back(value);
        Affine one;
        const bool isClosed = scanner.skip(')') || scanner.atEnd();  // some programs forget the last one
        if (!isClosed || !oneTransform(name, numbers, one)) return false;
        transform = transform * one;
    }
    return true;
}

// --- Texts ---

std::string transformText(const Affine& transform) {
    std::string text = "matrix(";
    for (const double value : {transform.A(0, 0), transform.A(1, 0), transform.A(0, 1), transform.A(1, 1),
                               transform.b.x(), transform.b.y()})
        text += (text.back() == '(' ? "" : " ") + numberText(value + 0.0);  // not -0
    return text + ")";
}

std::string decimalText(double value, int decimals) {
    std::array<char, 400> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    std::string text(digits.data(), end);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string pathText(const SvgPath& path, int decimals) {
    std::string text;
    for (const PathPiece& piece : path) {
        text += "MLCZ"[static_cast<std::size_t>(piece.kind)];
        for (int k = 0; k < piece.count(); ++k) {
            const Vec2& p = piece.points[static_cast<std::size_t>(k)];
            if (k > 0) text += ' ';
            text += decimalText(p.x(), decimals) + ',' + decimalText(p.y(), decimals);
        }
    }
    return text;
}

}  // namespace wend
