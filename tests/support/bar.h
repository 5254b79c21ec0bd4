#pragma once

#include "tests/support/solid_fixture.h"

namespace wend::test {

/// The same bar as a cut-out and as a solid, 4 long and 1 high in its own coordinates: u from −2 to 2, v from
/// −½ to ½, over its visible part.
template <int Dim>
struct Bar;

template <>
struct Bar<2> {
    static constexpr double kUnit = 50;  // pixels of the picture
    static bool open(SolidFixture& f) { return f.openPicture(); }
    static ShapeCanvas& canvas(SolidFixture& f) { return f.window().canvas(); }
    static Vec2 place(double u, double v) { return {120 + kUnit * u, 80 + 40 * v}; }
};

template <>
struct Bar<3> {
    static constexpr double kUnit = 1;
    static bool open(SolidFixture& f) { return f.open(600); }
    static SolidCanvas& canvas(SolidFixture& f) { return f.canvas(); }
    static Vec3 place(double u, double v) { return {u, -0.5, v}; }
};

inline void dimensions() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("picture") << 2;
    QTest::newRow("solid") << 3;
}

/// Runs the body of the current dimension, in a test with the data of dimensions().
#define BOTH(body)          \
    QFETCH(int, dimension); \
    if (dimension == 2)     \
        body<2>();          \
    else                    \
        body<3>()

}  // namespace wend::test
