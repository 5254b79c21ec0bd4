#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <atomic>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

#include "tests/support/pictures.h"
#include "tests/support/simd_targets.h"
#include "tests/support/warps.h"
#include "warp/convert.h"
#include "warp/coverage.h"

using namespace wend;
using namespace wend::test;

/// The share of the source's pixels in each result: between pixels, when reduced, and beside transparent
/// ones.
class TestWarpFilters : public QObject {
    Q_OBJECT
  private slots:
    void viewIsACropOfTheExportInEveryFilter_data();
    void viewIsACropOfTheExportInEveryFilter();
    void movingPicturesAreBilinear_data();
    void movingPicturesAreBilinear();
    void rowsAreFinishedOnce();
    void transparentColoursDoNotBleed_data();
    void transparentColoursDoNotBleed();
    void halvingsWeightColoursByAlpha_data();
    void halvingsWeightColoursByAlpha();
    void colourStaysBelowItsAlpha();
    void edgesOfAlphaDoNotOvershoot_data();
    void edgesOfAlphaDoNotOvershoot();
    void integerEdgesKeepTheirColour();
    void lightWithoutAlphaSurvives();
    void highlightsDoNotRingBelowZero_data();
    void highlightsDoNotRingBelowZero();
    void largestHalfDoesNotOverflow();
    void notANumberStaysInItsPixel_data();
    void notANumberStaysInItsPixel();
    void oddNumbersAreKeptByTheIdentity_data();
    void oddNumbersAreKeptByTheIdentity();
    void collapsedShapeEnds();
    void minifiedFinePatternTurnsGrey();
    void minifiedCoarsePatternStays();
    void squeezedPatternTurnsGrey();
};

namespace {

void filterRows() {
    QTest::addColumn<int>("filter");
    QTest::newRow("nearest") << static_cast<int>(Filter::Nearest);
    QTest::newRow("bilinear") << static_cast<int>(Filter::Bilinear);
    QTest::newRow("bicubic") << static_cast<int>(Filter::Bicubic);
    QTest::newRow("ewa") << static_cast<int>(Filter::Ewa);
}

/// Lines across x: half of full scale and a sine around it.
Image lines(int size, double period) {
    Image image = plainPicture(size, size, {0});
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            image.row(y)[x] = static_cast<std::byte>(
                std::lround(127.5 + 100 * std::sin(2 * std::numbers::pi * (x + 0.5) / period)));
    return image;
}

using Rgba = std::array<float, 4>;

/// Returns a picture of half or float numbers; `at(x, y)` gives the channels.
template <typename At>
Image numbers(PixelType type, int channels, bool alpha, const At& at) {
    Image image{64, 48, channels, type, alpha, false, {}, nullptr};
    image.makePixels();
    withPixelType(type, [&](auto t) {
        using T = decltype(t);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                for (int c = 0; c < channels; ++c)
                    reinterpret_cast<T*>(image.row(y))[x * channels + c] =
                        static_cast<T>(at(x, y)[static_cast<std::size_t>(c)]);
    });
    return image;
}

float number(const Image& image, int x, int y, int channel) {
    return image.type == PixelType::Half ? static_cast<float>(valueAt<half>(image, x, y, channel))
                                         : valueAt<float>(image, x, y, channel);
}

/// Returns the source place of a pixel of shifted(), if its filter stays within the picture.
std::optional<Vec2> sourceOf(int x, int y, double scale, const Vec2& by = {0.5, 0.3}) {
    const Vec2 at = scale * Vec2(x + 0.5, y + 0.5) - by;
    const double border = 2 + 2 * scale;
    const bool isInside = at.minCoeff() > border && at.x() < 64 - border && at.y() < 48 - border;
    return isInside ? std::optional(at) : std::nullopt;
}

/// The picture reduced by `scale` and shifted by parts of a pixel.
Image shifted(const Image& source, double scale, Filter filter, const Vec2& by = {0.5, 0.3}) {
    const auto mesh = wholePicture();
    WarpOptions options;
    options.filter = filter;
    return warpImage(source, mesh, (mesh.points.colwise() + by) / scale, kView, options);
}

void floatRows(bool straight) {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("filter");
    QTest::addColumn<bool>("unassociated");
    for (const PixelType type : {PixelType::Half, PixelType::Float})
        for (const Filter filter : {Filter::Bilinear, Filter::Bicubic, Filter::Ewa})
            for (int k = 0; k <= (straight ? 1 : 0); ++k)
                QTest::addRow("type %d filter %d %s", int(type), int(filter), k ? "straight" : "associated")
                    << int(type) << int(filter) << (k == 1);
}

}  // namespace

