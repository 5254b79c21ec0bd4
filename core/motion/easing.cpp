#include "core/motion/easing.h"

#include <algorithm>
#include <cmath>

namespace wend {

double ease(Ease kind, double s) {
    switch (kind) {
        case Ease::Linear:
            break;
        case Ease::In:
            return s * s;
        case Ease::Out:
            return s * (2 - s);
        case Ease::InOut:
            return s * s * (3 - 2 * s);
    }
    return s;
}

double easeRate(Ease kind, double s) {
    switch (kind) {
        case Ease::Linear:
            break;
        case Ease::In:
            return 2 * s;
        case Ease::Out:
            return 2 * (1 - s);
        case Ease::InOut:
            return 6 * s * (1 - s);
    }
    return 1;
}

double easeInverse(Ease kind, double u) {
    switch (kind) {
        case Ease::Linear:
            break;
        case Ease::In:
            return std::sqrt(u);
        case Ease::Out:
            return 1 - std::sqrt(1 - u);
        // s = ½ − w turns s² (3 − 2s) = u into the triple-angle formula sin 3a = 3 sin a − 4 sin³ a with w =
        // sin a.
        case Ease::InOut:
            return 0.5 - std::sin(std::asin(std::clamp(1 - 2 * u, -1.0, 1.0)) / 3);
    }
    return u;
}

}  // namespace wend
