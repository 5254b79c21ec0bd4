#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wend {

/// Numbers as text in the C locale, whatever the user's locale: with std::to_chars and std::from_chars, which
/// know none.

/// 17 significant digits, enough to read the identical double back.
void appendNumber(std::string& text, double value);

/// The number that the whole text is (a leading + is accepted, as are nan and inf), or nothing. What is
/// nearer to zero than the smallest double is zero; what is greater than the greatest one is no number.
std::optional<double> parseNumber(std::string_view text);

}  // namespace wend
