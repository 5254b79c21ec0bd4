#pragma once

#include "app/session/shape_session.h"

namespace wend {

/// Many points of one handle have one way for all.
template <int Dim>
std::vector<Vec<Dim>> shownStarts(const std::vector<Vec<Dim>>& starts) {
    constexpr std::size_t kMost = 3;
    return starts.size() <= kMost ? starts : std::vector<Vec<Dim>>{meanOf<Dim>(starts)};
}

/// A pin becomes all that lies within a circle, or a ball, around it, or with a radius of 0 a single point;
/// false, with a notice, where that is too small to hold a part. Changes of one `key` that follow each other
/// are one step.
template <int Dim>
bool widenPin(ShapeSession& session, int handle, double radius, const QString& key = {});

}  // namespace wend
