#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <complex>
#include <map>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "tests/support/pictures.h"
#include "tests/support/simd_targets.h"
#include "tests/support/warps.h"
#include "warp/convert.h"
#include "warp/coverage.h"
#include "warp/outline_pixels.h"
#include "warp/warped_picture.h"

using namespace wend;
using namespace wend::test;

class TestWarp : public QObject {
    Q_OBJECT
  private slots:
    void identityKeepsEveryBit_data();
    void identityKeepsEveryBit();
    void nothingIsCutWhereNothingHasMoved_data();
    void nothingIsCutWhereNothingHasMoved();
    void quarterTurnIsAnArrayRotation_data();
    void quarterTurnIsAnArrayRotation();
    void noSeamBetweenCells();
    void coverageIsTheArea();
    void samplesAreWhatSpansCover();
    void slantedEdgeIsAntialiased();
    void halfPixelShiftIsTheMean();
    void nearerCellsHideOthers();
    void partsInFrontLeaveNoSlits();
    void stMapTellsTheNearest();
    void partsAreLaidOverOneAnother_data();
    void partsAreLaidOverOneAnother();
    void sheetOverItselfHasNoHairlines();
    void outsideModes();
    void greyPicturesTakeColours_data();
    void greyPicturesTakeColours();
    void pictureWithoutAlphaGetsOneWhereNeeded();
    void threadsDoNotMatter();
    void planMadeBeforeChangesNothing();
    void viewIsACropOfTheExport();
    void stMapOfIdentity();
    void stMapForwardAndInverse();
    void badShapeIsAnError();
    void targetsChangeRoundingOnly_data();
    void targetsChangeRoundingOnly();
    void exportIsTheWarp_data();
    void exportIsTheWarp();
    void stoppedExportLeavesNothing();
    void alphaComesOnlyWhereSomethingShowsThrough();
    void errorsReachTheCaller();
};

void TestWarp::identityKeepsEveryBit_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<bool>("alpha");
    QTest::addColumn<int>("filter");
    for (int type = 0; type < 4; ++type)
        for (int filter = 0; filter < 4; ++filter)
            for (int channels = 1; channels <= 4; ++channels)
                QTest::addRow("type %d filter %d channels %d", type, filter, channels)
                    << type << channels << (channels % 2 == 0) << filter;
}

void TestWarp::identityKeepsEveryBit() {
    QFETCH(int, type);
    QFETCH(int, channels);
    QFETCH(bool, alpha);
    QFETCH(int, filter);
    const Image source = randomPicture(64, 48, channels, static_cast<PixelType>(type), alpha);
    const auto mesh = wholePicture();
    WarpOptions options;
    options.filter = static_cast<Filter>(filter);
    onEveryTarget([&](SimdTarget) {
        const Image warped = warpImage(source, mesh, mesh.points, kView, options);
        QCOMPARE(warped.channels, source.channels);
        QVERIFY(warped.data == source.data);
    });
}

void TestWarp::nothingIsCutWhereNothingHasMoved_data() {
    QTest::addColumn<int>("type");
    for (int type = 0; type < 4; ++type) QTest::addRow("type %d", type) << type;
}

/// A shape leaves gaps open in the visible picture, and some visible pixels are far from it.
void TestWarp::nothingIsCutWhereNothingHasMoved() {
    QFETCH(int, type);
    const Image source = randomPicture(64, 600, 4, static_cast<PixelType>(type), true);
    const auto mesh = joined(rectangle({4, 3.3}, {20.5, 590}, 3), rectangle({22.2, 3.3}, {40, 590}, 3));
    const View view{64, 600, Vec2::Zero(), 1};
    WarpOptions options;
    options.restMargin = 4;
    const Image still = warpImage(source, mesh, mesh.points, view, options);
    const std::size_t pixel = source.pixelBytes();
    for (int y = 0; y < 590; ++y) {
        QVERIFY(std::memcmp(still.row(y), source.row(y), 40 * pixel) == 0);  // the gap, too
        for (std::size_t k = 46 * pixel; k < 64 * pixel; ++k) QVERIFY(still.row(y)[k] == std::byte(0));
    }
    Points2 moved = mesh.points;
    moved(0, 0) += 1e-9;
    const Image cut = warpImage(source, mesh, moved, view, options);
    QVERIFY(std::memcmp(cut.row(300), source.row(300), 40 * pixel) != 0);
}

