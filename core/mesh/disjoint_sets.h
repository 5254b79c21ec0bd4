#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace wend {

/// Numbers 0 … count − 1 in sets that can be united; a set is called by its lowest.
class DisjointSets {
  public:
    explicit DisjointSets(int count) : m_parents(static_cast<std::size_t>(count)) {
        std::iota(m_parents.begin(), m_parents.end(), 0);
    }
    int root(int i) {
        while (m_parents[i] != i) i = m_parents[i] = m_parents[m_parents[i]];
        return i;
    }
    void join(int a, int b) {
        const auto [low, high] = std::minmax({root(a), root(b)});
        m_parents[high] = low;
    }

  private:
    std::vector<int> m_parents;
};

}  // namespace wend
