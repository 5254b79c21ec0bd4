#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QToolButton>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/measure_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/project/domain.h"
#include "app/session/opening.h"
#include "app/window/actions/toolbox.h"
#include "app/window/notices/info_banner.h"
#include "core/mesh/quality.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The choice of a solid's mesh in the window, and surfaces embedded in it.
class TestSolidMesh : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void magnitudesOfAnySize();
    void maxVolumeByThePanel();
    void detailSurfaceIsChosenAndRemoved();
    void pointedCellTellsItsShape();
    void badDetailSurfacesAreRefused_data();
    void badDetailSurfacesAreRefused();

  private:
    MeshPanel& panel() { return *m_f->window().findChild<MeshPanel*>(); }
    MagnitudeBox& volume() { return *panel().findChild<MagnitudeBox*>(); }
    QToolButton& button(const char* name) { return *panel().findChild<QToolButton*>(name); }
    double maxCell() { return qualityOf<3>(*m_f->session().motion().frame<3>()->rest).maxMeasure; }
    void chooseAim(int row);
    QString write(const QString& name, const QByteArray& text);
    QTemporaryDir m_folder;
    std::unique_ptr<SolidFixture> m_f;
};

void TestSolidMesh::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->open());
    m_f->window().tools().setMode(Mode::Mesh);
}

/// Chooses by keys, as a user would.
void TestSolidMesh::chooseAim(int row) {
    for (QComboBox* box : panel().findChildren<QComboBox*>()) {
        if (box->accessibleName() != MeshPanel::tr("Aim")) continue;
        box->setFocus();
        QTest::keyClick(box, row == 0 ? Qt::Key_Home : Qt::Key_End);
    }
}

QString TestSolidMesh::write(const QString& name, const QByteArray& text) {
    QFile file(m_folder.filePath(name));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName() : QString();
}

void TestSolidMesh::magnitudesOfAnySize() {
    MagnitudeBox box;
    for (const double value : {1e-21, 3.14159e-7, 0.0125, 1.0, 42.5, 1.25e21}) {
        box.setValue(value);
        QCOMPARE(box.valueFromText(box.textFromValue(value)), box.value());
        QVERIFY(std::abs(box.value() - value) <= 1e-9 * value);
        box.stepBy(1);
        QVERIFY(box.value() > value && box.value() < 1.2 * value);
        box.setValue(value);
        box.stepBy(-1);
        QVERIFY(box.value() < value && box.value() > 0.8 * value);
    }
    QString text = QStringLiteral("-1");
    int at = 0;
    QVERIFY(box.validate(text, at) != QValidator::Acceptable);
}

void TestSolidMesh::maxVolumeByThePanel() {
    QVERIFY(!volume().isVisible());
    panel().findChild<QCheckBox*>()->click();  // at a surface that is kept some cells stay larger
    QVERIFY(settle(m_f->session()));
    const int before = m_f->session().motion().frame()->vertices;
    const double cell = maxCell();
    chooseAim(1);
    QVERIFY(volume().isVisible());
    QVERIFY(settle(m_f->session()));
    // The volume of the mesh that was there, to two digits.
    QVERIFY(volume().value() >= cell && volume().value() <= 1.1 * cell);
    // Smoothing passes the volume a little; the mesh is about as fine as it was.
    QVERIFY(std::abs(m_f->session().motion().frame()->vertices - before) < before / 5);
    volume().setFocus();
    volume().selectAll();
    QTest::keyClicks(&volume(), volume().locale().toString(0.002));
    QTest::keyClick(&volume(), Qt::Key_Return);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->domain().maxVolume, 0.002);
    QVERIFY(m_f->session().motion().frame()->cells > 4 / 0.002);  // so many such cells make its volume
    m_f->picture(QStringLiteral("largest-volume"));
    m_f->window().actions().undo->trigger();
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->domain().maxVolume, 0.0);
    QCOMPARE(m_f->session().motion().frame()->vertices, before);
    QVERIFY(!volume().isVisible());
    m_f->window().actions().redo->trigger();
    chooseAim(0);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame()->vertices, before);
}