void TestWarp::quarterTurnIsAnArrayRotation_data() {
    QTest::addColumn<int>("type");
    for (int type = 0; type < 4; ++type) QTest::addRow("type %d", type) << type;
}

void TestWarp::quarterTurnIsAnArrayRotation() {
    QFETCH(int, type);
    const Image source = randomPicture(48, 48, 3, static_cast<PixelType>(type), false);
    const auto mesh = rectangle({0, 0}, {48, 48}, 5);
    Points2 pose = mesh.points;  // x towards y: (x, y) → (48 − y, x)
    pose.row(0) = 48 - mesh.points.row(1).array();
    pose.row(1) = mesh.points.row(0);
    for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}) {
        WarpOptions options;
        options.filter = filter;
        const Image turned = warpImage(source, mesh, pose, {48, 48, Vec2::Zero(), 1}, options);
        QCOMPARE(turned.channels, 3);
        withPixelType(source.type, [&](auto t) {
            using T = decltype(t);
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x)
                    for (int c = 0; c < 3; ++c) {
                        const float expected = static_cast<float>(valueAt<T>(source, y, 47 - x, c));
                        const float found = static_cast<float>(valueAt<T>(turned, x, y, c));
                        // Integers are exact; the others to the rounding of the type, since positions are
                        // rounded too.
                        const float tolerance = std::is_integral_v<T> ? 0 : sizeof(T) == 2 ? 1e-3F : 1e-6F;
                        QVERIFY(std::abs(found - expected) <= tolerance);
                    }
        });
    }
}

void TestWarp::noSeamBetweenCells() {
    const Image source = plainPicture(64, 48, {200, 100, 50, 255});
    const auto mesh = wholePicture(12);
    const Points2 pose = wave(mesh.points);
    for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}) {
        WarpOptions options;
        options.filter = filter;
        const Image warped = warpImage(source, mesh, pose, kView, options);
        for (int y = 6; y < 42; ++y)
            for (int x = 6; x < 58; ++x)
                for (int c = 0; c < 4; ++c)
                    QCOMPARE(valueAt<std::uint8_t>(warped, x, y, c), valueAt<std::uint8_t>(source, x, y, c));
    }
}

/// Every sample of every pixel on the outline of small triangles is compared, some of them beyond the
/// picture.
void TestWarp::samplesAreWhatSpansCover() {
    constexpr int kWidth = 150, kHeight = 40, kBand = 8;
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        SimplicialMesh<2> mesh;
        mesh.points.resize(2, 3);
        for (int k = 0; k < 6; ++k) {  // eighths of pixels too, where samples and corners coincide
            const double size = k % 2 == 0 ? kWidth + 10 : kHeight + 10;
            const double place = size * static_cast<double>(random()) / std::mt19937::max() - 5;
            mesh.points(k % 2, k / 2) = round % 3 == 0 ? std::round(16 * place) / 16 : place;
        }
        mesh.cells.push_back({0, 1, 2});
        const TriangleRows rows(mesh.points.col(0), mesh.points.col(1), mesh.points.col(2));
        const OutlinePixels outline(PaintingPlan(mesh, {}), mesh.points, kWidth, kHeight, kBand);
        for (int band = 0; band < kHeight / kBand; ++band) {
            std::map<int, std::uint64_t> found;
            outline.visit(band, rows, [&](int index, std::uint64_t samples) { found[index] = samples; });
            std::pair before(-1, -1);
            for (const OutlinePixels::Pixel& pixel : outline.pixels(band)) {
                QVERIFY(before < std::pair(pixel.y, pixel.x) && pixel.y / kBand == band);
                before = {pixel.y, pixel.x};
                std::uint64_t expected = 0;
                for (int k = 0; k < 64; ++k) {
                    const double x = pixel.x + (k % 8 + 0.5) / 8, y = pixel.y + (k / 8 + 0.5) / 8;
                    const Span span = y >= rows.top() && y < rows.bottom() ? rows.at(y) : Span();
                    if (x >= span.begin && x < span.end) expected |= std::uint64_t{1} << k;
                }
                QCOMPARE(found[pixel.index], expected);
            }
        }
    }
}

