#include "app/window/film/track_layout.h"

#include <algorithm>
#include <cmath>

#include "app/window/film/time_strip.h"

namespace wend {

namespace {

constexpr double kBarHeight = 16;    // pixels
constexpr double kBarGrip = 5;       // pixels of a bar's end, to both sides
constexpr double kKeyReach = 6;      // pixels around a key
constexpr double kDragDistance = 3;  // pixels before a press is a drag

}  // namespace

QRectF TrackLayout::rowRect(int row) const {
    return {0, area.top() + row * kRowHeight - scrolled, area.width(), kRowHeight};
}

MotionTime TrackLayout::timeOf(const Bar& bar) const {
    MotionTime time = bar.time;
    const bool isHold = bar.motion == kHold, isDragged = drag && isAmong<MotionId>(drag->bars, bar);
    if (isDragged && !isHold)
        time = {carried(time.start, drag->from, drag->to), carried(time.end, drag->from, drag->to)};
    else if (isDragged)
        time = drag->to;
    else if (drag && drag->hit.isKey() && !isHold)
        time = {timeOf(KeyId{bar.handle, time.start}), timeOf(KeyId{bar.handle, time.end})};
    return {std::max(time.start, 0.0), isHold ? std::min(time.end, scale.end()) : time.end};
}

double TrackLayout::timeOf(const KeyId& key) const {
    return drag && isAmong(drag->keys, key) ? carried(key.time, drag->from, drag->to) : key.time;
}

QRectF TrackLayout::rectOf(const Bar& bar) const {
    const MotionTime time = timeOf(bar);
    return {scale.xOf(time.start), rowRect(bar.handle).center().y() - kBarHeight / 2,
            std::max(scale.pixelsOf(time.end - time.start), 4.0), kBarHeight};
}

QPointF TrackLayout::spotOf(const KeyId& key) const {
    return {scale.xOf(timeOf(key)), rowRect(key.handle).center().y()};
}

int TrackLayout::rowAt(const QPointF& at) const {
    if (at.y() < area.top()) return -1;
    const int row = static_cast<int>((at.y() - area.top() + scrolled) / kRowHeight);
    return row < static_cast<int>(rows.size()) ? row : -1;
}

/// Returns the item at a place. The middle of a short bar moves it, and its ends reach a little beyond it. If
/// both ends of a hold are there, the one that can move further is returned.
std::optional<TrackLayout::Hit> TrackLayout::hitAt(const QPointF& at,
                                                   const std::vector<KeyId>& others) const {
    const int row = rowAt(at);
    if (row < 0) return {};
    const Row& own = rows[row];
    const auto off = [&](const KeyId& key) { return std::abs(scale.xOf(key.time) - at.x()); };
    const auto nearest = std::ranges::min_element(own.keys, {}, off);
    if (nearest != own.keys.end() && off(*nearest) <= kKeyReach && !isAmong(others, *nearest))
        return Hit{Part::Key, *nearest};
    for (const Bar& bar : own.bars) {
        const QRectF box = rectOf(bar);
        if (at.x() < box.left() - kBarGrip || at.x() > box.right() + kBarGrip) continue;
        const double inner = std::min(kBarGrip, box.width() / 4);
        if (at.x() < box.left() + inner) return Hit{Part::Start, {}, bar};
        return Hit{at.x() > box.right() - inner ? Part::End : Part::Body, {}, bar};
    }
    const MotionTime hold = timeOf(own.hold);
    const double toStart = std::abs(at.x() - scale.xOf(hold.start));
    const double toEnd = std::abs(at.x() - scale.xOf(hold.end));
    if (std::min(toStart, toEnd) > kBarGrip) return {};
    const bool isStart = toStart < toEnd || (toStart == toEnd && own.hold.time.start > 0);
    return Hit{isStart ? Part::Start : Part::End, {}, own.hold};
}

// --- Dragging ---

double TrackLayout::snapped(double time, std::vector<double> marks) const {
    for (const Row& row : rows)
        for (const KeyId& key : row.keys)
            if (!isAmong(drag->keys, key)) marks.push_back(key.time);
    return scale.snapped(time, marks);
}

void TrackLayout::dragTo(double x, const Design& design, const std::vector<double>& marks) {
    if (!drag->moves() && std::abs(x - scale.xOf(drag->at)) < kDragDistance) return;
    const double by = scale.timeAt(x) - drag->at, key = drag->hit.key.time;
    if (drag->hit.isKey()) {
        const double shift = fittedShift(design, drag->keys, snapped(key + by, marks) - key);
        drag->to = {drag->from.start + shift, drag->from.end + shift};
    } else {
        drag->to = drag->hit.isHold() ? draggedHold(by, marks) : draggedBars(by, design, marks);
    }
}

/// Returns the dragged hold, which always covers the handle's motions.
MotionTime TrackLayout::draggedHold(double by, const std::vector<double>& marks) const {
    const auto& [start, end] = drag->from;
    const auto& bars = rows[drag->hit.bar.handle].bars;
    const double film = scale.end(), first = std::max(start, 0.0), last = std::min(end, film);
    const double latest = bars.empty() ? last - kShortestMotion : bars.front().time.start;
    const double earliest = bars.empty() ? first + kShortestMotion : std::min(bars.back().time.end, film);
    if (drag->hit.part == Part::Start)
        return {std::clamp(snapped(first + by, marks), 0.0, std::max(latest, 0.0)), end};
    return {start, std::clamp(snapped(last + by, marks), std::min(earliest, film), film)};
}

/// Moves the bars; by an end, scales all of them from the opposite end.
MotionTime TrackLayout::draggedBars(double by, const Design& design, const std::vector<double>& marks) const {
    const auto& [start, end] = drag->hit.bar.time;
    const MotionTime& span = drag->from;
    const double toStart = snapped(start + by, marks), toEnd = snapped(end + by, marks);
    MotionTime wanted = span;
    if (drag->hit.part == Part::Start) {
        wanted.start = std::lerp(span.end, toStart, (span.end - span.start) / (span.end - start));
    } else if (drag->hit.part == Part::End) {
        wanted.end = std::lerp(span.start, toEnd, (span.end - span.start) / (end - span.start));
    } else {
        const bool byEnd = toEnd != end + by && toStart == start + by;
        wanted.start = byEnd ? toEnd - (end - span.start) : toStart - (start - span.start);
        wanted.end = wanted.start + (span.end - span.start);
    }
    return fittedSpan(design, drag->bars, wanted);
}

}  // namespace wend
