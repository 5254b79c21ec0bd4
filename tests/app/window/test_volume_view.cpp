#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/views/volume/volume_view.h"
#include "core/mesh/cell_geometry.h"
#include "core/meshing/volume_mesher.h"
#include "tests/support/surfaces.h"

using namespace wend;

class TestVolumeView : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void drawsTheSolid();
    void rayAndProjectionAgree();
    void panKeepsThePointUnderThePointer();
    void zoomKeepsThePointUnderThePointer();
    void picksTheNearestCell();
    void marqueeSeesThroughOrNot();
    void navigationIgnoresWhatIsUnderThePointer();
    void cutShowsTheInside();
    void ridingSurfaceHasItsTexture();
    void paintLiesOverASkin();
    void ridingSurfaceFollowsAndIsCut();
    void raysMeetTheEmbeddedSurface();
    void hugeAndTinySolidsLookTheSame();
    void picturesOfTilesAreWhole();
    void surfacesAloneAreNotCut_data();
    void surfacesAloneAreNotCut();
    void anotherSolidMayHaveFewerPoints();
    void viewMovesToAnotherWindow();
    void missingPicturesAreReportedOnce();
    void fitShowsGlyphs();
    void fineDrawingOutlivesTheBeginningOfAMotion();
    void movingShapesAreInTheirPlace();
    void manyTrianglesAreDrawn();
    void edgesFadeWhereTheyAreDense();
    void faceOfACutHasAnOutline();
    void coveredMarksShineThrough();
    void markedTrianglesShineThrough();
    void marksOfTwoKindsDoNotMix();
    void rimIsAroundTheShapeAlone();
    void smoothColoursChangeEvenly();
    void smoothColoursOfASkin();

  private:
    /// Waits until nothing moves any more and the view is drawn in full quality.
    bool isSettled() {
        return QTest::qWaitFor([this] { return m_view->isSettled(); }, 20000);
    }

    std::unique_ptr<VolumeView> m_view;
    VolumePicture m_picture;
};

void TestVolumeView::initTestCase() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    VolumeMeshOptions options;
    options.vertices = 600;
    const auto mesh = meshVolume(test::box({-2, -0.5, -0.5}, {2, 0.5, 0.5}, 6), options).mesh;
    m_picture.rest = std::make_shared<SimplicialMesh<3>>(mesh);
    m_picture.facets = std::make_shared<std::vector<Facet<3>>>(facetsOf(mesh));
    m_picture.pose = mesh.points;
    m_view = std::make_unique<VolumeView>();
    m_view->resize(800, 600);
    m_view->setPicture(m_picture, true);
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get(), 20000));
}

void TestVolumeView::drawsTheSolid() {
    const QImage image = m_view->grabFramebuffer();
    QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2) != image.pixelColor(2, 2));
    if (qEnvironmentVariableIsSet("WEND_TEST_PICTURES"))
        QVERIFY(image.save(qEnvironmentVariable("WEND_TEST_PICTURES") + "/volume.png"));
}

void TestVolumeView::rayAndProjectionAgree() {
    Camera camera = m_view->camera();
    const QSize viewport(640, 480);
    for (bool orthographic : {false, true}) {
        camera.setOrthographic(orthographic);
        const Ray ray = camera.ray({123.5, 77.25}, viewport);
        for (double t : {1.0, 5.0, 9.0}) {
            const Vec3 screen = camera.project(ray.origin + t * ray.direction, viewport);
            QVERIFY((screen.head<2>() - Eigen::Vector2d(123.5, 77.25)).norm() < 1e-9);
        }
    }
}

void TestVolumeView::panKeepsThePointUnderThePointer() {
    Camera camera = m_view->camera();
    const QSize viewport(640, 480);
    const Vec3 before = camera.project(camera.pivot(), viewport);
    const Vec3 held = camera.pivot();
    camera.pan(30, -12, viewport);
    QVERIFY((camera.project(held, viewport).head<2>() - before.head<2>() - Eigen::Vector2d(30, -12)).norm() <
            1e-9);
}

void TestVolumeView::zoomKeepsThePointUnderThePointer() {
    Camera camera = m_view->camera();
    const QSize viewport(640, 480);
    const Eigen::Vector2d pixel(500, 100);
    const Ray ray = camera.ray(pixel, viewport);
    const double depth =
        (camera.pivot() - ray.origin).dot(camera.direction()) / ray.direction.dot(camera.direction());
    const Vec3 held = ray.origin + depth * ray.direction;
    camera.zoom(2.5, pixel, viewport);
    QVERIFY((camera.project(held, viewport).head<2>() - pixel).norm() < 1e-9);
}

void TestVolumeView::picksTheNearestCell() {
    const SolidHit hit = m_view->pick(QPointF(400, 300));
    QVERIFY(hit.cell >= 0 && hit.vertex >= 0);
    QVERIFY(hit.point.cwiseAbs().maxCoeff() <= 2 + 1e-12);
    QCOMPARE(m_view->pick(QPointF(2, 2)).cell, -1);
}

void TestVolumeView::marqueeSeesThroughOrNot() {
    const auto inside = [this](const QPointF& p) { return QRectF(m_view->rect()).contains(p); };
    const auto all = m_view->verticesWhere(inside, false);
    const auto visible = m_view->verticesWhere(inside, true);
    QCOMPARE(static_cast<Eigen::Index>(all.size()), m_picture.pose.cols());
    QVERIFY(!visible.empty() && visible.size() < all.size());
}

