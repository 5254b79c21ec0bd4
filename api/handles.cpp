#include "api/handle_values.h"

namespace wend {
namespace {

Ease easeOf(Pacing pacing) {
    switch (pacing) {
        case Pacing::EaseIn:
            return Ease::In;
        case Pacing::EaseOut:
            return Ease::Out;
        case Pacing::EaseInOut:
            return Ease::InOut;
        case Pacing::Even:
            break;
    }
    return Ease::Linear;
}

Interpolation interpolationOf(Joining joining) {
    switch (joining) {
        case Joining::Spline:
            return Interpolation::Spline;
        case Joining::Lines:
            return Interpolation::Polyline;
        case Joining::Cubics:
            break;
    }
    return Interpolation::Bezier;
}

FrameKind frameOf(CurveFrame frame) {
    switch (frame) {
        case CurveFrame::Frenet:
            return FrameKind::Frenet;
        case CurveFrame::Minimal:
            return FrameKind::Minimal;
        case CurveFrame::None:
            break;
    }
    return FrameKind::None;
}

}  // namespace

template <int Dim>
Place<Dim>::Place(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}
template <int Dim>
Place<Dim>::Place(std::vector<int> vertices)
    : m_data(std::make_shared<const Data>(Data{std::move(vertices)})) {}

template <int Dim>
Place<Dim> Place<Dim>::vertices(std::vector<int> vertices) {
    return Place(std::move(vertices));
}
template <int Dim>
Place<Dim> Place<Dim>::points(std::vector<Coordinates<Dim>> points) {
    return Place(std::make_shared<const Data>(Data{vecsOf<Dim>(points)}));
}
template <int Dim>
Place<Dim> Place<Dim>::ball(const Coordinates<Dim>& centre, double radius) {
    return Place(std::make_shared<const Data>(Data{Region<Dim>(Ball<Dim>{vecOf<Dim>(centre), radius})}));
}
template <int Dim>
Place<Dim> Place<Dim>::box(const Coordinates<Dim>& min, const Coordinates<Dim>& max) {
    return Place(std::make_shared<const Data>(Data{Region<Dim>(Box<Dim>{vecOf<Dim>(min), vecOf<Dim>(max)})}));
}
template <int Dim>
Place<Dim> Place<Dim>::halfSpace(const Coordinates<Dim>& point, const Coordinates<Dim>& normal) {
    return Place(std::make_shared<const Data>(
        Data{Region<Dim>(HalfSpace<Dim>{vecOf<Dim>(point), vecOf<Dim>(normal)})}));
}
template <int Dim>
Place<Dim> Place<Dim>::polygon(std::vector<Coordinates<2>> points) requires(Dim == 2) {
    return Place(std::make_shared<const Data>(Data{Region<2>(Polygon{vecsOf<2>(points)})}));
}

template <int Dim>
Place<Dim> Place<Dim>::free(const std::array<bool, Dim>& along) const {
    Data data = *m_data;
    data.slides = 0;
    for (int k = 0; k < Dim; ++k)
        if (along[k]) data.slides |= 1U << k;
    return Place(std::make_shared<const Data>(std::move(data)));
}

template <int Dim>
Movement<Dim>::Movement() : m_data(std::make_unique<Data>()) {}
template <int Dim>
Movement<Dim>::Movement(const Movement& other) : m_data(std::make_unique<Data>(*other.m_data)) {}
template <int Dim>
Movement<Dim>::Movement(Movement&& other) noexcept = default;
template <int Dim>
Movement<Dim>& Movement<Dim>::operator=(const Movement& other) {
    return *this = Movement(other);
}
template <int Dim>
Movement<Dim>& Movement<Dim>::operator=(Movement&& other) noexcept = default;
template <int Dim>
Movement<Dim>::~Movement() = default;

template <int Dim>
void Movement<Dim>::Data::add(decltype(Motion<Dim>::kind) kind, const TimeWindow& when) {
    motions.push_back({std::move(kind), when.start, when.end, easeOf(when.pacing)});
}

template <int Dim>
Movement<Dim>& Movement<Dim>::translate(const Coordinates<Dim>& by, const TimeWindow& when) {
    m_data->add(Translate<Dim>{vecOf<Dim>(by)}, when);
    return *this;
}
template <int Dim>
Movement<Dim>& Movement<Dim>::rotate(const Coordinates<2>& centre, double angle,
                                     const TimeWindow& when) requires(Dim == 2) {
    m_data->add(Rotate<2>{vecOf<2>(centre), Vec2::Zero(), angle}, when);
    return *this;
}
template <int Dim>
Movement<Dim>& Movement<Dim>::rotate(const Coordinates<3>& centre, const Coordinates<3>& axis, double angle,
                                     const TimeWindow& when) requires(Dim == 3) {
    m_data->add(Rotate<3>{vecOf<3>(centre), vecOf<3>(axis), angle}, when);
    return *this;
}
template <int Dim>
Movement<Dim>& Movement<Dim>::follow(const std::vector<Coordinates<Dim>>& curve,
                                     const CurveCarriage& carriage, const TimeWindow& when) {
    m_data->add(CurveMotion<Dim>{interpolationOf(carriage.joining), vecsOf<Dim>(curve),
                                 frameOf(carriage.frame), carriage.twist, carriage.scale},
                when);
    return *this;
}
template <int Dim>
Movement<Dim>& Movement<Dim>::record(const std::vector<double>& times,
                                     const std::vector<Coordinates<Dim>>& points, const TimeWindow& when) {
    m_data->add(Recorded<Dim>{times, vecsOf<Dim>(points)}, when);
    return *this;
}
template <int Dim>
Movement<Dim>& Movement<Dim>::displace(const std::vector<std::pair<int, Coordinates<Dim>>>& displacements,
                                       const TimeWindow& when) {
    Displacements<Dim> values;
    values.reserve(displacements.size());
    for (const auto& [vertex, by] : displacements) values.emplace_back(vertex, vecOf<Dim>(by));
    m_data->add(FieldMotion<Dim>{{}, {}, std::make_shared<const Displacements<Dim>>(std::move(values))},
                when);
    return *this;
}

template class Place<2>;
template class Place<3>;
template class Movement<2>;
template class Movement<3>;

}  // namespace wend
