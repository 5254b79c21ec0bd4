#include <Eigen/Geometry>
#include <QPainter>
#include <QSemaphore>
#include <QThreadPool>
#include <QWheelEvent>
#include <map>
#include <set>

#include "app/engine/motion/fields.h"
#include "app/panels/legend.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/opening.h"
#include "app/tools/measure_tool.h"
#include "app/tools/pins/pin_picking.h"
#include "app/tools/pins/pin_tool.h"
#include "app/tools/region_outline.h"
#include "app/views/canvas/canvas.h"
#include "app/views/canvas/cell_filler.h"
#include "core/energy/distortion.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"
#include "warp/convert.h"
#include "warp/coverage.h"
#include "warp/warp.h"

using namespace wend;
using namespace wend::test;

/// The canvas compared with the code that exports.
class TestCanvas : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void viewMapsBothWays();
    void zoomKeepsThePointUnderThePointer();
    void wheelZoomsToThePointer();
    void fitShowsWhatIsBentBeyondThePicture();
    void paperEndsWithThePicture();
    void middleDragPans();
    void pictureIsWhatAnExportWrites();
    void everyDepthComesOutTheSame_data();
    void everyDepthComesOutTheSame();
    void lightIsBlendedAsInExports();
    void mapColoursAreOrdered_data();
    void mapColoursAreOrdered();
    void cellsAreFilledOnce();
    void smoothMapGoesByMeans();
    void mapsHaveALightRimInTheDark();
    void areaIsCentredOnOne();
    void rangesReachTheGreatestValuesButAHundredth();
    void nothingHasAPlainRange();
    void pictureIsSeenBeforeItsMesh();
    void nothingIsSeenBeforeItsPicture();
    void picturesOfMeshesAreDrawn_data();
    void picturesOfMeshesAreDrawn();
    void worstPlaceIsThatOfTheMap();
    void lengthsAndAnglesAreMeasured();
    void shearIsTheRightAngleThatChangesMost();
    void everyMeasureIsComplete();
    void worstPlaceIsMarkedWhereItIs();
    void namesOfPinsWaitForAMoment();
    void draggedPinsAreNotCovered();
    void partsAreFramedWhereTheyAre();
    void framesStandOnTheirPath();
    void edgesAreThoseOfThePose();
    void restIsShown();
    void legendTellsItsEnds();
    void coarsePixelsFillTheView();

  private:
    void bendFar();
    QPoint pixelAt(const Vec2& p) const;
    OpenedFile shapeless();
    void checkThatThePictureIsSeen();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ShapeSession> m_session;
    std::unique_ptr<ShapeCanvas> m_canvas;
};

/// Keeps all threads of the pool busy during its lifetime.
class BusyPool {
  public:
    BusyPool() {
        for (int i = 0; i < m_threads; ++i) {
            QThreadPool::globalInstance()->start([gate = m_gate, started = m_started] {
                started->release();
                gate->acquire();
            });
        }
        m_started->acquire(m_threads);
    }
    ~BusyPool() { m_gate->release(m_threads); }
    BusyPool(const BusyPool&) = delete;
    BusyPool& operator=(const BusyPool&) = delete;

  private:
    int m_threads = QThreadPool::globalInstance()->maxThreadCount();
    std::shared_ptr<QSemaphore> m_gate = std::make_shared<QSemaphore>(),
                                m_started = std::make_shared<QSemaphore>();
};

void TestCanvas::init() {
    m_canvas.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<ShapeSession>();
    m_canvas = std::make_unique<ShapeCanvas>(*m_session);
    m_canvas->resize(640, 480);
    m_canvas->show();
    m_session->document().open(openFile(writeCutOut(*m_folder)));
    QVERIFY(settle(*m_session));
}

void TestCanvas::viewMapsBothWays() {
    ViewTransform view;
    for (const bool up : {false, true}) {
        view.setPointsUp(up);
        view.fit({-3, 5, 20, 10}, {400, 300}, 20);
        const Vec2 p(2.5, 7.25);
        QVERIFY((view.toShape(view.toWidget(p)) - p).norm() < 1e-12);
        QVERIFY(QLineF(view.matrix().map(QPointF(p.x(), p.y())), view.toWidget(p)).length() < 1e-9);
        QVERIFY((view.toShape({200, 150}) - Vec2(7, 10)).norm() < 1e-9);  // the middle is in the middle
    }
}

void TestCanvas::zoomKeepsThePointUnderThePointer() {
    ViewTransform view;
    view.fit({0, 0, 100, 100}, {400, 300}, 20);
    const Vec2 before = view.toShape({37, 251});
    view.setZoom(9.5, {37, 251});
    QVERIFY((view.toShape({37, 251}) - before).norm() < 1e-9);
    QCOMPARE(view.zoom(), 9.5);
}

void TestCanvas::wheelZoomsToThePointer() {
    const QPointF at(200, 150);
    const Vec2 before = m_canvas->toShape(at);
    const double zoom = m_canvas->view().zoom();
    QWheelEvent wheel(at, m_canvas->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_canvas.get(), &wheel);
    QVERIFY(m_canvas->view().zoom() > 1.1 * zoom);
    QVERIFY((m_canvas->toShape(at) - before).norm() < 1e-9);
    m_canvas->fit();
    QCOMPARE(m_canvas->view().zoom(), zoom);
}

