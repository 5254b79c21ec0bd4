#include "app/session/live_drag.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/handle_edits.h"

namespace wend {

namespace {

constexpr double kLongestPiece = 0.03;  // of the diagonal, per step of the midpoint rule
constexpr double kMostPieces = 2;       // per sample: the pointer is more urgent than the path

IntegrationOptions liveOptions() {
    IntegrationOptions options;
    options.method = Method::Midpoint;
    options.steps = 1;  // one step per unit of time, which is one piece of the way
    options.end = 1;
    return options;
}

std::vector<Handle<2>> still(std::vector<Handle<2>> handles) {
    for (Handle<2>& handle : handles) {
        handle.motions.clear();
        handle.activeFrom = -std::numeric_limits<double>::infinity();
        handle.activeTo = std::numeric_limits<double>::infinity();
    }
    return handles;
}

}  // namespace

LiveDrag::LiveDrag(const BuiltShape& shape, std::vector<Handle<2>> handles)
    : m_shape(shape),
      m_diagonal(boundingBoxDiagonal<2>(shape.rest->points)),
      m_handles(still(std::move(handles))),
      m_deformer(shape.rest, shape.material, m_handles, liveOptions()) {
    m_deformer.velocity();
}

bool LiveDrag::fits(const BuiltShape& shape, const std::vector<Handle<2>>& handles) const {
    return shape.rest == m_shape.rest && shape.material == m_shape.material &&
           std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), samePlace);
}

void LiveDrag::begin(std::vector<int> dragged, const Points<2>& pose) {
    m_dragged = std::move(dragged);
    m_offset.setZero();
    m_handles = still(std::move(m_handles));
    m_deformer.setHandles(m_handles);
    State<2> now;
    now.time = m_deformer.state().time;
    now.points = pose;
    m_deformer.restore(now);
}

void LiveDrag::aim(const Vec<2>& by) {
    const double now = m_deformer.state().time;
    for (const int h : m_dragged) {
        Motion<2> motion;
        motion.kind = Translate<2>{by};
        motion.start = now;
        motion.end = now + 1;
        m_handles[h].motions = {motion};
    }
    m_deformer.setHandles(m_handles);
}

LiveDrag::Step LiveDrag::follow(const Vec<2>& offset) {
    Step step;
    const Vec<2> way = offset - m_offset;
    const double pieces = std::clamp(std::ceil(way.norm() / (kLongestPiece * m_diagonal)), 1.0, kMostPieces);
    for (int i = 0; i < pieces && !step.stopped && way != Vec<2>::Zero(); ++i) {
        const double before = m_deformer.state().time;
        aim(way / pieces);
        const AdvanceResult result = m_deformer.advance(before + 1);
        const double done = std::clamp(m_deformer.state().time - before, 0.0, 1.0);
        m_offset += done * way / pieces;
        step.stopped = result.outcome != Outcome::Done;
        step.message = result.message;
    }
    if (!step.stopped) m_offset = offset;
    step.offset = m_offset;
    step.pinError = m_deformer.statistics().constraintError * m_diagonal;
    return step;
}

}  // namespace wend