void TestWarp::coverageIsTheArea() {
    const Image source = plainPicture(64, 48, {255, 255, 255, 255});
    const auto mesh = rectangle({12, 12}, {50, 36}, 9);
    const Points2 pose = wave(mesh.points);
    const Image warped = warpImage(source, mesh, pose, kView);
    QVERIFY(std::abs(alphaSum(warped) / area(mesh, pose) - 1) < 1e-3);
}

void TestWarp::slantedEdgeIsAntialiased() {
    const Image source = plainPicture(64, 48, {255, 255, 255, 255});
    SimplicialMesh<2> mesh;  // below the line y = x / 4 + 10
    mesh.points.resize(2, 4);
    mesh.points << 0, 64, 64, 0, 10, 26, 48, 48;
    mesh.cells = {{0, 1, 2}, {0, 2, 3}};
    const Image warped = warpImage(source, mesh, mesh.points, kView);
    for (int x = 0; x < 64; ++x)
        for (int y = 0; y < 48; ++y) {
            // Exact: the mean over the pixel's width of the part below the line, by a fine sum.
            double exact = 0;
            for (int k = 0; k < 1000; ++k)
                exact += std::clamp(y + 1 - ((x + (k + 0.5) / 1000) / 4 + 10), 0.0, 1.0) / 1000;
            const double found = valueAt<std::uint8_t>(warped, x, y, 3) / 255.0;
            // 8 × 8 places: an edge can misjudge one place in each of the 8 columns by half.
            QVERIFY(std::abs(found - exact) <= 0.5 / 8 + 1.0 / 255);
        }
}

void TestWarp::halfPixelShiftIsTheMean() {
    const Image source = randomPicture(64, 48, 1, PixelType::UInt16, false);
    const auto mesh = wholePicture();
    const Points2 pose = mesh.points.colwise() + Vec2(0.5, 0);
    WarpOptions options;
    options.filter = Filter::Bilinear;
    const Image warped = warpImage(source, mesh, pose, kView, options);
    for (int y = 0; y < 48; ++y)
        for (int x = 1; x < 63; ++x) {
            const double mean =
                (valueAt<std::uint16_t>(source, x - 1, y, 0) + valueAt<std::uint16_t>(source, x, y, 0)) / 2.0;
            QVERIFY(std::abs(valueAt<std::uint16_t>(warped, x, y, 0) - mean) <= 0.5);
        }
}

void TestWarp::nearerCellsHideOthers() {
    // Two squares of different colour, moved onto each other.
    Image source = plainPicture(40, 20, {10, 20, 30, 255});
    for (int y = 0; y < 20; ++y)
        for (int x = 20; x < 40; ++x) source.row(y)[4 * x] = static_cast<std::byte>(250);
    const SimplicialMesh<2> left = rectangle({0, 0}, {20, 20}, 2);
    const SimplicialMesh<2> mesh = joined(left, rectangle({20, 0}, {40, 20}, 2));
    const int count = left.vertexCount(), cells = left.cellCount();
    Points2 pose = mesh.points;
    pose.rightCols(count).row(0).array() -= 20;
    WarpOptions options;
    const View view{20, 20, Vec2::Zero(), 1};
    QCOMPARE(valueAt<std::uint8_t>(warpImage(source, mesh, pose, view, options), 10, 10, 0),
             std::uint8_t(250));
    options.depth.assign(static_cast<std::size_t>(2 * cells), 0.0F);
    std::fill_n(options.depth.begin(), cells, 1.0F);
    const Image first = warpImage(source, mesh, pose, view, options);
    QCOMPARE(valueAt<std::uint8_t>(first, 10, 10, 0), std::uint8_t(10));
    QCOMPARE(valueAt<std::uint8_t>(first, 0, 10, 3), std::uint8_t(255));
}

/// Where nothing overlaps, orders change nothing, neither at rest nor bent, except for rounding where two
/// cells share a pixel.
void TestWarp::partsInFrontLeaveNoSlits() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = wholePicture();
    WarpOptions orders;
    for (int c = 0; c < mesh.cellCount(); ++c) orders.depth.push_back(static_cast<float>(c * 7 % 5 - 2));
    QVERIFY(warpImage(source, mesh, mesh.points, kView, orders).data == source.data);
    const Image plain = plainPicture(64, 48, {10, 200, 30, 140});
    const Points2 pose = wave(mesh.points);
    const Image one = warpImage(plain, mesh, pose, kView),
                other = warpImage(plain, mesh, pose, kView, orders);
    for (std::size_t i = 0; i < one.data.size(); ++i)
        QVERIFY(std::abs(static_cast<int>(one.data[i]) - static_cast<int>(other.data[i])) <= 1);
}