void TestCanvas::fitShowsWhatIsBentBeyondThePicture() {
    const auto seen = [&] {
        m_canvas->fit();
        return QRectF(m_canvas->rect()).contains(m_canvas->toWidget({0, 0}));
    };
    QVERIFY(seen());
    const double zoom = m_canvas->view().zoom();
    const int pin = m_session->addPin({40, 80, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({300, -400, 0});
    m_session->gestures().end(0.5);
    QVERIFY(settle(*m_session));
    QVERIFY(seen() && m_canvas->view().zoom() < 0.9 * zoom);
    const Points2& pose = m_session->motion().frame<2>()->pose;
    for (Eigen::Index v = 0; v < pose.cols(); ++v)
        QVERIFY(m_canvas->rect().contains(m_canvas->toWidget(pose.col(v)).toPoint()));
}

/// The checks reach as far as the picture, to the nearest pixel: otherwise a dark photograph would have a
/// bright line beside it.
void TestCanvas::paperEndsWithThePicture() {
    const Theme theme = Theme::of(m_canvas->palette());
    std::array<int, 2> seen{};
    for (const double zoom : {0.61, 0.7, 0.83, 0.97, 1.13, 1.27, 1.39}) {
        m_canvas->zoomTo(zoom);
        const QPointF corner = m_canvas->toWidget({240, 0}), below = m_canvas->toWidget({240, 30});
        const int last = static_cast<int>(std::floor(corner.x()));
        const double part = corner.x() - last;
        if (std::abs(part - 0.5) < 0.05) continue;
        const QRgb pixel = m_canvas->grab().toImage().pixel(last, qRound(below.y()));
        const bool isPaper = pixel == theme.checkerA.rgb() || pixel == theme.checkerB.rgb();
        QVERIFY2(isPaper == (part > 0.5), qPrintable(QString("%1: %2").arg(zoom).arg(part)));
        ++seen[isPaper ? 1 : 0];
    }
    QVERIFY(seen[0] > 0 && seen[1] > 0);
}

void TestCanvas::middleDragPans() {
    const Vec2 before = m_canvas->toShape({100, 100});
    QTest::mousePress(m_canvas.get(), Qt::MiddleButton, {}, {100, 100});
    QTest::mouseMove(m_canvas.get(), {130, 80});
    QTest::mouseRelease(m_canvas.get(), Qt::MiddleButton, {}, {130, 80});
    QVERIFY((m_canvas->toShape({130, 80}) - before).norm() < 1e-9);
}

void TestCanvas::pictureIsWhatAnExportWrites() {
    const int pin = m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 20, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000));
    View view;
    view.width = 640;
    view.height = 480;
    view.origin = m_canvas->view().toShape({0, 0});
    view.scale = 1 / m_canvas->view().zoom();
    const Image exported = warpImage(*m_session->document().picture(), *m_session->motion().frame<2>()->rest,
                                     m_session->motion().frame<2>()->pose, view);
    QVERIFY(exported.channels == 4 && exported.unassociated);
    const QImage expected(reinterpret_cast<const uchar*>(exported.data.data()), 640, 480,
                          QImage::Format_RGBA8888);
    QVERIFY(m_canvas->shape().drawn()->image ==
            expected.convertToFormat(QImage::Format_ARGB32_Premultiplied));
}

void TestCanvas::everyDepthComesOutTheSame_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("unassociated");
    QTest::newRow("8 bits") << int(PixelType::UInt8) << false;
    QTest::newRow("8 bits, unassociated") << int(PixelType::UInt8) << true;
    QTest::newRow("16 bits, unassociated") << int(PixelType::UInt16) << true;
}

void TestCanvas::everyDepthComesOutTheSame() {
    QFETCH(int, type);
    QFETCH(bool, unassociated);
    Image image;
    image.width = image.height = 1;
    image.channels = 4;
    image.alpha = true;
    image.type = static_cast<PixelType>(type);
    image.unassociated = unassociated;
    const std::array<int, 4> associated = {102, 51, 0, 127}, own = {205, 102, 0, 127};
    for (const int value : unassociated ? own : associated) {
        image.data.push_back(std::byte(value));
        if (image.type == PixelType::UInt16) image.data.push_back(std::byte(value));  // 257 times the value
    }
    const ScreenPicture screen(std::make_shared<const Image>(image));
    QCOMPARE(screen.image().unassociated, unassociated);
    for (int c = 0; c < 4; ++c) {
        const int expected = unassociated ? own[c] : associated[c];
        QVERIFY(std::abs(std::to_integer<int>(screen.image().data[c]) - expected) <= 1);
    }
}

/// Two sheets of linear light, 0.8 over 0.1 by half: the screen shows the mean light, encoded, as the export
/// has it, and not the mean of encoded numbers.
void TestCanvas::lightIsBlendedAsInExports() {
    for (const PixelType type : {PixelType::Half, PixelType::Float}) {
        SimplicialMesh<2> rest;
        rest.points.resize(2, 8);
        rest.points << 0, 8, 8, 0, 8, 16, 16, 8, 0, 0, 8, 8, 0, 0, 8, 8;
        rest.cells = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
        Image image{16, 8, 4, PixelType::Float, true, false, {}, {}};
        image.makePixels();
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x) {
                const float alpha = x < 8 ? 1 : 0.5F, light = x < 8 ? 0.1F : 0.8F * alpha;
                const std::array<float, 4> pixel{light, light, light, alpha};
                std::memcpy(image.row(y) + 16 * x, pixel.data(), 16);
            }
        const ScreenPicture screen(std::make_shared<const Image>(converted(image, {type, 4, true, false})));
        Points2 pose = rest.points;
        pose.rightCols(4).row(0).array() -= 8;  // over the first
        View view;
        view.width = 16, view.height = 8;
        WarpOptions options;
        options.plan = std::make_shared<const PaintingPlan>(rest, std::vector<float>{0, 0, 1, 1});
        const QColor seen = screen.warped(rest, pose, view, options).pixelColor(4, 4);
        const double light = 0.5 * 0.8 + 0.5 * 0.1, code = 1.055 * std::pow(light, 1 / 2.4) - 0.055;
        QVERIFY2(std::abs(seen.red() - 255 * code) <= 1.5, qPrintable(QString::number(seen.red())));
        QCOMPARE(seen.alpha(), 255);
    }
}

