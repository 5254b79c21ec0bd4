#include "app/project/edits/grip.h"

#include <Eigen/Geometry>

namespace wend {

template <int Dim>
Vec<Dim> carried(const Grip& grip, const Amount& amount, const Vec<Dim>& start) {
    const Vec<Dim> centre = grip.centre.template head<Dim>(), arm = start - centre;
    switch (grip.kind) {
        case Grip::Kind::Turn:
            if constexpr (Dim == 2)
                return centre + Eigen::Rotation2Dd(amount[0]) * arm;
            else
                return centre + Eigen::AngleAxisd(amount[0], grip.axis.normalized()) * arm;
        case Grip::Kind::Grow:
            return centre + (1 + amount[0]) * arm;
        case Grip::Kind::Move:
            break;
    }
    return start + amount.template head<Dim>();
}

template <int Dim>
Motion<Dim> motionBetween(const Grip& grip, const Amount& from, const Amount& to) {
    const Vec<Dim> centre = grip.centre.template head<Dim>();
    Motion<Dim> motion;
    switch (grip.kind) {
        case Grip::Kind::Move:
            motion.kind = Translate<Dim>{(to - from).template head<Dim>()};
            break;
        case Grip::Kind::Turn:
            motion.kind = Rotate<Dim>{centre, grip.axis.template head<Dim>(), to[0] - from[0]};
            break;
        case Grip::Kind::Grow:  // a curve that stays at the centre while it grows
            motion.kind = CurveMotion<Dim>{Interpolation::Bezier,
                                           {centre, centre, centre, centre},
                                           FrameKind::None,
                                           0,
                                           (1 + to[0]) / (1 + from[0])};
            break;
    }
    return motion;
}

template Vec<2> carried(const Grip&, const Amount&, const Vec<2>&);
template Vec<3> carried(const Grip&, const Amount&, const Vec<3>&);
template Motion<2> motionBetween(const Grip&, const Amount&, const Amount&);
template Motion<3> motionBetween(const Grip&, const Amount&, const Amount&);

}  // namespace wend
