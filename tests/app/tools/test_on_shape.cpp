#include <QtTest>
#include <cmath>
#include <numbers>

#include "app/views/canvas/cell_filler.h"
#include "app/views/canvas/render_thread.h"
#include "core/energy/distortion.h"

using namespace wend;

/// Overlays on a shape meet the picture correctly: the rim of maps, and lines on light and on dark.
class TestOnShape : public QObject {
    Q_OBJECT
  private slots:
    void rimIsWhatTheShapeCovers();
    void rimOfAPhotographIsItsOwn_data();
    void rimOfAPhotographIsItsOwn();
    void rimOfACutOutIsThePictures();
    void mapIsSeenOnTransparentGround();
    void frontCellsHideOthers();
    void smoothMapsHaveTheSameRim();
    void linesAreSeenOnEveryGround_data();
    void linesAreSeenOnEveryGround();
    void linesAreOfOneKindUpToTheOutline_data();
    void linesAreOfOneKindUpToTheOutline();
    void denseLinesAreNoVeil();
};

namespace {

constexpr QSize kSize(220, 200);
constexpr int kSide = 12;  // cells

/// Returns a square of 120 pixels a side as a grid with two cells in each square.
std::shared_ptr<const SimplicialMesh<2>> square() {
    auto mesh = std::make_shared<SimplicialMesh<2>>();
    mesh->points.resize(2, (kSide + 1) * (kSide + 1));
    const auto at = [](int x, int y) { return y * (kSide + 1) + x; };
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x) mesh->points.col(at(x, y)) = Vec2(10.0 * x, 10.0 * y);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            mesh->cells.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            mesh->cells.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    return mesh;
}

/// Rotates about its middle and moves that to the middle of the view.
Points2 turned(const Points2& points, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    Mat2 turn;
    turn << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
    return (turn * (points.colwise() - Vec2(60, 60))).colwise() + Vec2(109.3, 98.6);
}

using Polygon = std::vector<Vec2>;

/// Returns the part of a polygon where n·p ≤ d.
Polygon clipped(const Polygon& polygon, const Vec2& n, double d) {
    Polygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double from = d - n.dot(p), to = d - n.dot(q);
        if (from >= 0) part.push_back(p);
        if ((from < 0) != (to < 0)) part.emplace_back(p + from / (from - to) * (q - p));
    }
    return part;
}

double areaOf(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        twice += p.x() * q.y() - q.x() * p.y();
    }
    return std::abs(twice) / 2;
}

/// Returns the exact share of a pixel that the rotated square covers.
double covered(const Points2& corners, int x, int y) {
    Polygon part{corners.col(0), corners.col(kSide), corners.col(corners.cols() - 1),
                 corners.col(kSide * (kSide + 1))};
    part = clipped(part, -Vec2::UnitX(), -x);
    part = clipped(part, Vec2::UnitX(), x + 1);
    part = clipped(part, -Vec2::UnitY(), -y);
    part = clipped(part, Vec2::UnitY(), y + 1);
    return areaOf(part);
}

/// Returns a picture of one colour whose alpha depends on the place.
std::shared_ptr<const ScreenPicture> picture(QRgb colour,
                                             const std::function<double(double, double)>& alpha) {
    Image image;
    image.width = image.height = 120;
    image.channels = 4;
    image.alpha = image.unassociated = true;
    image.makePixels();
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x) {
            const auto opaque = static_cast<int>(std::lround(255 * alpha(x + 0.5, y + 0.5)));
            const std::array pixel{std::byte(qRed(colour)), std::byte(qGreen(colour)),
                                   std::byte(qBlue(colour)), std::byte(opaque)};
            std::copy(pixel.begin(), pixel.end(), image.row(y) + 4 * x);
        }
    return std::make_shared<const ScreenPicture>(std::make_shared<const Image>(std::move(image)));
}

double everywhere(double, double) {
    return 1;
}

/// Returns the alpha of a disc with an edge of four pixels.
double disc(double x, double y) {
    return std::clamp((50 - std::hypot(x - 60, y - 60)) / 4 + 0.5, 0.0, 1.0);
}

