#include <QSignalSpy>
#include <QTest>

#include "app/view/volume/volume_view.h"
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

  private:
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
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
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
            const Vec<3> screen = camera.project(ray.origin + t * ray.direction, viewport);
            QVERIFY((screen.head<2>() - Eigen::Vector2d(123.5, 77.25)).norm() < 1e-9);
        }
    }
}

void TestVolumeView::panKeepsThePointUnderThePointer() {
    Camera camera = m_view->camera();
    const QSize viewport(640, 480);
    const Vec<3> before = camera.project(camera.pivot(), viewport);
    const Vec<3> held = camera.pivot();
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
    const Vec<3> held = ray.origin + depth * ray.direction;
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
    const auto all = m_view->verticesIn(m_view->rect(), false);
    const auto visible = m_view->verticesIn(m_view->rect(), true);
    QCOMPARE(static_cast<Eigen::Index>(all.size()), m_picture.pose.cols());
    QVERIFY(!visible.empty() && visible.size() < all.size());
}

void TestVolumeView::navigationIgnoresWhatIsUnderThePointer() {
    for (const QPoint at : {QPoint(400, 300), QPoint(10, 10)}) {
        const Vec<3> before = m_view->camera().direction();
        QTest::mousePress(m_view.get(), Qt::MiddleButton, {}, at);
        QTest::mouseMove(m_view.get(), at + QPoint(40, 0));
        QTest::mouseRelease(m_view.get(), Qt::MiddleButton, {}, at + QPoint(40, 0));
        QVERIFY((m_view->camera().direction() - before).norm() > 0.1);
    }
}

void TestVolumeView::cutShowsTheInside() {
    const QImage whole = m_view->grabFramebuffer();
    m_view->setCut(CutKind::WholeCells, {Vec<3>::Zero(), Vec<3>::UnitX()});
    const QImage cells = m_view->grabFramebuffer();
    m_view->setCut(CutKind::Exact, {Vec<3>::Zero(), Vec<3>::UnitX()});
    const QImage exact = m_view->grabFramebuffer();
    QVERIFY(whole != cells && cells != exact);
    m_view->setCut(CutKind::None, {});
    QVERIFY(m_view->grabFramebuffer() == whole);
}

QTEST_MAIN(TestVolumeView)
#include "test_volume_view.moc"