void TestCanvas::mapColoursAreOrdered_data() {
    QTest::addColumn<int>("measure");
    QTest::newRow("angle") << static_cast<int>(Measure::Angle);
    QTest::newRow("length") << static_cast<int>(Measure::Length);
}

/// Every step is darker than the one before, and by about as much (lightness L* of CIE).
void TestCanvas::mapColoursAreOrdered() {
    QFETCH(int, measure);
    const auto lightness = [&](double position) {
        const QColor c(colourAt(static_cast<Measure>(measure), position));
        const auto linear = [](double v) {
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        const double y = 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
        return 116 * std::cbrt(y) - 16;
    };
    for (int i = 0; i < 5; ++i) {
        const double step = lightness(i / 5.0) - lightness((i + 1) / 5.0);
        QVERIFY2(step > 10 && step < 24, qPrintable(QString::number(step)));
    }
}

/// A fan of translucent triangles over a square is filled as by QPainter: no pixel twice, none beside it.
void TestCanvas::cellsAreFilledOnce() {
    QImage image(40, 30, QImage::Format_ARGB32_Premultiplied), expected = image;
    for (QImage* one : {&image, &expected}) one->fill(qRgba(10, 200, 90, 255));
    Points2 points(2, 5);
    points << -5, 4, 4, -5, 0.3, 2, 2, 8, 8, 4.7;  // to be doubled
    const SimplicialMesh<2> fan{points, {{0, 1, 4}, {2, 1, 4}, {4, 2, 3}, {3, 0, 4}}};
    CellFiller filler(image.size(), PaintingPlan(fan, {}), points, QTransform::fromScale(2, 3));
    for (const Cell<2>& cell : fan.cells) filler.fill(cell, qRgba(250, 20, 130, 209));
    filler.layOver(image, CellFiller::Extent::Shape);
    QPainter painter(&expected);
    painter.fillRect(QRect(QPoint(0, 6), QPoint(7, 23)), QColor(250, 20, 130, 209));
    painter.end();
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb a = image.pixel(x, y), b = expected.pixel(x, y);
            for (const int difference :
                 {qRed(a) - qRed(b), qGreen(a) - qGreen(b), qBlue(a) - qBlue(b), qAlpha(a) - qAlpha(b)})
                QVERIFY2(std::abs(difference) <= 1, qPrintable(QString("pixel %1, %2").arg(x).arg(y)));
        }
}

/// A vertex has the colour of the mean of its cells by their areas, and the middle of a triangle that of the
/// mean of its corners: the canvas is compared with independent formulas.
void TestCanvas::smoothMapGoesByMeans() {
    bendFar();
    const auto frame = m_session->motion().frame<2>();
    RenderRequest request;
    request.frame = frame;
    request.view = m_canvas->view();
    request.view.setZoom(8, m_canvas->toWidget({150, 60}));
    request.size = QSize(2000, 1400);
    request.map = request.colours.smooth = true;
    request.colours.range = {0, 0.4};
    const QImage image = RenderThread::render(request);
    const SimplicialMesh<2>& rest = *frame->rest;
    std::vector<double> sums(rest.vertexCount(), 0), areas(rest.vertexCount(), 0);
    for (std::size_t c = 0; c < rest.cells.size(); ++c) {
        const auto& t = rest.cells[c];
        const Vec2 a = rest.points.col(t[0]), u = rest.points.col(t[1]) - a, v = rest.points.col(t[2]) - a;
        const double area = std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
        for (const int corner : t) {
            sums[corner] += area * frame->distortion->metric[c];
            areas[corner] += area;
        }
    }
    int seen = 0;
    for (const auto& t : rest.cells) {
        Vec2 middle = Vec2::Zero();
        double place = 0;
        for (const int v : t) {
            middle += frame->pose.col(v) / 3;
            place += std::clamp(sums[v] / areas[v] / 0.4, 0.0, 1.0) / 3;
        }
        const QPointF where = request.view.toWidget(middle);
        const QPoint at(static_cast<int>(std::floor(where.x())), static_cast<int>(std::floor(where.y())));
        if (!image.rect().contains(at)) continue;
        const QColor expected(colourAt(Measure::Length, place)), found(image.pixel(at));
        // The place is half a pixel off and the colour is rounded to one of 256 steps.
        QVERIFY2(std::abs(found.red() - expected.red()) <= 8 &&
                     std::abs(found.green() - expected.green()) <= 8 &&
                     std::abs(found.blue() - expected.blue()) <= 8,
                 qPrintable(found.name() + ' ' + expected.name()));
        ++seen;
    }
    QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
}

