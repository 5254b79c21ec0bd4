// The view of a solid: the camera that is saved with its project, the axis that points up, and the drawing of
// its maps.
#include <QCheckBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QWheelEvent>

#include "app/panels/distortion_panel.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/design.h"
#include "app/project/file/project_writer.h"
#include "tests/support/layers.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

class TestSolidView : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void cameraIsKept();
    void cameraThatNobodyMovedIsNotWritten();
    void fileAsItWasKeepsItsCamera();
    void cameraIsGoneWithTheNextDocument();
    void upAxisIsUndone();
    void sidesGoByTheUpAxis();
    void colourMapIsSmooth();
    void stiffnessShinesThrough();

  private:
    QString path() const { return m_folder->filePath(QStringLiteral("seen.wend")); }
    QJsonObject saved();
    QJsonObject savedView() { return saved()["view"].toObject(); }
    void open(const QString& path);
    void turn();
    Document& document() { return m_f->session().document(); }
    /// Returns the world's axis on the screen, in pixels to the right and up.
    QPointF onScreen(int axis);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SolidFixture> m_f;
};

void TestSolidView::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_folder = std::make_unique<QTemporaryDir>();
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(m_f->open());
}

/// Returns the contents of the file, read by Qt.
QJsonObject TestSolidView::saved() {
    QFile file(path());
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

void TestSolidView::open(const QString& path) {
    const int before = document().generation();
    m_f->window().openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return document().generation() > before; }, 20000));
    QVERIFY(settle(m_f->session()));
}

/// Rotates the view with mouse and wheel.
void TestSolidView::turn() {
    SolidCanvas& canvas = m_f->canvas();
    QTest::mousePress(&canvas, Qt::MiddleButton, {}, {300, 300});
    QTest::mouseMove(&canvas, {390, 340});
    QTest::mouseRelease(&canvas, Qt::MiddleButton, {}, {390, 340});
    QWheelEvent wheel({200, 150}, canvas.mapToGlobal(QPointF(200, 150)), {}, {0, 360}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas, &wheel);
}

QPointF TestSolidView::onScreen(int axis) {
    const QPointF way = m_f->canvas().toWidget(Vec3::Unit(axis)) - m_f->canvas().toWidget(Vec3::Zero());
    return {way.x(), -way.y()};
}

/// Moving the camera changes nothing in the document; saving stores it, and opening restores it.
void TestSolidView::cameraIsKept() {
    document().save(path());
    const int steps = document().undoStack()->count();
    turn();
    m_f->actions().orthographic->setChecked(true);
    QVERIFY(!document().isModified());
    QCOMPARE(document().undoStack()->count(), steps);
    m_f->window().actions().save->trigger();
    const QJsonObject camera = savedView()["camera"].toObject();
    QVERIFY(camera["parallel"].toBool());
    const std::vector<Vec3> places = {{-2, -0.5, -0.5}, {2, 0.5, 0.5}, {0, 0, 0}, {1, -0.5, 0.5}};
    std::vector<QPointF> seen;
    for (const Vec3& p : places) seen.push_back(m_f->canvas().toWidget(p));
    const Vec3 pivot = m_f->canvas().camera().pivot();
    m_f->actions().orthographic->setChecked(false);
    m_f->canvas().look(Camera::Axis::Top);
    open(path());
    for (std::size_t i = 0; i < places.size(); ++i)
        QVERIFY(QLineF(m_f->canvas().toWidget(places[i]), seen[i]).length() < 0.01);
    QVERIFY((m_f->canvas().camera().pivot() - pivot).norm() < 1e-4);
    QVERIFY(m_f->actions().orthographic->isChecked());
    // Both the eye and its target are on the line of sight through the middle.
    const auto point = [&](const char* key) {
        const QJsonValue p = camera[QLatin1String(key)];
        return Vec3(p[0].toDouble(), p[1].toDouble(), p[2].toDouble());
    };
    const QPointF middle = m_f->canvas().rect().center() + QPointF(0.5, 0.5);
    QVERIFY(QLineF(m_f->canvas().toWidget(point("target")), middle).length() < 1);
    const Vec3 way = (point("target") - point("position")).normalized();
    QVERIFY((way - m_f->canvas().viewDirection()).norm() < 1e-5);
}