void TestVolumeView::navigationIgnoresWhatIsUnderThePointer() {
    for (const QPoint at : {QPoint(400, 300), QPoint(10, 10)}) {
        const Vec3 before = m_view->camera().direction();
        QTest::mousePress(m_view.get(), Qt::MiddleButton, {}, at);
        QTest::mouseMove(m_view.get(), at + QPoint(40, 0));
        QTest::mouseRelease(m_view.get(), Qt::MiddleButton, {}, at + QPoint(40, 0));
        QVERIFY((m_view->camera().direction() - before).norm() > 0.1);
    }
}

void TestVolumeView::cutShowsTheInside() {
    const QImage whole = m_view->grabFramebuffer();
    m_view->setCut(CutKind::WholeCells, {Vec3::Zero(), Vec3::UnitX()});
    const QImage cells = m_view->grabFramebuffer();
    m_view->setCut(CutKind::Exact, {Vec3::Zero(), Vec3::UnitX()});
    const QImage exact = m_view->grabFramebuffer();
    QVERIFY(whole != cells && cells != exact);
    VolumePicture tinted = m_picture;  // the face of a cut may have a colour of its own
    tinted.section = qRgb(220, 40, 40);
    m_view->setPicture(tinted, false);
    const QImage own = m_view->grabFramebuffer();
    int red = 0;
    for (int y = 0; y < own.height(); ++y)
        for (int x = 0; x < own.width(); ++x) {
            const bool isRed = qRed(own.pixel(x, y)) > 2 * qGreen(own.pixel(x, y)) + 20;
            red += isRed;
            if (!isRed) QCOMPARE(own.pixel(x, y), exact.pixel(x, y));
        }
    QVERIFY2(red > 100, qPrintable(QString::number(red)));
    m_view->setPicture(m_picture, false);
    QVERIFY(m_view->grabFramebuffer() == exact);
    m_view->setCut(CutKind::None, {});
    QVERIFY(m_view->grabFramebuffer() == whole);
}

namespace {

/// Returns a square on the top of the bar, half of it red, half of it with a picture.
std::shared_ptr<Skin> plate(const QString& texture) {
    auto skin = std::make_shared<Skin>();
    skin->points.resize(3, 6);
    skin->points << -1.5, 0, 1.5, -1.5, 0, 1.5, -0.4, -0.4, -0.4, 0.4, 0.4, 0.4, 0.6, 0.6, 0.6, 0.6, 0.6, 0.6;
    skin->triangles = {{0, 1, 4}, {1, 2, 5}, {0, 4, 3}, {1, 5, 4}};
    skin->uv.resize(2, 4);
    skin->uv << 0, 1, 1, 0, 0, 0, 1, 1;
    skin->uvCorners = {{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 2, 3}};
    skin->materialOf = {0, 1, 0, 1};
    skin->materials = {{"red", {1, 0, 0, 1}, ""}, {"picture", {1, 1, 1, 1}, texture.toStdString()}};
    return skin;
}

QColor at(const QImage& image, const VolumeView& view, const Vec3& p) {
    const Vec3 pixel = view.camera().project(p, view.size());
    return image.pixelColor(int(pixel.x()), int(pixel.y()));
}

/// Returns a triangle mesh of a wave, without tetrahedra behind it.
VolumePicture waves(int side) {
    VolumePicture picture;
    picture.rest = std::make_shared<SimplicialMesh<3>>();
    picture.pose.resize(3, static_cast<Eigen::Index>(side + 1) * (side + 1));
    for (int i = 0; i <= side; ++i)
        for (int j = 0; j <= side; ++j) {
            const double x = 2.0 * i / side - 1, y = 2.0 * j / side - 1;
            picture.pose.col(i * (side + 1) + j) << x, y, 0.2 * std::sin(9 * x) * std::cos(7 * y);
        }
    auto facets = std::make_shared<std::vector<Facet<3>>>();
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const int a = i * (side + 1) + j, b = a + side + 1;
            for (const auto& t : {std::array{a, b, a + 1}, std::array{a + 1, b, b + 1}})
                facets->push_back({t, {static_cast<int>(facets->size()), -1}});
        }
    picture.facets = facets;
    return picture;
}

}  // namespace

void TestVolumeView::ridingSurfaceHasItsTexture() {
    QTemporaryDir folder;
    QImage chequers(2, 2, QImage::Format_RGB32);  // green above blue
    chequers.fill(Qt::green);
    chequers.setPixelColor(0, 1, Qt::blue);
    chequers.setPixelColor(1, 1, Qt::blue);
    const QString file = folder.filePath(QStringLiteral("chequers.png"));
    QVERIFY(chequers.scaled(64, 64).save(file));
    VolumePicture picture = m_picture;
    picture.skin = plate(file);
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, picture.skin->points);
    picture.materials = true;
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(picture, true);
    const QImage image = m_view->grabFramebuffer();
    const QColor left = at(image, *m_view, {-0.8, 0, 0.6}), high = at(image, *m_view, {0.8, 0.25, 0.6}),
                 low = at(image, *m_view, {0.8, -0.25, 0.6}), bar = at(image, *m_view, {1.8, 0, 0.5});
    QVERIFY(left.red() > 100 && left.green() < 60 && left.blue() < 60);
    QVERIFY(high.green() > 100 && high.red() < 60 && high.blue() < 60);  // texture points count from below
    QVERIFY(low.blue() > 100 && low.red() < 60 && low.green() < 60);
    QCOMPARE(bar, image.pixelColor(2, 2));  // the border is not drawn
    QCOMPARE(m_view->solid().triangles(), 4);
    picture.materials = false;  // the colours of a map
    picture.cellColours.assign(picture.rest->cells.size(), qRgb(230, 230, 0));
    m_view->setPicture(picture, false);
    const QColor map = at(m_view->grabFramebuffer(), *m_view, {0.8, 0.25, 0.6});
    QVERIFY(map.red() > 100 && map.green() > 100 && map.blue() < 60);
    // Over the materials it covers their grays: light is a factor, so the colours are mixed in proportion.
    picture.materials = true;
    m_view->setPicture(picture, false);
    std::array<std::array<QColor, 2>, 3> seen;
    for (int k = 0; k < 3; ++k) {
        SurfaceStyle style;
        style.edges = false;
        style.mapOpacity = std::array{1.0, 0.5, 0.001}[k];
        m_view->setStyle(style);
        const QImage covered = m_view->grabFramebuffer();
        seen[k] = {at(covered, *m_view, {-0.8, 0, 0.6}), at(covered, *m_view, {0.8, 0.25, 0.6})};
    }
    m_view->setStyle({});
    QCOMPARE(seen[0][0], seen[0][1]);
    for (int place = 0; place < 2; ++place) {
        const QColor whole = seen[0][place], half = seen[1][place], gray = seen[2][place];
        QVERIFY(whole.red() > 100 && whole.green() == whole.red() && whole.blue() < 3);
        QVERIFY(gray.red() - gray.blue() <= 2 && gray.green() - gray.blue() <= 2 && gray.red() > 20);
        QVERIFY(std::abs(2 * half.red() - whole.red() - gray.red()) <= 3);
        QVERIFY(std::abs(2 * half.blue() - whole.blue() - gray.blue()) <= 3);
    }
    QVERIFY(seen[2][1].red() > seen[2][0].red() + 15);  // green is lighter than red
}

