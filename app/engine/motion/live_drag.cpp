#include "app/engine/motion/live_drag.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <thread>

#include "app/project/edits/handle_comparison.h"
#include "core/base/error.h"
#include "core/mesh/shape_size.h"
#include "kernels/back_end_choice.h"

namespace wend {

namespace {

constexpr double kLongestPiece = 0.06;  // of the size
constexpr double kMostPieces = 2;       // per sample: the pointer is more urgent than the path
// fraction of the size: the lever arm that converts rotation and scaling to a length
constexpr double kArm = 0.25;
// Vertices up to which a factor for every field is quick enough.
template <int Dim>
constexpr int kExactVertices = Dim == 2 ? 20000 : 2500;
constexpr int kSmall = 10000;            // vertices
constexpr double kStiffestPreview = 16;  // w_r / w_q of which factors still last

/// Small shapes use one thread: their fields cost about as much as painting, which needs the other cores, and
/// synchronizing threads a hundred times per field is slower than one thread. Large shapes use all.
int previewThreads(int vertices) {
    return vertices > kSmall ? 0 : std::max(1, static_cast<int>(std::thread::hardware_concurrency() / 2));
}

/// Returns the material of the preview. Every field near EQUIA needs its own factor, so the preview of a
/// large shape preserves areas and volumes slightly less strictly.
template <int Dim>
std::shared_ptr<const Material<Dim>> previewMaterial(const std::shared_ptr<const Material<Dim>>& material,
                                                     const Shape<Dim>& shape) {
    const double minimum = std::atan(1 / kStiffestPreview);
    const auto& phi = material->phi;
    const bool lasts = std::all_of(phi.begin(), phi.end(), [&](double x) { return x >= minimum; });
    if (lasts || shape.rest->vertexCount() <= kExactVertices<Dim>) return material;
    auto softer = std::make_shared<Material<Dim>>(*material);
    for (double& x : softer->phi) x = std::max(x, minimum);
    return softer;
}

/// Makes the flow of the shape, or of the body that carries it.
template <int Dim>
DragFlow<Dim> flowOf(const Shape<Dim>& shape, const std::shared_ptr<const SimplicialMesh<Dim>>& rest,
                     const std::shared_ptr<const Material<Dim>>& material,
                     const std::vector<Handle<Dim>>& handles) {
    return DragFlow<Dim>(rest, previewMaterial<Dim>(material, shape), handles,
                         backEndFactory<Dim>(BackEndKind::Automatic), previewThreads(rest->vertexCount()));
}

}  // namespace

template <int Dim>
LiveDrag<Dim>::LiveDrag(const Shape<Dim>& shape, std::vector<Handle<Dim>> handles,
                        std::shared_ptr<const CoarseBody<Dim>> body)
    : m_shape(shape),
      m_size(shapeSize<Dim>(shape.rest->points, shape.rest->cells).size),
      m_handles(std::move(handles)),
      m_body(std::move(body)) {
    if (!m_body || !ride()) flowByItself();
}

/// Returns false if the body cannot be held as the shape is.
template <int Dim>
bool LiveDrag<Dim>::ride() try {
    auto held = m_body->held(m_handles);
    if (!held) return false;
    m_flow.emplace(flowOf<Dim>(m_shape, m_body->rest(), m_body->material(), held->handles));
    m_held = std::move(*held);
    return true;
} catch (const InputError&) {
    return false;
}

template <int Dim>
void LiveDrag<Dim>::flowByItself() {
    m_body.reset();
    m_flow.emplace(flowOf<Dim>(m_shape, m_shape.rest, m_shape.material, m_handles));
}

template <int Dim>
bool LiveDrag<Dim>::fits(const Shape<Dim>& shape, const std::vector<Handle<Dim>>& handles) const {
    return shape.rest == m_shape.rest && shape.material == m_shape.material &&
           std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(),
                      [](const auto& a, const auto& b) { return samePlace(inSpace(a), inSpace(b)); });
}

template <int Dim>
void LiveDrag<Dim>::begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose,
                          const std::vector<Handle<Dim>>& handles, double time) {
    m_dragged = std::move(dragged);
    m_grip = grip;
    m_amount.setZero();
    m_time = time;
    m_others.clear();
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        if (std::count(m_dragged.begin(), m_dragged.end(), h)) continue;
        Other other{h, {}};
        for (const Motion<Dim>& motion : handles[static_cast<std::size_t>(h)].motions)
            if (motion.end > time) other.motions.emplace_back(motion);
        if (!other.motions.empty()) m_others.push_back(std::move(other));
    }
    beginFlow(pose);
}

template <int Dim>
void LiveDrag<Dim>::beginFlow(const Points<Dim>& pose) {
    auto ride = m_body ? m_body->begin(pose) : std::nullopt;
    if (m_body && !ride) flowByItself();
    if (!ride) return m_flow->begin(pose);
    m_ride = std::move(*ride);
    m_carried = pose;
    m_flow->begin(m_ride.body);
}

/// Composes the motions of the other handles up to the given time: M(t₁) ∘ M(t₀)⁻¹, motion after motion.
template <int Dim>
std::vector<typename DragFlow<Dim>::Alongside> LiveDrag<Dim>::othersUntil(double time) const {
    std::vector<typename DragFlow<Dim>::Alongside> others;
    for (const Other& other : m_others) {
        AffineMap<Dim> all;
        for (const Trajectory<Dim>& motion : other.motions) {
            if (time <= motion.start() || m_time >= motion.end()) continue;
            const AffineMap<Dim> from = motion.at(m_time).position,
                                 to = motion.at(time, Side::Before).position;
            const Mat<Dim> A = to.A * from.A.inverse();
            const Vec<Dim> b = to.b - A * from.b;
            all = {A * all.A, A * all.b + b};
        }
        others.push_back({other.handle, all});
    }
    return others;
}

/// Returns an estimate of a change as a length in domain units.
template <int Dim>
double LiveDrag<Dim>::length(const Amount& change) const {
    return m_grip.kind == Grip::Kind::Move ? change.norm() : kArm * m_size * std::abs(change[0]);
}

template <int Dim>
typename LiveDrag<Dim>::Step LiveDrag<Dim>::follow(const Amount& amount, std::optional<double> time) {
    Step step;
    const Amount from = m_amount, change = amount - m_amount;
    const double begin = m_time, later = time && !m_others.empty() ? std::max(*time - m_time, 0.0) : 0;
    const double pieces = std::clamp(std::ceil(length(change) / (kLongestPiece * m_size)), 1.0, kMostPieces);
    for (int i = 0; i < pieces && !step.stopped && (change != Amount::Zero() || later > 0); ++i) {
        const double part = (i + 1) / pieces, then = begin + part * later;
        const Amount next = from + part * change;
        const auto led =
            m_flow->lead(m_dragged, motionIn<Dim>(motionBetween(m_grip, m_amount, next)), othersUntil(then));
        m_amount += led.done * (next - m_amount);
        m_time += led.done * (then - m_time);
        step.stopped = led.done < 1;
        step.message = led.problem;
    }
    if (m_body) m_carried = m_body->carried(m_ride, m_flow->pose(), m_held);
    if (!step.stopped) m_amount = amount;
    step.amount = m_amount;
    step.pinError = m_flow->constraintError();
    return step;
}

template class LiveDrag<2>;
template class LiveDrag<3>;

}  // namespace wend
