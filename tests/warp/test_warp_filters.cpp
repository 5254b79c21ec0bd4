#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <complex>
#include <numbers>

#include "tests/support/pictures.h"
#include "tests/support/warps.h"
#include "warp/convert.h"
#include "warp/coverage.h"

using namespace wend;
using namespace wend::test;

/// What of the pixels goes into one: between them, of fewer pixels than there were, and beside transparent
/// ones.
class TestWarpFilters : public QObject {
    Q_OBJECT
  private slots:
    void viewIsACropOfTheExportInEveryFilter_data();
    void viewIsACropOfTheExportInEveryFilter();
    void transparentColoursDoNotBleed_data();
    void transparentColoursDoNotBleed();
    void halvingsWeightColoursByAlpha_data();
    void halvingsWeightColoursByAlpha();
    void colourStaysBelowItsAlpha();
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
        const Points<2> pose = wave(mesh.points, 7);
        const Image whole = warpImage(source, mesh, pose, {300, 240, Vec<2>::Zero(), 1}, options);
        const Image crop = warpImage(source, mesh, pose, {131, 97, Vec<2>(83, 61), 1}, options);
        for (int y = 0; y < 97; ++y)
            for (int x = 0; x < 131; ++x)
                for (int c = 0; c < channels; ++c)
                    QCOMPARE(valueAt<std::uint16_t>(crop, x, y, c),
                             valueAt<std::uint16_t>(whole, x + 83, y + 61, c));
    }
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
        const Points<2> pose = (mesh.points.colwise() + Vec<2>(0.37, 0.21)) / scale;
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
        const Points<2> pose = (mesh.points.colwise() + Vec<2>(0.4, 0.3)) / scale;
        const Image warped = warpImage(source, mesh, pose, kView);
        for (std::size_t p = 0; p < warped.data.size(); p += 4)
            for (std::size_t c = 0; c < 3; ++c) QVERIFY(warped.data[p + c] <= warped.data[p + 3]);
    }
}

void TestWarpFilters::collapsedShapeEnds() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = wholePicture();
    for (const Vec<2>& shrink :
         {Vec<2>(1e-7, 1), Vec<2>(1, 1e-13), Vec<2>(1e-9, 1e-9), Vec<2>(0, 0), Vec<2>(1e-300, 1)}) {
        const Points<2> pose = (shrink.asDiagonal() * mesh.points).colwise() + Vec<2>(10.5, 20.5);
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
        const Image small = warpImage(source, mesh, mesh.points, {size, size, Vec<2>::Zero(), scale});
        for (int y = 4; y < size - 4; ++y)
            for (int x = 4; x < size - 4; ++x)
                QVERIFY(std::abs(valueAt<std::uint8_t>(small, x, y, 0) - 127.5) <= 4);
    }
}

/// To a quarter: a pixel is the mean of four, which leaves sin(π/6) / (π/6) = 0.955 of a wave of 24.
void TestWarpFilters::minifiedCoarsePatternStays() {
    const Image source = lines(256, 24);
    const auto mesh = rectangle({0, 0}, {256, 256}, 4);
    for (const auto& [filter, minimum] :
         {std::pair(Filter::Bilinear, 0.93), {Filter::Bicubic, 0.93}, {Filter::Ewa, 0.8}}) {
        WarpOptions options;
        options.filter = filter;
        const Image small = warpImage(source, mesh, mesh.points, {64, 64, Vec<2>::Zero(), 4}, options);
        std::complex<double> sum = 0;
        for (int x = 2; x < 62; ++x)  // ten waves
            sum +=
                (valueAt<std::uint8_t>(small, x, 32, 0) - 127.5) * std::polar(1.0, x * std::numbers::pi / 3);
        const double left = std::abs(sum) / 30 / 100;
        QVERIFY2(left > minimum && left < 0.98, qPrintable(QString("%1: %2").arg(int(filter)).arg(left)));
    }
}

/// Of lines that are squeezed together the elliptical filter leaves nothing, of lines along the way all.
void TestWarpFilters::squeezedPatternTurnsGrey() {
    const Image source = lines(256, 3);
    const auto mesh = rectangle({0, 0}, {256, 256}, 4);
    Points<2> across = mesh.points, along = mesh.points;
    across.row(0) /= 4;
    along.row(1) /= 4;
    const View view{256, 256, Vec<2>::Zero(), 1};
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
