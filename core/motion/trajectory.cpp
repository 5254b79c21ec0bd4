#include "core/motion/trajectory.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/motion/easing.h"
#include "core/motion/moving_frame.h"
#include "core/motion/screw_motion.h"

namespace wend {

namespace {

void require(bool condition, const std::string& reason) {
    if (!condition) throw InputError(reason);
}

template <int Dim>
void requireFinite(const std::vector<Vec<Dim>>& points) {
    for (size_t i = 0; i < points.size(); ++i) {
        require(points[i].allFinite(), "\"points\": point " + std::to_string(i) + " is not finite");
    }
}

template <int Dim>
void check(const Translate<Dim>& motion) {
    require(motion.by.allFinite(), "\"by\" is not finite");
}

template <int Dim>
void check(const Rotate<Dim>& motion) {
    require(motion.centre.allFinite(), "\"centre\" is not finite");
    require(std::isfinite(motion.angle), "\"angle\" is not finite");
    if (Dim == 3) {
        require(motion.axis.allFinite() && motion.axis.norm() > 0, "\"axis\" has no direction");
    }
}

/// Throws InputError for too few points, or a twist or scale that is not allowed.
template <int Dim>
void check(const CurveMotion<Dim>& motion) {
    const size_t count = motion.points.size();
    if (motion.interpolation == Interpolation::Bezier) {
        require(count >= 4 && count % 3 == 1,
                "\"points\": a bezier takes 4, 7, 10 … points (3k + 1), not " + std::to_string(count));
    } else {
        require(count >= 2, "\"points\": a curve takes at least 2 points");
    }
    requireFinite(motion.points);
    require(motion.scale > 0 && std::isfinite(motion.scale), "\"scale\" must be greater than 0");
    require(std::isfinite(motion.twist), "\"twist\" is not finite");
    if (motion.twist == 0) return;
    require(Dim == 3, "\"twist\" needs three dimensions");
    require(motion.frame != FrameKind::None, "\"twist\" needs a frame: \"frenet\" or \"minimal\"");
}

template <int Dim>
void check(const Recorded<Dim>& motion) {
    const std::vector<double>& times = motion.times;
    require(times.size() == motion.points.size(),
            "\"times\" and \"points\": " + std::to_string(times.size()) + " times for " +
                std::to_string(motion.points.size()) + " points");
    require(times.size() >= 2, "\"points\": a stroke takes at least 2 points");
    requireFinite(motion.points);
    for (size_t i = 0; i < times.size(); ++i) {
        require(std::isfinite(times[i]) && (i == 0 || times[i] > times[i - 1]),
                "\"times\" do not increase at entry " + std::to_string(i));
    }
}

template <int Dim>
void check(const FieldMotion<Dim>& motion) {
    for (const auto& [vertex, displacement] : *motion.values)
        require(displacement.allFinite(),
                "the displacement of vertex " + std::to_string(vertex) + " is not finite");
}

template <int Dim>
void check(const PoseMotion<Dim>& motion) {
    require(motion.times.size() == motion.poses.size() && motion.poses.size() >= 2,
            "poses are needed for at least 2 times");
    for (size_t i = 0; i < motion.times.size(); ++i) {
        require(std::isfinite(motion.times[i]) && (i == 0 || motion.times[i] > motion.times[i - 1]),
                "the times of the poses do not increase at pose " + std::to_string(i));
        require(motion.poses[i].position.allFinite() && motion.poses[i].rotation.allFinite(),
                "pose " + std::to_string(i) + " is not finite");
    }
}

template <int Dim>
Curve<Dim> curveOf(const CurveMotion<Dim>& motion) {
    switch (motion.interpolation) {
        case Interpolation::Bezier:
            break;
        case Interpolation::Spline:
            return splineCurve(motion.points);
        case Interpolation::Polyline:
            return polylineCurve(motion.points);
    }
    return bezierCurve(motion.points);
}

template <int Dim>
Curve<Dim> curveOf(const Recorded<Dim>& motion) {
    return timedCurve(motion.times, motion.points);
}

Mat3 crossMatrix(const Vec3& w) {
    Mat3 result;
    result << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return result;
}

template <int Dim>
Mat<Dim> rotationBy(double angle, const Vec<Dim>& axis) {
    if constexpr (Dim == 2) {
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    } else {
        return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    }
}

/// Returns [axis]×, the rate of a rotation by one radian per unit of time.
template <int Dim>
Mat<Dim> spin(const Vec<Dim>& axis) {
    if constexpr (Dim == 2) {
        return (Mat2() << 0, -1, 1, 0).finished();
    } else {
        return crossMatrix(axis);
    }
}

/// Returns a motion as a function of its parameter u ∈ [0, 1]; velocity per unit of u.
template <int Dim>
MovingMap<Dim> mapOf(const Translate<Dim>& motion, double u) {
    return {{Mat<Dim>::Identity(), u * motion.by}, {Mat<Dim>::Zero(), motion.by}};
}

template <int Dim>
MovingMap<Dim> mapOf(const Rotate<Dim>& motion, double u) {
    const Vec<Dim> axis = Dim == 3 ? Vec<Dim>(motion.axis.normalized()) : motion.axis;
    const Mat<Dim> R = rotationBy<Dim>(u * motion.angle, axis), rate = motion.angle * spin<Dim>(axis) * R;
    return {{R, motion.centre - R * motion.centre}, {rate, -rate * motion.centre}};
}

/// Moves every point along a path of its own: see MovingMap::share.
template <int Dim>
MovingMap<Dim> mapOf(const FieldMotion<Dim>&, double u) {
    return {{}, {Mat<Dim>::Zero(), Vec<Dim>::Zero()}, u, 1};
}

}  // namespace

template <int Dim>
struct Trajectory<Dim>::Path {
    /// A curve and its moving frame.
    struct Carried {
        Curve<Dim> curve;
        std::optional<MovingFrame> frame;
        double twist = 0, scale = 1;
        std::vector<int> stretches;  // first pieces between the breaks