void TestWarpFilters::viewIsACropOfTheExportInEveryFilter_data() {
    filterRows();
}
void TestWarpFilters::viewIsACropOfTheExportInEveryFilter() {
    QFETCH(int, filter);
    WarpOptions options;
    options.filter = static_cast<Filter>(filter);
    for (int channels : {3, 4}) {
        const Image source = randomPicture(300, 240, channels, PixelType::UInt16, channels == 4);
        const auto mesh = rectangle({7, 7}, {291, 233}, 11);
        const Points2 pose = wave(mesh.points, 7);
        onEveryTarget([&](SimdTarget) {
            const Image whole = warpImage(source, mesh, pose, {300, 240, Vec2::Zero(), 1}, options);
            const Image crop = warpImage(source, mesh, pose, {131, 97, Vec2(83, 61), 1}, options);
            for (int y = 0; y < 97; ++y)
                for (int x = 0; x < 131; ++x)
                    for (int c = 0; c < channels; ++c)
                        QCOMPARE(valueAt<std::uint16_t>(crop, x, y, c),
                                 valueAt<std::uint16_t>(whole, x + 83, y + 61, c));
        });
    }
}

void TestWarpFilters::movingPicturesAreBilinear_data() {
    QTest::addColumn<bool>("opaque");
    QTest::addColumn<bool>("unassociated");
    QTest::addColumn<double>("scale");
    QTest::newRow("opaque") << true << false << 1.0;
    QTest::newRow("opaque, enlarged") << true << true << 0.3;
    QTest::newRow("opaque, reduced") << true << true << 2.7;
    QTest::newRow("transparent") << false << false << 1.0;
    QTest::newRow("transparent, straight") << false << true << 1.0;
}

/// Every colour is off by less than a fortieth of a level before it is rounded: few pixels differ, by one.
/// The shape is also turned upside down, so that spans go backwards through the picture.
void TestWarpFilters::movingPicturesAreBilinear() {
    QFETCH(bool, opaque);
    QFETCH(bool, unassociated);
    QFETCH(double, scale);
    Image source = randomPicture(300, 240, 4, PixelType::UInt8, true);
    source.unassociated = unassociated;
    for (std::size_t k = 0; k < source.data.size(); k += 4) {
        const auto alpha = static_cast<std::uint8_t>(source.data[k + 3]);
        if (opaque) source.data[k + 3] = std::byte{255};
        for (std::size_t c = 0; !opaque && !unassociated && c < 3; ++c)
            source.data[k + c] = std::byte(static_cast<std::uint8_t>(source.data[k + c]) * alpha / 255);
    }
    const auto mesh = rectangle({7, 7}, {291, 233}, 5);
    const Points2 wavy = wave(mesh.points, 7);
    const Points2 turned = (-wavy).colwise() + Vec2(300, 240);
    for (const Points2& pose : {wavy, turned}) {
        const View view{260, 200, Vec2(11.3, 5.7), scale};
        WarpOptions options;
        options.filter = Filter::Bilinear;
        onEveryTarget([&](SimdTarget) {
            options.isQuick = false;
            const Image exact = warpImage(source, mesh, pose, view, options);
            options.isQuick = true;
            const Image quick = warpImage(source, mesh, pose, view, options);
            QCOMPARE(quick.data.size(), exact.data.size());
            std::size_t others = 0;
            for (std::size_t k = 0; k < exact.data.size(); ++k) {
                const int difference =
                    std::abs(static_cast<int>(exact.data[k]) - static_cast<int>(quick.data[k]));
                QVERIFY(difference <= 1);
                others += difference != 0 ? 1 : 0;
            }
            QVERIFY(others <= exact.data.size() / 20);
        });
    }
}