void TestSolidView::cameraThatNobodyMovedIsNotWritten() {
    m_f->actions().oblique->trigger();
    document().save(path());
    QVERIFY(!saved().isEmpty() && !saved().contains("view"));
    m_f->window().resize(1000, 700);
    document().save(path());
    QVERIFY(!saved().contains("view"));
    m_f->actions().top->trigger();
    document().save(path());
    QVERIFY(savedView().contains("camera"));
    m_f->actions().oblique->trigger();
    document().save(path());
    QVERIFY(!saved().contains("view"));
}

/// No digit changes unless the user moves the camera.
void TestSolidView::fileAsItWasKeepsItsCamera() {
    document().save(path());
    QJsonObject project = saved();
    const QJsonObject view{{"up", "y"},
                           {"camera", QJsonObject{{"position", QJsonArray{0.1234567890123, -7, 3}},
                                                  {"target", QJsonArray{1.0 / 3, 0, 0}},
                                                  {"up", QJsonArray{0, 3, 4}},
                                                  {"pivot", QJsonArray{1, 0, 0.25}}}}};
    project["view"] = view;
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(project).toJson()) > 0);
    file.close();
    open(path());
    QVERIFY((m_f->canvas().camera().pivot() - Vec3(1, 0, 0.25)).norm() < 1e-9);
    document().save(path());
    QCOMPARE(savedView(), view);
    turn();
    document().save(path());
    QVERIFY(savedView()["camera"].toObject() != view["camera"].toObject());
    QCOMPARE(savedView()["up"].toString(), QStringLiteral("y"));
}

void TestSolidView::cameraIsGoneWithTheNextDocument() {
    m_f->actions().oblique->trigger();
    document().save(path());
    QVERIFY(QFile::copy(path(), m_folder->filePath(QStringLiteral("other.wend"))));
    const Vec3 first = [&] {
        open(path());
        return m_f->canvas().viewDirection();
    }();
    turn();
    m_f->actions().orthographic->setChecked(true);
    m_f->actions().upAxes[0]->trigger();
    document().save(path());
    open(m_folder->filePath(QStringLiteral("other.wend")));
    QVERIFY((m_f->canvas().viewDirection() - first).norm() < 1e-9);
    QVERIFY(!m_f->actions().orthographic->isChecked() && !m_f->canvas().camera().orthographic());
    QVERIFY(m_f->actions().upAxes[2]->isChecked());
}

void TestSolidView::upAxisIsUndone() {
    m_f->actions().front->trigger();
    QVERIFY(onScreen(2).y() > 50 && std::abs(onScreen(2).x()) < 1);
    m_f->actions().upAxes[1]->trigger();
    QVERIFY(document().isModified());
    QVERIFY(onScreen(1).y() > 50 && std::abs(onScreen(1).x()) < 1);
    document().save(path());
    QCOMPARE(savedView()["up"].toString(), QStringLiteral("y"));
    document().undoStack()->undo();
    QVERIFY(m_f->actions().upAxes[2]->isChecked());
    QVERIFY(onScreen(2).y() > 50 && std::abs(onScreen(2).x()) < 1);
}

