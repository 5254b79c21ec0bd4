#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/assembly/stage_vectors.h"
#include "core/base/error.h"

// A states file begins with 16 bytes that name the format and its version; blocks follow. A block consists of
// its kind (4 bytes), the length of its content (8), the content, and the CRC-32 of all of these (4). Numbers
// are little-endian.
//
//   Header      identifies what the run is of
//   Array       a number by which others refer to it (8 bytes), its columns (8), and Dim doubles for each
//   Step        StepRecord
//   Checkpoint  lets a run continue from the last step before it
//
// Blocks are only ever appended. A run that is killed leaves at most one incomplete block; blocks after the
// last checkpoint do not count.

namespace wend::states {

static_assert(std::endian::native == std::endian::little, "states files are little-endian");

inline constexpr std::string_view kMagic("wend states v003", 16);
inline constexpr std::size_t kVersionAt = 13;  // in the magic
/// The kinds of blocks; the numbers are those in the file.
enum class BlockKind : std::uint32_t { Header = 1, Array, Step, Checkpoint };
inline constexpr std::uint64_t kBeforeBlock = 12, kAfterBlock = 4;

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Serializes values to bytes.
template <int Dim>
class Storing {
  public:
    /// `idOf` writes an array to the file, if it is not there yet, and returns its number.
    explicit Storing(std::function<std::uint64_t(const Nodal<Dim>&)> idOf) : m_idOf(std::move(idOf)) {}

    template <class... T>
    void operator()(T&... values) {
        (put(values), ...);
    }
    const std::string& bytes() const { return m_bytes; }

  private:
    template <class T>
    void putRaw(T value) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), &value, sizeof(T));
        m_bytes.append(raw.data(), raw.size());
    }
    void put(Nodal<Dim>& array) { putRaw(array ? m_idOf(array) : std::uint64_t{0}); }
    void put(std::string& text) {
        putRaw(static_cast<std::uint64_t>(text.size()));
        m_bytes += text;
    }
    template <class T>
    void put(std::optional<T>& value) {
        putRaw(value.has_value());
        if (value) put(*value);
    }
    template <class T>
    void put(std::vector<T>& values) {
        putRaw(static_cast<std::uint64_t>(values.size()));
        for (T& value : values) put(value);
    }
    template <class T>
    void put(T& value) {
        if constexpr (Plain<T>)
            putRaw(value);
        else
            value.archive(*this);
    }

    std::function<std::uint64_t(const Nodal<Dim>&)> m_idOf;
    std::string m_bytes;
};

/// Deserializes values from bytes. Throws InputError if the bytes end too early.
template <int Dim>
class Restoring {
  public:
    Restoring(std::string_view bytes, std::function<Nodal<Dim>(std::uint64_t)> arrayOf)
        : m_bytes(bytes), m_arrayOf(std::move(arrayOf)) {}

    template <class... T>
    void operator()(T&... values) {
        (take(values), ...);
    }

  private:
    std::string_view next(std::uint64_t count) {
        if (count > m_bytes.size()) throw InputError("is damaged");
        const std::string_view piece = m_bytes.substr(0, count);
        m_bytes.remove_prefix(count);
        return piece;
    }
    void take(Nodal<Dim>& array) {
        std::uint64_t id = 0;
        take(id);
        array = id == 0 ? nullptr : m_arrayOf(id);
    }
    std::uint64_t takeCount() {
        std::uint64_t count = 0;
        take(count);
        if (count > m_bytes.size()) throw InputError("is damaged");  // everything takes a byte at least
        return count;
    }
    void take(std::string& text) { text = next(takeCount()); }
    template <class T>
    void take(std::optional<T>& value) {
        bool has = false;
        take(has);
        value.reset();
        if (has) take(value.emplace());
    }
    template <class T>
    void take(std::vector<T>& values) {
        values.clear();
        for (std::uint64_t left = takeCount(); left > 0; --left) take(values.emplace_back());
    }
    template <class T>
    void take(T& value) {
        if constexpr (Plain<T>)
            std::memcpy(&value, next(sizeof(T)).data(), sizeof(T));
        else
            value.archive(*this);
    }

    std::string_view m_bytes;
    std::function<Nodal<Dim>(std::uint64_t)> m_arrayOf;
};

}  // namespace wend::states