void TestCanvas::areaIsCentredOnOne() {
    const MeasureRange range = rangeOf({0.5, 0.8, 1.0, 1.1, 1.2}, Measure::Area);
    QVERIFY(std::abs(range.low * range.high - 1) < 1e-12);
    QVERIFY(std::abs(positionIn(range, Measure::Area, 1) - 0.5) < 1e-12);
    QVERIFY(std::abs(valueAt(range, Measure::Area, 0.5) - 1) < 1e-12);
}

/// Only the largest hundredth of the values is left out.
void TestCanvas::rangesReachTheGreatestValuesButAHundredth() {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(0.002 * i);
    for (const Measure measure : {Measure::Length, Measure::Angle, Measure::Speed}) {
        const MeasureRange range = rangeOf(values, measure);
        QCOMPARE(range.low, 0.0);
        QVERIFY(std::abs(range.high - 1.98) < 1e-12);
    }
    for (double& value : values) value = std::exp(value);
    QVERIFY(std::abs(std::log(rangeOf(values, Measure::Area).high) - 1.98) < 1e-12);
}

/// Speeds and displacements when nothing moves have no scale of rounding errors.
void TestCanvas::nothingHasAPlainRange() {
    for (const Measure measure : {Measure::Speed, Measure::Way}) {
        QCOMPARE(rangeOf(std::vector<double>(100, 0.0), measure).high, 1.0);
        QCOMPARE(rangeOf(std::vector<double>(100, 1e-14), measure).high, 1.0);
        QCOMPARE(rangeOf(std::vector<double>(100, 1e-3), measure).high, 1e-3);
    }
}

/// The dark end of a map would vanish on a dark ground, so the drawing has a light rim, which the picture
/// covers inside. In the light window, and without a map, there is none.
void TestCanvas::mapsHaveALightRimInTheDark() {
    const auto rim = [&](Appearance appearance, bool map, Measure measure) {
        m_canvas->setPalette(wendPalette(appearance, {}));
        m_canvas->viewport().set(&Looks::map, map);
        m_canvas->viewport().set(&Looks::colours, MapLook{measure, {0, 1}});
        if (!QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000)) return -1;
        const Theme theme = Theme::of(m_canvas->palette());
        const QImage seen = m_canvas->grab().toImage(), shape = m_canvas->shape().drawn()->image;
        int most = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width() / 2; ++x)  // left of the legend
                if (qAlpha(shape.pixel(x, y)) == 0)     // beside it
                    most = std::max(most, qGray(seen.pixel(x, y)) - qGray(theme.checkerA.rgb()));
        return most;
    };
    m_canvas->zoomTo(0.5);  // where the edge of the picture is hard
    const int dark = rim(Appearance::Dark, true, Measure::Way);
    QVERIFY2(dark > 40, qPrintable(QString::number(dark)));
    QCOMPARE(rim(Appearance::Dark, false, Measure::Way), 0);
    QCOMPARE(rim(Appearance::Dark, true, Measure::Phi), 0);  // the picture's own colours
    QCOMPARE(rim(Appearance::Light, true, Measure::Way), 0);
}

/// Opens a picture whose mesh takes longer than any test waits.
OpenedFile TestCanvas::shapeless() {
    OpenedFile file = openFile(writeCutOut(*m_folder));
    auto project = copyOf(*file.project);
    domainOf(*project).vertices = 1000000;
    file.project = project;
    return file;
}

void TestCanvas::checkThatThePictureIsSeen() {
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->shape().drawn() != nullptr; }, 20000));
    QVERIFY(!m_session->motion().frame());
    const QPoint left = m_canvas->toWidget({40, 80}).toPoint(),
                 right = m_canvas->toWidget({200, 80}).toPoint();
    const QImage shown = m_canvas->grab().toImage();
    QVERIFY(qRed(shown.pixel(left)) > 180 && qBlue(shown.pixel(left)) < 100);
    QVERIFY(qRed(shown.pixel(right)) < 100 && qBlue(shown.pixel(right)) > 150);
}

void TestCanvas::pictureIsSeenBeforeItsMesh() {
    m_session->document().open(shapeless());
    checkThatThePictureIsSeen();
}

/// The picture is complete at first sight, even where it takes longer to prepare than the canvas waits before
/// it draws the last one more finely.
void TestCanvas::nothingIsSeenBeforeItsPicture() {
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000));
    OpenedFile file = shapeless();
    Image large = *file.picture;
    large.width = 6000;
    large.height = 4000;
    large.makePixels();
    file.picture = std::make_shared<const Image>(std::move(large));
    m_canvas->zoomBy(1.1);
    m_session->document().open(std::move(file));
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->shape().drawn() != nullptr; }, 60000));
    QVERIFY(m_canvas->shape().drawn()->request.picture);
}

void TestCanvas::picturesOfMeshesAreDrawn_data() {
    QTest::addColumn<bool>("uv");
    QTest::newRow("by uv, y up") << true;
    QTest::newRow("in pixels, y down") << false;
}

