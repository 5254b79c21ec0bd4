#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/types.h"

namespace wend {

/// Numbers as text in the C locale, whatever the user's locale: with std::to_chars and std::from_chars, which
/// know none.

/// 17 significant digits, enough to read the identical double back.
void appendNumber(std::string& text, double value);

/// At most nine significant digits, for messages and command lines.
std::string numberText(double value);

/// (x, y) or (x, y, z) with nine significant digits at the most, for messages: of a shape far from the origin
/// the places of two of its points are told apart, and 0.1 + 0.2 is 0.3.
template <int Dim>
std::string placeName(const Vec<Dim>& p);

/// The number that the whole text is (a leading + is accepted, as are nan and inf), or nothing. What is
/// nearer to zero than the smallest double is zero; what is greater than the largest one is no number.
std::optional<double> parseNumber(std::string_view text);

}  // namespace wend
