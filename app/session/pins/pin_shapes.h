#pragma once

#include "app/session/shape_session.h"

namespace wend {

/// Returns one path for all points of a handle.
template <int Dim>
std::vector<Vec<Dim>> shownStarts(const std::vector<Vec<Dim>>& starts) {
    constexpr std::size_t kMost = 3;
    return starts.size() <= kMost ? starts : std::vector<Vec<Dim>>{meanOf<Dim>(starts)};
}

/// Widens a pin to a disc or ball, or reduces it to a point for radius 0. Returns false and emits a notice if
/// the radius is too small to contain a vertex. Consecutive changes with the same `key` merge into one step.
template <int Dim>
bool widenPin(ShapeSession& session, int handle, double radius, const QString& key = {});

}  // namespace wend