/// Two squares are moved onto each other: the map gives the place of the one in front, also in the pixels of
/// its outline and where the other's outline is below it.
void TestWarp::stMapTellsTheNearest() {
    const SimplicialMesh<2> left = rectangle({0, 0}, {20, 20}, 2);
    const SimplicialMesh<2> mesh = joined(left, rectangle({20, 0}, {40, 20}, 3));
    Points2 pose = mesh.points;
    pose.rightCols(mesh.vertexCount() - left.vertexCount()).row(0).array() -=
        15.25;  // now from 4.75 to 24.75
    const View view{30, 20, Vec2::Zero(), 1};
    for (const float front : {0.0F, 1.0F}) {  // of the left square
        std::vector<float> depth(mesh.cells.size(), 0.5F);
        std::fill_n(depth.begin(), left.cellCount(), front);
        const Image map = stMap(mesh, pose, view, 40, 20, depth);
        for (int x = 0; x < 25; ++x) {
            const bool isLeft = front > 0.5F ? x < 20 : x < 4;
            const double expected = (x + 0.5 + (isLeft ? 0 : 15.25)) / 40;
            if (x == 4 && front < 0.5F) continue;  // a quarter of it is the right square's
            QVERIFY(std::abs(double(valueAt<float>(map, x, 10, 0)) - expected) < 1e-6);
            QCOMPARE(valueAt<float>(map, x, 10, 3), x < 24 ? 1.0F : 0.75F);
        }
    }
}

void TestWarp::partsAreLaidOverOneAnother_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<bool>("unassociated");
    for (int type = 0; type < 4; ++type)
        for (int channels : {2, 4})
            for (bool unassociated : {false, true})
                QTest::addRow("type %d channels %d %s", type, channels,
                              unassociated ? "unassociated" : "associated")
                    << type << channels << unassociated;
}

/// Two squares of one colour each, the upper one at [30¼, 42¼] over the lower one at [24, 36]: by the formula
/// of Porter and Duff, also along the upper one's border, of which pixel 30 has three quarters.
void TestWarp::partsAreLaidOverOneAnother() {
    QFETCH(int, type);
    QFETCH(int, channels);
    QFETCH(bool, unassociated);
    const auto mesh = joined(rectangle({24, 4}, {36, 16}, 3), rectangle({4, 4}, {16, 16}, 2));
    Points2 pose = mesh.points;
    for (Eigen::Index i = 0; i < pose.cols(); ++i) pose(0, i) += mesh.points(0, i) < 20 ? 26.25 : 0;
    const double tolerance = type == 0 ? 0.6 / 255 : type == 1 ? 0.6 / 65535 : type == 2 ? 1e-3 : 1e-6;
    for (const double opacity : {0.0, 0.5, 1.0}) {
        const Eigen::Array4d upper(0.3, 0.9, 0.6, opacity), lower(0.8, 0.2, 0.4, 0.75);
        const auto pixel = [&](const Eigen::Array4d& colour) {
            std::vector<float> values;
            for (int c = 0; c + 1 < channels; ++c)
                values.push_back(static_cast<float>(colour[c] * (unassociated ? 1 : colour[3])));
            values.push_back(static_cast<float>(colour[3]));
            return values;
        };
        Image source{40, 20, channels, static_cast<PixelType>(type), true, unassociated, {}, nullptr};
        source.makePixels();
        std::vector<float> row;
        for (int x = 0; x < 40; ++x)
            for (float value : pixel(x < 20 ? upper : lower)) row.push_back(value);
        for (int y = 0; y < 20; ++y) storeRow(source, y, row.data());
        // The two colours as the number type stores them, associated.
        loadRow(source, 0, row.data());
        const auto held = [&](int x) {
            Eigen::ArrayXd colour(channels);
            for (int c = 0; c < channels; ++c) colour[c] = static_cast<double>(row[x * channels + c]);
            if (unassociated) colour.head(channels - 1) *= colour[channels - 1];
            return colour;
        };
        const Eigen::ArrayXd above = held(0), below = held(30);
        const Eigen::ArrayXd both = above + (1 - above[channels - 1]) * below;
        for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}) {
            WarpOptions options;
            options.filter = filter;
            const Image warped = warpImage(source, mesh, pose, {48, 20, Vec2::Zero(), 1}, options);
            std::vector<float> found(48 * static_cast<std::size_t>(channels));
            loadRow(warped, 10, found.data());
            const std::pair<int, Eigen::ArrayXd> places[] = {
                {25, below}, {29, below}, {30, 0.75 * both + 0.25 * below}, {31, both}, {35, both},
                {36, above}, {41, above}};
            for (auto [x, expected] : places) {
                const double alpha = expected[channels - 1];
                if (unassociated && alpha > 0) expected.head(channels - 1) /= alpha;
                for (int c = 0; c < channels; ++c) {
                    const double value =
                        static_cast<double>(found[static_cast<std::size_t>(x * channels + c)]);
                    if (unassociated && alpha == 0 && c < channels - 1) continue;  // of no colour
                    QVERIFY2(std::abs(value - expected[c]) <= tolerance,
                             qPrintable(QString("pixel %1 channel %2: %3 instead of %4")
                                            .arg(x)
                                            .arg(c)
                                            .arg(value)
                                            .arg(expected[c])));
                }
            }
        }
    }
}

