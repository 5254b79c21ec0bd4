#pragma once

#include <functional>
#include <map>
#include <optional>

#include "core/integration/deformer.h"

namespace wend {

/// States by time, from which an integration can go on. Changing a handle at time t keeps what lies up to t.
template <int Dim>
class PoseCache {
  public:
    void clear() { m_states.clear(); }
    void add(const State<Dim>& state) { m_states.insert_or_assign(state.time, state); }
    void keepUpTo(double time) { m_states.erase(m_states.upper_bound(time), m_states.end()); }
    /// Gives every state another time, or drops it where there is none.
    void retime(const std::function<std::optional<double>(double)>& timeOf) {
        std::map<double, State<Dim>> states;
        for (auto& [time, state] : m_states) {
            const auto other = timeOf(time);
            if (!other) continue;
            state.time = *other;
            states.insert_or_assign(*other, std::move(state));
        }
        m_states = std::move(states);
    }
    /// The newest state, or null.
    const State<Dim>* last() const { return m_states.empty() ? nullptr : &m_states.rbegin()->second; }
    std::size_t size() const { return m_states.size(); }

  private:
    std::map<double, State<Dim>> m_states;
};

}  // namespace wend