RenderRequest requestOf(const std::shared_ptr<const SimplicialMesh<2>>& mesh, const Points2& pose) {
    auto frame = std::make_shared<PosedFrame<2>>();
    frame->rest = mesh;
    frame->vertices = mesh->vertexCount();
    frame->cells = mesh->cellCount();
    frame->pose = pose;
    frame->diagonal = 170;
    frame->distortion = std::make_shared<const Distortion>(distortion<2>(*mesh, pose));
    RenderRequest request;
    request.frame = std::move(frame);
    request.size = kSize;
    request.filter = Filter::Ewa;
    request.fill = QColor(200, 30, 60);
    request.line = QColor(24, 28, 44);
    return request;
}

RenderRequest turnedRequest(double degrees) {
    const auto mesh = square();
    return requestOf(mesh, turned(mesh->points, degrees));
}

template <class Check>
void forPixels(const Check& check) {
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x) check(x, y);
}

/// Returns the greatest difference of the opacities of two images.
int alphaOff(const QImage& a, const QImage& b) {
    int worst = 0;
    forPixels([&](int x, int y) {
        worst = std::max(worst, std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(x, y))));
    });
    return worst;
}

}  // namespace

/// The rim is compared with the area of the rotated square in each pixel, by clipping polygons. 8 × 8 samples
/// in a pixel give it to within an eighth along an edge that passes by them, and far better in the mean.
void TestOnShape::rimIsWhatTheShapeCovers() {
    for (const double degrees : {0.0, 13.0, 45.0, 71.5}) {
        const RenderRequest request = turnedRequest(degrees);
        const QImage image = RenderThread::render(request);
        double sum = 0;
        int rim = 0;
        forPixels([&](int x, int y) {
            const double exact = covered(request.frame->pose, x, y), seen = qAlpha(image.pixel(x, y)) / 255.0;
            QVERIFY2(std::abs(exact - seen) < 0.14, qPrintable(QString("%1 %2").arg(exact).arg(seen)));
            if (exact > 1 - 1e-9) QCOMPARE(image.pixel(x, y), request.fill.rgba());
            if (exact < 1e-9) QCOMPARE(image.pixel(x, y), qRgba(0, 0, 0, 0));
            if (exact > 1e-9 && exact < 1 - 1e-9) sum += std::abs(exact - seen), ++rim;
        });
        QVERIFY(rim > 400);
        if (degrees > 0) QVERIFY2(sum < 0.03 * rim, qPrintable(QString::number(sum / rim)));
    }
}

void TestOnShape::rimOfAPhotographIsItsOwn_data() {
    QTest::addColumn<bool>("smooth");
    QTest::addColumn<bool>("beside");
    QTest::newRow("cell by cell") << false << false;
    QTest::newRow("smooth") << true << false;
    QTest::newRow("with what the shape leaves out") << false << true;
}

/// The map changes colours, but not the alpha of opaque pixels.
void TestOnShape::rimOfAPhotographIsItsOwn() {
    QFETCH(bool, smooth);
    QFETCH(bool, beside);
    RenderRequest request = turnedRequest(13);
    request.picture = picture(qRgb(90, 160, 60), everywhere);
    request.allOfPicture = beside;
    const QImage plain = RenderThread::render(request);
    request.map = true;
    request.colours.smooth = smooth;
    const QImage mapped = RenderThread::render(request);
    QVERIFY2(alphaOff(plain, mapped) <= 2, qPrintable(QString::number(alphaOff(plain, mapped))));
    // There is one colour, as far as the shape is opaque: no pixel of the rim is without the map.
    const QRgb inside = mapped.pixel(109, 98);
    forPixels([&](int x, int y) {
        const QRgb seen = qUnpremultiply(mapped.pixel(x, y));
        if (!beside && qAlpha(seen) > 40)
            QVERIFY2(std::abs(qRed(seen) - qRed(inside)) <= 8 && std::abs(qBlue(seen) - qBlue(inside)) <= 8,
                     qPrintable(QColor(seen).name()));
    });
}

