#include "core/mesh/formats/scalar_type.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace wend::formats {
namespace {

/// Calls use(T()) for the C++ type T of a Scalar.
template <class Use>
auto withType(Scalar type, const Use& use) {
    switch (type) {
        // NOLINTNEXTLINE(bugprone-branch-clone): each branch has another type
        case Scalar::Int8:
            return use(std::int8_t());
        case Scalar::UInt8:
            return use(std::uint8_t());
        case Scalar::Int16:
            return use(std::int16_t());
        case Scalar::UInt16:
            return use(std::uint16_t());
        case Scalar::Int32:
            return use(std::int32_t());
        case Scalar::UInt32:
            return use(std::uint32_t());
        case Scalar::Int64:
            return use(std::int64_t());
        case Scalar::UInt64:
            return use(std::uint64_t());
        case Scalar::Float32:
            return use(float());
        case Scalar::Float64:
            break;
    }
    return use(double());
}

template <class T>
T decode(std::string_view bytes, std::endian order) {
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes.begin(), sizeof(T), raw.begin());
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

template <class T>
void append(std::string& bytes, T value, std::endian order) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// A real number that no std::int64_t can hold becomes −1, which no count and no index accepts.
std::int64_t truncated(double value) {
    return std::abs(value) < 9e18 ? static_cast<std::int64_t>(value) : -1;
}

}  // namespace

std::size_t sizeOf(Scalar type) {
    return withType(type, [](auto zero) { return sizeof(zero); });
}

double decodeReal(std::string_view bytes, Scalar type, std::endian order) {
    return withType(type,
                    [&](auto zero) { return static_cast<double>(decode<decltype(zero)>(bytes, order)); });
}

std::int64_t decodeInteger(std::string_view bytes, Scalar type, std::endian order) {
    if (type == Scalar::Float32 || type == Scalar::Float64) return truncated(decodeReal(bytes, type, order));
    return withType(
        type, [&](auto zero) { return static_cast<std::int64_t>(decode<decltype(zero)>(bytes, order)); });
}

void appendReal(std::string& bytes, double value, Scalar type, std::endian order) {
    withType(type, [&](auto zero) { append(bytes, static_cast<decltype(zero)>(value), order); });
}

void appendInteger(std::string& bytes, std::int64_t value, Scalar type, std::endian order) {
    withType(type, [&](auto zero) { append(bytes, static_cast<decltype(zero)>(value), order); });
}

namespace {
constexpr double kBeyondInt64 = 9223372036854775808.0;  // 2⁶³, which the highest numbers are rounded to
}

SplitNumber splitNumber(std::int64_t number) {
    const auto value = static_cast<double>(number);
    constexpr auto kHighest = std::numeric_limits<std::int64_t>::max();
    const std::int64_t beyond =
        value < kBeyondInt64 ? number - static_cast<std::int64_t>(value) : number - kHighest - 1;
    return {value, static_cast<std::int16_t>(beyond)};
}

std::int64_t wholeNumber(SplitNumber split) {
    constexpr auto kHighest = std::numeric_limits<std::int64_t>::max();
    constexpr auto kLowest = std::numeric_limits<std::int64_t>::min();
    if (split.value >= kBeyondInt64) return kHighest + std::min(split.beyond + 1, 0);
    if (!(split.value >= -kBeyondInt64)) return kLowest;
    return static_cast<std::int64_t>(split.value) + split.beyond;
}

SplitNumber splitNumber(std::uint64_t number) {
    const auto value = static_cast<double>(number);
    // Modulo 2⁶⁴, to which the highest numbers are rounded.
    const std::uint64_t whole = value < 2 * kBeyondInt64 ? static_cast<std::uint64_t>(value) : 0;
    return {value, static_cast<std::int16_t>(static_cast<std::int64_t>(number - whole))};
}

std::uint64_t unsignedNumber(SplitNumber split) {
    constexpr auto kHighest = std::numeric_limits<std::uint64_t>::max();
    if (split.value >= 2 * kBeyondInt64)
        return kHighest - static_cast<std::uint64_t>(-std::min(split.beyond + 1, 0));
    if (!(split.value >= 0)) return 0;
    return static_cast<std::uint64_t>(split.value) +
           static_cast<std::uint64_t>(static_cast<std::int64_t>(split.beyond));
}

}  // namespace wend::formats