/// A translucent strip is rolled up: between its borders it has one alpha where it is alone, and that of two
/// layers where it covers itself, whatever borders of triangles are there.
void TestWarp::sheetOverItselfHasNoHairlines() {
    const Image source = plainPicture(64, 48, {200, 100, 50, 128});
    const auto mesh = rectangle({0, 0}, {64, 48}, 48);
    const Points2 pose = rolledUp(mesh.points, {64, 48});
    for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}) {
        WarpOptions options;
        options.filter = filter;
        const Image warped = warpImage(source, mesh, pose, {160, 160, Vec2::Zero(), 1}, options);
        int seen[3] = {0, 0, 0};
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) {
                const Vec2 p = Vec2(x + 0.5, y + 0.5) - Vec2(80, 80);
                const double radius = p.norm(),
                             turn = std::remainder(std::atan2(p.y(), p.x()) / (2 * M_PI) - 0.5, 1) + 0.5;
                const double near = 1.5 / (2 * M_PI * radius);
                if (std::abs(radius - 52) > 11 || turn < near || turn > 1 - near ||
                    std::abs(turn - 0.3) < near)
                    continue;
                const int layers = turn < 0.3 ? 2 : 1;
                ++seen[layers];
                QCOMPARE(int(valueAt<std::uint8_t>(warped, x, y, 3)), layers == 1 ? 128 : 192);
                for (int c = 0; c < 3; ++c)
                    QCOMPARE(valueAt<std::uint8_t>(warped, x, y, c), valueAt<std::uint8_t>(source, 0, 0, c));
            }
        QVERIFY(seen[1] > 3000 && seen[2] > 1500);
    }
}

void TestWarp::outsideModes() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({20, 20}, {30, 30}, 2);
    WarpOptions options;
    options.outside = Outside::Transparent;
    QCOMPARE(valueAt<std::uint8_t>(warpImage(source, mesh, mesh.points, kView, options), 5, 5, 3),
             std::uint8_t(0));
    options.outside = Outside::Colour;
    options.colour = {1, 0.5F, 0, 1};
    const Image coloured = warpImage(source, mesh, mesh.points, kView, options);
    QCOMPARE(valueAt<std::uint8_t>(coloured, 5, 5, 0), std::uint8_t(255));
    QCOMPARE(valueAt<std::uint8_t>(coloured, 5, 5, 1), std::uint8_t(128));
    options.colour = {0.25F, 0.125F, 0, 0.5F};  // associated, in a picture that is not
    const Image veiled = warpImage(source, mesh, mesh.points, kView, options);
    QVERIFY(veiled.unassociated);
    QCOMPARE(valueAt<std::uint8_t>(veiled, 5, 5, 0), std::uint8_t(128));
    QCOMPARE(valueAt<std::uint8_t>(veiled, 5, 5, 1), std::uint8_t(64));
    QCOMPARE(valueAt<std::uint8_t>(veiled, 5, 5, 3), std::uint8_t(128));
    options.outside = Outside::Original;
    QVERIFY(warpImage(source, mesh, mesh.points, kView, options).data == source.data);
    options.outside = Outside::Clamp;
    const Image clamped = warpImage(source, mesh, mesh.points, {8, 8, Vec2(-20, -20), 1}, options);
    for (int c = 0; c < 4; ++c)
        QCOMPARE(valueAt<std::uint8_t>(clamped, 3, 3, c), valueAt<std::uint8_t>(source, 0, 0, c));
}