/// Rows are finished once, even in a strip that ends within a band.
void TestWarpFilters::rowsAreFinishedOnce() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = wholePicture();
    WarpOptions options;
    const Image plain = warpImage(source, mesh, mesh.points, kView, options);
    std::atomic<int> rows = 0;
    options.finishRows = [&](std::byte* first, int count) {
        rows += count;
        std::for_each_n(first, static_cast<std::ptrdiff_t>(plain.rowBytes()) * count,
                        [](std::byte& one) { one = ~one; });
    };
    const Image finished = warpImage(source, mesh, mesh.points, kView, options);
    QCOMPARE(rows.load(), 48);
    QCOMPARE(finished.data.size(), plain.data.size());
    for (std::size_t k = 0; k < plain.data.size(); ++k) QVERIFY(finished.data[k] == ~plain.data[k]);
}

void TestWarpFilters::transparentColoursDoNotBleed_data() {
    filterRows();
}
void TestWarpFilters::transparentColoursDoNotBleed() {
    QFETCH(int, filter);
    WarpOptions options;
    options.filter = static_cast<Filter>(filter);
    Image source = plainPicture(64, 48, {40, 90, 200, 255});
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 31; ++x)  // transparent, and glaring if it were seen; halves are mixed
            for (int c = 0; c < 4; ++c) source.row(y)[4 * x + c] = static_cast<std::byte>(c == 0 ? 255 : 0);
    const auto mesh = wholePicture();
    for (double scale : {1.0, 1.2, 2.7, 6.0}) {
        const Points2 pose = (mesh.points.colwise() + Vec2(0.37, 0.21)) / scale;
        const Image warped = warpImage(source, mesh, pose, kView, options);
        int mixed = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const int alpha = valueAt<std::uint8_t>(warped, x, y, 3);
                if (alpha == 0) continue;
                mixed += alpha < 255 ? 1 : 0;
                QCOMPARE(valueAt<std::uint8_t>(warped, x, y, 0), std::uint8_t(40));
                QCOMPARE(valueAt<std::uint8_t>(warped, x, y, 1), std::uint8_t(90));
                QCOMPARE(valueAt<std::uint8_t>(warped, x, y, 2), std::uint8_t(200));
            }
        QVERIFY(mixed > 0);
    }
}

void TestWarpFilters::halvingsWeightColoursByAlpha_data() {
    QTest::addColumn<int>("type");
    for (int type = 0; type < 4; ++type) QTest::addRow("type %d", type) << type;
}

/// The mean of up to four pixels: of alpha, and of colours times alpha. Odd sizes have fewer at their
/// borders.
void TestWarpFilters::halvingsWeightColoursByAlpha() {
    QFETCH(int, type);
    const Image source = randomPicture(13, 7, 4, static_cast<PixelType>(type), true);
    const Pyramid pyramid(std::make_shared<const Image>(source), 1);
    const Image& halved = pyramid.level(1);
    QCOMPARE(halved.width, 7);
    QCOMPARE(halved.height, 4);
    const double tolerance = type == 0 ? 0.51 / 255 : type == 1 ? 0.51 / 65535 : type == 2 ? 1e-3 : 1e-6;
    std::vector<std::vector<float>> rows(7, std::vector<float>(13 * 4));
    for (int y = 0; y < 7; ++y) loadRow(source, y, rows[static_cast<std::size_t>(y)].data());
    std::vector<float> found(7 * 4);
    for (int y = 0; y < 4; ++y) {
        loadRow(halved, y, found.data());
        for (int x = 0; x < 7; ++x) {
            Eigen::Array4d sum = Eigen::Array4d::Zero();
            int count = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, 7); ++j)
                for (int i = 2 * x; i < std::min(2 * x + 2, 13); ++i, ++count) {
                    const float* p = rows[static_cast<std::size_t>(j)].data() + 4 * i;
                    const auto alpha = static_cast<double>(p[3]);
                    sum += Eigen::Array4d(p[0] * alpha, p[1] * alpha, p[2] * alpha, alpha);
                }
            const float* p = found.data() + 4 * x;
            QVERIFY(std::abs(static_cast<double>(p[3]) - sum[3] / count) <= tolerance);
            for (int c = 0; c < 3 && sum[3] > 0; ++c)
                QVERIFY(std::abs(static_cast<double>(p[c]) - sum[c] / sum[3]) <= tolerance);
        }
    }
}

