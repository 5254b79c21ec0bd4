#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/types.h"

namespace wend {

/// These functions write and read numbers in the C locale regardless of the user's locale, by std::to_chars
/// and std::from_chars.

/// Appends 17 significant digits, enough to read the identical double back.
void appendNumber(std::string& text, double value);

/// Returns at most nine significant digits, for messages and command lines.
std::string numberText(double value);

/// Returns at most six significant digits, for times in messages.
std::string timeText(double time);

/// Returns (x, y) or (x, y, z) with at most nine significant digits, for messages: enough to distinguish
/// points of a shape far from the origin, and 0.1 + 0.2 is 0.3.
template <int Dim>
std::string placeName(const Vec<Dim>& p);
/// Returns the same with about three significant digits of the size of the shape, for a window: pixels of a
/// picture have one decimal at most.
template <int Dim>
std::string roughPlaceName(const Vec<Dim>& p, double size);

/// Returns a number with a fixed number of decimals; −0 is written as 0.
std::string fixedText(double value, int decimals);

/// Parses the whole text as a number (a leading +, nan and inf are accepted); nothing if it is none.
/// Underflow gives zero; overflow gives nothing. Blanks around it, a comma and hexadecimal digits are not
/// accepted; an empty text is no number.
std::optional<double> parseNumber(std::string_view text);

}  // namespace wend
