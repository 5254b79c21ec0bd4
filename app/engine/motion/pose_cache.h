#pragma once

#include <functional>
#include <map>
#include <optional>

#include "app/project/edits/handle_comparison.h"
#include "core/integration/deformer.h"

namespace wend {

/// States by time from which the integration can continue. Changing a handle at time t keeps all states up to
/// t.
template <int Dim>
class PoseCache {
  public:
    void clear() { m_states.clear(); }
    void add(const State<Dim>& state) { m_states.insert_or_assign(state.time, state); }
    /// Keeps the states up to a time and returns the others.
    PoseCache keepUpTo(double time) {
        PoseCache later;
        while (!m_states.empty() && m_states.rbegin()->first > time)
            later.m_states.insert(m_states.extract(std::prev(m_states.end())));
        return later;
    }
    /// Adds the states of another cache that are later than a time.
    void addLater(PoseCache other, double time) { m_states.merge(other.keepUpTo(time).m_states); }
    /// Returns the state at a time that is nearly this one, or null.
    const State<Dim>* at(double time) const {
        for (const auto& [own, state] : m_states)
            if (sameTime(own, time)) return &state;
        return nullptr;
    }
    /// Changes the time of every state, or drops it where the function returns nothing.
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
    /// Returns the newest state, or null.
    const State<Dim>* last() const { return m_states.empty() ? nullptr : &m_states.rbegin()->second; }
    std::size_t size() const { return m_states.size(); }

  private:
    std::map<double, State<Dim>> m_states;
};

}  // namespace wend