/// A soft disc in a square mesh: with the map it is as soft, and beside it nothing is coloured.
void TestOnShape::rimOfACutOutIsThePictures() {
    RenderRequest request = turnedRequest(13);
    request.picture = picture(qRgb(90, 160, 60), disc);
    request.cutOut = true;
    const QImage plain = RenderThread::render(request);
    request.map = true;
    const QImage mapped = RenderThread::render(request);
    QVERIFY(mapped.pixel(109, 98) != plain.pixel(109, 98));
    QVERIFY2(alphaOff(plain, mapped) <= 2, qPrintable(QString::number(alphaOff(plain, mapped))));
}

/// Where the shape extends beyond the visible picture, its map does too.
void TestOnShape::mapIsSeenOnTransparentGround() {
    RenderRequest request = turnedRequest(13);
    request.picture = picture(qRgb(90, 160, 60), disc);
    request.map = true;
    const QImage image = RenderThread::render(request);
    int clear = 0;
    forPixels([&](int x, int y) {
        const double exact = covered(request.frame->pose, x, y), off = std::hypot(x - 109, y - 98);
        if (off < 54) return;
        ++clear;
        const double seen = qAlpha(image.pixel(x, y)) / 255.0;
        QVERIFY2(std::abs(kMapOpacity * exact - seen) < 0.1,
                 qPrintable(QString("%1 %2").arg(exact).arg(seen)));
    });
    QVERIFY(clear > 10000);
}