void TestWarpFilters::colourStaysBelowItsAlpha() {
    Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    source.unassociated = false;
    for (std::size_t p = 0; p < source.data.size(); p += 4)
        for (std::size_t c = 0; c < 3; ++c)
            source.data[p + c] = std::min(source.data[p + c], source.data[p + 3]);
    const auto mesh = wholePicture();
    for (double scale : {1.0, 1.5}) {
        const Points2 pose = (mesh.points.colwise() + Vec2(0.4, 0.3)) / scale;
        const Image warped = warpImage(source, mesh, pose, kView);
        for (std::size_t p = 0; p < warped.data.size(); p += 4)
            for (std::size_t c = 0; c < 3; ++c) QVERIFY(warped.data[p + c] <= warped.data[p + 3]);
    }
}

void TestWarpFilters::edgesOfAlphaDoNotOvershoot_data() {
    floatRows(true);
}

/// Red is 0.5 everywhere, green between 0.2 and 0.9, blue 0: they stay so along hard and soft edges, and
/// alpha stays between 0 and 1.
void TestWarpFilters::edgesOfAlphaDoNotOvershoot() {
    QFETCH(int, type);
    QFETCH(int, filter);
    QFETCH(bool, unassociated);
    const Image associated = numbers(static_cast<PixelType>(type), 4, true, [](int x, int y) {
        const float alpha = x < 20 ? 0 : x < 22 ? 0.3F * static_cast<float>(x - 19) : y > 30 ? 0 : 1;
        const float green = (x * 7 + y * 3) % 5 < 2 ? 0.2F : 0.9F;
        return Rgba{0.5F * alpha, green * alpha, 0, alpha};
    });
    const Image source = converted(associated, {associated.type, 4, true, unassociated});
    const float rounding = source.type == PixelType::Half ? 2e-3F : 1e-5F;
    for (double scale : {0.6, 1.0, 1.2, 2.7}) {
        const Image warped = shifted(source, scale, static_cast<Filter>(filter));
        int edge = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                if (!sourceOf(x, y, scale)) continue;
                const float alpha = number(warped, x, y, 3);
                QVERIFY(alpha >= 0 && alpha <= 1);
                edge += alpha > 0 && alpha < 1 ? 1 : 0;
                QCOMPARE(number(warped, x, y, 2), 0.0F);
                if (unassociated && alpha < 0.01F) continue;
                const float part = unassociated ? 1 : alpha;
                QVERIFY(std::abs(number(warped, x, y, 0) - 0.5F * part) <= rounding);
                if (alpha > 1 - rounding) continue;  // within, filters may sharpen
                QVERIFY(number(warped, x, y, 1) >= 0.2F * part - rounding);
                QVERIFY(number(warped, x, y, 1) <= 0.9F * part + rounding);
            }
        QVERIFY(edge > 10);
    }
}

/// Where alpha would overshoot, associated colours shrink with it.
void TestWarpFilters::integerEdgesKeepTheirColour() {
    Image source = plainPicture(64, 48, {100, 60, 20, 200});
    source.unassociated = false;
    for (int y = 0; y < 48; ++y) std::fill_n(source.row(y), 4 * 30, std::byte(0));
    for (int y = 0; y < 48; ++y)
        for (int x = 33; x < 64; ++x)
            source.row(y)[4 * x + 3] = std::byte(255), source.row(y)[4 * x] = std::byte(127);
    const Image warped = shifted(source, 1, Filter::Bicubic);
    for (int y = 4; y < 44; ++y)
        for (int x = 0; x < 64; ++x) {
            const int alpha = valueAt<std::uint8_t>(warped, x, y, 3);
            QVERIFY(std::abs(valueAt<std::uint8_t>(warped, x, y, 0) - alpha / 2.0) <= 1);
        }
}

/// A glow without coverage is beside covered pixels.
void TestWarpFilters::lightWithoutAlphaSurvives() {
    const Image source = numbers(PixelType::Half, 4, true, [](int x, int y) {
        if (x > 40) return Rgba{0.25F, 0.25F, 0.25F, 1};
        return x > 10 && y > 10 && y < 40 ? Rgba{0.8F, 0.1F, 0, 0} : Rgba{0, 0, 0, 0};
    });
    for (const Filter filter : {Filter::Bilinear, Filter::Bicubic, Filter::Ewa})
        for (double scale : {1.0, 1.2, 2.0}) {
            const Image warped = shifted(source, scale, filter);
            const int x = static_cast<int>(25 / scale), y = static_cast<int>(25 / scale);
            QVERIFY(std::abs(number(warped, x, y, 0) - 0.8F) < 1e-3F);
            QCOMPARE(number(warped, x, y, 3), 0.0F);
            for (int v = 0; v < 48; ++v)
                for (int u = 0; u < 64; ++u) {
                    QVERIFY(number(warped, u, v, 0) >= 0);
                    QVERIFY(number(warped, u, v, 0) <= 1.2F * 0.8F);
                }
        }
}