void TestCanvas::picturesOfMeshesAreDrawn() {
    QFETCH(bool, uv);
    writeCutOut(*m_folder);
    QFile mesh(m_folder->filePath(QStringLiteral("quad.obj")));
    QVERIFY(mesh.open(QIODevice::WriteOnly));
    mesh.write(
        uv ? "v 0 0 0\nv 3 0 0\nv 3 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 "
             "4/4\n"
           : "v 0 0 0\nv 240 0 0\nv 240 160 0\nv 0 160 0\nf 1 2 3\nf 1 3 4\n");
    mesh.close();
    QFile project(m_folder->filePath(QStringLiteral("quad.wend")));
    QVERIFY(project.open(QIODevice::WriteOnly));
    project.write(R"({"format": "wend", "version": 1, "domain": {"mesh": "quad.obj", "image": "bar.png"}})");
    project.close();
    m_session->document().open(openFile(project.fileName()));
    QVERIFY(settle(*m_session));
    QVERIFY(QTest::qWaitFor(
        [&] { return m_canvas->isSettled() && m_canvas->shape().drawn()->request.picture; }, 20000));
    const double scale = uv ? 1 / 80.0 : 1;
    const double y = uv ? 1 : 80;
    const QPoint left = m_canvas->toWidget({40 * scale, y}).toPoint(),
                 right = m_canvas->toWidget({200 * scale, y}).toPoint();
    QVERIFY(left.x() < right.x());
    const QImage shown = m_canvas->grab().toImage();
    QVERIFY(qRed(shown.pixel(left)) > 180 && qBlue(shown.pixel(left)) < 100);
    QVERIFY(qRed(shown.pixel(right)) < 100 && qBlue(shown.pixel(right)) > 150);
}

void TestCanvas::worstPlaceIsThatOfTheMap() {
    Distortion distortion;
    distortion.angle = {0.5, 0.25, 0.125};
    distortion.metric = {0.0, 0.75, 0.5};
    distortion.ratio = {1.5, 1, 0.25};
    distortion.worstCell = 1;
    QCOMPARE(worstOf(distortion, Measure::Angle).cell, 0);
    QCOMPARE(worstOf(distortion, Measure::Length).cell, 1);
    QCOMPARE(worstOf(distortion, Measure::Area).cell, 2);
    QCOMPARE(worstOf(distortion, Measure::Area).value, 0.25);
    QVERIFY(worstText(distortion, Measure::Area).contains(QLocale().toString(0.25, 'f', 2)));
    QVERIFY(worstText(distortion, Measure::Length).contains(QLocale().toString(0.75)));
    distortion.metric = {4e-31, 0, 0};  // rounding at rest
    QVERIFY(worstText(distortion, Measure::Length).endsWith(QStringLiteral(" 0")));
    QVERIFY(worstWarning(distortion, Measure::Length).isEmpty());
    QVERIFY(worstWarning(distortion, Measure::Angle).isEmpty());
    QVERIFY(worstWarning(distortion, Measure::Area).contains(measureText(Measure::Area, 0.25)));
    distortion.ratio = {1.9, 1, 0.6};
    QVERIFY(worstWarning(distortion, Measure::Area).isEmpty());
    distortion.metric = {2874.6, 0, 0};  // never with an exponent
    QVERIFY(worstWarning(distortion, Measure::Length).contains(QStringLiteral("Stretched too far here")));
    QVERIFY(worstWarning(distortion, Measure::Length).contains(QLocale().toString(2875)));
    QVERIFY(worstText(distortion, Measure::Length).endsWith(QLocale().toString(2875)));
    QCOMPARE(measureText(Measure::Length, 287.4), QLocale().toString(287));
}

/// Clicked points are carried along by the shape: the distances shown are those now and at rest.
void TestCanvas::lengthsAndAnglesAreMeasured() {
    MeasureTool tool(*m_canvas);
    m_canvas->viewport().setTool(&tool);
    const auto click = [&](double x, double y, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(m_canvas.get(), Qt::LeftButton, keys, m_canvas->toWidget({x, y}).toPoint());
    };
    const auto told = [&](int word) {
        return tool.text().section(' ', word, word).remove(',').remove(QStringLiteral("°")).toDouble();
    };
    QVERIFY(tool.hint().contains(QStringLiteral("Click")) && tool.text().isEmpty());
    click(5, 5);  // beside the shape
    click(60, 80);
    click(180, 80);
    const double pixel = m_canvas->pixelSize({60, 80, 0});
    QVERIFY2(std::abs(told(1) - 120) < 2 * pixel, qPrintable(tool.text()));
    QVERIFY(tool.text().startsWith(QStringLiteral("length")) && tool.text().endsWith(QStringLiteral(" px")));
    const int pin = m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 30, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    QVERIFY2(tool.text().isEmpty(), qPrintable(tool.text()));  // pins are vertices: another mesh
    click(60, 110);
    click(180, 80);
    const auto frame = m_session->motion().frame<2>();
    QVERIFY(!tool.text().isEmpty() && std::abs(told(1) - told(5)) > 1);
    m_canvas->grab().toImage();  // paints
    QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
    QVERIFY(tool.text().isEmpty());
    for (const auto& [x, y] : {std::pair{60.0, 100.0}, {100.0, 80.0}, {180.0, 80.0}}) click(x, y);
    QVERIFY2(tool.text().startsWith(QStringLiteral("angle")) && told(1) > 90 && told(1) < 180,
             qPrintable(tool.text()));
    m_canvas->viewport().setTool(nullptr);
}

