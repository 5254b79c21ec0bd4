#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace wend {
namespace {

/// Distinguishes underflow from overflow, which from_chars does not. A number without a nonzero digit before
/// an exponent e−… is small.
bool tooSmall(std::string_view text) {
    const auto exponent = text.find_first_of("eE");
    return exponent != std::string_view::npos && exponent + 1 < text.size() && text[exponent + 1] == '-';
}

void appendDigits(std::string& text, double value, int count) {
    std::array<char, 40> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, count)
            .ptr;
    text.append(digits.data(), end);
}

}  // namespace

void appendNumber(std::string& text, double value) {
    appendDigits(text, value, 17);
}

std::string numberText(double value) {
    std::string text;
    appendDigits(text, value, 9);
    return text;
}

std::string timeText(double time) {
    std::string text;
    appendDigits(text, time, 6);
    return text;
}

template <int Dim>
std::string placeName(const Vec<Dim>& p) {
    std::string text;
    for (const double x : p) {
        text += text.empty() ? "(" : ", ";
        appendDigits(text, x, 9);
    }
    return text + ')';
}

std::string fixedText(double value, int decimals) {
    constexpr int kMostDigits = 340;
    const double unit = std::pow(10.0, decimals), rounded = std::round(value * unit) / unit;
    std::array<char, kMostDigits> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(),
                      std::isfinite(rounded) ? rounded + 0.0 : value, std::chars_format::fixed, decimals);
    return end.ec == std::errc() ? std::string(digits.data(), end.ptr) : numberText(value);
}

template <int Dim>
std::string roughPlaceName(const Vec<Dim>& p, double size) {
    constexpr int kMostDecimals = 9, kDigits = 3;
    const int decimals =
        size > 0 && std::isfinite(size) ? kDigits - static_cast<int>(std::lround(std::log10(size))) : kDigits;
    if (decimals > kMostDecimals) return placeName<Dim>(p);
    std::string text;
    for (const double x : p) {
        text += text.empty() ? "(" : ", ";
        text += fixedText(x, std::max(decimals, 0));
    }
    return text + ')';
}

template std::string roughPlaceName<2>(const Vec2&, double);
template std::string roughPlaceName<3>(const Vec3&, double);
template std::string placeName<2>(const Vec2&);
template std::string placeName<3>(const Vec3&);

std::optional<double> parseNumber(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    if (error == std::errc::result_out_of_range && tooSmall(text)) return 0.0;
    if (error != std::errc()) return std::nullopt;
    return value;
}

}  // namespace wend
