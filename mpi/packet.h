#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace wend {

/// Numbers and lists of numbers on their way to a process of the same program on the same kind of machine.
class Packet {
  public:
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void put(const T& value) {
        const auto* bytes = reinterpret_cast<const std::byte*>(&value);
        m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof(T));
    }
    template <class T>
    void put(const std::vector<T>& list) {
        put(list.size());
        const auto* bytes = reinterpret_cast<const std::byte*>(list.data());
        m_bytes.insert(m_bytes.end(), bytes, bytes + list.size() * sizeof(T));
    }

    /// Takes values in the order in which they were put.
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void get(T& value) {
        std::memcpy(&value, m_bytes.data() + m_read, sizeof(T));
        m_read += sizeof(T);
    }
    template <class T>
    void get(std::vector<T>& list) {
        std::size_t size = 0;
        get(size);
        list.resize(size);
        if (size > 0) std::memcpy(static_cast<void*>(list.data()), m_bytes.data() + m_read, size * sizeof(T));
        m_read += size * sizeof(T);
    }

    std::vector<std::byte>& bytes() { return m_bytes; }
    const std::vector<std::byte>& bytes() const { return m_bytes; }

  private:
    std::vector<std::byte> m_bytes;
    std::size_t m_read = 0;
};

}  // namespace wend
