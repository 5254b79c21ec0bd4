#include <QTest>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>

#include "core/base/error.h"
#include "core/meshing/planar_mesher.h"
#include "warp/outline.h"

using namespace wend;

namespace {

constexpr double pi = std::numbers::pi;
using Alpha = std::function<double(double x, double y)>;

std::uint16_t toHalf(double value) {
    if (value < std::ldexp(1, -14)) return static_cast<std::uint16_t>(std::lround(std::ldexp(value, 24)));
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);  // in [0.5, 1[
    return static_cast<std::uint16_t>(((exponent + 13) << 10) + std::lround((2 * fraction) * 1024));
}

void store(PixelType type, double alpha, std::byte* at) {
    const auto put = [&](auto value) { std::memcpy(at, &value, sizeof value); };
    switch (type) {
        case PixelType::UInt8:
            return put(static_cast<std::uint8_t>(std::lround(alpha * 255)));
        case PixelType::UInt16:
            return put(static_cast<std::uint16_t>(std::lround(alpha * 65535)));
        case PixelType::Half:
            return put(toHalf(alpha));
        case PixelType::Float:
            return put(static_cast<float>(alpha));
    }
}

/// A picture whose alpha is given at the pixels' centres.
Image picture(int width, int height, const Alpha& alpha, PixelType type = PixelType::UInt8,
              int channels = 4) {
    const std::size_t bytes = type == PixelType::UInt8 ? 1 : type == PixelType::Float ? 4 : 2;
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.type = type;
    image.alpha = true;
    image.data.resize(bytes * width * height * channels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            store(type, alpha(x + 0.5, y + 0.5),
                  image.data.data() + bytes * ((static_cast<std::size_t>(y) * width + x + 1) * channels - 1));
    return image;
}

/// A soft edge one pixel wide, its middle (alpha ½) where `distance` is 0; inside is negative.
double edge(double distance) {
    return std::clamp(0.5 - distance, 0.0, 1.0);
}

/// The share of the pixel that a disc covers, by 16 × 16 samples.
Alpha disc(double cx, double cy, double radius) {
    return [=](double x, double y) {
        const double distance = std::hypot(x - cx, y - cy) - radius;
        if (std::abs(distance) > 1) return distance < 0 ? 1.0 : 0.0;
        int covered = 0;
        for (int i = 0; i < 256; ++i)
            covered +=
                std::hypot(x - cx + (i % 16 - 7.5) / 16, y - cy + (i / 16 - 7.5) / 16) < radius ? 1 : 0;
        return covered / 256.0;
    };
}

/// A disc whose edge goes from opaque to clear over three pixels.
Alpha softDisc(double cx, double cy, double radius) {
    return [=](double x, double y) { return edge((std::hypot(x - cx, y - cy) - radius) / 3); };
}

Alpha box(double left, double top, double right, double bottom) {
    return [=](double x, double y) {
        return std::min(edge(std::max(left - x, x - right)), edge(std::max(top - y, y - bottom)));
    };
}

Alpha either(const Alpha& a, const Alpha& b) {
    return [=](double x, double y) { return std::max(a(x, y), b(x, y)); };
}

Alpha without(const Alpha& a, const Alpha& b) {
    return [=](double x, double y) { return std::min(a(x, y), 1 - b(x, y)); };
}

double signedArea(const std::vector<Vec2>& loop) {
    double twice = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto &p = loop[k], &q = loop[(k + 1) % loop.size()];
        twice += p.x() * q.y() - p.y() * q.x();
    }
    return twice / 2;
}

double areaOf(const Outline& outline) {
    double sum = 0;
    for (const auto& loop : outline.loops) sum += signedArea(loop);
    return std::abs(sum);
}

AlphaOutlineOptions plain() {
    return {.threshold = 0.5, .margin = 0, .gap = 0, .smallest = 4, .simplify = 0};
}

