#include "app/session/live_drag.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/handle_edits.h"

namespace wend {

namespace {

constexpr double kLongestPiece = 0.03;  // of the diagonal, per step of the midpoint rule
constexpr double kMostPieces = 2;       // per sample: the pointer is more urgent than the path
constexpr double kArm = 0.25;           // of the diagonal: what turning and growing are measured at

IntegrationOptions liveOptions() {
    IntegrationOptions options;
    options.method = Method::Midpoint;
    options.steps = 1;  // one step per unit of time, which is one piece of the way
    options.end = 1;
    return options;
}

template <int Dim>
std::vector<Handle<Dim>> still(std::vector<Handle<Dim>> handles) {
    for (Handle<Dim>& handle : handles) {
        handle.motions.clear();
        handle.activeFrom = -std::numeric_limits<double>::infinity();
        handle.activeTo = std::numeric_limits<double>::infinity();
    }
    return handles;
}

}  // namespace

template <int Dim>
LiveDrag<Dim>::LiveDrag(const BuiltShape<Dim>& shape, std::vector<Handle<Dim>> handles)
    : m_shape(shape),
      m_diagonal(boundingBoxDiagonal<Dim>(shape.rest->points)),
      m_handles(still(std::move(handles))),
      m_deformer(shape.rest, shape.material, m_handles, liveOptions()) {
    m_deformer.velocity();
}

template <int Dim>
bool LiveDrag<Dim>::fits(const BuiltShape<Dim>& shape, const std::vector<Handle<Dim>>& handles) const {
    return shape.rest == m_shape.rest && shape.material == m_shape.material &&
           std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), samePlace<Dim>);
}

template <int Dim>
void LiveDrag<Dim>::begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose) {
    m_dragged = std::move(dragged);
    m_grip = grip;
    m_amount.setZero();
    m_handles = still(std::move(m_handles));
    m_deformer.setHandles(m_handles);
    State<Dim> now;
    now.time = m_deformer.state().time;
    now.points = pose;
    m_deformer.restore(now);
}

template <int Dim>
void LiveDrag<Dim>::aim(const Amount& next) {
    const double now = m_deformer.state().time;
    Motion<Dim> motion = motionBetween<Dim>(m_grip, m_amount, next);
    motion.start = now;
    motion.end = now + 1;
    for (const int h : m_dragged) m_handles[h].motions = {motion};
    m_deformer.setHandles(m_handles);
}

/// Of a way in the domain's units, as far as it can be told.
template <int Dim>
double LiveDrag<Dim>::length(const Amount& way) const {
    return m_grip.kind == Grip::Kind::Move ? way.norm() : kArm * m_diagonal * std::abs(way[0]);
}

template <int Dim>
typename LiveDrag<Dim>::Step LiveDrag<Dim>::follow(const Amount& amount) {
    Step step;
    const Amount from = m_amount, way = amount - m_amount;
    const double pieces = std::clamp(std::ceil(length(way) / (kLongestPiece * m_diagonal)), 1.0, kMostPieces);
    for (int i = 0; i < pieces && !step.stopped && way != Amount::Zero(); ++i) {
        const double before = m_deformer.state().time;
        const Amount next = from + (i + 1) / pieces * way;
        aim(next);
        const AdvanceResult result = m_deformer.advance(before + 1);
        const double done = std::clamp(m_deformer.state().time - before, 0.0, 1.0);
        m_amount += done * (next - m_amount);
        step.stopped = result.outcome != Outcome::Done;
        step.message = result.message;
    }
    if (!step.stopped) m_amount = amount;
    step.amount = m_amount;
    step.pinError = m_deformer.statistics().constraintError * m_diagonal;
    return step;
}

template class LiveDrag<2>;
template class LiveDrag<3>;

}  // namespace wend