namespace {

/// Returns plain faces with lighting, without lines.
SurfaceStyle bare() {
    SurfaceStyle style;
    style.edges = false;
    return style;
}

}  // namespace

/// White is painted over the right half of a plate: half of the amount is half of the difference, light being
/// a factor, and on the left every pixel is unchanged.
void TestVolumeView::paintLiesOverASkin() {
    VolumePicture picture = m_picture;
    picture.skin = plate({});
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, picture.skin->points);
    picture.materials = true;
    m_view->setStyle(bare());
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(picture, true);
    const auto seen = [&](const VolumePicture& shown) {
        m_view->setPicture(shown, false);
        return m_view->grabFramebuffer();
    };
    const QImage plain = seen(picture);
    picture.paint.opacity = 0.5;
    picture.paint.own.assign(picture.rest->cells.size(), 0);
    picture.paint.colours = picture.paint.opacities = Points3::Zero(3, picture.pose.cols());
    QVERIFY(seen(picture) == plain);
    for (Eigen::Index v = 0; v < picture.pose.cols(); ++v)
        if (picture.pose(0, v) > 0.01) picture.paint.colours(2, v) = picture.paint.opacities(0, v) = 1;
    const QImage half = seen(picture);
    picture.paint.opacity = 1;
    const QImage whole = seen(picture);
    const Vec3 left(-0.8, 0, 0.6), right(1.3, 0.1, 0.6);
    QCOMPARE(at(half, *m_view, left), at(plain, *m_view, left));
    const auto mean = [](int a, int b) { return (a + b) / 2; };
    const QColor a = at(plain, *m_view, right), b = at(half, *m_view, right), c = at(whole, *m_view, right);
    QVERIFY(c.red() == c.green() && c.blue() > c.red() + 80 && a.red() > c.red() + 80);
    QVERIFY(std::abs(b.red() - mean(a.red(), c.red())) <= 2);
    QVERIFY(std::abs(b.green() - mean(a.green(), c.green())) <= 2);
    QVERIFY(std::abs(b.blue() - mean(a.blue(), c.blue())) <= 2);
    m_view->setPicture(m_picture, true);
    m_view->setStyle({});
}

void TestVolumeView::ridingSurfaceFollowsAndIsCut() {
    VolumePicture picture = m_picture;
    picture.skin = plate({});
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, picture.skin->points);
    picture.materials = true;
    picture.pose.row(1).array() += 1;
    picture.cellColours.assign(picture.rest->cells.size(), qRgb(40, 220, 40));
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(m_picture, true);
    m_view->setPicture(picture, false);
    QImage image = m_view->grabFramebuffer();
    const QColor nothing = image.pixelColor(2, 2);
    QCOMPARE(at(image, *m_view, {-0.8, -0.1, 0.6}), nothing);
    QVERIFY(at(image, *m_view, {-0.8, 1, 0.6}).red() > 100);
    // The parts of the plate and of the solid above the plane are removed.
    m_view->setCut(CutKind::Exact, {Vec3::Zero(), -Vec3::UnitX()});
    image = m_view->grabFramebuffer();
    QCOMPARE(at(image, *m_view, {-0.8, 1, 0.6}), nothing);
    QVERIFY(at(image, *m_view, {0.8, 1, 0.6}) != nothing);
    // Seen along the normal, the section is the solid's, where the plate has no inside.
    m_view->look(Camera::Axis::Left);
    m_view->fit();
    const QColor section = at(m_view->grabFramebuffer(), *m_view, {0, 1, 0});
    QVERIFY(section.green() > 2 * section.red());
    m_view->setCut(CutKind::None, {});
    m_view->look(Camera::Axis::Isometric);
    m_view->setPicture(m_picture, true);
}