void TestWarp::greyPicturesTakeColours_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    for (int type = 0; type < 4; ++type)
        for (int channels : {1, 2}) QTest::addRow("type %d channels %d", type, channels) << type << channels;
}

/// A picture of grey with blue around it gets colours, and its own pixels stay as they were; one with grey
/// around it does not.
void TestWarp::greyPicturesTakeColours() {
    QFETCH(int, type);
    QFETCH(int, channels);
    const bool alpha = channels == 2;
    const Image source = randomPicture(64, 48, channels, static_cast<PixelType>(type), alpha);
    const auto mesh = rectangle({20, 20}, {30, 30}, 2);
    WarpOptions options;
    options.outside = Outside::Colour;
    options.colour = {0, 0, 1, 1};
    const Pyramid pyramid(std::make_shared<const Image>(source));
    for (const Image& warped : {warpImage(source, mesh, mesh.points, kView, options),
                                warpImage(pyramid, mesh, mesh.points, kView, options)}) {
        QCOMPARE(warped.channels, channels + 2);
        std::vector<float> row(64 * static_cast<std::size_t>(warped.channels)),
            own(64 * static_cast<std::size_t>(channels));
        loadRow(warped, 25, row.data());
        loadRow(source, 25, own.data());
        const auto at = [&](int x, int c) { return row[static_cast<std::size_t>(x * warped.channels + c)]; };
        for (int c = 0; c < warped.channels; ++c) QCOMPARE(at(5, c), c < 2 ? 0.0F : 1.0F);
        for (int x = 21; x < 29; ++x) {
            for (int c = 0; c < 3; ++c) QCOMPARE(at(x, c), own[static_cast<std::size_t>(x * channels)]);
            if (alpha) QCOMPARE(at(x, 3), own[static_cast<std::size_t>(x * channels + 1)]);
        }
    }
    options.colour = {0.5F, 0.5F, 0.5F, 1};
    QCOMPARE(warpImage(source, mesh, mesh.points, kView, options).channels, channels);
}

void TestWarp::pictureWithoutAlphaGetsOneWhereNeeded() {
    const Image source = randomPicture(64, 48, 3, PixelType::UInt8, false);
    const auto mesh = wholePicture();
    const Image warped = warpImage(source, mesh, mesh.points.colwise() + Vec2(10, 0), kView);
    QCOMPARE(warped.channels, 4);
    QVERIFY(warped.alpha);
    QCOMPARE(valueAt<std::uint8_t>(warped, 3, 20, 3), std::uint8_t(0));
    QCOMPARE(valueAt<std::uint8_t>(warped, 30, 20, 3), std::uint8_t(255));
    QCOMPARE(valueAt<std::uint8_t>(warped, 30, 20, 0), valueAt<std::uint8_t>(source, 20, 20, 0));
}

/// The order of the cells and the outline are those of the depths, whether the plan was made before or not.
void TestWarp::planMadeBeforeChangesNothing() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const SimplicialMesh<2> left = rectangle({0, 0}, {20, 20}, 2);
    const SimplicialMesh<2> mesh = joined(left, rectangle({20, 0}, {40, 20}, 3));
    Points2 pose = mesh.points;
    pose.rightCols(pose.cols() - left.vertexCount()).row(0).array() -= 13.3;
    for (const float front : {0.0F, 1.0F}) {
        WarpOptions fresh;
        fresh.depth.assign(mesh.cells.size(), 0.5F);
        std::fill_n(fresh.depth.begin(), left.cellCount(), front);
        WarpOptions planned;
        planned.plan = std::make_shared<PaintingPlan>(mesh, fresh.depth);
        const Image wanted = warpImage(source, mesh, pose, kView, fresh);
        QVERIFY(warpImage(source, mesh, pose, kView, planned).data == wanted.data);
        QVERIFY(warpImage(source, mesh, pose, kView).data != wanted.data || front == 0.0F);
    }
}

