#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace wend {

/// Keeps the numbers 0 … count − 1 in sets that can be united, each alone at first. A set is represented by
/// its lowest number, so that results do not depend on the order in which sets were united. Queries halve the
/// path to the root (Tarjan and van Leeuwen 1984), which makes both functions cheap over many calls, and
/// changes the object: one thread uses it at a time.
class DisjointSets {
  public:
    explicit DisjointSets(int count) : m_parents(static_cast<std::size_t>(count)) {
        std::iota(m_parents.begin(), m_parents.end(), 0);
    }
    /// Returns the lowest number of the set that contains i.
    int root(int i) {
        while (m_parents[i] != i) i = m_parents[i] = m_parents[m_parents[i]];
        return i;
    }
    /// Unites the sets of a and b.
    void join(int a, int b) {
        const auto [low, high] = std::minmax({root(a), root(b)});
        m_parents[high] = low;
    }

  private:
    std::vector<int> m_parents;
};

}  // namespace wend
