// SVG drawings as paths, and these paths through a map, compared with closed forms and with the drawing of
// Qt's library.

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <numbers>
#include <pugixml.hpp>
#include <random>

#include "core/base/error.h"
#include "warp/curve_fit.h"
#include "warp/picture_process.h"
#include "warp/warped_drawing.h"

using namespace wend;

namespace {

using Kind = PathPiece::Kind;

/// A square grid of the plane from 0 to `size`, and the mapped places of its vertices.
struct Grid {
    SimplicialMesh<2> rest;
    Points2 pose;

    Grid(double size, int cells, const std::function<Vec2(const Vec2&)>& map) {
        const int side = cells + 1;
        rest.points.resize(2, side * side);
        pose.resize(2, side * side);
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                rest.points.col(j * side + i) = size / cells * Vec2(i, j);
                pose.col(j * side + i) = map(rest.points.col(j * side + i));
            }
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const int a = j * side + i;
                rest.cells.push_back({a, a + 1, a + side + 1});
                rest.cells.push_back({a, a + side + 1, a + side});
            }
    }
};

Vec2 same(const Vec2& p) {
    return p;
}

/// An area-preserving map with a bend of a fifth of its waves.
Vec2 waves(const Vec2& p) {
    return {p.x() + 12 * std::sin(p.y() / 30), p.y()};
}

Vec2 cubicAt(const std::array<Vec2, 4>& p, double t) {
    const double s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// Calls `take` with every curve and line of a path as a cubic.
void forCurves(const SvgPath& path, const std::function<void(const std::array<Vec2, 4>&)>& take) {
    Vec2 at(0, 0), start(0, 0);
    for (const PathPiece& piece : path) {
        if (piece.kind == Kind::Move) start = piece.points[0];
        const Vec2 to =
            piece.kind == Kind::Close ? start : piece.points[static_cast<std::size_t>(piece.count() - 1)];
        if (piece.kind == Kind::Cubic) take({at, piece.points[0], piece.points[1], to});
        if (piece.kind == Kind::Line || piece.kind == Kind::Close)
            take({at, at + (to - at) / 3, to + (at - to) / 3, to});
        at = to;
    }
}

/// ½ ∮ x dy − y dx, by Simpson's rule, which is exact for the fifth degree with enough intervals.
double areaOf(const SvgPath& path) {
    double area = 0;
    constexpr int kIntervals = 400;
    forCurves(path, [&](const auto& p) {
        for (int k = 0; k < kIntervals; ++k) {
            const Vec2 a = cubicAt(p, double(k) / kIntervals), b = cubicAt(p, double(k + 1) / kIntervals);
            area += (a.x() * b.y() - a.y() * b.x()) / 2;
        }
    });
    return std::abs(area);
}

QImage drawn(const std::string& svg, const QSize& size) {
    QSvgRenderer renderer(QByteArray::fromStdString(svg));
    QImage image(size, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter);
    return image;
}

double meanDifference(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            sum +=
                std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
        }
    return sum / (3.0 * a.width() * a.height());
}

}  // namespace

class TestWarpedDrawing : public QObject {
    Q_OBJECT

  private slots:
    void pathsAreRead_data();
    void pathsAreRead();
    void arcsAreEllipses();
    void mapIsExactForAffineOnes();
    void mapIsOfThirdOrder();
    void cubicsGoThroughAffineMaps();
    void discsKeepTheirArea();
    void curvesKeepTheirDistance();
    void cornersAndEndsStay();
    void drawingsStayTheSame();
    void styleSheetsAndUses();
    void pensAndPaintsGoAlong();
    void clipsAndLayers();
    void clipsInBoxUnits();
    void picturesAreEmbedded();
    void damagedDrawings_data();
    void damagedDrawings();
    void randomDamage();

