#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace wend {

/// Writes the binary messages between the program and its helpers: arrays in native byte order, each preceded
/// by its length.
class ArrayWriter {
  public:
    template <typename Container>
    void array(const Container& values) {
        const auto count = static_cast<std::uint64_t>(values.size());
        m_bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
        m_bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(*values.data()));
    }
    std::string take() { return std::move(m_bytes); }

  private:
    std::string m_bytes;
};

/// Reads such messages. Each array is read into a container of the same kind; array() returns false if there
/// are too few bytes.
class ArrayReader {
  public:
    explicit ArrayReader(const std::string& bytes) : m_bytes(bytes) {}

    template <typename Container>
    bool array(Container& values) {
        std::uint64_t count = 0;
        if (m_bytes.size() - m_at < sizeof count) return false;
        std::memcpy(&count, m_bytes.data() + m_at, sizeof count);
        m_at += sizeof count;
        constexpr std::size_t size = sizeof(typename Container::value_type);
        if (count > (m_bytes.size() - m_at) / size) return false;
        values.resize(count);
        std::memcpy(values.data(), m_bytes.data() + m_at, count * size);
        m_at += count * size;
        return true;
    }
    bool done() const { return m_at == m_bytes.size(); }

  private:
    const std::string& m_bytes;
    std::size_t m_at = 0;
};

}  // namespace wend