QString errorOf(const std::function<void()>& f) {
    try {
        f();
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

double maxRadiusError(const Outline& outline, const Vec2& centre, double radius) {
    double worst = 0;
    for (const auto& loop : outline.loops)
        for (const auto& p : loop) worst = std::max(worst, std::abs((p - centre).norm() - radius));
    return worst;
}

}  // namespace

class TestOutline : public QObject {
    Q_OBJECT
  private slots:
    void discIsSubPixelAccurate_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        for (int type = 0; type < 4; ++type)
            for (int channels : {1, 2, 4})
                QTest::addRow("type %d, %d channels", type, channels) << type << channels;
    }
    void discIsSubPixelAccurate() {
        QFETCH(int, type);
        QFETCH(int, channels);
        const auto image =
            picture(100, 90, softDisc(51.3, 44.8, 33.37), static_cast<PixelType>(type), channels);
        const auto outline = outlineFromAlpha(image, plain());
        QCOMPARE(outline.loops.size(), std::size_t(1));
        QVERIFY2(maxRadiusError(outline, {51.3, 44.8}, 33.37) <= 0.05,
                 qPrintable(QString::number(maxRadiusError(outline, {51.3, 44.8}, 33.37))));
        const double area = pi * 33.37 * 33.37;
        QVERIFY(std::abs(areaOf(outline) - area) < 0.002 * area);
    }

    /// An edge that is one pixel wide is not a linear ramp, most of all along diagonals: contours deviate by
    /// up to 0.11 pixels from the true circle, but not on the average.
    void hardEdgesAreRightOnTheAverage() {
        const auto outline = outlineFromAlpha(picture(100, 90, disc(51.3, 44.8, 33.37)), plain());
        QVERIFY(maxRadiusError(outline, {51.3, 44.8}, 33.37) <= 0.12);
        QVERIFY(std::abs(std::sqrt(areaOf(outline) / pi) - 33.37) < 0.02);
    }

    /// The threshold determines the place in an edge that is soft over twenty pixels.
    void thresholdMovesTheEdge() {
        const Alpha soft = [](double x, double y) {
            return std::clamp(0.5 + (40 - std::hypot(x - 64, y - 64)) / 20, 0.0, 1.0);
        };
        const Image image = picture(128, 128, soft, PixelType::Float);
        for (const double threshold : {0.2, 0.5, 0.8}) {
            AlphaOutlineOptions options = plain();
            options.threshold = threshold;
            const double radius = 40 + 20 * (0.5 - threshold), disc = std::numbers::pi * radius * radius;
            QVERIFY(std::abs(areaOf(outlineFromAlpha(image, options)) / disc - 1) < 5e-3);
        }
    }

    /// Two pixels that meet in a corner are one part if the mean between them is inside.
    void cornersJoinByTheirMean() {
        for (const double between : {0.1, 0.3}) {
            const Image image = picture(
                8, 8,
                [between](double x, double y) {
                    const bool left = x > 3 && x<4, right = x> 4 && x < 5;
                    const bool top = y > 3 && y<4, bottom = y> 4 && y < 5;
                    if ((left && top) || (right && bottom)) return 1.0;
                    return (left && bottom) || (right && top) ? between : 0.0;
                },
                PixelType::Float);
            AlphaOutlineOptions options = plain();
            options.threshold = 0.6;  // 2 (1 − 0.6) + 2 (between − 0.6) is 0 at 0.2
            options.smallest = 0;
            QCOMPARE(outlineFromAlpha(image, options).loops.size(), std::size_t(between > 0.2 ? 1 : 2));
        }
    }

    void marginGrowsByThatMuch_data() {
        QTest::addColumn<double>("margin");
        for (double margin : {0.5, 2.0, 7.25}) QTest::addRow("%g", margin) << margin;
    }
    void marginGrowsByThatMuch() {
        QFETCH(double, margin);
        auto options = plain();
        options.margin = margin;
        options.gap = 2;
        const auto outline = outlineFromAlpha(picture(100, 90, disc(51.3, 44.8, 30)), options);
        QCOMPARE(outline.loops.size(), std::size_t(1));
        QVERIFY(maxRadiusError(outline, {51.3, 44.8}, 30 + margin) <= 0.12);
        QVERIFY(std::abs(std::sqrt(areaOf(outline) / pi) - 30 - margin) < 0.05);
    }

    /// With the defaults every pixel with any alpha is inside.
    void softEdgesAreInside() {
        const auto outline = outlineFromAlpha(picture(200, 200, disc(100, 100, 60)));
        for (const auto& p : outline.loops[0]) QVERIFY((p - Vec2(100, 100)).norm() > 60.5 + 0.7);
        QVERIFY(outline.loops[0].size() < 40);
    }

    void simplificationStaysWithinItsTolerance() {
        auto options = plain();
        options.simplify = 0.75;
        const auto outline = outlineFromAlpha(picture(200, 200, disc(100, 100, 80)), options);
        const auto& loop = outline.loops[0];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2 middle = (loop[k] + loop[(k + 1) % loop.size()]) / 2;
            QVERIFY((middle - Vec2(100, 100)).norm() > 80 - 0.75 - 0.05);
        }
        QVERIFY(loop.size() < 60 && loop.size() > 15);
    }

    void holesPartsAndSpecks() {
        const Alpha ring = without(disc(60, 60, 50), disc(60, 60, 30));
        const Alpha parts = either(either(ring, disc(60, 60, 12)), box(120, 20, 180, 100));
        const Alpha all = without(either(parts, disc(150, 10, 2)), disc(150, 60, 2));  // a speck, a pinhole
        auto options = plain();
        options.smallest = 64;
        const auto outline = outlineFromAlpha(picture(200, 120, all), options);
        QCOMPARE(outline.loops.size(), std::size_t(4));
        int holes = 0;
        for (const auto& loop : outline.loops)
            holes += signedArea(loop) * signedArea(outline.loops[0]) < 0 ? 1 : 0;
        QCOMPARE(holes, 1);
        const double area = pi * (2500 - 900 + 144) + 60 * 80;
        QVERIFY(std::abs(areaOf(outline) - area) < 0.005 * area);
        options.margin = 2;
        QCOMPARE(outlineFromAlpha(picture(200, 120, all), options).loops.size(), std::size_t(4));
    }

    void opaquePictureGivesTheFrame() {
        for (double margin : {0.0, 2.0}) {
            auto options = plain();
            options.margin = margin;
            options.simplify = 0.01;
            const auto outline =
                outlineFromAlpha(picture(40, 30, [](double, double) { return 1.0; }), options);
            QCOMPARE(outline.loops.size(), std::size_t(1));
            QCOMPARE(outline.loops[0].size(), std::size_t(4));
            QCOMPARE(areaOf(outline), 1200.0);
        }
        QCOMPARE(areaOf(frameOutline(40, 30)), 1200.0);
    }

    /// A half disc is at the left border: the outline runs on the border and never leaves the picture.
    void bordersClose() {
        for (double margin : {0.0, 3.0}) {
            auto options = plain();
            options.margin = margin;
            const auto outline = outlineFromAlpha(picture(100, 100, disc(0, 50, 30)), options);
            QCOMPARE(outline.loops.size(), std::size_t(1));
            const double radius = 30 + margin, area = pi * radius * radius / 2;
            QVERIFY(std::abs(areaOf(outline) - area) < 0.005 * area);
            int onBorder = 0;
            for (const auto& p : outline.loops[0]) {
                QVERIFY(p.x() >= 0 && p.x() <= 100 && p.y() >= 0 && p.y() <= 100);
                onBorder += p.x() == 0 ? 1 : 0;
            }
            QVERIFY(onBorder >= 2);
        }
    }

    /// Two parts 4 pixels apart, and two legs 4 pixels apart on one body: the gaps stay open when the shape
    /// is grown by 3.
    void gapsStayOpen() {
        auto options = plain();
        options.margin = 3;
        options.gap = 2;
        const auto two = either(box(20, 20, 50, 80), box(54, 20, 90, 80));
        const auto apart = outlineFromAlpha(picture(110, 110, two), options);
        QCOMPARE(apart.loops.size(), std::size_t(2));
        const auto legs = either(two, box(20, 20, 90, 40));
        const auto joined = outlineFromAlpha(picture(110, 110, legs), options);
        QCOMPARE(joined.loops.size(), std::size_t(1));
        // Halfway down the legs only the gap's two pixels are outside.
        std::vector<double> crossings;
        const auto& loop = joined.loops[0];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto &a = loop[k], &b = loop[(k + 1) % loop.size()];
            if ((a.y() <= 60.2) != (b.y() <= 60.2))
                crossings.push_back(a.x() + (b.x() - a.x()) * (60.2 - a.y()) / (b.y() - a.y()));
        }
        std::sort(crossings.begin(), crossings.end());
        QCOMPARE(crossings.size(), std::size_t(4));
        QVERIFY(std::abs(crossings[0] - 17) < 0.1 && std::abs(crossings[3] - 93) < 0.1);
        QVERIFY2(std::abs(crossings[1] - 51) < 0.3 && std::abs(crossings[2] - 53) < 0.3,
                 qPrintable(QString("%1 %2").arg(crossings[1]).arg(crossings[2])));
        options.gap = 0;
        QCOMPARE(outlineFromAlpha(picture(110, 110, two), options).loops.size(), std::size_t(1));
    }

    /// Thin limbs grow as much as thick ones: their own other side does not count as across a gap.
    void thinLimbsGrow() {
        auto options = plain();
        options.margin = 3;
        const auto outline = outlineFromAlpha(picture(120, 60, box(20, 28, 100, 31)), options);
        const double grown = 80 * 3 + 2 * 3 * (80 + 3) + pi * 9;
        QVERIFY2(std::abs(areaOf(outline) - grown) < 0.02 * grown,
                 qPrintable(QString::number(areaOf(outline))));
    }

    /// Random blobs and noise always give a valid outline (the mesher refuses crossings).
    void anyOutlineCanBeMeshed_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 12; ++seed) QTest::addRow("%d", seed) << seed;
    }
    void anyOutlineCanBeMeshed() {
        QFETCH(int, seed);
        std::uint32_t state = seed * 2654435761U;
        const auto random = [&] { return (state = state * 1664525U + 1013904223U) / 4294967296.0; };
        std::vector<double> waves(24);
        for (auto& w : waves) w = random();
        auto image = picture(160, 120, [&](double x, double y) {
            double sum = 0;
            for (int k = 0; k < 8; ++k)
                sum += std::sin(0.25 * (waves[3 * k] - 0.5) * x + 0.25 * (waves[3 * k + 1] - 0.5) * y +
                                6.3 * waves[3 * k + 2]);
            return std::clamp(0.5 + sum * (seed % 3 == 0 ? 4 : 0.4) + (seed % 4 == 0 ? random() - 0.5 : 0),
                              0.0, 1.0);
        });
        for (double margin : {0.0, 2.0}) {
            AlphaOutlineOptions options;
            options.threshold = 0.4;
            options.margin = margin;
            const auto outline = outlineFromAlpha(image, options);
            requireValid(meshOutline(outline, {}));
        }
    }

    void sameInputSameBits() {
        const auto image = picture(100, 90, disc(51.3, 44.8, 33.37));
        const auto a = outlineFromAlpha(image), b = outlineFromAlpha(image);
        QVERIFY(a.loops == b.loops);
    }

    /// Steps of pixels have many points of the same cost, in several loops, whose places in memory differ
    /// from one time to the next.
    void sameInputSameBitsWithManyLoops() {
        const Alpha discs = [](double x, double y) {
            return std::hypot(std::fmod(x, 60) - 30, std::fmod(y, 50) - 25) < 21.3 + y / 60 ? 1.0 : 0.0;
        };
        const Image image = picture(480, 300, discs);
        const auto first = outlineFromAlpha(image);
        QVERIFY(first.loops.size() > 10);
        std::vector<std::vector<char>> held;
        for (int k = 1; k <= 20; ++k) {
            QVERIFY(outlineFromAlpha(image).loops == first.loops);
            for (int size = 16; size < 256; size += 8 * k) held.emplace_back(static_cast<std::size_t>(size));
        }
    }

    /// Straight edges of tens of thousands of pixels become one segment each, at once.
    void longEdgesAreSegments_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addRow("wide") << 30000 << 10;
        QTest::addRow("tall") << 10 << 30000;
        QTest::addRow("large") << 6000 << 1500;
    }
    void longEdgesAreSegments() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Alpha opaque = [](double, double) { return 1.0; };
        const auto outline = outlineFromAlpha(picture(width, height, opaque));
        QCOMPARE(outline.loops.size(), std::size_t(1));
        QCOMPARE(outline.loops[0].size(), std::size_t(4));
        QCOMPARE(areaOf(outline), 1.0 * width * height);
    }

    /// A notch within a long edge keeps its corners.
    void longEdgesKeepNotches() {
        const auto notched = without(box(0, 0, 9000, 40), box(4000, 20, 4030, 40));
        auto options = plain();
        options.simplify = 0.75;
        const auto outline = outlineFromAlpha(picture(9000, 40, notched), options);
        QCOMPARE(outline.loops.size(), std::size_t(1));
        QVERIFY(std::abs(areaOf(outline) - (9000 * 40 - 30 * 20)) < 25);
        QVERIFY(outline.loops[0].size() >= 8 && outline.loops[0].size() <= 16);
    }

    void badInputIsRefused() {
        const auto clear = picture(20, 20, [](double, double) { return 0.0; });
        QVERIFY(errorOf([&] { outlineFromAlpha(clear); }).contains("fully transparent"));
        const auto faint = picture(20, 20, [](double, double) { return 0.05; });
        QVERIFY(errorOf([&] { outlineFromAlpha(faint); }).contains("nowhere above the threshold of 10 %"));
        const auto speck = picture(20, 20, disc(10, 10, 2));
        QVERIFY(
            errorOf([&] { outlineFromAlpha(speck); }).contains("no part of the picture is as large as 64"));
        auto opaque = clear;
        opaque.alpha = false;
        auto empty = clear;
        empty.data.clear();
        QVERIFY(errorOf([&] { outlineFromAlpha(opaque); }).contains("no alpha channel"));
        QVERIFY(errorOf([&] { outlineFromAlpha(empty); }).contains("no pixels"));
        for (double threshold : {0.0, 1.0, -1.0, double(NAN)})
            QVERIFY(errorOf([&] {
                        outlineFromAlpha(speck, {.threshold = threshold});
                    }).contains("between 0 and 1"));
        QVERIFY(errorOf([&] { outlineFromAlpha(speck, {.margin = -1}); }).contains("margin"));
        QVERIFY(errorOf([&] { frameOutline(0, 5); }).contains("no pixels"));
    }

    /// A ring has a dot in it, and a second part is beside it: when filled, the shape includes the hole and
    /// the dot.
    void holesAreFilledOnRequest() {
        const Alpha drawn = [](double x, double y) {
            const double ring = std::hypot(x - 40, y - 40), dot = std::hypot(x - 100, y - 40);
            return (ring < 34 && ring > 28) || ring < 8 || dot < 12 ? 1.0 : 0.0;
        };
        auto options = plain();
        QCOMPARE(outlineFromAlpha(picture(120, 80, drawn), options).loops.size(), std::size_t(4));
        options.holes = OutlineHoles::Filled;
        const auto outline = outlineFromAlpha(picture(120, 80, drawn), options);
        QCOMPARE(outline.loops.size(), std::size_t(2));
        QVERIFY(std::abs(areaOf(outline) - pi * (34 * 34 + 12 * 12)) < 0.01 * pi * 34 * 34);
        options.margin = 3;
        QCOMPARE(outlineFromAlpha(picture(120, 80, drawn), options).loops.size(), std::size_t(2));
    }

    void notANumberIsTransparent() {
        auto image = picture(40, 40, disc(20, 20, 12), PixelType::Float, 1);
        const float nan = NAN;
        std::memcpy(image.data.data(), &nan, sizeof nan);
        QCOMPARE(outlineFromAlpha(image, plain()).loops.size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(TestOutline)
#include "test_outline.moc"
