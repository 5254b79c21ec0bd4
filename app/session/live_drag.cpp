#include "app/session/live_drag.h"

#include <algorithm>
#include <cmath>

#include "app/document/handle_comparison.h"
#include "core/mesh/shape_size.h"
#include "kernels/back_end_choice.h"

namespace wend {

namespace {

constexpr double kLongestPiece = 0.06;  // of the size
constexpr double kMostPieces = 2;       // per sample: the pointer is more urgent than the path
constexpr double kArm = 0.25;           // of the size: what turning and growing are measured at
// Vertices up to which a factor for every field is quick enough.
template <int Dim>
constexpr int kExactVertices = Dim == 2 ? 20000 : 2500;
constexpr double kStiffestPreview = 16;  // w_r / w_q of which factors still last

/// On the way to EQUIA every field needs a factor of its own: the preview of a large shape keeps areas and
/// volumes a little less strictly, so that it keeps up.
template <int Dim>
std::shared_ptr<const Material<Dim>> previewMaterial(const Shape<Dim>& shape) {
    const double minimum = std::atan(1 / kStiffestPreview);
    const auto& phi = shape.material->phi;
    const bool lasts = std::all_of(phi.begin(), phi.end(), [&](double x) { return x >= minimum; });
    if (lasts || shape.rest->vertexCount() <= kExactVertices<Dim>) return shape.material;
    auto softer = std::make_shared<Material<Dim>>(*shape.material);
    for (double& x : softer->phi) x = std::max(x, minimum);
    return softer;
}

}  // namespace

template <int Dim>
LiveDrag<Dim>::LiveDrag(const Shape<Dim>& shape, std::vector<Handle<Dim>> handles)
    : m_shape(shape),
      m_size(shapeSize<Dim>(shape.rest->points, shape.rest->cells).size),
      m_handles(std::move(handles)),
      m_flow(shape.rest, previewMaterial<Dim>(shape), m_handles,
             backEndFactory<Dim>(BackEndKind::Automatic)) {}

template <int Dim>
bool LiveDrag<Dim>::fits(const Shape<Dim>& shape, const std::vector<Handle<Dim>>& handles) const {
    return shape.rest == m_shape.rest && shape.material == m_shape.material &&
           std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), samePlace<Dim>);
}

template <int Dim>
void LiveDrag<Dim>::begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose) {
    m_dragged = std::move(dragged);
    m_grip = grip;
    m_amount.setZero();
    m_flow.begin(pose);
}

/// Of a way in the domain's units, as far as it can be told.
template <int Dim>
double LiveDrag<Dim>::length(const Amount& way) const {
    return m_grip.kind == Grip::Kind::Move ? way.norm() : kArm * m_size * std::abs(way[0]);
}

template <int Dim>
typename LiveDrag<Dim>::Step LiveDrag<Dim>::follow(const Amount& amount) {
    Step step;
    const Amount from = m_amount, way = amount - m_amount;
    const double pieces = std::clamp(std::ceil(length(way) / (kLongestPiece * m_size)), 1.0, kMostPieces);
    for (int i = 0; i < pieces && !step.stopped && way != Amount::Zero(); ++i) {
        const Amount next = from + (i + 1) / pieces * way;
        const auto led = m_flow.lead(m_dragged, motionBetween<Dim>(m_grip, m_amount, next));
        m_amount += led.done * (next - m_amount);
        step.stopped = led.done < 1;
        step.message = led.problem;
    }
    if (!step.stopped) m_amount = amount;
    step.amount = m_amount;
    step.pinError = m_flow.constraintError();
    return step;
}

template class LiveDrag<2>;
template class LiveDrag<3>;

}  // namespace wend