/// The shear is compared with every pair of perpendicular directions of a plane, tried one by one.
void TestCanvas::shearIsTheRightAngleThatChangesMost() {
    const auto most = [](const Mat2& F) {
        double largest = 0;
        for (int i = 0; i < 3600; ++i) {
            const double a = i * std::numbers::pi / 3600;
            const Vec2 p = F * Vec2(std::cos(a), std::sin(a)), q = F * Vec2(-std::sin(a), std::cos(a));
            largest = std::max(
                largest, std::abs(90 - std::acos(p.dot(q) / p.norm() / q.norm()) * 180 / std::numbers::pi));
        }
        return largest;
    };
    const auto shearOf = [](const auto& F, auto& frame) {
        frame.pose = F * frame.rest->points;
        return cellValues(frame, Measure::Shear)[0];
    };
    PosedFrame<2> flat;
    flat.rest = std::make_shared<const SimplicialMesh<2>>(
        SimplicialMesh<2>{(Points2(2, 3) << 0, 2, 1, 0, 0, 1).finished(), {{0, 1, 2}}});
    for (const Mat2& F : {Mat2{{1, 0.5}, {0, 1}}, Mat2{{3, 1}, {-1, 0.5}}, Mat2{{-1, 0.2}, {0, 1}}})
        QVERIFY(std::abs(shearOf(F, flat) - most(F)) < 1e-3);
    const Mat2 turned = 1.7 * Eigen::Rotation2Dd(0.4).toRotationMatrix();
    QVERIFY(std::abs(shearOf(turned, flat)) < 1e-6);
    PosedFrame<3> solid;
    solid.rest = std::make_shared<const SimplicialMesh<3>>(
        SimplicialMesh<3>{(Points3(3, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished(), {{0, 1, 2, 3}}});
    const Mat3 squeezed = Vec3(2, 0.5, 1).asDiagonal();  // most in the plane of the first two
    QVERIFY(std::abs(shearOf(squeezed, solid) - most(Mat2{{2, 0}, {0, 0.5}})) < 1e-3);
}

/// The table has for each measure in each dimension a name of its own, a value for every cell within its
/// range and colours, and words for the worst place.
void TestCanvas::everyMeasureIsComplete() {
    PosedFrame<2> frame;
    frame.rest = std::make_shared<const SimplicialMesh<2>>(
        SimplicialMesh<2>{(Points2(2, 4) << 0, 1, 0, 1, 0, 0, 1, 1).finished(), {{0, 1, 2}, {1, 3, 2}}});
    frame.pose = Mat2{{1.5, 0.25}, {0, 1}} * frame.rest->points;
    frame.distortion = std::make_shared<const Distortion>(distortion<2>(*frame.rest, frame.pose));
    QStringList names;
    for (const Measure measure : measuresOf(2)) {
        names << measureName(measure, 2);
        const auto values = cellValues(frame, measure);
        QCOMPARE(values.size(), std::size_t(2));
        const MeasureRange range = rangeOf(values, measure, 2);
        const double at = positionIn(range, measure, values[0]);
        if (measure != Measure::Phi) QVERIFY(std::abs(valueAt(range, measure, at) - values[0]) < 1e-12);
        QVERIFY(range.low < range.high && !measureText(measure, range.high).isEmpty());
        QVERIFY(!worstText(*frame.distortion, measure, 2).contains('%'));
    }
    QCOMPARE(names.removeDuplicates(), 0);
    QVERIFY(measuresOf(3).size() > measuresOf(2).size() && measureName(Measure::Area, 3) != names[1]);
    QCOMPARE(measureText(Measure::Influence, 50.04), QStringLiteral("50 %"));
    QCOMPARE(measureText(Measure::Length, 1.9e-31), QStringLiteral("0"));
    QCOMPARE(measureText(Measure::Stiffness, 1), QStringLiteral("×1"));
    QCOMPARE(measureText(Measure::Stiffness, 31.62), QStringLiteral("×") + QLocale().toString(31.6));
    QCOMPARE(measureText(Measure::Stiffness, 1e6), QStringLiteral("×") + QLocale().toString(1000000));
    QCOMPARE(measureText(Measure::Shear, 12.5), QLocale().toString(12.5, 'f', 2) + QStringLiteral("°"));
}

/// Moves the right end up, so that all but the left one is away from its place at rest.
void TestCanvas::bendFar() {
    setVertices(m_session->document(), 400);
    changeSetting(m_session->document(), "material.memory", 0);
    QVERIFY(settle(*m_session));
    m_session->addPin({40, 80, 0});
    const int pin = m_session->addPin({200, 80, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({-40, -70, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    m_session->selection().clear();
}

QPoint TestCanvas::pixelAt(const Vec2& p) const {
    const QPointF at = m_canvas->toWidget(p) * m_canvas->devicePixelRatioF();
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}

/// The ring is drawn for measures of distortion only; the pins are always drawn.
void TestCanvas::worstPlaceIsMarkedWhereItIs() {
    bendFar();
    m_session->selection().set({0, 1});  // so that every place lies elsewhere
    m_session->gestures().moveAtOnce({}, {0, -45, 0});
    m_session->selection().clear();
    QVERIFY(settle(*m_session));
    const auto frame = m_session->motion().frame<2>();
    const int cell = worstOf(*frame->distortion, Measure::Angle).cell;
    Vec2 pose = Vec2::Zero(), rest = Vec2::Zero();
    for (const int v : frame->rest->cells[cell]) {
        pose += frame->pose.col(v) / 3;
        rest += frame->rest->points.col(v) / 3;
    }
    m_canvas->viewport().set(&Looks::map, true);
    const auto overPicture = [&](Measure measure) {
        m_canvas->viewport().set(&Looks::colours, {measure, {0, 1}});
        const bool settled = QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000);
        const QImage grabbed = m_canvas->grab().toImage(), drawn = m_canvas->shape().drawn()->image;
        std::set<std::pair<int, int>> places;
        for (int y = 0; y < drawn.height(); ++y)
            for (int x = 0; x < drawn.width() && settled; ++x)
                if (qAlpha(drawn.pixel(x, y)) == 255 && grabbed.pixel(x, y) != drawn.pixel(x, y))
                    places.insert({x, y});
        return places;
    };
    const auto marked = overPicture(Measure::Angle), plain = overPicture(Measure::Phi);
    const auto near = [&](const Vec2& p) {
        const QPointF at = m_canvas->toWidget(p) * m_canvas->devicePixelRatioF();
        int count = 0;
        for (const auto& [x, y] : marked)
            if (!plain.contains({x, y}) && QLineF(at, QPointF(x + 0.5, y + 0.5)).length() < 20) ++count;
        return count;
    };
    QVERIFY((pose - rest).norm() > 40 / m_canvas->view().zoom());
    QVERIFY2(near(pose) > 20, qPrintable(QString::number(near(pose))));
    QCOMPARE(near(rest), 0);
}

/// The bar is in [20, 220] × [60, 100], with a margin of two pixels, in cells of about five; the area drawn
/// around its right end is far larger.
void TestCanvas::partsAreFramedWhereTheyAre() {
    for (const Region<3>& drawn :
         {Region<3>(Box<3>{{170, 10, 0}, {500, 300, 0}}),
          Region<3>(Polygon{{Vec2(170, 10), Vec2(500, 10), Vec2(500, 300), Vec2(170, 300)}})}) {
        const auto next = copyOf(*m_session->document().project());
        Pin end;
        end.at = drawn;
        designOf(*next).handles = {end};
        m_session->document().change(QStringLiteral("Hold"), next);
        QVERIFY(settle(*m_session));
        const auto border =
            regionBorder(end, m_session->gestures().pins().front(), *m_session->motion().frame<2>());
        QCOMPARE(border.size(), std::size_t(4));
        double left = 1e9, right = 0;
        for (const Vec3& p : border) {
            QVERIFY2(p.y() > 45 && p.y() < 115, qPrintable(QString::number(p.y())));
            left = std::min(left, p.x()), right = std::max(right, p.x());
        }
        QVERIFY(left >= 169 && left < 185 && right > 217 && right < 235);
    }
}

/// The name appears twenty pixels beside the pin under the pointer, once the pointer has rested there, and
/// disappears with it.
void TestCanvas::namesOfPinsWaitForAMoment() {
    PinChoice choice;
    PinTool tool(*m_canvas, choice, true);
    m_canvas->viewport().setTool(&tool);
    const int pin = m_session->addPin({40, 80, 0});
    m_session->selection().clear();
    QTRY_VERIFY(m_canvas->isSettled());
    const QPoint at = m_canvas->toWidget({40, 80}).toPoint();
    const auto beside = [&] { return m_canvas->grab(QRect(at + QPoint(22, -6), QSize(8, 12))).toImage(); };
    const Viewport& viewport = m_canvas->viewport();
    // Runs no event loop, in which the name could become due.
    const auto moveTo = [&](const QPoint& to) {
        QMouseEvent move(QEvent::MouseMove, to, m_canvas->mapToGlobal(to), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(m_canvas.get(), &move);
    };
    moveTo(at + QPoint(0, 90));
    const QImage nothing = beside();
    moveTo(at);
    QCOMPARE(tool.hovered(), pin);
    QCOMPARE(viewport.named(), -1);
    QCOMPARE(beside(), nothing);
    QTRY_COMPARE(viewport.named(), pin);
    QVERIFY(beside() != nothing);
    moveTo(at + QPoint(0, 90));
    QCOMPARE(viewport.named(), -1);
    QCOMPARE(beside(), nothing);
}

/// The pointer moves a pin over another place of the shape before the shape follows.
void TestCanvas::draggedPinsAreNotCovered() {
    const int pin = m_session->addPin({40, 80, 0});
    m_session->addPin({200, 80, 0});
    QVERIFY(settle(*m_session));
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({60, 0, 0});
    const PinView dragged = m_session->gestures().pins()[0];
    QVERIFY((dragged.centre - Vec3(100, 80, 0)).norm() < 1e-9);
    QVERIFY((m_session->motion().frame()->at(dragged.places[0]) - Vec3(40, 80, 0)).norm() < 1e-9);
    QVERIFY(m_canvas->touch(m_canvas->onScreen(dragged.centre)));
    QVERIFY(!isMarkCovered(*m_canvas, dragged));
    m_session->gestures().cancel();
}

/// The frames are on a curve after another motion, and do not overlap where the curve is short on the screen.
void TestCanvas::framesStandOnTheirPath() {
    Design next = m_session->document().design();
    Pin pin;
    pin.at = std::vector<Vec3>{{120, 80, 0}};
    pin.motions = {
        {Translate<3>{{0, 50, 0}}, 0, 0.5},
        {CurveMotion<3>{Interpolation::Polyline, {{120, 130, 0}, {200, 130, 0}}, FrameKind::Minimal}, 0.5,
         1}};
    next.handles = {pin};
    m_session->document().changeDesign(QStringLiteral("Path"), next);
    QVERIFY(settle(*m_session));
    const auto levels = [&] {  // of what has the colour of the second axis
        std::map<int, int> count;
        const QImage seen = m_canvas->grab().toImage();
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) {
                const QColor off = seen.pixelColor(x, y);
                const bool isAxis = std::abs(off.red() - 0x12) < 25 && std::abs(off.green() - 0xa5) < 25 &&
                                    std::abs(off.blue() - 0x94) < 25;
                if (isAxis) ++count[qRound(m_canvas->toShape(QPointF(x, y)).y() / 10)];
            }
        return count;
    };
    m_session->selection().set({0});
    m_canvas->zoomTo(2);
    const auto wide = levels();
    QVERIFY(wide.contains(13));
    for (const auto& [level, count] : wide)
        QVERIFY2(level == 13 || level == 14 || count < 4, qPrintable(QString::number(level)));
    m_canvas->zoomTo(0.2);  // sixteen pixels
    int pixels = 0;
    for (const auto& [level, count] : levels()) pixels += count;
    QVERIFY2(pixels > 10 && pixels < 100, qPrintable(QString::number(pixels)));
}

void TestCanvas::edgesAreThoseOfThePose() {
    bendFar();
    const auto shown = [&](bool mesh) {
        m_canvas->viewport().set(&Looks::mesh, mesh);
        const bool settled = QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000);
        return settled ? m_canvas->shape().drawn()->image : QImage();
    };
    const QImage bare = shown(false), lined = shown(true);
    const auto frame = m_session->motion().frame<2>();
    int changed = 0, all = 0;
    for (const auto& facet : facetsOf(*frame->rest)) {
        const Vec2 middle = (frame->pose.col(facet.vertices[0]) + frame->pose.col(facet.vertices[1])) / 2;
        const QPoint at = pixelAt(middle);
        if (!bare.valid(at) || qAlpha(bare.pixel(at)) < 255) continue;
        ++all;
        changed += bare.pixel(at) != lined.pixel(at);
    }
    QVERIFY(all > 300);
    QVERIFY2(changed > 0.9 * all, qPrintable(QString("%1 of %2").arg(changed).arg(all)));
    int between = 0;  // cells' middles lie on no edge
    for (const auto& cell : frame->rest->cells) {
        Vec2 centre = Vec2::Zero();
        for (const int v : cell) centre += frame->pose.col(v) / 3;
        const QPoint at = pixelAt(centre);
        between += bare.valid(at) && bare.pixel(at) != lined.pixel(at);
    }
    QVERIFY2(between < 0.2 * frame->cells, qPrintable(QString("%1 of %2").arg(between).arg(frame->cells)));
}

/// The shape at rest is shown as if nothing had been dragged, and then the pose again.
void TestCanvas::restIsShown() {
    const auto picture = [&] {
        const bool settled = QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000);
        return settled ? m_canvas->shape().drawn()->image : QImage();
    };
    setVertices(m_session->document(), 400);  // as bendFar() makes it
    QVERIFY(settle(*m_session));
    const QImage before = picture();
    bendFar();
    const QImage bent = picture();
    QVERIFY(bent != before);
    m_canvas->viewport().set(&Looks::rest, true);
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->shape().drawn()->image == before; }, 20000));
    m_canvas->viewport().set(&Looks::rest, false);
    QCOMPARE(picture(), bent);
}