void TestSolidMesh::detailSurfaceIsChosenAndRemoved() {
    QVERIFY(!button("removeDetail").isVisible() && !m_f->actions().removeDetail->isEnabled());
    const QString plate = write(QStringLiteral("plate.obj"),
                                "v -1 -0.4 0.6\nv 1 -0.4 0.6\nv 1 0.4 0.6\nv -1 0.4 0.6\nf 1 2 3 4\n");
    const auto drawn = [this] {
        m_f->canvas().grabFramebuffer();
        return m_f->canvas().solid().triangles();
    };
    const auto border = drawn();
    nameNextFile(this, plate);
    QTest::mouseClick(&button("chooseDetail"), Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !m_f->domain().detail.empty(); }, 20000));
    QVERIFY(settle(m_f->session()));
    QCOMPARE(drawn(), 2);
    QVERIFY(button("removeDetail").isVisible());
    m_f->picture(QStringLiteral("detail-row"));
    // After saving and reading, the file is the same.
    const QString saved = m_folder.filePath(QStringLiteral("with.wend"));
    m_f->session().document().save(saved);
    QCOMPARE(QFileInfo(QString::fromStdString(domainOf(*openFile(saved).project).detail)), QFileInfo(plate));
    QTest::mouseClick(&button("removeDetail"), Qt::LeftButton);
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->domain().detail.empty());
    QCOMPARE(drawn(), border);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(drawn(), 2);
    m_f->window().actions().undo->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->domain().detail.empty());
}

/// The pointed cell shows its shape without a map, and on a cut.
void TestSolidMesh::pointedCellTellsItsShape() {
    m_f->tool("measure")->trigger();
    const auto pointed = [this](const Vec3& p) {
        const QPoint at = m_f->at(p);
        QTest::mouseMove(&m_f->canvas(), at + QPoint(3, 0));
        QTest::mouseMove(&m_f->canvas(), at);
        return m_f->canvas().pick(at);
    };
    const auto text = [this] {
        return m_f->window().findChild<QLabel*>(QStringLiteral("measureCell"))->text();
    };
    const SolidHit outside = pointed({0.3, -0.5, 0.1});
    QVERIFY(outside.cell >= 0 && std::abs(outside.point.y() + 0.5) < 1e-6);
    QVERIFY(QTest::qWaitFor(
        [&] { return text().contains(MeasurePanel::tr("Tetrahedron %1").arg(outside.cell)); }));
    QVERIFY(text().contains(MeasurePanel::tr("dihedral angles")) && text().contains(QStringLiteral("°")));
    m_f->actions().cut->trigger();  // across y in the middle: seen from the front
    const SolidHit inside = pointed({0.3, 0, 0.1});
    QVERIFY(inside.cell >= 0 && inside.cell != outside.cell && inside.point.y() > -0.4);
    QVERIFY(QTest::qWaitFor(
        [&] { return text().contains(MeasurePanel::tr("Tetrahedron %1").arg(inside.cell)); }));
    m_f->picture(QStringLiteral("pointed-cell"));
}

void TestSolidMesh::badDetailSurfacesAreRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("no triangle") << QByteArray("v 0 0 0\nv 1 0 0\n");
    QTest::newRow("no such vertex") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    QTest::newRow("not a number") << QByteArray("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("another kind") << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
}

void TestSolidMesh::badDetailSurfacesAreRefused() {
    QFETCH(QByteArray, text);
    const auto before = m_f->session().document().project();
    nameNextFile(this, write(QStringLiteral("bad.obj"), text));
    m_f->actions().chooseDetail->trigger();
    QVERIFY(QTest::qWaitFor([&] { return m_f->window().banner().isVisible(); }, 20000));
    QVERIFY2(m_f->window().banner().text().contains(QStringLiteral("bad.obj")),
             qPrintable(m_f->window().banner().text()));
    QCOMPARE(m_f->session().document().project(), before);
}

QTEST_MAIN(TestSolidMesh)
#include "test_solid_mesh.moc"