/// An octahedron |x| + |y| + |z| = 0.4 is embedded in the bar: rays meet it, not the bar around it.
void TestVolumeView::raysMeetTheEmbeddedSurface() {
    auto skin = std::make_shared<Skin>();
    skin->points.resize(3, 6);
    skin->points << Mat3(0.4 * Mat3::Identity()), Mat3(-0.4 * Mat3::Identity());
    for (int i = 0; i < 8; ++i) skin->triangles.push_back({i & 1 ? 3 : 0, i & 2 ? 4 : 1, i & 4 ? 5 : 2});
    VolumePicture picture = m_picture;
    picture.skin = skin;
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, skin->points);
    const auto hitAt = [this](const Vec3& p) {
        return m_view->pick(QPointF(m_view->camera().project(p, m_view->size()).x(),
                                    m_view->camera().project(p, m_view->size()).y()));
    };
    const auto misses = [](const Vec3& p) { return std::abs(p.cwiseAbs().sum() - 0.4); };
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(m_picture, true);
    m_view->setOrthographic(true);
    QVERIFY(std::abs(hitAt({0.1, 0.2, 0}).point.z() - 0.5) < 1e-6);
    m_view->setPicture(picture, false);
    for (const Vec3& p : {Vec3(0.1, 0.2, 0), Vec3(-0.3, 0.05, 0), Vec3(0.02, -0.03, 0)}) {
        const SolidHit hit = hitAt(p);
        QVERIFY(hit.cell >= 0 && misses(hit.point) < 1e-6 && hit.point.z() > 0);
        QVERIFY(PointLocator<3>(picture.pose, {picture.rest->cells[hit.cell]}).find(hit.point, 1e-6));
        const auto& corners = picture.rest->cells[hit.cell];
        QVERIFY(std::find(corners.begin(), corners.end(), hit.vertex) != corners.end());
    }
    QCOMPARE(hitAt({0.3, 0.3, 0}).cell, -1);  // the bar is there, and is not drawn
    // The octahedron follows the bar, which is rotated by half a turn about z and moved; a cut opens it as
    // drawn.
    picture.pose.topRows<2>() *= -1;
    picture.pose.row(0).array() += 1;
    m_view->setPicture(picture, false);
    QCOMPARE(hitAt({-0.1, 0.1, 0}).cell, -1);
    const SolidHit moved = hitAt({1.1, 0.2, 0});
    QVERIFY(moved.cell >= 0 && misses(moved.point - Vec3::UnitX()) < 1e-6);
    QVERIFY(PointLocator<3>(picture.pose, {picture.rest->cells[moved.cell]}).find(moved.point, 1e-6));
    m_view->setCut(CutKind::Exact, {Vec3(0, 0, -0.1), Vec3::UnitZ()});
    QVERIFY(std::abs(hitAt({1.1, 0.1, 0}).point.z() + 0.1) < 1e-6);  // the section of the bar
    m_view->setCut(CutKind::Exact, {Vec3(1, 0, 0), Vec3::UnitX()});
    QCOMPARE(hitAt({1.1, 0.1, 0}).cell, -1);
    QVERIFY(misses(hitAt({0.9, 0.1, 0}).point - Vec3::UnitX()) < 1e-6);
    // Rays do not meet the part beyond the plane of a surface that reaches out of the bar.
    auto wide = std::make_shared<Skin>();
    wide->points.resize(3, 3);
    wide->points << -1, 1, 0, 0.3, 0.3, 0.3, 0.6, 0.6, 1.2;
    wide->triangles = {{0, 1, 2}};
    picture = m_picture;
    picture.skin = wide;
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, wide->points);
    m_view->setCut(CutKind::None, {});
    m_view->look(Camera::Axis::Front);
    m_view->setPicture(picture, false);
    QVERIFY(std::abs(hitAt({0, 0.3, 0.8}).point.y() - 0.3) < 1e-6);
    m_view->setCut(CutKind::Exact, {Vec3::Zero(), Vec3::UnitY()});
    QCOMPARE(hitAt({0, 0.3, 0.8}).cell, -1);
    m_view->setCut(CutKind::None, {});
    m_view->setOrthographic(false);
    m_view->setPicture(m_picture, true);
}

void TestVolumeView::hugeAndTinySolidsLookTheSame() {
    m_view->setPicture(m_picture, true);
    const QImage expected = m_view->grabFramebuffer();
    for (const double size : {1e7, 1e-7}) {
        VolumePicture picture = m_picture;
        auto rest = std::make_shared<SimplicialMesh<3>>(*picture.rest);
        rest->points *= size;
        picture.pose *= size;
        picture.rest = rest;
        m_view->setPicture(picture, true);
        const QImage image = m_view->grabFramebuffer();
        int different = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                different += qAbs(qGray(image.pixel(x, y)) - qGray(expected.pixel(x, y))) > 8;
        QVERIFY2(different < 100, qPrintable(QString::number(different)));  // of 480 000: single edge pixels
    }
    m_view->setPicture(m_picture, true);
}

/// A picture drawn in tiles equals one drawn at once, except for the last bit of the clipped projection.
void TestVolumeView::picturesOfTilesAreWhole() {
    m_view->setPicture(m_picture, true);
    const QImage once = m_view->picture({900, 500}, true);
    m_view->setLargestTile(128);
    const QImage tiled = m_view->picture({900, 500}, true);
    QCOMPARE(tiled.size(), once.size());
    int different = 0;
    for (int y = 0; y < once.height(); ++y)
        for (int x = 0; x < once.width(); ++x)
            different += qAbs(qGray(tiled.pixel(x, y)) - qGray(once.pixel(x, y))) > 40 ||
                         qAbs(qAlpha(tiled.pixel(x, y)) - qAlpha(once.pixel(x, y))) > 70;
    QVERIFY2(different < 50, qPrintable(QString::number(different)));
    m_view->setLargestTile(2048);
    const QImage wide = m_view->picture({9000, 40}, false);  // more than renderers can draw at once
    QCOMPARE(wide.size(), QSize(9000, 40));
    QVERIFY(wide.pixel(4500, 20) != wide.pixel(2, 2));
}