/// The views follow any up axis: the front and the sides have it upright, the top view along the line of
/// sight, and a rotated view keeps it upright.
void TestSolidView::sidesGoByTheUpAxis() {
    using Axis = Camera::Axis;
    SolidCanvas& canvas = m_f->canvas();
    for (int up = 0; up < 3; ++up) {
        m_f->actions().upAxes[up]->trigger();
        std::vector<Vec3> ways;
        for (const Axis side : {Axis::Front, Axis::Right, Axis::Back, Axis::Left}) {
            canvas.look(side);
            QVERIFY((canvas.camera().up() - Vec3::Unit(up)).norm() < 1e-9);
            ways.push_back(canvas.viewDirection());
        }
        QVERIFY((ways[0] + ways[2]).norm() < 1e-9 && (ways[1] + ways[3]).norm() < 1e-9);
        // The order from the front to the right is counterclockwise, seen from above.
        QVERIFY((ways[0].cross(ways[1]) - Vec3::Unit(up)).norm() < 1e-9);
        canvas.look(Axis::Top);
        QVERIFY((canvas.viewDirection() + Vec3::Unit(up)).norm() < 1e-9);
        canvas.look(Axis::Front);
        turn();
        QVERIFY(std::abs(canvas.camera().right().dot(Vec3::Unit(up))) < 1e-9);
    }
}

/// The check box is in the collapsed section of the properties, and its choice is remembered.
void TestSolidView::colourMapIsSmooth() {
    auto* box = m_f->window().findChild<QCheckBox*>(QStringLiteral("mapSmooth"));
    QVERIFY(box && !box->isChecked() && !box->toolTip().isEmpty());
    bool isFolded = false;
    for (const QWidget* w = box; w; w = w->parentWidget())
        isFolded = isFolded || dynamic_cast<const FoldingSection*>(w);
    QVERIFY(isFolded);
    QVERIFY(m_f->holdEnds());
    m_f->window().actions().showMap->setChecked(true);
    auto* panel = m_f->window().findChild<DistortionPanel*>();
    panel->setMeasure(Measure::CellSize);
    m_f->canvas().camera().fit(Vec3(-1, -0.5, -0.5), Vec3(1, 0.5, 0.5));
    // Counts neighbouring pixels that differ much: the edges of the cells.
    const auto jumps = [&] {
        const QImage image = m_f->canvas().grabFramebuffer();
        const QPoint middle = image.rect().center();
        int count = 0;
        for (int y = middle.y() - 50; y < middle.y() + 50; ++y)
            for (int x = middle.x() - 100; x < middle.x() + 100; ++x)
                count += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x + 1, y))) > 8;
        return count;
    };
    const int flat = jumps();
    QVERIFY2(flat > 100, qPrintable(QString::number(flat)));
    box->click();
    QVERIFY(box->isChecked());
    const int smooth = jumps();
    QVERIFY2(10 * smooth < flat, qPrintable(QString::number(smooth)));
    QVERIFY(DistortionPanel(m_f->session().motion(), m_f->session().playback()).isSmooth());
    box->click();
    QCOMPARE(jumps(), flat);
}

/// Stiffness at the back of the bar is visible on its front, which is not stiff; arrows at the back are not.
void TestSolidView::stiffnessShinesThrough() {
    const auto stiff = copyOf(m_f->project());
    designOf(*stiff).material.layers.push_back(
        layerWith("back", {{Box<3>{{-3, 0.2, -1}, {3, 1, 1}}}, {}, Stiffness{{1, 0, 0}, 20}}));
    document().change(QStringLiteral("Stiffen"), stiff);
    QVERIFY(settle(m_f->session()));
    m_f->canvas().fit();
    const auto front = [&] {
        const QRectF face(m_f->canvas().toWidget({-1.8, -0.5, 0.4}),
                          m_f->canvas().toWidget({1.8, -0.5, -0.4}));
        return m_f->canvas().grabFramebuffer().copy(face.toRect());
    };
    const QImage plain = front();
    m_f->window().actions().showMarks->setChecked(true);
    const QImage marked = front();
    int told = 0;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x) {
            const QColor before = plain.pixelColor(x, y), after = marked.pixelColor(x, y);
            if (before == after) continue;
            QVERIFY(after.red() - after.blue() > before.red() - before.blue());  // orange, on a brown ground
            ++told;
        }
    QVERIFY2(told > 300, qPrintable(QString::number(told)));
    m_f->window().actions().showMarks->setChecked(false);
    QVERIFY(front() == plain);
}

QTEST_MAIN(TestSolidView)
#include "test_solid_view.moc"