        explicit Carried(const CurveMotion<Dim>& motion)
            : curve(curveOf(motion)), twist(motion.twist), scale(motion.scale) {
            if (motion.frame != FrameKind::None) frame.emplace(inSpace(curve), motion.frame);
            stretches = curve.smoothStretches();
        }
        explicit Carried(const Recorded<Dim>& motion)
            : curve(curveOf(motion)), stretches(curve.smoothStretches()) {}

        /// Returns the piece that holds u within a stretch.
        int pieceAt(double u, size_t stretch) const {
            const bool last = stretch + 1 == stretches.size();
            return curve.locate(u, stretches[stretch],
                                last ? static_cast<int>(curve.pieces.size()) : stretches[stretch + 1]);
        }
        MovingFrame::Sample turned(double u, int piece) const;
        MovingMap<Dim> map(double u, int piece) const;
    };

    /// The path through poses.
    struct Ridden {
        std::vector<double> parameters;     // u of each pose
        std::vector<AffineMap<Dim>> poses;  // relative to the first
        std::vector<ScrewMotion<Dim>> between;
        Vec<Dim> origin;  // of the body, at the first pose

        explicit Ridden(const PoseMotion<Dim>& motion);
        /// Returns screw motion `k`, which follows pose k.
        MovingMap<Dim> map(double u, size_t k) const;
    };

    double start, end;
    Ease easing;
    std::variant<Translate<Dim>, Rotate<Dim>, FieldMotion<Dim>, Carried, Ridden> kind;
    std::vector<double> breaks;

