#pragma once

#include <cstdint>
#include <vector>

namespace wend {

/// Numbers keys in the order in which they first appear; the number of a key is its position in keys().
class Numbering {
  public:
    /// Returns the number of a key, which is appended if it is new.
    int of(int key) {
        if (2 * m_keys.size() >= m_table.size()) grow();
        std::size_t at = slot(key);
        while (m_table[at] >= 0 && m_keys[m_table[at]] != key) at = (at + 1) & (m_table.size() - 1);
        if (m_table[at] < 0) {
            m_table[at] = static_cast<int>(m_keys.size());
            m_keys.push_back(key);
        }
        return m_table[at];
    }
    const std::vector<int>& keys() const { return m_keys; }
    int size() const { return static_cast<int>(m_keys.size()); }
    void clear() {
        m_keys.clear();
        m_table.assign(m_table.size(), -1);
    }

  private:
    std::size_t slot(int key) const {
        return (static_cast<std::uint32_t>(key) * 2654435769U >> 7) & (m_table.size() - 1);
    }
    void grow() {
        m_table.assign(2 * m_table.size(), -1);
        for (std::size_t i = 0; i < m_keys.size(); ++i) {
            std::size_t at = slot(m_keys[i]);
            while (m_table[at] >= 0) at = (at + 1) & (m_table.size() - 1);
            m_table[at] = static_cast<int>(i);
        }
    }

    std::vector<int> m_keys;
    std::vector<int> m_table = std::vector<int>(128, -1);  // places; a power of two of them
};

}  // namespace wend