void TestWarp::threadsDoNotMatter() {
    const Image source = randomPicture(300, 200, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({10, 10}, {290, 190}, 60);  // more cells than one thread takes at a time
    const Points2 pose = wave(mesh.points, 6);
    WarpOptions one, four;
    one.threads = 1;
    four.threads = 4;
    const View view{300, 200, Vec2::Zero(), 1};
    onEveryTarget([&](SimdTarget) {
        const Image alone = warpImage(source, mesh, pose, view, one);
        QVERIFY(alone.data == warpImage(source, mesh, pose, view, four).data);
        QVERIFY(alone.data == warpImage(source, mesh, pose, view, one).data);
    });
}

void TestWarp::viewIsACropOfTheExport() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({5, 5}, {60, 44}, 9);
    const Points2 pose = wave(mesh.points);
    const Image whole = warpImage(source, mesh, pose, kView);
    const Image crop = warpImage(source, mesh, pose, {30, 20, Vec2(16, 8), 1});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            for (int c = 0; c < 4; ++c)
                QCOMPARE(valueAt<std::uint8_t>(crop, x, y, c),
                         valueAt<std::uint8_t>(whole, x + 16, y + 8, c));
}

void TestWarp::stMapOfIdentity() {
    const auto mesh = wholePicture();
    const Image map = stMap(mesh, mesh.points, kView, 64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            QCOMPARE(valueAt<float>(map, x, y, 0), static_cast<float>((x + 0.5) / 64));
            QCOMPARE(valueAt<float>(map, x, y, 1), static_cast<float>(1 - (y + 0.5) / 48));
            QCOMPARE(valueAt<float>(map, x, y, 3), 1.0F);
        }
}

void TestWarp::stMapForwardAndInverse() {
    const auto mesh = rectangle({4, 4}, {60, 44}, 40);
    const Points2 pose = wave(mesh.points, 1.5);
    const Image forward = stMap(mesh, pose, kView, 64, 48),
                inverse = stMap(mesh, pose, kView, 64, 48, {}, true);
    int seen = 0;
    for (int y = 8; y < 40; ++y)
        for (int x = 8; x < 56; ++x) {
            if (valueAt<float>(forward, x, y, 3) < 1) continue;
            // Where pixel (x, y) comes from; the inverse map there, read bilinearly, leads back.
            const double sx = valueAt<float>(forward, x, y, 0) * 64.0 - 0.5,
                         sy = (1 - valueAt<float>(forward, x, y, 1)) * 48.0 - 0.5;
            const int ix = static_cast<int>(std::floor(sx)), iy = static_cast<int>(std::floor(sy));
            const double tx = sx - ix, ty = sy - iy;
            const auto mean = [&](int c) {
                return (1 - ty) * ((1 - tx) * valueAt<float>(inverse, ix, iy, c) +
                                   tx * valueAt<float>(inverse, ix + 1, iy, c)) +
                       ty * ((1 - tx) * valueAt<float>(inverse, ix, iy + 1, c) +
                             tx * valueAt<float>(inverse, ix + 1, iy + 1, c));
            };
            // The maps bend by less than 0.02 pixels within one.
            QVERIFY(std::abs(mean(0) * 64 - (x + 0.5)) < 0.05);
            QVERIFY(std::abs((1 - mean(1)) * 48 - (y + 0.5)) < 0.05);
            ++seen;
        }
    QVERIFY(seen > 500);
}

/// Errors reach the caller from any thread.
void TestWarp::errorsReachTheCaller() {
    const Image source = randomPicture(64, 512, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {64, 512}, 4);
    const View view{64, 512, Vec2::Zero(), 1};
    for (int threads : {1, 4}) {
        WarpOptions options;
        options.threads = threads;
        options.progress = [](double) { throw std::bad_alloc(); };
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, warpImage(source, mesh, mesh.points, view, options));
    }
}

void TestWarp::badShapeIsAnError() {
    const auto mesh = wholePicture();
    Points2 pose = mesh.points;
    pose(0, 3) = std::nan("");
    QVERIFY_THROWS_EXCEPTION(InputError,
                             warpImage(randomPicture(64, 48, 3, PixelType::UInt8, false), mesh, pose, kView));
    // Far away, folded and without area are fine.
    pose = mesh.points * 1e9;
    pose.col(5).setZero();
    QVERIFY(warpImage(randomPicture(64, 48, 3, PixelType::UInt8, false), mesh, pose, kView).data.size() > 0);
}

/// Allows one step of an integer, and as many last bits of the other types as there are sums.
template <typename T>
constexpr float kRounding = std::is_integral_v<T> ? 1
                            : sizeof(T) == 2      ? 2e-3F
                                                  : 2e-5F;

