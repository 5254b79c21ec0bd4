#include "python/handles_module.h"

#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/module.h"

namespace wend::python {
namespace {

using Numbers = Array<double>;

TimeWindow windowFrom(const std::pair<double, double>& time, const std::string& ease) {
    return {time.first, time.second,
            choice<Pacing>("ease", ease,
                           {{"linear", Pacing::Even},
                            {"in", Pacing::EaseIn},
                            {"out", Pacing::EaseOut},
                            {"in-out", Pacing::EaseInOut}})};
}

template <int Dim>
std::vector<Coordinates<Dim>> pointsFrom(const Numbers& array, const std::string& name) {
    const auto rows = rowsOf<Dim, double>(array, name);
    return {rows.begin(), rows.end()};
}

AnyPlace pointsAt(const Numbers& points) {
    if (dimensionIn(points, "points") == 2) return {Place<2>::points(pointsFrom<2>(points, "points"))};
    return {Place<3>::points(pointsFrom<3>(points, "points"))};
}

AnyPlace ballAt(const Numbers& centre, double radius) {
    if (dimensionIn(centre, "centre") == 2)
        return {Place<2>::ball(coordinatesIn<2>(centre, "centre"), radius)};
    return {Place<3>::ball(coordinatesIn<3>(centre, "centre"), radius)};
}

template <int Dim>
AnyPlace boxOf(const Numbers& min, const Numbers& max) {
    return {Place<Dim>::box(coordinatesIn<Dim>(min, "min"), coordinatesIn<Dim>(max, "max"))};
}
AnyPlace boxAt(const Numbers& min, const Numbers& max) {
    return dimensionIn(min, "min") == 2 ? boxOf<2>(min, max) : boxOf<3>(min, max);
}

template <int Dim>
AnyPlace halfSpaceOf(const Numbers& point, const Numbers& normal) {
    return {Place<Dim>::halfSpace(coordinatesIn<Dim>(point, "point"), coordinatesIn<Dim>(normal, "normal"))};
}
AnyPlace halfSpaceAt(const Numbers& point, const Numbers& normal) {
    return dimensionIn(point, "point") == 2 ? halfSpaceOf<2>(point, normal) : halfSpaceOf<3>(point, normal);
}

AnyPlace freeAlong(const AnyPlace& place, const std::vector<bool>& along) {
    return std::visit(
        [&]<int Dim>(const Place<Dim>& one) -> AnyPlace {
            if (along.size() != Dim)
                throw InvalidInput("along: " + std::to_string(Dim) + " values are needed");
            std::array<bool, Dim> free;
            std::copy(along.begin(), along.end(), free.begin());
            return {one.free(free)};
        },
        place.place);
}

/// A piece that has the same numbers in both dimensions: `add(movement)` for the one that the array has.
template <typename Add>
Piece pieceOf(int dimension, Add add) {
    Piece piece;
    if (dimension == 2)
        piece.inPlane = [add](Movement<2>& movement) { add(movement); };
    else
        piece.inSpace = [add](Movement<3>& movement) { add(movement); };
    return piece;
}

Piece translate(const Numbers& by, const std::pair<double, double>& time, const std::string& ease) {
    const TimeWindow when = windowFrom(time, ease);
    return pieceOf(dimensionIn(by, "by"), [=]<int Dim>(Movement<Dim>& movement) {
        movement.translate(coordinatesIn<Dim>(by, "by"), when);
    });
}

Piece rotate(const Numbers& centre, double angle, const std::optional<Numbers>& axis,
             const std::pair<double, double>& time, const std::string& ease) {
    const TimeWindow when = windowFrom(time, ease);
    Piece piece;
    if (dimensionIn(centre, "centre") == 2) {
        if (axis) throw InvalidInput("axis: in the plane there is none");
        const auto c = coordinatesIn<2>(centre, "centre");
        piece.inPlane = [=](Movement<2>& movement) { movement.rotate(c, angle, when); };
    } else {
        if (!axis) throw InvalidInput("axis: in space one is needed");
        const auto c = coordinatesIn<3>(centre, "centre"), a = coordinatesIn<3>(*axis, "axis");
        piece.inSpace = [=](Movement<3>& movement) { movement.rotate(c, a, angle, when); };
    }
    return piece;
}

Piece follow(const Numbers& points, const std::string& interpolation, const std::string& frame, double twist,
             double scale, const std::pair<double, double>& time, const std::string& ease) {
    CurveCarriage carriage;
    carriage.joining = choice<Joining>(
        "interpolation", interpolation,
        {{"bezier", Joining::Cubics}, {"spline", Joining::Spline}, {"polyline", Joining::Lines}});
    carriage.frame = choice<CurveFrame>(
        "frame", frame,
        {{"none", CurveFrame::None}, {"frenet", CurveFrame::Frenet}, {"minimal", CurveFrame::Minimal}});
    carriage.twist = twist;
    carriage.scale = scale;
    const TimeWindow when = windowFrom(time, ease);
    return pieceOf(dimensionIn(points, "points"), [=]<int Dim>(Movement<Dim>& movement) {
        movement.follow(pointsFrom<Dim>(points, "points"), carriage, when);
    });
}

Piece record(const std::vector<double>& times, const Numbers& points, const std::pair<double, double>& time,
             const std::string& ease) {
    const TimeWindow when = windowFrom(time, ease);
    return pieceOf(dimensionIn(points, "points"), [=]<int Dim>(Movement<Dim>& movement) {
        movement.record(times, pointsFrom<Dim>(points, "points"), when);
    });
}

Piece displace(const std::vector<int>& vertices, const Numbers& by, const std::pair<double, double>& time,
               const std::string& ease) {
    const TimeWindow when = windowFrom(time, ease);
    if (by.ndim() != 2 || by.shape(0) != static_cast<py::ssize_t>(vertices.size()))
        throw InvalidInput("by: a row for each of the " + std::to_string(vertices.size()) +
                           " vertices is needed");
    return pieceOf(dimensionIn(by, "by"), [=]<int Dim>(Movement<Dim>& movement) {
        std::vector<std::pair<int, Coordinates<Dim>>> displacements;
        const auto rows = rowsOf<Dim, double>(by, "by");
        for (std::size_t k = 0; k < rows.size(); ++k) displacements.emplace_back(vertices[k], rows[k]);
        movement.displace(displacements, when);
    });
}

template <int Dim>
void addTo(Movement<Dim>& movement, const Piece& piece) {
    if constexpr (Dim == 2) {
        if (piece.inPlane) return piece.inPlane(movement);
    } else {
        if (piece.inSpace) return piece.inSpace(movement);
    }
    throw InvalidInput("a movement has not the dimension of the mesh, " + std::to_string(Dim));
}

}  // namespace

template <int Dim>
Place<Dim> placeFrom(const py::object& object) {
    if (py::isinstance<AnyPlace>(object)) {
        const auto& any = object.cast<const AnyPlace&>();
        if (const auto* place = std::get_if<Place<Dim>>(&any.place)) return *place;
        throw InvalidInput("the place has not the dimension of the mesh, " + std::to_string(Dim));
    }
    const py::array any = py::array::ensure(object);
    const bool whole = any && any.ndim() == 1 && (any.dtype().kind() == 'i' || any.dtype().kind() == 'u');
    if (!whole && !(any && any.size() == 0))
        throw InvalidInput("a place is one of wend.points(), ball(), box() …, or a list of vertices");
    const auto numbers = Array<int>::ensure(any);
    return Place<Dim>(std::vector<int>(numbers.data(), numbers.data() + numbers.size()));
}
template Place<2> placeFrom<2>(const py::object&);
template Place<3> placeFrom<3>(const py::object&);

template <int Dim>
Movement<Dim> movementFrom(const py::object& object) {
    Movement<Dim> movement;
    if (object.is_none()) return movement;
    if (py::isinstance<Piece>(object)) {
        addTo(movement, object.cast<const Piece&>());
        return movement;
    }
    for (const py::handle piece : object) addTo(movement, piece.cast<const Piece&>());
    return movement;
}
template Movement<2> movementFrom<2>(const py::object&);
template Movement<3> movementFrom<3>(const py::object&);

void addHandles(py::module_& module) {
    using namespace py::literals;
    const std::pair<double, double> unit(0, 1);
    py::class_<AnyPlace>(module, "Place", "Points of a shape at rest that move as one.")
        .def("free", &freeAlong, "along"_a,
             "The same points, free along the coordinates that are True and held along the others.");
    module.def("points", &pointsAt, "points"_a,
               "Points anywhere in the rest shape, an array of shape (n, 2) or (n, 3).");
    module.def("ball", &ballAt, "centre"_a, "radius"_a, "All vertices in a disc or ball.");
    module.def("box", &boxAt, "min"_a, "max"_a, "All vertices in an axis-aligned box.");
    module.def("half_space", &halfSpaceAt, "point"_a, "normal"_a,
               "All vertices on the side of a line or plane that its normal points to.");
    module.def(
        "polygon",
        [](const Numbers& points) -> AnyPlace {
            return {Place<2>::polygon(pointsFrom<2>(points, "points"))};
        },
        "points"_a, "All vertices in a polygon, an array of shape (n, 2).");

    py::class_<Piece>(module, "Movement",
                      "One piece of a handle's motion, in its time window; several make a list.");
    module.def("translate", &translate, "by"_a, py::kw_only(), "time"_a = unit, "ease"_a = "linear",
               "Translates by a vector. ease: linear, in, out, in-out.");
    module.def("rotate", &rotate, "centre"_a, "angle"_a, "axis"_a = py::none(), py::kw_only(),
               "time"_a = unit, "ease"_a = "linear",
               "Rotates about a centre, in space about an axis through it, by an angle in radians; in the "
               "plane x turns towards y.");
    module.def(
        "follow", &follow, "points"_a, "interpolation"_a = "bezier", "frame"_a = "none", "twist"_a = 0.0,
        "scale"_a = 1.0, py::kw_only(), "time"_a = unit, "ease"_a = "linear",
        "Carries the points along a curve, relative to its first point. interpolation: bezier (a chain "
        "of cubics, 3 k + 1 points), spline, polyline; frame: none, frenet, minimal; twist in radians "
        "over the whole curve; scale: the factor at its end.");
    module.def(
        "record", &record, "times"_a, "points"_a, py::kw_only(), "time"_a = unit, "ease"_a = "linear",
        "Translates along recorded points, relative to the first; the times are spread over the window.");
    module.def("displace", &displace, "vertices"_a, "by"_a, py::kw_only(), "time"_a = unit,
               "ease"_a = "linear",
               "Displaces vertices, each along its own straight line: `by` has a row for each.");
}

}  // namespace wend::python