void TestVolumeView::surfacesAloneAreNotCut_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("whole cells") << int(CutKind::WholeCells);
    QTest::newRow("exact") << int(CutKind::Exact);
}

/// A file's triangles without tetrahedra are shown whole after a cut solid.
void TestVolumeView::surfacesAloneAreNotCut() {
    QFETCH(int, kind);
    VolumeView view;
    view.resize(200, 200);
    view.setPicture(m_picture, true);
    view.setCut(static_cast<CutKind>(kind), {Vec3::Zero(), Vec3::UnitX()});
    QVERIFY(!view.solid().surface().triangles.empty());
    VolumePicture picture = m_picture;
    picture.rest = std::make_shared<const SimplicialMesh<3>>();
    picture.facets = std::make_shared<const std::vector<Facet<3>>>(
        std::vector<Facet<3>>{{{0, 1, 2}, {0, -1}}, {{0, 1, 3}, {1, -1}}});
    view.setPicture(picture, true);
    QCOMPARE(view.solid().surface().triangles.size(), std::size_t(2));
}

/// The remaining points may be the same.
void TestVolumeView::anotherSolidMayHaveFewerPoints() {
    VolumeView view;
    view.resize(200, 200);
    view.setPicture(m_picture, true);
    VolumePicture picture = m_picture;
    const Cell<3> first = m_picture.rest->cells.front();
    auto one = std::make_shared<SimplicialMesh<3>>();
    one->points = m_picture.rest->points.leftCols(*std::max_element(first.begin(), first.end()) + 1);
    one->cells = {first};
    picture.rest = one;
    picture.facets = std::make_shared<const std::vector<Facet<3>>>(facetsOf(*one));
    picture.pose = one->points;
    view.setPicture(picture, true);
    const Vec3 middle = centroid<3>(one->points, first);
    view.camera().lookAt(middle);
    const Vec3 screen = view.camera().project(middle, view.size());
    QCOMPARE(view.pick({screen.x(), screen.y()}).cell, 0);
    view.setPicture(m_picture, true);
    QCOMPARE(view.solid().surface().triangles.size(), wholeSurface(*m_picture.facets).triangles.size());
}

/// The other window has an OpenGL context of its own.
void TestVolumeView::viewMovesToAnotherWindow() {
    QWidget first, second;
    for (QWidget* window : {&first, &second}) window->resize(300, 200);
    auto* view = new VolumeView(&first);
    view->setGeometry(0, 0, 300, 200);
    view->setPicture(m_picture, true);
    first.show();
    QVERIFY(QTest::qWaitForWindowExposed(&first, 20000));
    const QImage before = view->grabFramebuffer();
    QVERIFY(before.pixelColor(150, 100) != before.pixelColor(2, 2));
    second.show();
    QVERIFY(QTest::qWaitForWindowExposed(&second, 20000));
    view->setParent(&second);
    view->show();
    QTRY_VERIFY_WITH_TIMEOUT(view->grabFramebuffer() == before, 20000);
    QCOMPARE(view->picture({64, 64}, true).pixelColor(32, 32).alpha(), 255);
}

void TestVolumeView::missingPicturesAreReportedOnce() {
    VolumeView view;
    view.resize(200, 200);
    QSignalSpy missing(&view, &VolumeView::picturesMissing);
    auto skin = std::make_shared<Skin>();
    skin->points = m_picture.rest->points;
    skin->triangles = {{0, 1, 2}};
    skin->materials.resize(1);
    skin->materials[0].texture = "/nowhere/wood.png";
    skin->materialOf = {0};
    VolumePicture embedded = m_picture;
    embedded.skin = skin;
    embedded.embedding = std::make_shared<Embedding<3>>(*m_picture.rest, skin->points);
    embedded.materials = true;
    view.setPicture(embedded, true);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, 20000));
    view.grabFramebuffer();
    QCOMPARE(missing.count(), 1);
    QCOMPARE(missing.front().front().toStringList(), QStringList{"/nowhere/wood.png"});
    view.setPicture(m_picture, false);  // the border, and the surface again
    view.grabFramebuffer();
    view.setPicture(embedded, false);
    view.grabFramebuffer();
    QCOMPARE(missing.count(), 1);
}

void TestVolumeView::fitShowsGlyphs() {
    m_view->look(Camera::Axis::Front);
    m_view->setPicture(m_picture, true);
    const Vec3 tip(6, 0, 0);
    const auto isInView = [&] {
        m_view->fit();
        return m_view->camera().project(tip, m_view->size()).x() < m_view->width();
    };
    QVERIFY(!isInView());
    DrawVertex corner;
    corner.position = {6, 0, 0};
    m_view->setGlyphs({corner, corner, corner});
    QVERIFY(isInView());
    m_view->setGlyphs({});
    QVERIFY(!isInView());
}

/// A mesh whose triangles are as small as pixels shows its surface, a coarse one its edges.
void TestVolumeView::edgesFadeWhereTheyAreDense() {
    const auto darkest = [this](int side) {
        m_view->look(Camera::Axis::Top);
        m_view->setPicture(waves(side), true);
        std::array<QImage, 2> images;
        for (const bool edges : {false, true}) {
            SurfaceStyle style;
            style.edges = edges;
            m_view->setStyle(style);
            images[edges] = m_view->grabFramebuffer();
        }
        m_view->setStyle({});
        double most = 0;
        for (int y = 250; y < 350; ++y)
            for (int x = 350; x < 450; ++x) {
                const double plain = qGray(images[0].pixel(x, y)), edged = qGray(images[1].pixel(x, y));
                if (plain > 20) most = std::max(most, 1 - edged / plain);
            }
        return most;
    };
    const double coarse = darkest(20), dense = darkest(224);
    QVERIFY2(coarse > 0.25, qPrintable(QString::number(coarse)));
    QVERIFY2(dense > 0.02 && dense < 0.5 * coarse, qPrintable(QString::number(dense)));
}