static void compareRounded(const Image& image, const Image& other, bool alpha) {
    const int last = image.channels - 1;
    withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c <= last; ++c) {
                    const auto a = static_cast<float>(valueAt<T>(image, x, y, c));
                    const auto b = static_cast<float>(valueAt<T>(other, x, y, c));
                    if (std::abs(a - b) <= kRounding<T>) continue;
                    // A colour of almost no alpha is a quotient of two small numbers.
                    QVERIFY(alpha && c < last);
                    QVERIFY(static_cast<float>(valueAt<T>(image, x, y, last)) < 0.02F * kFull<T>);
                }
    });
}

void TestWarp::targetsChangeRoundingOnly_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    for (int type = 0; type < 4; ++type)
        for (int channels = 1; channels <= 4; ++channels)
            QTest::addRow("type %d channels %d", type, channels) << type << channels;
}

void TestWarp::targetsChangeRoundingOnly() {
    QFETCH(int, type);
    QFETCH(int, channels);
    const Image source = randomPicture(64, 48, channels, static_cast<PixelType>(type), channels % 2 == 0);
    const auto mesh = wholePicture();
    Points2 pose = wave(mesh.points);
    pose.row(0) *= 0.4;  // ellipses of every length
    for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa}) {
        WarpOptions options;
        options.filter = filter;
        const Image best = warpImage(source, mesh, pose, kView, options);
        onEveryTarget([&](SimdTarget) {
            compareRounded(warpImage(source, mesh, pose, kView, options), best, channels % 2 == 0);
        });
    }
}

void TestWarp::exportIsTheWarp_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {"png", "tif", "exr", "jpg", "webp"}) QTest::newRow(extension) << extension;
}

/// The picture is higher than two strips, with a remainder.
void TestWarp::exportIsTheWarp() {
    QFETCH(QString, extension);
    QTemporaryDir folder;
    const Image source = randomPicture(40, 600, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {40, 600}, 9);
    const View view{44, 610, Vec2(-2, -5), 1};
    const Points2 pose = wave(mesh.points, 1);
    const std::string whole = folder.filePath("whole." + extension).toStdString(),
                      strips = folder.filePath("strips." + extension).toStdString();
    writeImage(whole, warpImage(source, mesh, pose, view));
    writeWarped(strips, WarpedPicture(source, mesh, pose, view, {}));
    const Image a = readImage(whole), b = readImage(strips);
    const bool isFramed = extension == "exr";  // is read as its display window, the source's
    QCOMPARE(a.width, isFramed ? 40 : 44);
    QCOMPARE(a.height, isFramed ? 600 : 610);
    QVERIFY(a.channels == b.channels && a.data == b.data);
}

void TestWarp::stoppedExportLeavesNothing() {
    QTemporaryDir folder;
    const Image source = randomPicture(40, 900, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {40, 900}, 9);
    std::stop_source stop;
    WarpOptions options;
    options.stop = stop.get_token();
    options.progress = [&](double done) {
        if (done > 0.5) stop.request_stop();
    };
    for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg", "a.webp"}) {
        stop = {};
        options.stop = stop.get_token();
        const WarpedPicture picture(source, mesh, mesh.points, {40, 900, Vec2::Zero(), 1}, options);
        QVERIFY_THROWS_EXCEPTION(Cancelled, writeWarped(folder.filePath(name).toStdString(), picture));
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
}

void TestWarp::alphaComesOnlyWhereSomethingShowsThrough() {
    const Image source = randomPicture(64, 48, 3, PixelType::UInt8, false);
    const auto mesh = wholePicture();
    const auto channels = [&](const Points2& pose, Outside outside) {
        WarpOptions options;
        options.outside = outside;
        return WarpedPicture(source, mesh, pose, kView, options).header().channels;
    };
    Points2 corner = mesh.points, grown = mesh.points;
    corner.col(0) += Vec2(0.2, 0.2);  // a sliver along two borders
    grown.array() *= 1.5;
    QCOMPARE(channels(mesh.points, Outside::Transparent), 3);
    QCOMPARE(channels(grown, Outside::Transparent), 3);
    QCOMPARE(channels(corner, Outside::Transparent), 4);
    QCOMPARE(channels(corner, Outside::Clamp), 3);
}

QTEST_APPLESS_MAIN(TestWarp)
#include "test_warp.moc"