/// Two squares overlap: the map of the front one covers the other's, and the line between them is as soft as
/// the outline.
void TestOnShape::frontCellsHideOthers() {
    Points2 points(2, 8);
    points << 20, 150, 150, 20, 60.4, 110.4, 110.4, 60.4, 20, 20, 150, 150, 40, 60, 120, 100;
    const SimplicialMesh<2> mesh{points, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
    CellFiller filler(kSize, PaintingPlan(mesh, {}), points, {});
    const QRgb below = qRgba(0, 0, 200, 128), above = qRgba(200, 0, 0, 128);
    for (const int c : {0, 1, 2, 3}) filler.fill(mesh.cells[c], c < 2 ? below : above);
    QImage image(kSize, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    filler.layOver(image, CellFiller::Extent::Shape);
    QCOMPARE(image.pixel(30, 30), qPremultiply(below));
    QCOMPARE(image.pixel(85, 80), qPremultiply(above));
    forPixels([&](int x, int y) {
        const bool inside = x >= 20 && x < 150 && y >= 20 && y < 150;
        QCOMPARE(qAlpha(image.pixel(x, y)), inside ? 128 : 0);
    });
    // At (60, 70) the upper one begins at 60.4 and descends by 20 in 50: about six tenths of it.
    const QRgb edge = qUnpremultiply(image.pixel(60, 70));
    QVERIFY2(std::abs(qRed(edge) - 120) < 26 && std::abs(qBlue(edge) - 80) < 26,
             qPrintable(QColor(edge).name()));
}

/// Colours of vertices at the rim are those of the place, not of beyond it.
void TestOnShape::smoothMapsHaveTheSameRim() {
    const auto mesh = square();
    const Points2 pose = turned(mesh->points, 13);
    const PaintingPlan plan(*mesh, {});
    CellFiller soft(kSize, plan, pose, {}), even(kSize, plan, pose, {});
    for (const Cell<2>& cell : mesh->cells) {
        std::array<CellFiller::Colour, 3> corners;
        for (int k = 0; k < 3; ++k) corners[k] << 2 * mesh->points(0, cell[k]), 0, 0, 255;
        soft.fill(cell, corners);
        even.fill(cell, qRgba(0, 0, 0, 255));
    }
    QImage a(kSize, QImage::Format_ARGB32_Premultiplied);
    a.fill(Qt::transparent);
    QImage b = a;
    soft.layOver(a, CellFiller::Extent::Shape);
    even.layOver(b, CellFiller::Extent::Shape);
    QCOMPARE(alphaOff(a, b), 0);
    Mat2 turn;
    turn.col(0) = (pose.col(1) - pose.col(0)) / 10;
    turn.col(1) = (pose.col(kSide + 1) - pose.col(0)) / 10;
    forPixels([&](int x, int y) {
        if (qAlpha(a.pixel(x, y)) < 40) return;
        const Vec2 rest = turn.inverse() * (Vec2(x + 0.5, y + 0.5) - pose.col(0));
        const double expected = std::clamp(2 * rest.x(), 0.0, 240.0);
        QVERIFY2(std::abs(qRed(qUnpremultiply(a.pixel(x, y))) - expected) < 5,
                 qPrintable(QString::number(expected)));
    });
}

void TestOnShape::linesAreSeenOnEveryGround_data() {
    QTest::addColumn<int>("gray");
    QTest::addColumn<bool>("transparent");
    for (const int gray : {0, 25, 60, 90, 130, 180, 255}) {
        QTest::addRow("picture %d", gray) << gray << false;
        QTest::addRow("ground %d", gray) << gray << true;
    }
}

/// Lines contrast in lightness with any ground, in the picture and beside it.
void TestOnShape::linesAreSeenOnEveryGround() {
    QFETCH(int, gray);
    QFETCH(bool, transparent);
    RenderRequest request = turnedRequest(0);
    request.picture =
        picture(qRgb(gray, gray, gray), [&](double, double) { return transparent ? 0.0 : 1.0; });
    request.ground = QColor(gray, gray, gray);
    request.mesh = true;
    QImage seen(kSize, QImage::Format_ARGB32_Premultiplied);
    seen.fill(request.ground);
    QPainter(&seen).drawImage(0, 0, RenderThread::render(request));
    int most = 0;
    for (int x = 100; x < 120; ++x) most = std::max(most, std::abs(qGray(seen.pixel(x, 97)) - gray));
    QVERIFY2(most > 30, qPrintable(QString::number(most)));
}

void TestOnShape::linesAreOfOneKindUpToTheOutline_data() {
    QTest::addColumn<int>("gray");
    QTest::newRow("light lines") << 100;
    QTest::newRow("dark lines") << 150;
}

/// On a plain picture no line is dark in one place and light in another, whatever surrounds it.
void TestOnShape::linesAreOfOneKindUpToTheOutline() {
    QFETCH(int, gray);
    RenderRequest request = turnedRequest(0);
    request.picture = picture(qRgb(gray, gray, gray),
                              [](double x, double y) { return std::hypot(x - 60, y - 60) < 50 ? 1 : 0; });
    request.mesh = true;
    const QImage seen = RenderThread::render(request);
    int light = 0, dark = 0;
    forPixels([&](int x, int y) {
        if (std::hypot(x + 0.5 - 109.3, y + 0.5 - 98.6) > 47) return;
        const int lightness = qGray(seen.pixel(x, y));
        light += lightness > gray + 2 ? 1 : 0;
        dark += lightness < gray - 2 ? 1 : 0;
    });
    const int right = gray < 112 ? light : dark, wrong = gray < 112 ? dark : light;
    QVERIFY2(right > 500 && wrong == 0, qPrintable(QString("%1, %2").arg(right).arg(wrong)));
}

/// With a line at every other pixel the picture is still visible.
void TestOnShape::denseLinesAreNoVeil() {
    RenderRequest request = turnedRequest(0);
    request.picture = picture(qRgb(0, 0, 0), everywhere);
    request.mesh = true;
    request.view.setZoom(0.2, {109.3, 98.6});
    const QImage seen = RenderThread::render(request);
    double sum = 0;
    int count = 0;
    for (int y = 92; y < 106; ++y)
        for (int x = 102; x < 116; ++x, ++count) sum += qGray(seen.pixel(x, y));
    QVERIFY2(sum / count < 40, qPrintable(QString::number(sum / count)));
}

QTEST_GUILESS_MAIN(TestOnShape)
#include "test_on_shape.moc"