void TestVolumeView::manyTrianglesAreDrawn() {
    VolumePicture picture = waves(224);  // 100 352
    m_view->look(Camera::Axis::Isometric);
    m_view->setPicture(picture, true);
    const QImage image = m_view->grabFramebuffer();
    QCOMPARE(m_view->solid().triangles(), 100352);
    QVERIFY(image.pixelColor(400, 300) != image.pixelColor(2, 2));
    QVERIFY(m_view->pick({400, 300}).cell >= 0);
    QVERIFY(m_view->solid().visited() < 400);
    picture.pose.row(2).array() += 0.3;
    m_view->setPicture(picture, false);
    QVERIFY(m_view->grabFramebuffer() != image);
    const SolidHit hit = m_view->pick({400, 300});
    QVERIFY(hit.cell >= 0 && hit.point.z() > 0.09);  // the moved surface: its lowest place is 0.1
    if (!qEnvironmentVariableIsSet("WEND_TEST_FIGURES")) return;
    // Figures for the manual: milliseconds from a new pose to the painted frame.
    for (const int side : {224, 707})
        for (const bool edges : {false, true})
            for (const bool moving : {false, true}) {
                SurfaceStyle style;
                style.edges = edges;
                m_view->setStyle(style);
                VolumePicture large = waves(side);
                m_view->resize(1280, 800);
                m_view->setPicture(large, true);
                m_view->grabFramebuffer();
                double prepare = 0, draw = 0, turn = 0;
                for (int i = 0; i < 5; ++i) {
                    large.pose.row(2) *= 1.01;
                    if (moving)
                        m_view->hurry();
                    else
                        QVERIFY(isSettled());
                    m_view->setPicture(large, false);
                    m_view->repaint();
                    prepare += m_view->lastFrame().prepare / 5;
                    draw += m_view->lastFrame().draw / 5;
                    if (moving) m_view->hurry();
                    m_view->update();
                    m_view->repaint();
                    turn += (m_view->lastFrame().prepare + m_view->lastFrame().draw) / 5;
                }
                qInfo(
                    "%zu triangles, edges %d, moving %d: prepare %.1f ms, draw %.1f ms; turned view %.1f ms",
                    large.facets->size(), edges, moving, prepare, draw, turn);
            }
}

/// With software rendering, edges are rough during a motion, but only once another picture is to be drawn.
void TestVolumeView::fineDrawingOutlivesTheBeginningOfAMotion() {
    VolumePicture picture = waves(24);
    m_view->look(Camera::Axis::Isometric);
    m_view->setPicture(picture, true);
    QVERIFY(isSettled());
    const QImage fine = m_view->grabFramebuffer();
    m_view->hurry();
    QVERIFY(m_view->grabFramebuffer() == fine);
    picture.pose.row(2) *= 1.2;
    m_view->setPicture(picture, false);
    QVERIFY(m_view->grabFramebuffer() != fine);
}

/// With software rendering, a moving shape may have fewer pixels once it has been slow: they fill the view,
/// and at rest it has all of them again.
void TestVolumeView::movingShapesAreInTheirPlace() {
    const VolumePicture picture = waves(224);
    VolumePicture other = picture;
    other.pose.row(2) *= 1.3;
    const auto restore = qScopeGuard([this, size = m_view->size()] { m_view->resize(size); });
    m_view->resize(1600, 1000);
    m_view->look(Camera::Axis::Isometric);
    m_view->setPicture(picture, true);
    QVERIFY(isSettled());
    const QImage fine = m_view->grabFramebuffer();
    QImage moving;
    for (int k = 0; k < 4; ++k) {
        const VolumePicture* next = k % 2 == 0 ? &other : &picture;
        m_view->hurry();
        m_view->setPicture(*next, false);
        moving = m_view->grabFramebuffer();
        QCOMPARE(moving.size(), fine.size());
    }
    double sum = 0;
    for (int y = 0; y < fine.height(); y += 3)
        for (int x = 0; x < fine.width(); x += 3)
            sum += std::abs(qGray(moving.pixel(x, y)) - qGray(fine.pixel(x, y)));
    const double mean = 9 * sum / fine.width() / fine.height();
    QVERIFY2(mean < 3, qPrintable(QString::number(mean)));
    QTRY_VERIFY_WITH_TIMEOUT(m_view->grabFramebuffer() == fine, 20000);
}

namespace {

/// Returns a square across x as two triangles.
std::vector<DrawVertex> square(double x, double half, QRgb colour) {
    std::vector<DrawVertex> triangles;
    const auto corner = [&](double y, double z) {
        DrawVertex vertex;
        vertex.position = {float(x), float(y), float(z)};
        vertex.normal = {1, 0, 0};
        vertex.colour = {uchar(qRed(colour)), uchar(qGreen(colour)), uchar(qBlue(colour)), 255};
        triangles.push_back(vertex);
    };
    for (const auto& [y, z] : {std::pair{-half, -half}, {half, -half}, {half, half}}) corner(y, z);
    for (const auto& [y, z] : {std::pair{-half, -half}, {half, half}, {-half, half}}) corner(y, z);
    return triangles;
}

}  // namespace