/// Its left end equals that of another legend from there on, its right end does not.
void TestCanvas::legendTellsItsEnds() {
    const auto drawn = [](double low, double high) {
        Legend legend;
        legend.resize(300, legend.sizeHint().height());
        legend.set(Measure::Length, {low, high}, 2);
        return legend.grab().toImage();
    };
    const auto end = [](const QImage& all, bool left) {
        return all.copy(left ? 0 : all.width() - 60, 0, 60, all.height());
    };
    const QImage one = drawn(0.11, 0.57), longer = drawn(0.11, 0.83), later = drawn(0.24, 0.57);
    QVERIFY(end(one, true) == end(longer, true) && end(one, false) != end(longer, false));
    QVERIFY(end(one, true) != end(later, true) && end(one, false) == end(later, false));
}

/// A moving shape in a large view is drawn with fewer pixels over the same part of the screen.
void TestCanvas::coarsePixelsFillTheView() {
    QVERIFY(QTest::qWaitFor([this] { return m_canvas->isSettled(); }, 20000));
    m_canvas->resize(3200, 2200);
    const auto before = m_canvas->shape().drawn();
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->shape().drawn() != before; }, 20000));
    QVERIFY(m_canvas->shape().drawn()->request.coarseness > 1);
    const auto seen = [this] {
        return m_canvas->grab().toImage().scaled(320, 220, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage coarse = seen();
    QVERIFY(QTest::qWaitFor([this] { return m_canvas->isSettled(); }, 20000));
    QCOMPARE(m_canvas->shape().drawn()->request.coarseness, 1);
    const QImage fine = seen();
    int differing = 0;
    for (int y = 0; y < fine.height(); ++y)
        for (int x = 0; x < fine.width(); ++x)
            differing += std::abs(qGreen(coarse.pixel(x, y)) - qGreen(fine.pixel(x, y))) > 24;
    QVERIFY2(differing < fine.width() * fine.height() / 100, qPrintable(QString::number(differing)));
}

QTEST_MAIN(TestCanvas)
#include "test_canvas.moc"
