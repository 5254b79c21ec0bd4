#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace wend::formats {

/// The types of number that binary mesh files hold.
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

/// Returns the number of bytes of a type.
std::size_t sizeOf(Scalar type);

/// Returns the number in the first sizeOf(type) bytes.
double decodeReal(std::string_view bytes, Scalar type, std::endian order);
/// Returns that number as a whole number; a real type is rounded towards zero. A real number that no 64-bit
/// number can hold becomes −1, and so does NaN; unsigned numbers of 2⁶³ and more become negative. Neither is
/// accepted as a count or an index.
std::int64_t decodeInteger(std::string_view bytes, Scalar type, std::endian order);

/// Append a number in the given type and byte order.
void appendReal(std::string& bytes, double value, Scalar type, std::endian order);
void appendInteger(std::string& bytes, std::int64_t value, Scalar type, std::endian order);

/// A whole number of eight bytes as the nearest double and what it has beyond that. Doubles have 53 bits, so
/// nothing is beyond up to 2⁵³.
struct SplitNumber {
    double value = 0;
    std::int16_t beyond = 0;
};
/// Return the two parts of a number, and the number of two parts: wholeNumber(splitNumber(n)) is n. A double
/// beyond the range, or NaN, gives the nearest end of it, or the lowest number.
SplitNumber splitNumber(std::int64_t number);
SplitNumber splitNumber(std::uint64_t number);
std::int64_t wholeNumber(SplitNumber split);
std::uint64_t unsignedNumber(SplitNumber split);

}  // namespace wend::formats