void TestWarpFilters::highlightsDoNotRingBelowZero_data() {
    floatRows(false);
}

/// The picture has alpha or not; colours that are negative in the picture stay so.
void TestWarpFilters::highlightsDoNotRingBelowZero() {
    QFETCH(int, type);
    QFETCH(int, filter);
    for (int channels : {1, 3, 4}) {
        const Image source = numbers(static_cast<PixelType>(type), channels, channels == 4, [](int x, int y) {
            const float light = x % 8 == 3 && y % 8 == 3 ? 900.0F : 0.25F;
            return x < 32 ? Rgba{light, light, light, 1} : Rgba{-0.125F, -0.125F, -0.125F, 1};
        });
        for (double scale : {1.0, 1.2}) {
            const Image warped = shifted(source, scale, static_cast<Filter>(filter));
            for (int y = 2; y < 36; ++y)
                for (int x = 2; x < 50; ++x) {
                    const bool dark = x * scale > 35;
                    if (x * scale > 28 && !dark) continue;
                    const float value = number(warped, x, y, 0);
                    QVERIFY2(
                        dark ? std::abs(value + 0.125F) < 1e-3F : value >= 0,
                        qPrintable(QString("%1, %2, %3: %4").arg(x).arg(y).arg(channels).arg(double(value))));
                }
        }
    }
}

void TestWarpFilters::largestHalfDoesNotOverflow() {
    const Image source = numbers(PixelType::Half, 3, false, [](int x, int) {
        return x % 8 < 4 ? Rgba{65504, 65504, 65504} : Rgba{0, 0, 0};
    });
    const Image warped = shifted(source, 1, Filter::Bicubic);
    for (int y = 1; y < 47; ++y)
        for (int x = 1; x < 63; ++x) QVERIFY(number(warped, x, y, 0) <= 65504);
}

void TestWarpFilters::notANumberStaysInItsPixel_data() {
    floatRows(true);
}

/// Only positions within the pixel are affected; in a picture of one colour none of the others is.
void TestWarpFilters::notANumberStaysInItsPixel() {
    QFETCH(int, type);
    QFETCH(int, filter);
    QFETCH(bool, unassociated);
    for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        for (int channel : {0, 3}) {
            Image source = numbers(static_cast<PixelType>(type), 4, true, [&](int x, int y) {
                Rgba colour{0.5F, 0.25F, 0.125F, 1};
                if (x == 20 && y == 20) colour[static_cast<std::size_t>(channel)] = odd;
                return colour;
            });
            source.unassociated = unassociated;
            for (double scale : {0.5, 1.0, 1.2, 3.0}) {
                const Vec2 by(0.5, 0.25);
                const Image warped = shifted(source, scale, static_cast<Filter>(filter), by);
                int seen = 0;
                for (int y = 0; y < 48; ++y)
                    for (int x = 0; x < 64; ++x) {
                        const auto at = sourceOf(x, y, scale, by);
                        if (!at) continue;
                        const bool within = at->x() >= 20 && at->x() <= 21 && at->y() >= 20 && at->y() <= 21;
                        bool finite = true;
                        for (int c = 0; c < 4; ++c) finite = finite && std::isfinite(number(warped, x, y, c));
                        QVERIFY(finite || within);
                        seen += finite ? 0 : 1;
                        for (int c = 0; c < 4 && finite; ++c)
                            QVERIFY(std::abs(number(warped, x, y, c) -
                                             Rgba{0.5F, 0.25F, 0.125F, 1}[std::size_t(c)]) < 1e-3F);
                    }
                if (scale < 1) QVERIFY(seen > 0);
            }
        }
}