  private:
    std::string written(const char* name, const std::string& text) const {
        const std::string path = m_folder.filePath(name).toStdString();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    VectorDrawing vectors(const std::string& body, const char* size = "width='100' height='100'") const {
        return readVectors(written("drawing.svg",
                                   "<svg xmlns='http://www.w3.org/2000/svg' "
                                   "xmlns:xlink='http://www.w3.org/1999/xlink' " +
                                       std::string(size) + ">" + body + "</svg>"),
                           {}, {});
    }
    static std::string carried(const VectorDrawing& drawing, const std::function<Vec2(const Vec2&)>& map) {
        const double scale = drawing.width / drawing.viewBox[2];
        const Grid grid(drawing.width, 40, [&](const Vec2& p) { return Vec2(scale * map(p / scale)); });
        SvgPage page;
        page.viewBox = drawing.viewBox;
        page.width = "100", page.height = "100";
        page.fromPixels.A *= 1 / scale;
        SvgFile file(page);
        file.add({}, drawing, {0, 0}, PlaneMap(grid.rest, grid.pose),
                 [](const Image& picture, const Vec2& at) {
                     return PlacedPng{"png", at, picture.width, picture.height};
                 });
        return file.text();
    }
    /// The attribute of the first element that a path of XPath finds.
    static std::string attribute(const std::string& svg, const char* xpath, const char* name) {
        pugi::xml_document document;
        document.load_string(svg.c_str());
        return document.select_node(xpath).node().attribute(name).value();
    }

    QTemporaryDir m_folder;
};

void TestWarpedDrawing::pathsAreRead_data() {
    QTest::addColumn<QString>("d");
    QTest::addColumn<QString>("expected");
    QTest::newRow("lines") << "M1 2 3 4h5v-6l-1,1z"
                           << "M1,2L3,4L8,4L8,-2L7,-1Z";
    QTest::newRow("relative moves") << "m1 2 3 4z m1 1 1 0"
                                    << "M1,2L4,6ZM2,3L3,3";
    QTest::newRow("after the end") << "M1 2L3 4ZL5 6"
                                   << "M1,2L3,4ZM1,2L5,6";
    QTest::newRow("without blanks") << "M.5.5-.5-.5L1e1-1E-1"
                                    << "M0.5,0.5L-0.5,-0.5L10,-0.1";
    QTest::newRow("cubics") << "M0 0C1 2 3 4 5 6S9 8 10 10"
                            << "M0,0C1,2 3,4 5,6C7,8 9,8 10,10";
    QTest::newRow("smooth after a line") << "M0 0L5 6S9 8 10 10"
                                         << "M0,0L5,6C5,6 9,8 10,10";
    QTest::newRow("quadratics") << "M0 0Q3 3 6 0T12 0"
                                << "M0,0C2,2 4,2 6,0C8,-2 10,-2 12,0";
    QTest::newRow("flags") << "M0 0a0 0 0 0110 0"
                           << "M0,0L10,0";
    QTest::newRow("up to a fault") << "M0 0L1 1L2 x L3 3"
                                   << "M0,0L1,1";
    QTest::newRow("no move") << "L1 1"
                             << "";
    QTest::newRow("too large") << "M0 0L1e999 1"
                               << "M0,0L0,1";
    QTest::newRow("not a number") << "M0 0L-nan 1"
                                  << "M0,0";
}

void TestWarpedDrawing::pathsAreRead() {
    QFETCH(QString, d);
    QFETCH(QString, expected);
    QCOMPARE(QString::fromStdString(pathText(pathOf(d.toStdString()), 3)), expected);
}

/// All points satisfy the equation of the ellipse, and the arcs have the direction that their flags give.
void TestWarpedDrawing::arcsAreEllipses() {
    for (const int flags : {0, 1, 2, 3}) {
        const SvgPath path = pathOf("M30,10A20,10 30 " + std::to_string(flags / 2) +
                                    std::to_string(flags % 2) + " 25,25L30,10Z");
        const double turn = 30 * std::numbers::pi / 180;
        // The centre is equally far from both ends in the coordinates of the ellipse.
        Mat2 toCircle;
        toCircle << std::cos(turn) / 20, std::sin(turn) / 20, -std::sin(turn) / 10, std::cos(turn) / 10;
        const Vec2 a = toCircle * Vec2(30, 10), b = toCircle * Vec2(25, 25), half = (b - a) / 2;
        const double lift = std::sqrt(1 - half.squaredNorm());
        const double side = flags / 2 == flags % 2 ? 1 : -1;
        const Vec2 centre = (a + b) / 2 + side * lift * Vec2(half.y(), -half.x()).normalized();
        for (const PathPiece& piece : path)
            if (piece.kind == Kind::Cubic)
                QVERIFY(std::abs((toCircle * piece.points[2] - centre).norm() - 1) < 1e-9);
        const double chord = 2 * std::asin(half.norm()),
                     angle = flags / 2 ? 2 * std::numbers::pi - chord : chord;
        const double expected = 200 * (angle - std::sin(angle)) / 2;  // of the segment
        QVERIFY2(std::abs(areaOf(path) - expected) < 1e-3 * expected, qPrintable(QString::number(flags)));
    }
    const SvgPath circle = ellipsePath({50, 50}, 40, 40);
    QVERIFY(std::abs(areaOf(circle) - 1600 * std::numbers::pi) < 0.02);
    forCurves(circle, [&](const auto& p) {
        for (const double t : {0.25, 0.5, 0.75})
            if (p[0] != p[3]) QVERIFY(std::abs((cubicAt(p, t) - Vec2(50, 50)).norm() - 40) < 40 * 5e-6);
    });
}

void TestWarpedDrawing::mapIsExactForAffineOnes() {
    const auto affine = [](const Vec2& p) {
        return Vec2(0.8 * p.x() - 0.3 * p.y() + 7, 0.5 * p.x() + 1.1 * p.y() - 3);
    };
    const Grid grid(100, 7, affine);
    const PlaneMap map(grid.rest, grid.pose);
    for (const Vec2& p : {Vec2(3, 4), Vec2(50, 50), Vec2(99.9, 0), Vec2(-20, 130), Vec2(0, 100)})
        QVERIFY((map(p) - affine(p)).norm() < 1e-10);
    QVERIFY(map.contains({0, 0}) && map.contains({100, 30}) && !map.contains({101, 30}));
    const Affine nearest = nearestAffine(map, {Vec2(1, 1), Vec2(90, 20), Vec2(30, 70)});
    QVERIFY((nearest({20, 20}) - affine({20, 20})).norm() < 1e-9);
    const Affine onLine = nearestAffine(map, {Vec2(1, 1), Vec2(9, 9)});
    QVERIFY((onLine({9, 1}) - affine({9, 1})).norm() < 1e-9);
    QCOMPARE(map.border().size(), std::size_t(1));
}

/// Halving the cells divides the error by about 8; that of the linear map of each cell, by 4.
void TestWarpedDrawing::mapIsOfThirdOrder() {
    const auto errorWith = [](int cells) {
        const Grid grid(200, cells, waves);
        const PlaneMap map(grid.rest, grid.pose);
        double greatest = 0;
        for (double x = 60; x < 140; x += 3.1)
            for (double y = 60; y < 140; y += 2.9)
                greatest = std::max(greatest, (map(Vec2(x, y)) - waves(Vec2(x, y))).norm());
        return greatest;
    };
    const double coarse = errorWith(20), fine = errorWith(40);
    QVERIFY2(fine < coarse / 6, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
    QVERIFY2(coarse < 0.03, qPrintable(QString::number(coarse)));
}

void TestWarpedDrawing::cubicsGoThroughAffineMaps() {
    const auto affine = [](const Vec2& p) { return Vec2(1.5 * p.x() + 0.5 * p.y(), p.y() - 0.25 * p.x()); };
    const Grid grid(100, 9, affine);
    const SvgPath path = pathOf("M10 10C20 80 60 0 90 90L50 95 10 60Z M30 30L40 30 40 40");
    const SvgPath carried = carriedPath(path, PlaneMap(grid.rest, grid.pose), 0.05);
    QCOMPARE(carried.size(), path.size());
    for (std::size_t k = 0; k < path.size(); ++k) {
        QCOMPARE(carried[k].kind, path[k].kind);
        for (int i = 0; i < path[k].count(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            QVERIFY((carried[k].points[at] - affine(path[k].points[at])).norm() < 1e-6);
        }
    }
}

/// A map of determinant 1 keeps areas.
void TestWarpedDrawing::discsKeepTheirArea() {
    const Grid grid(200, 60, waves);
    const SvgPath carried =
        carriedPath(ellipsePath({100, 100}, 70, 70), PlaneMap(grid.rest, grid.pose), 0.05);
    const double area = std::numbers::pi * 4900;
    QVERIFY2(std::abs(areaOf(carried) - area) < 1e-4 * area,
             qPrintable(QString::number(areaOf(carried) - area)));
    QVERIFY2(carried.size() < 50, qPrintable(QString::number(carried.size())));
    QCOMPARE(carried.back().kind, Kind::Close);
}

/// No place of the curve is farther from the carried one than the tolerance.
void TestWarpedDrawing::curvesKeepTheirDistance() {
    const Grid grid(200, 60, waves);
    const PlaneMap map(grid.rest, grid.pose);
    const SvgPath source = pathOf("M20 20L180 190C100 200 20 180 20 60");
    std::vector<Vec2> exact;
    forCurves(source, [&](const auto& p) {
        for (int k = 0; k <= 4000; ++k) exact.push_back(map(cubicAt(p, k / 4000.0)));
    });
    for (const double tolerance : {0.5, 0.05, 0.005}) {
        double farthest = 0;
        forCurves(carriedPath(source, map, tolerance), [&](const auto& p) {
            for (const double t : {0.1, 0.3, 0.45, 0.62, 0.8, 0.95}) {
                const Vec2 at = cubicAt(p, t);
                double nearest = 1e9;
                for (std::size_t k = 1; k < exact.size(); ++k) {
                    const Vec2 along = exact[k] - exact[k - 1];
                    const double part =
                        std::clamp((at - exact[k - 1]).dot(along) / (along.squaredNorm() + 1e-300), 0.0, 1.0);
                    nearest = std::min(nearest, (exact[k - 1] + part * along - at).norm());
                }
                farthest = std::max(farthest, nearest);
            }
        });
        QVERIFY2(farthest < 1.2 * tolerance + 0.002,
                 qPrintable(QString("%1 %2").arg(tolerance).arg(farthest)));
    }
}

/// A square keeps its corners, a smooth place has one tangent on both sides, and closed curves are closed.
void TestWarpedDrawing::cornersAndEndsStay() {
    const Grid grid(200, 60, waves);
    const PlaneMap map(grid.rest, grid.pose);
    const SvgPath square = carriedPath(rectanglePath({50, 50}, {100, 100}, 0, 0), map, 0.05);
    for (const Vec2& corner : {Vec2(50, 50), Vec2(150, 50), Vec2(150, 150), Vec2(50, 150)}) {
        double nearest = 1e9;
        for (const PathPiece& piece : square)
            if (piece.count() > 0)
                nearest = std::min(
                    nearest,
                    (piece.points[static_cast<std::size_t>(piece.count() - 1)] - map(corner)).norm());
        QVERIFY(nearest < 1e-9);
    }
    std::vector<std::array<Vec2, 4>> curves;
    forCurves(carriedPath(ellipsePath({100, 100}, 70, 40), map, 0.01), [&](const auto& p) {
        if ((p[3] - p[0]).norm() > 1e-9) curves.push_back(p);
    });
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const auto &a = curves[k], &b = curves[(k + 1) % curves.size()];
        QVERIFY((a[3] - b[0]).norm() < 1e-9);
        const Vec2 before = (a[3] - a[2]).normalized(), after = (b[1] - b[0]).normalized();
        QVERIFY((before - after).norm() < 1e-6);
    }
}

/// Everything that Qt's library draws looks the same as paths, except that its own circles have coarser
/// cubics.
void TestWarpedDrawing::drawingsStayTheSame() {
    const std::string body = R"svg(
      <defs>
        <linearGradient id="l"><stop offset="0" stop-color="red"/><stop offset="1" stop-color="#00f" stop-opacity="0.5"/></linearGradient>
        <radialGradient id="r" gradientUnits="userSpaceOnUse" cx="70" cy="70" r="20"><stop offset="0.2" stop-color="yellow"/><stop offset="1" stop-color="green"/></radialGradient>
      </defs>
      <g transform="translate(5 3) rotate(8)" fill="url(#l)" stroke="#333" stroke-width="2">
        <rect x="5" y="5" width="30" height="20" rx="6"/>
        <circle cx="60" cy="18" r="12" fill="teal"/>
        <ellipse cx="85" cy="18" rx="8" ry="14" fill="none" stroke-dasharray="4 2"/>
      </g>
      <path d="M10 50q10-20 20 0t20 0a10 6 20 1 1 5 12z" fill="#c84" fill-rule="evenodd" stroke="black" stroke-linejoin="round"/>
      <circle cx="70" cy="70" r="20" fill="url(#r)"/>
      <g opacity="0.5"><polygon points="10,95 30,70 50,95" fill="purple"/><polyline points="20,95 40,75 55,95" fill="none" stroke="orange" stroke-width="3"/></g>
      <line x1="60" y1="95" x2="95" y2="92" stroke="blue" stroke-width="1.2" stroke-linecap="round"/>
      <text x="12" y="45" font-size="9" fill="#204060">Wend</text>)svg";
    const VectorDrawing drawing = vectors(body);
    QCOMPARE(textsOf(drawing.notices), std::vector<std::string>());
    const QSize size(800, 800);
    const QImage before =
        drawn("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + body + "</svg>", size);
    QVERIFY(meanDifference(before, drawn("<svg xmlns='http://www.w3.org/2000/svg'/>", size)) > 30);
    const QImage paths =
        drawn(std::string(drawing.svg).insert(drawing.svg.find("<svg") + 4, " viewBox='0 0 100 100'"), size);
    QVERIFY2(meanDifference(before, paths) < 0.2, qPrintable(QString::number(meanDifference(before, paths))));
    const QImage same = drawn(carried(drawing, &::same), size);
    QVERIFY2(meanDifference(before, same) < 0.2, qPrintable(QString::number(meanDifference(before, same))));
    // The map is applied outside the drawing, which is rotated by a transform.
    const auto turn = [](const Vec2& p) { return Vec2(0.8 * p.x() + 0.2 * p.y(), 0.7 * p.y() + 10); };
    std::string fixed = body;  // pens are not turned with it
    for (std::size_t at = 0; (at = fixed.find("stroke=\"", at)) != std::string::npos; at += 8)
        if (fixed.compare(at, 14, "stroke=\"none\">") != 0) fixed.replace(at, 6, "strokX");
    const VectorDrawing plain = vectors(fixed);
    const QImage turned = drawn(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><g "
        "transform='matrix(0.8 0 0.2 0.7 0 10)'>" +
            fixed + "</g></svg>",
        size);
    const QImage carriedOnes = drawn(carried(plain, turn), size);
    QVERIFY2(meanDifference(turned, carriedOnes) < 0.3,
             qPrintable(QString::number(meanDifference(turned, carriedOnes))));
}

void TestWarpedDrawing::styleSheetsAndUses() {
    const VectorDrawing drawing = vectors(R"svg(
      <style>/* all */ .a, #x .b { fill: red; } path.a { stroke: blue } #y { fill: green !important } g > rect {opacity:.5}
             @media print { path { fill: black } } rect:hover { fill: pink }</style>
      <symbol id="s" viewBox="0 0 10 10"><path id="inner" class="a" d="M0 0H10V10Z"/></symbol>
      <g id="x"><rect class="b" width="10" height="10"/><path id="y" class="a" style="fill:yellow" d="M1 1L2 2"/></g>
      <use id="u1" href="#s" x="20" y="20" width="20" height="20"/><use xlink:href="#s" width="10" height="10"/>)svg");
    const std::string& svg = drawing.svg;
    QCOMPARE(attribute(svg, "//g[@id='x']/path[1]", "fill"), "red");
    QCOMPARE(attribute(svg, "//g[@id='x']/path[1]", "opacity"), ".5");
    QCOMPARE(attribute(svg, "//path[@id='y']", "stroke"), "blue");
    QCOMPARE(attribute(svg, "//g[@id='u1']/path", "d"), "M20,20L40,20L40,40Z");
    QCOMPARE(attribute(svg, "//g[@id='u1']/path", "fill"), "red");
    QCOMPARE(attribute(svg, "//g[@id='u1']/path", "id"), "inner");
    QCOMPARE(attribute(svg, "/svg/g/g[3]/path", "d"), "M0,0L10,0L10,10Z");
    QCOMPARE(attribute(svg, "/svg/g/g[3]/path", "id"), "");  // ids are unique
}

/// Pens keep their width; the transform that makes a pen an ellipse stays; gradients follow.
void TestWarpedDrawing::pensAndPaintsGoAlong() {
    const VectorDrawing drawing = vectors(R"svg(
      <linearGradient id="g" gradientUnits="userSpaceOnUse" x1="10" y1="0" x2="30" y2="0"><stop offset="0"/><stop offset="1" stop-color="red"/></linearGradient>
      <path id="round" transform="scale(2)" d="M5 5L20 20" stroke="red" stroke-width="1.5" stroke-dasharray="2,1"/>
      <path id="flat" transform="scale(2 1)" d="M5 5L20 20" stroke="red" stroke-width="1.5"/>
      <path id="filled" d="M10 10H40V40H10Z" fill="url(#g)"/>)svg");
    const auto turn = [](const Vec2& p) { return Vec2(100 - p.y(), p.x()); };  // by a right angle
    const std::string svg = carried(drawing, turn);
    QCOMPARE(attribute(svg, "//path[@id='round']", "stroke-width"), "3");
    QCOMPARE(attribute(svg, "//path[@id='round']", "stroke-dasharray"), "4,2");
    QCOMPARE(attribute(svg, "//path[@id='round']", "d"), "M90,10L60,40");
    QCOMPARE(attribute(svg, "//path[@id='flat']", "transform"), "matrix(2 0 0 1 0 0)");
    QCOMPARE(attribute(svg, "//path[@id='flat']", "stroke-width"), "1.5");
    QCOMPARE(attribute(svg, "//path[@id='flat']", "d"), "M47.5,10L40,40");  // within its transform
    const std::string gradient = attribute(svg, "//path[@id='filled']", "fill");
    QVERIFY(gradient.starts_with("url(#"));
    const std::string found = "//linearGradient[@id='" + gradient.substr(5, gradient.size() - 6) + "']";
    Affine transform;
    QVERIFY(readTransform(attribute(svg, found.c_str(), "gradientTransform"), transform));
    const Vec2 from(std::stod(attribute(svg, found.c_str(), "x1")),
                    std::stod(attribute(svg, found.c_str(), "y1")));
    QVERIFY((transform(from) - turn({10, 0})).norm() < 1e-5);
    QVERIFY((transform(Vec2(30, 0)) - turn({30, 0})).norm() < 1e-5);
    QCOMPARE(attribute(svg, "//stop[2]", "stop-color"), "red");
}

void TestWarpedDrawing::clipsAndLayers() {
    const VectorDrawing drawing = vectors(R"svg(
      <clipPath id="c"><rect x="10" y="10" width="20" height="20" transform="translate(5)"/></clipPath>
      <filter id="f"><feGaussianBlur stdDeviation="2"/></filter>
      <mask id="m"><rect width="50" height="50" fill="white"/></mask>
      <g id="layer" inkscape:label="arm" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" style="mix-blend-mode:multiply;display:none" opacity="0.5">
        <g clip-path="url(#c)"><circle cx="20" cy="20" r="9"/></g>
        <rect id="soft" width="10" height="10" transform="scale(2)" filter="url(#f)"/>
        <rect id="masked" width="10" height="10" mask="url(#m)"/></g>)svg");
    const auto shift = [](const Vec2& p) { return Vec2(p.x() + 2, p.y() + 3); };
    const std::string svg = carried(drawing, shift);
    const std::string layer = "//g[@id='layer']";
    QCOMPARE(attribute(svg, layer.c_str(), "inkscape:label"), "arm");
    QCOMPARE(attribute(svg, layer.c_str(), "display"), "none");
    QCOMPARE(attribute(svg, layer.c_str(), "opacity"), "0.5");
    QCOMPARE(attribute(svg, layer.c_str(), "style"), "mix-blend-mode:multiply;");
    QCOMPARE(attribute(svg, "//clipPath/path", "d"), "M17,13L37,13L37,33L17,33Z");
    QVERIFY(!attribute(svg, (layer + "/g[@clip-path]").c_str(), "clip-path").empty());
    QCOMPARE(attribute(svg, "//mask/path", "d"), "M2,3L52,3L52,53L2,53Z");
    QVERIFY(!attribute(svg, "//g[@id='masked']", "mask").empty());
    // A blur is in the frame of its shape, its contents are not.
    QCOMPARE(attribute(svg, "//g[@filter]", "transform"), "matrix(2 0 0 2 0 0)");
    QCOMPARE(attribute(svg, "//g[@filter]/g", "transform"), "matrix(0.5 0 0 0.5 0 0)");
    QCOMPARE(attribute(svg, "//g[@filter]/g/path", "d"), "M2,3L22,3L22,23L2,23Z");
    QCOMPARE(attribute(svg, "//feGaussianBlur", "stdDeviation"), "2");
    // Parts outside the shape are clipped by its border.
    const std::string large = carried(vectors("<rect x='-5' width='110' height='50'/>"), shift);
    QVERIFY(!attribute(large, "/svg/g", "clip-path").empty());
    QVERIFY(attribute(svg, "/svg/g", "clip-path").empty());
}

/// Boxes enclose the drawn part of an element, in its own coordinates, whatever clips it.
void TestWarpedDrawing::clipsInBoxUnits() {
    const VectorDrawing drawing = vectors(R"svg(
      <clipPath id="c" clipPathUnits="objectBoundingBox"><rect x="0.25" width="0.5" height="1"/></clipPath>
      <clipPath id="t" clipPathUnits="objectBoundingBox" transform="translate(1 2)"><rect width="1" height="1"/></clipPath>
      <mask id="m" maskContentUnits="objectBoundingBox"><rect width="0.5" height="0.5" fill="white"/></mask>
      <defs><rect id="far" x="40" y="40" width="8" height="4"/></defs>
      <g id="group" clip-path="url(#c)" transform="translate(10 10)"><g clip-path="url(#c)"><rect width="4" height="8"/></g>
        <circle transform="translate(16 0)" r="4" stroke="red" stroke-width="9"/><rect x="90" width="9" height="9" display="none"/></g>
      <use id="used" clip-path="url(#t)" x="2" href="#far"/>
      <g id="masked" mask="url(#m)"><rect x="20" y="30" width="6" height="8"/></g>)svg");
    const std::string svg = carried(drawing, [](const Vec2& p) { return p; });
    const auto clipped = [&](const std::string& element, const char* property) {
        const std::string url = attribute(svg, element.c_str(), property);
        return attribute(
            svg, ("//*[@id='" + url.substr(5, std::max<std::size_t>(url.size(), 6) - 6) + "']/path").c_str(),
            "d");
    };
    QCOMPARE(clipped("//g[@id='group']", "clip-path"), "M15,6L25,6L25,18L15,18Z");
    QCOMPARE(clipped("//g[@id='group']/g", "clip-path"), "M11,10L13,10L13,18L11,18Z");
    QCOMPARE(clipped("//g[@id='used']", "clip-path"), "M43,42L51,42L51,46L43,46Z");
    QCOMPARE(clipped("//g[@id='masked']", "mask"), "M20,30L23,30L23,34L20,34Z");
    QVERIFY(drawing.notices.empty());
}

void TestWarpedDrawing::picturesAreEmbedded() {
    const VectorDrawing drawing = vectors(
        "<rect id='below' width='9' height='9'/><image id='photo' x='10' y='20' width='30' height='30' "
        "href='data:image/"
        "png;base64,"
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJg"
        "gg=='/><image href='other.png' width='5' height='5'/><rect id='above' width='9' height='9'/>");
    QCOMPARE(drawing.pictures.size(), std::size_t(1));
    const DrawnPicture& picture = drawing.pictures.front();
    const double scale = drawing.width / 100.0;
    QVERIFY(std::abs(picture.x - 10 * scale) <= 3 && std::abs(picture.height - 30 * scale) <= 6);
    QCOMPARE(picture.pixels.size(), std::size_t(4 * picture.width * picture.height));
    QCOMPARE(textsOf(drawing.notices),
             (std::vector<std::string>{"a picture in it stays one",
                                       "its picture \"other.png\" is not in the file: it is left out"}));
    const std::string svg = carried(drawing, &::same);
    QCOMPARE(attribute(svg, "//image", "xlink:href"), "data:image/png;base64,cG5n");  // "png"
    QVERIFY(std::abs(std::stod(attribute(svg, "//image", "y")) - 20) < 0.3);
    QVERIFY(svg.find("'below'") == std::string::npos && svg.find("\"below\"") < svg.find("<image"));
    QVERIFY(svg.find("<image") < svg.find("\"above\""));
}

void TestWarpedDrawing::damagedDrawings_data() {
    QTest::addColumn<QString>("body");
    QTest::addColumn<QString>("message");  // of the error or the notice; empty: nothing is to be said
    QTest::newRow("use without a target") << "<use href='#gone'/>"
                                          << "a <use> refers to \"gone\", which is missing";
    QTest::newRow("use of itself") << "<g id='a'><use href='#a'/></g>"
                                   << "uses its \"a\" within itself";
    QTest::newRow("uses in a ring") << "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"
                                    << "within itself";
    QTest::newRow("gradient of itself")
        << "<linearGradient id='g' xlink:href='#g'/><rect width='9' height='9' fill='url(#g)'/>"
        << "takes attributes from itself";
    QTest::newRow("clip by itself")
        << "<clipPath id='c'><rect width='9' height='9' clip-path='url(#c)'/></clipPath>"
           "<rect width='9' height='9' clip-path='url(#c)'/>"
        << "";
    QTest::newRow("missing paint") << "<rect width='9' height='9' fill='url(#gone)'/>"
                                   << "its paint url(#gone) is missing";
    QTest::newRow("far away") << "<path d='M0 0L1e30 5'/>"
                              << "reaches too far";
    QTest::newRow("no transform") << "<rect width='9' height='9' transform='scale(x)'/>"
                                  << "cannot be read";
    QTest::newRow("flat transform") << "<rect width='9' height='9' transform='scale(0)'/>"
                                    << "";
    QTest::newRow("absurd sizes")
        << "<rect width='-1e300' height='1e308'/><circle r='nan'/><ellipse rx='1e400' ry='3'/>"
        << "";
    QTest::newRow("unknown") << "<foreignObject width='5' height='5'/>"
                             << "its <foreignObject> is left out";
    QTest::newRow("many uses") << [] {
        QString text = QStringLiteral("<g id='n0'><rect width='1' height='1'/></g>");
        for (int k = 1; k < 30; ++k)
            text += QStringLiteral("<g id='n%1'><use href='#n%2'/><use href='#n%2'/><use href='#n%2'/></g>")
                        .arg(k)
                        .arg(k - 1);
        return "<defs>" + text + "</defs><use href='#n29'/>";
    }() << "";
    QTest::newRow("deep") << QString("<g>").repeated(5000) + "<rect width='1' height='1'/>" +
                                 QString("</g>").repeated(5000)
                          << "";
}

/// One line, and no crash.
void TestWarpedDrawing::damagedDrawings() {
    QFETCH(QString, body);
    QFETCH(QString, message);
    QString said;
    try {
        const VectorDrawing drawing = vectors(body.toStdString());
        carried(drawing, &::same);
        for (const Message& notice : drawing.notices) said += QString::fromStdString(notice);
    } catch (const InputError& error) {
        said = QString::fromStdString(error.what());
        QVERIFY2(!said.contains('\n') && !said.contains(QStringLiteral("signal")), qPrintable(said));
    }
    QVERIFY2(said.contains(message), qPrintable(said));
}

/// Bytes are exchanged, dropped and doubled.
void TestWarpedDrawing::randomDamage() {
    const std::string sound =
        R"svg(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" width="40" height="40" viewBox="0 0 40 40">
<defs><linearGradient id="g" x1="0"><stop offset="0" stop-color="red"/><stop offset="1"/></linearGradient><clipPath id="c"><circle r="9"/></clipPath></defs>
<style>.a{fill:url(#g);stroke:blue}</style><g transform="matrix(1 0 0 1 5 5)" clip-path="url(#c)"><path class="a" d="M1 2C3 4 5 6 7 8Q1 2 3 4A5 6 30 1 0 9 9z"/>
<use href="#r" x="3"/><rect id="r" width="10%" height="3mm" rx="1"/><text x="3" y="9" font-size="5">ab</text></g></svg>)svg";
    std::mt19937 random(5);
    int read = 0;
    for (int round = 0; round < 60; ++round) {
        std::string text = sound;
        for (unsigned k = random() % 6; k-- > 0;) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 30));
                    break;
                default:
                    text[at] = "0123456789.-e#<>/\"'"[random() % 19];
            }
        }
        try {
            carried(readVectors(written("damaged.svg", text), {}, {}), waves);
            ++read;
        } catch (const InputError& error) {
            QVERIFY2(!QString(error.what()).contains("signal"), error.what());
        }
    }
    QVERIFY(read > 5);
}

QTEST_MAIN(TestWarpedDrawing)
#include "test_warped_drawing.moc"
