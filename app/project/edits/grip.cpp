#include "app/project/edits/grip.h"

#include <Eigen/Geometry>

namespace wend {

Vec3 carried(const Grip& grip, const Amount& amount, const Vec3& start) {
    const Vec3 centre = grip.centre, arm = start - centre;
    switch (grip.kind) {
        case Grip::Kind::Turn:
            return centre + Eigen::AngleAxisd(amount[0], grip.axis.normalized()) * arm;
        case Grip::Kind::Grow:
            return centre + (1 + amount[0]) * arm;
        case Grip::Kind::Move:
            break;
    }
    return start + amount;
}

PinMotion motionBetween(const Grip& grip, const Amount& from, const Amount& to) {
    const Vec3 centre = grip.centre;
    PinMotion motion;
    switch (grip.kind) {
        case Grip::Kind::Move:
            motion.kind = Translate<3>{to - from};
            break;
        case Grip::Kind::Turn:
            motion.kind = Rotate<3>{centre, grip.axis, to[0] - from[0]};
            break;
        case Grip::Kind::Grow:  // a curve that stays at the centre while it grows
            motion.kind = CurveMotion<3>{Interpolation::Bezier,
                                         {centre, centre, centre, centre},
                                         FrameKind::None,
                                         0,
                                         (1 + to[0]) / (1 + from[0])};
            break;
    }
    return motion;
}

}  // namespace wend