/// The section of the bar is a square: along its sides there is a dark line, inside there is none, and from
/// behind it is hidden.
void TestVolumeView::faceOfACutHasAnOutline() {
    VolumePicture tinted = m_picture;
    tinted.section = qRgb(230, 180, 140);
    m_view->setStyle(bare());
    m_view->look(Camera::Axis::Right);
    m_view->setPicture(tinted, true);
    m_view->setCut(CutKind::Exact, {Vec3(0.013, 0, 0), Vec3::UnitX()});
    const auto darkAlong = [&](double half) {
        const QImage image = m_view->grabFramebuffer();
        int dark = 0;
        for (int i = -9; i <= 9; ++i)
            for (const Vec3& p : {Vec3(0.013, half, i / 20.), Vec3(0.013, -half, i / 20.),
                                  Vec3(0.013, i / 20., half), Vec3(0.013, i / 20., -half)}) {
                const Vec3 pixel = m_view->camera().project(p, m_view->size());
                int least = 255;  // at a pixel's border it may be the neighbour
                for (int dx = -1; dx <= 1; ++dx)
                    for (int dy = -1; dy <= 1; ++dy)
                        least = std::min(least, qGray(image.pixel(int(pixel.x()) + dx, int(pixel.y()) + dy)));
                dark += least < 90;
            }
        return dark;
    };
    QCOMPARE(darkAlong(0.5), 4 * 19);
    QCOMPARE(darkAlong(0.46), 0);  // about six pixels inside
    m_view->look(Camera::Axis::Left);
    QCOMPARE(darkAlong(0.46), 0);
    m_view->setCut(CutKind::None, {});
    m_view->look(Camera::Axis::Right);
    QCOMPARE(darkAlong(0.5), 0);
    m_view->setPicture(m_picture, true);
    m_view->setStyle({});
}

/// The marks, such as pins, are blended where the surface is in front, once for each overlap, and not
/// elsewhere.
void TestVolumeView::coveredMarksShineThrough() {
    m_view->setStyle(bare());
    m_view->look(Camera::Axis::Right);
    m_view->setPicture(m_picture, true);
    const auto middle = [&] { return at(m_view->grabFramebuffer(), *m_view, {2, 0.01, 0.02}); };
    const QColor surface = middle();
    const QRgb blue = qRgb(0, 0, 255);
    m_view->setGlyphs(square(2.2, 0.3, blue));
    const QColor seen = middle();
    m_view->setGlyphs({}, square(1, 0.3, blue));
    const QColor covered = middle();
    const auto mixed = [](int a, int b) { return 0.6 * a + 0.4 * b; };
    QVERIFY(seen.blue() > 2 * seen.red() + 40);
    QVERIFY(std::abs(covered.red() - mixed(surface.red(), seen.red())) <= 3);
    QVERIFY(std::abs(covered.blue() - mixed(surface.blue(), seen.blue())) <= 3);
    auto twice = square(1, 0.3, blue);
    const auto behind = square(0.5, 0.3, blue);
    twice.insert(twice.end(), behind.begin(), behind.end());
    m_view->setGlyphs({}, twice);
    QCOMPARE(middle(), covered);
    m_view->setGlyphs({}, square(2.2, 0.3, blue));
    QCOMPARE(middle(), surface);
    m_view->setGlyphs({});
    QCOMPARE(middle(), surface);
    m_view->setStyle({});
}

/// Two sheets are one behind the other: a marked triangle of the second shines through the first, and looks
/// the same where it is in front.
void TestVolumeView::markedTrianglesShineThrough() {
    Points3 points(3, 6);
    points << 1, 1, 1, -1, -1, -1, -1, 1, 0, -1, 1, 0, -1, -1, 1.5, -1, -1, 1.5;
    VolumePicture picture =
        pictureOfSurface(points, {{0, 1, 2}, {3, 4, 5}}, {qRgb(200, 200, 200), qRgb(220, 30, 30)});
    VolumeView view;
    view.resize(300, 300);
    view.setStyle(bare());
    view.look(Camera::Axis::Right);
    view.setPicture(picture, true);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, 20000));
    const auto colour = [&](double x) { return at(view.grabFramebuffer(), view, {x, 0, -0.2}); };
    const QColor plain = colour(1);
    QCOMPARE(plain.red(), plain.green());
    picture.marked = {1};
    view.setPicture(picture, false);
    const QColor marked = colour(1);
    QVERIFY2(marked.red() > marked.green() + 30, qPrintable(marked.name()));
    QVERIFY(marked.green() > 60);
    view.look(Camera::Axis::Left);
    const QColor front = colour(-1);
    picture.marked = {};
    view.setPicture(picture, false);
    QCOMPARE(colour(-1), front);
}

/// A yellow sheet is in front of a green one: both colours are visible in stripes, with no olive between
/// them; in front of one of its own kind it is plain.
void TestVolumeView::marksOfTwoKindsDoNotMix() {
    Points3 points(3, 6);
    points << 1, 1, 1, -1, -1, -1, -1, 1, 0, -1, 1, 0, -1, -1, 1.5, -1, -1, 1.5;
    const QRgb yellow = qRgb(255, 170, 0), green = qRgb(46, 158, 92);
    VolumePicture picture = pictureOfSurface(points, {{0, 1, 2}, {3, 4, 5}}, {yellow, green});
    picture.marked = {0, 1};
    picture.isOpen = true;
    VolumeView view;
    view.resize(300, 300);
    view.setStyle(bare());
    view.look(Camera::Axis::Right);
    view.setPicture(picture, true);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, 20000));
    const auto count = [&view] {
        std::array<int, 3> found{};  // yellow, green, neither
        const QImage image = view.grabFramebuffer();
        const Vec3 place = view.camera().project({1, 0, -0.2}, view.size());
        const QPoint middle = QPointF(place.x(), place.y()).toPoint();
        for (int y = -15; y <= 15; ++y)
            for (int x = -15; x <= 15; ++x) {
                const QColor c = image.pixelColor(middle + QPoint(x, y));
                const bool isYellow = c.red() > 1.3 * c.green(), isGreen = c.green() > 1.5 * c.red();
                ++found[isYellow ? 0 : isGreen ? 1 : 2];
            }
        return found;
    };
    const auto mixed = count();
    QVERIFY(mixed[0] > 300 && mixed[1] > 200);
    QVERIFY2(mixed[2] < 250, qPrintable(QString::number(mixed[2])));  // where stripes meet
    picture.cellColours[1] = yellow;
    view.setPicture(picture, false);
    QCOMPARE(count()[0], 31 * 31);
}