    explicit Path(const Motion<Dim>& motion)
        : start(motion.start), end(motion.end), easing(motion.ease), kind(Translate<Dim>{}) {
        require(std::isfinite(start) && std::isfinite(end) && start < end,
                "\"time\" must be two increasing numbers");
        std::visit([this](const auto& given) { this->set(given); }, motion.kind);
    }
    template <class Kind>
    void set(const Kind& given) {
        check(given);
        if constexpr (std::is_same_v<Kind, CurveMotion<Dim>> || std::is_same_v<Kind, Recorded<Dim>>) {
            kind = Carried(given);
            setBreaks(std::get<Carried>(kind));
        } else if constexpr (std::is_same_v<Kind, PoseMotion<Dim>>) {
            kind = Ridden(given);
            const std::vector<double>& all = std::get<Ridden>(kind).parameters;
            for (size_t k = 1; k + 1 < all.size(); ++k) addBreak(all[k]);
        } else {
            kind = given;
        }
    }
    void setBreaks(const Carried& carried);
    void addBreak(double u) { breaks.push_back(start + (end - start) * easeInverse(easing, u)); }
    double parameter(double t) const {
        return ease(easing, std::clamp((t - start) / (end - start), 0.0, 1.0));
    }
    /// Returns the interval of t; decided in time, on the same doubles that breakTimes() returns.
    size_t stretchAt(double t, Side side) const {
        const auto at = side == Side::After ? std::upper_bound(breaks.begin(), breaks.end(), t)
                                            : std::lower_bound(breaks.begin(), breaks.end(), t);
        return static_cast<size_t>(at - breaks.begin());
    }
    MovingMap<Dim> perParameter(double t, Side side) const {
        const double u = parameter(t);
        if (const Carried* carried = std::get_if<Carried>(&kind)) {
            return carried->map(u, carried->pieceAt(u, stretchAt(t, side)));
        }
        if (const auto* ridden = std::get_if<Ridden>(&kind)) return ridden->map(u, stretchAt(t, side));
        if (const auto* field = std::get_if<FieldMotion<Dim>>(&kind)) return mapOf(*field, u);
        if (const auto* translate = std::get_if<Translate<Dim>>(&kind)) return mapOf(*translate, u);
        return mapOf(std::get<Rotate<Dim>>(kind), u);
    }
};

template <int Dim>
void Trajectory<Dim>::Path::setBreaks(const Carried& carried) {
    for (size_t i = 1; i < carried.stretches.size(); ++i) {
        addBreak(carried.curve.pieces[carried.stretches[i]].from);
    }
}

template <int Dim>
Trajectory<Dim>::Path::Ridden::Ridden(const PoseMotion<Dim>& motion) : origin(motion.poses.front().position) {
    const double begin = motion.times.front(), span = motion.times.back() - begin;
    const Mat<Dim> first = rotationOf<Dim>(motion.poses.front().rotation);
    for (size_t k = 0; k < motion.poses.size(); ++k) {
        parameters.push_back((motion.times[k] - begin) / span);
        const Mat<Dim> A = k == 0 ? Mat<Dim>(Mat<Dim>::Identity())
                                  : Mat<Dim>(rotationOf<Dim>(motion.poses[k].rotation) * first.transpose());
        poses.push_back({A, motion.poses[k].position - A * origin});
        if (k == 0) continue;
        try {
            between.emplace_back(motion.poses[k - 1], motion.poses[k]);
        } catch (const InputError& error) {
            throw InputError("pose " + std::to_string(k) + ": " + error.message());
        }
    }
}

/// Composes the pose at the start of the screw motion with it. Poses themselves are returned as given,
/// without the rounding of a screw motion that ends there.
template <int Dim>
MovingMap<Dim> Trajectory<Dim>::Path::Ridden::map(double u, size_t k) const {
    const double length = parameters[k + 1] - parameters[k];
    const double s = std::clamp((u - parameters[k]) / length, 0.0, 1.0);
    MovingMap<Dim> map = between[k].at(s);
    const auto after = [&](const AffineMap<Dim>& screw) {
        return AffineMap<Dim>{screw.A * poses[k].A, screw.A * poses[k].b + screw.b};
    };
    map.position = s == 1 ? poses[k + 1] : s == 0 ? poses[k] : after(map.position);
    map.velocity = after(map.velocity);
    map.velocity.A /= length;
    map.velocity.b /= length;
    return map;
}

/// Returns Q(u) and its ω with the twist: Q Rot(T(0), ψ), which rotates about Q T(0).
template <int Dim>
MovingFrame::Sample Trajectory<Dim>::Path::Carried::turned(double u, int piece) const {
    if (!frame || u == 0) {
        MovingFrame::Sample sample = frame ? frame->at(u, piece) : MovingFrame::Sample{};
        sample.rotation.setIdentity();  // exactly
        if (frame) sample.omega += twist * frame->start().col(0);
        return sample;
    }
    MovingFrame::Sample sample = frame->at(u, piece);
    if (twist == 0) return sample;
    const Vec3 tangent = frame->start().col(0);
    sample.omega += twist * (sample.rotation * tangent);
    sample.rotation *= Eigen::AngleAxisd(twist * u, tangent).toRotationMatrix();
    return sample;
}

/// Returns x ↦ γ(u) + s(u) Q(u) (x − γ(0)) (docs/method.md, (18)) with its derivative by u: γ′, and s′ Q + s
/// [ω]× Q.
template <int Dim>
MovingMap<Dim> Trajectory<Dim>::Path::Carried::map(double u, int piece) const {
    const CurvePiece<Dim>& p = curve.pieces[piece];
    const Vec<Dim> first = curve.pieces.front().value(0), rate = p.rate(p.local(u));
    const double grown = 1 + u * (scale - 1);
    const Vec<Dim> moved = p.value(p.local(u)) - first;
    if (!frame && scale == 1) return {{Mat<Dim>::Identity(), moved}, {Mat<Dim>::Zero(), rate}};
    const MovingFrame::Sample sample = turned(u, piece);
    const Mat3 turning = crossMatrix(sample.omega) * sample.rotation;
    const Mat<Dim> Q = sample.rotation.template topLeftCorner<Dim, Dim>();
    const Mat<Dim> A = grown * Q,
                   rateA = (scale - 1) * Q + grown * turning.template topLeftCorner<Dim, Dim>();
    return {{A, moved + (first - A * first)}, {rateA, rate - rateA * first}};
}

template <int Dim>
Trajectory<Dim>::Trajectory(const Motion<Dim>& motion) : m_path(std::make_unique<Path>(motion)) {}
template <int Dim>
Trajectory<Dim>::~Trajectory() = default;
template <int Dim>
Trajectory<Dim>::Trajectory(Trajectory&&) noexcept = default;
template <int Dim>
Trajectory<Dim>& Trajectory<Dim>::operator=(Trajectory&&) noexcept = default;

template <int Dim>
double Trajectory<Dim>::start() const {
    return m_path->start;
}
template <int Dim>
double Trajectory<Dim>::end() const {
    return m_path->end;
}
template <int Dim>
const std::vector<double>& Trajectory<Dim>::breakTimes() const {
    return m_path->breaks;
}

/// Evaluates by d/dt = e′(s) / (end − start) · d/du.
template <int Dim>
MovingMap<Dim> Trajectory<Dim>::at(double t, Side side) const {
    const Path& path = *m_path;
    MovingMap<Dim> map = path.perParameter(t, side);
    const double span = path.end - path.start;
    const double rate =
        t < path.start || t > path.end ? 0 : easeRate(path.easing, (t - path.start) / span) / span;
    map.velocity.A *= rate;
    map.velocity.b *= rate;
    map.shareRate *= rate;
    return map;
}

template <int Dim>
Vec<Dim> Trajectory<Dim>::curvePoint(double t) const {
    const double u = m_path->parameter(t);
    if (const auto* translate = std::get_if<Translate<Dim>>(&m_path->kind)) return u * translate->by;
    if (const auto* rotate = std::get_if<Rotate<Dim>>(&m_path->kind)) return rotate->centre;
    if (const auto* ridden = std::get_if<typename Path::Ridden>(&m_path->kind))
        return at(t).position(ridden->origin);
    if (const auto* field = std::get_if<FieldMotion<Dim>>(&m_path->kind)) {
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (const auto& [vertex, displacement] : *field->values)
            mean += displacement / static_cast<double>(field->values->size());
        return u * mean;
    }
    const auto& carried = std::get<typename Path::Carried>(m_path->kind);
    const CurvePiece<Dim>& piece =
        carried.curve.pieces[carried.pieceAt(u, m_path->stretchAt(t, Side::After))];
    return piece.value(piece.local(u));
}

template <int Dim>
Mat<Dim> Trajectory<Dim>::frame(double t) const {
    const auto* carried = std::get_if<typename Path::Carried>(&m_path->kind);
    if (!carried) return at(t).position.A;
    if (!carried->frame) return Mat<Dim>::Identity();
    const double u = m_path->parameter(t);
    const Mat3 F = carried->turned(u, carried->pieceAt(u, m_path->stretchAt(t, Side::After))).rotation *
                   carried->frame->start();
    return F.template topLeftCorner<Dim, Dim>();
}

template class Trajectory<2>;
template class Trajectory<3>;

}  // namespace wend