void TestWarpFilters::oddNumbersAreKeptByTheIdentity_data() {
    floatRows(true);
}
void TestWarpFilters::oddNumbersAreKeptByTheIdentity() {
    QFETCH(int, type);
    QFETCH(int, filter);
    QFETCH(bool, unassociated);
    Image source = numbers(static_cast<PixelType>(type), 4, true, [](int x, int y) {
        constexpr std::array odd{-0.5F,
                                 1.5F,
                                 0.0F,
                                 300.0F,
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN(),
                                 1.000001F};
        const auto at = [&](int k) { return odd[static_cast<std::size_t>((x + k * y + k) % 7)]; };
        return Rgba{at(1), at(2), at(3), at(4)};
    });
    source.unassociated = unassociated;
    WarpOptions options;
    options.filter = static_cast<Filter>(filter);
    const auto mesh = wholePicture();
    QVERIFY(warpImage(source, mesh, mesh.points, kView, options).data == source.data);
}

void TestWarpFilters::collapsedShapeEnds() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = wholePicture();
    for (const Vec2& shrink :
         {Vec2(1e-7, 1), Vec2(1, 1e-13), Vec2(1e-9, 1e-9), Vec2(0, 0), Vec2(1e-300, 1)}) {
        const Points2 pose = (shrink.asDiagonal() * mesh.points).colwise() + Vec2(10.5, 20.5);
        const Image warped = warpImage(source, mesh, pose, kView);
        QCOMPARE(valueAt<std::uint8_t>(warped, 40, 5, 3), std::uint8_t(0));
    }
}

void TestWarpFilters::minifiedFinePatternTurnsGrey() {
    Image source = plainPicture(512, 512, {0});
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) source.row(y)[x] = static_cast<std::byte>((x + y) % 2 == 0 ? 255 : 0);
    const auto mesh = rectangle({0, 0}, {512, 512}, 4);
    for (double scale : {2.0, 3.3, 5.0, 8.0}) {
        const int size = static_cast<int>(512 / scale);
        const Image small = warpImage(source, mesh, mesh.points, {size, size, Vec2::Zero(), scale});
        for (int y = 4; y < size - 4; ++y)
            for (int x = 4; x < size - 4; ++x)
                QVERIFY(std::abs(valueAt<std::uint8_t>(small, x, y, 0) - 127.5) <= 4);
    }
}

/// The pattern is reduced to a quarter: a pixel is the mean of four, which leaves sin(π/6) / (π/6) = 0.955 of
/// a wave of 24.
void TestWarpFilters::minifiedCoarsePatternStays() {
    const Image source = lines(256, 24);
    const auto mesh = rectangle({0, 0}, {256, 256}, 4);
    for (const auto& [filter, minimum] :
         {std::pair(Filter::Bilinear, 0.93), {Filter::Bicubic, 0.93}, {Filter::Ewa, 0.8}}) {
        WarpOptions options;
        options.filter = filter;
        const Image small = warpImage(source, mesh, mesh.points, {64, 64, Vec2::Zero(), 4}, options);
        std::complex<double> sum = 0;
        for (int x = 2; x < 62; ++x)  // ten waves
            sum +=
                (valueAt<std::uint8_t>(small, x, 32, 0) - 127.5) * std::polar(1.0, x * std::numbers::pi / 3);
        const double left = std::abs(sum) / 30 / 100;
        QVERIFY2(left > minimum && left < 0.98, qPrintable(QString("%1: %2").arg(int(filter)).arg(left)));
    }
}

/// The elliptical filter turns lines grey that are squeezed together, and keeps lines in the direction of the
/// squeeze.
void TestWarpFilters::squeezedPatternTurnsGrey() {
    const Image source = lines(256, 3);
    const auto mesh = rectangle({0, 0}, {256, 256}, 4);
    Points2 across = mesh.points, along = mesh.points;
    across.row(0) /= 4;
    along.row(1) /= 4;
    const View view{256, 256, Vec2::Zero(), 1};
    const Image grey = warpImage(source, mesh, across, view), sharp = warpImage(source, mesh, along, view);
    double minimum = 255, most = 0;
    for (int x = 6; x < 58; ++x) {
        QVERIFY(std::abs(valueAt<std::uint8_t>(grey, x, 100, 0) - 127.5) <= 8);
        minimum = std::min<double>(minimum, valueAt<std::uint8_t>(sharp, x, 30, 0));
        most = std::max<double>(most, valueAt<std::uint8_t>(sharp, x, 30, 0));
    }
    QVERIFY2(most - minimum > 60, qPrintable(QString::number(most - minimum)));
}

QTEST_APPLESS_MAIN(TestWarpFilters)
#include "test_warp_filters.moc"