/// The rim is as light as requested just beside the shape, also where it is cut, and absent on it.
void TestVolumeView::rimIsAroundTheShapeAlone() {
    VolumePicture picture = m_picture;
    picture.cellColours.assign(picture.rest->cells.size(), qRgb(1, 1, 1));
    m_view->look(Camera::Axis::Isometric);
    m_view->setPicture(picture, true);
    SurfaceStyle style = bare();
    for (const auto& cut : {CutKind::None, CutKind::Exact, CutKind::WholeCells}) {
        m_view->setCut(cut, {Vec3(0.31, 0, 0), Vec3(1, 0.2, 0.1).normalized()});
        m_view->setStyle(style = bare());
        const QImage without = m_view->grabFramebuffer();
        style.rim = QColor(255, 255, 255, 89);
        m_view->setStyle(style);
        const QImage with = m_view->grabFramebuffer();
        const QRgb ground = without.pixel(2, 2);
        const auto isShape = [&](int x, int y) { return without.pixel(x, y) != ground; };
        int beside = 0, rimmed = 0;
        for (int y = 4; y < with.height() - 4; ++y)
            for (int x = 4; x < with.width() - 4; ++x) {
                const bool changed = with.pixel(x, y) != without.pixel(x, y);
                bool isNear = false, isInside = true;
                for (int dy = -3; dy <= 3; ++dy)
                    for (int dx = -3; dx <= 3; ++dx) {
                        isNear = isNear || isShape(x + dx, y + dy);
                        isInside = isInside && isShape(x + dx, y + dy);
                    }
                QVERIFY(!changed || (isNear && !isInside));
                const bool touches =
                    isShape(x - 1, y) || isShape(x + 1, y) || isShape(x, y - 1) || isShape(x, y + 1);
                if (isShape(x, y) || !touches) continue;
                ++beside;
                rimmed += changed;
            }
        QVERIFY(beside > 400);  // some of them beside a pixel that the shape hardly touches
        QVERIFY2(rimmed > 0.9 * beside, qPrintable(QString("%1 of %2").arg(rimmed).arg(beside)));
    }
    // The pixels behind a picture with a transparent background are not known.
    QVERIFY(m_view->picture({200, 150}, true) ==
            (m_view->setStyle(bare()), m_view->picture({200, 150}, true)));
    m_view->setCut(CutKind::None, {});
    m_view->setStyle({});
    m_view->setPicture(m_picture, true);
}

/// The map runs from black to white along the bar, on its border and on a section: light is a factor, so that
/// the grays of one face are in proportion to the places.
void TestVolumeView::smoothColoursChangeEvenly() {
    VolumePicture picture = m_picture;
    for (int i = 0; i < 256; ++i) picture.ramp.push_back(qRgb(i, i, i));
    picture.places = Points3::Zero(3, picture.pose.cols());
    picture.places.row(0) = (picture.pose.row(0).array() + 2) / 4;
    m_view->setStyle(bare());
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(picture, true);
    for (const double height : {0.5, 0.1}) {
        if (height < 0.5) m_view->setCut(CutKind::Exact, {Vec3(0, 0, height), Vec3::UnitZ()});
        const QImage image = m_view->grabFramebuffer();
        const double white = qGray(at(image, *m_view, {1.97, 0.1, height}).rgb()) / (3.97 / 4);
        QVERIFY(white > 100);
        for (int i = -18; i <= 18; ++i) {
            const double gray = qGray(at(image, *m_view, {i / 10., 0.1, height}).rgb());
            QVERIFY2(std::abs(gray - white * (i / 10. + 2) / 4) <= 2.5, qPrintable(QString::number(i)));
        }
    }
    m_view->setCut(CutKind::None, {});
    m_view->setPicture(m_picture, true);
    m_view->setStyle({});
}

void TestVolumeView::smoothColoursOfASkin() {
    VolumePicture picture = m_picture;
    picture.skin = plate({});
    picture.embedding = std::make_shared<Embedding<3>>(*picture.rest, picture.skin->points);
    for (int i = 0; i < 256; ++i) picture.ramp.push_back(qRgb(0, i, 0));
    picture.places = Points3::Zero(3, picture.pose.cols());
    picture.places.row(0) = (picture.pose.row(0).array() + 2) / 4;
    m_view->setStyle(bare());
    m_view->look(Camera::Axis::Top);
    m_view->setPicture(picture, true);
    const QImage image = m_view->grabFramebuffer();
    const double full = at(image, *m_view, {1.4, 0.1, 0.6}).green() / (3.4 / 4);
    QVERIFY(full > 100);
    for (const double x : {-1.2, -0.5, 0.3, 0.9}) {
        const QColor seen = at(image, *m_view, {x, 0.1, 0.6});
        QVERIFY(seen.red() < 4);
        QVERIFY2(std::abs(seen.green() - full * (x + 2) / 4) <= 4, qPrintable(seen.name()));
    }
    m_view->setPicture(m_picture, true);
    m_view->setStyle({});
}

QTEST_MAIN(TestVolumeView)
#include "test_volume_view.moc"
