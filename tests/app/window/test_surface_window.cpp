#include <xcb/xcb.h>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QToolBar>

#include <array>
#include <cmath>
#include <cstdlib>

#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/facts_panel.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/material_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/surface_panel.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/tools/measure_tool.h"
#include "app/views/volume/solid_overlay.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/export/exporter.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/notes.h"
#include "app/window/solid_workshop.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Surfaces that bound no solid, and surfaces beside a solid: their display and messages in the window.
class TestSurfaceWindow : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void badSurfacesAreShownAndRepaired();
    void singleFaultsAreFixedOneByOne();
    void reasonIsSeenInANarrowWindow();
    void deskLeavesTheSolidToTools();
    void allAreFixedOnceThatIsKnown();
    void factsAreReportedAndGapsAreOpened();
    void noteOfWorkIsWhole();
    void noteTellsMeshesFromMotions();
    void detailedSurfaceIsShownAndTellsItsNotices();
    void pinsAreSetOnCagedSurfaces();

  private:
    void openHoles();
    QPushButton* button(const QString& name);
    bool says(const QString& words);
    bool saysThatThereIsNoSolid();
    bool edgesAreAsTheButtonSays();
    bool axesAreSeen();
    bool hasSign();
    int greenPixels();

    std::unique_ptr<SolidFixture> m_f;
};

void TestSurfaceWindow::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

/// Checks that a warning sign precedes the banner's text, in both appearances; it is drawn, since fonts may
/// lack it.
bool TestSurfaceWindow::hasSign() {
    const auto* sign = m_f->window().banner().findChild<QLabel*>(QStringLiteral("bannerSign"));
    std::array<QPixmap, 2> looks;
    m_f->window().actions().lightLook->trigger();
    looks[0] = sign->pixmap();
    m_f->window().actions().darkLook->trigger();
    looks[1] = sign->pixmap();
    m_f->window().actions().systemLook->trigger();
    return sign->text().isEmpty() && !looks[0].isNull() && looks[0].toImage() != looks[1].toImage();
}

void TestSurfaceWindow::badSurfacesAreShownAndRepaired() {
    QVERIFY(m_f->open());
    m_f->session().document().undoStack()->setClean();
    QFile good(m_f->folder().filePath(QStringLiteral("bar.obj")));
    QVERIFY(good.open(QIODevice::ReadOnly));
    QByteArray text = good.readAll();
    text.truncate(text.lastIndexOf("f "));  // one triangle less: a hole
    QFile bad(m_f->folder().filePath(QStringLiteral("open.obj")));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(text);
    bad.close();
    m_f->window().openPath(bad.fileName());
    const auto isOpen = [&] { return m_f->domain().path.ends_with("open.obj"); };
    QVERIFY(QTest::qWaitFor(isOpen, 20000));
    QVERIFY(settle(m_f->session()));  // in a cage, which is taken away now
    auto* panel = m_f->window().findChild<SurfacePanel*>();
    const auto press = [&](const QString& name) {  // once it can be pressed: the check may still go on
        const auto pressed = [&] {
            for (QPushButton* button : panel->findChildren<QPushButton*>())
                if (button->text() == name && button->isVisible() && button->isEnabled())
                    return QTest::mouseClick(button, Qt::LeftButton), true;
            return false;
        };
        QVERIFY2(QTest::qWaitFor(pressed, 20000), qPrintable(name));
    };
    QVERIFY(QTest::qWaitFor([&] { return !panel->isHidden(); }, 20000));
    QVERIFY(!panel->isVisible());  // the cage carries it: what is wrong is no business of the other steps
    QVERIFY(hasSign());
    for (QPushButton* button : m_f->window().banner().findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("See Why")) QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(panel->isVisible() && m_f->window().tools().mode() == Mode::Mesh);
    settleLayout(*panel);
    QVERIFY(m_f->canvas().solidLook().hasDetail());
    const double before = m_f->canvas().camera().pixelSize(m_f->canvas().size());
    press(QStringLiteral("Show them"));  // the hole is looked at from near
    m_f->picture(QStringLiteral("hole-in-cage"));
    const double near = m_f->canvas().camera().pixelSize(m_f->canvas().size());
    QVERIFY2(near < 0.8 * before, qPrintable(QString("%1 of %2").arg(near).arg(before)));
    press(QStringLiteral("Show them"));
    QVERIFY(m_f->canvas().camera().pixelSize(m_f->canvas().size()) > 1.2 * near);
    press(QStringLiteral("Exact surface only"));
    QCOMPARE(m_f->domain().fit, Fit::Exact);
    m_f->window().tools().setMode(Mode::Pins);  // where nothing can be done without a solid
    const auto offersCage = [&] {
        return std::ranges::any_of(panel->findChildren<QPushButton*>(), [](const QPushButton* button) {
            return button->isVisible() && button->text() == QStringLiteral("Fit a cage");
        });
    };
    QVERIFY(QTest::qWaitFor(offersCage, 20000));
    QVERIFY(m_f->window().banner().isVisible());
    QVERIFY(QTest::qWaitFor([&] { return m_f->canvas().isSettled(); }, 20000));
    m_f->picture(QStringLiteral("bad"));
    QVERIFY(saysThatThereIsNoSolid());
    QPushButton* repair = nullptr;
    for (QPushButton* button : panel->findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("Repair")) repair = button;
    QVERIFY(repair && repair->isEnabled());
    const QImage enabled = repair->grab().toImage();
    repair->setEnabled(false);
    QVERIFY(repair->grab().toImage() != enabled);  // is seen to do nothing
    repair->setEnabled(true);
    QVERIFY(edgesAreAsTheButtonSays());
    QVERIFY(axesAreSeen());
    QVERIFY(panel->findChildren<QLabel*>()[1]->text().contains(QStringLiteral("It would fill holes (1).")));
    QCOMPARE(greenPixels(), 0);
    press(QStringLiteral("See the repair"));
    m_f->picture(QStringLiteral("repair-seen"));
    QVERIFY(greenPixels() > 50);  // what would close the hole
    press(QStringLiteral("See the repair"));
    QCOMPARE(greenPixels(), 0);
    QTest::mousePress(&m_f->canvas(), Qt::RightButton, {}, QPoint(300, 300));
    QTest::mouseMove(&m_f->canvas(), QPoint(340, 280));
    QTest::mouseRelease(&m_f->canvas(), Qt::RightButton, {}, QPoint(340, 280));
    const Eigen::Matrix4d view = m_f->canvas().camera().view();
    const QString list = m_f->folder().filePath(QStringLiteral("wrong.txt"));
    nameNextFile(&m_f->window(), list);
    press(QStringLiteral("Save list…"));
    QFile saved(list);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("\nopen_edges 3\n"));
    QSpinBox* limit = panel->findChild<QSpinBox*>();
    limit->setValue(2);  // what it would do is told at once
    QVERIFY(QTest::qWaitFor([&] { return !repair->isEnabled(); }, 20000));
    QVERIFY(!panel->findChildren<QLabel*>()[1]->text().contains(QStringLiteral("It would")));
    auto* fillUp = panel->findChild<QPushButton*>(QStringLiteral("fillUp"));
    QVERIFY(fillUp && fillUp->isEnabled());
    QCOMPARE(fillUp->text(), QStringLiteral("One hole has 3 edges: fill up to 3"));
    QTest::mouseClick(fillUp, Qt::LeftButton);
    QCOMPARE(limit->value(), 3);
    QVERIFY(QTest::qWaitFor([&] { return repair->isEnabled() && !fillUp->isEnabled(); }, 20000));
    limit->setValue(7);
    QVERIFY(QTest::qWaitFor([&] { return repair->isEnabled(); }, 20000));
    QTest::mouseClick(repair, Qt::LeftButton);
    QVERIFY(m_f->domain().repair);
    QCOMPARE(m_f->domain().largestHole, 7);
    QVERIFY(settle(m_f->session()));
    QVERIFY(QTest::qWaitFor([&] { return !panel->isVisible(); }, 20000));
    QVERIFY(m_f->session().motion().frame<3>()->cells > 100);
    QVERIFY(!saysThatThereIsNoSolid());
    const QString told = m_f->window().banner().text().section('\n', 0, 0);
    QCOMPARE(told, QStringLiteral("The surface was repaired: 1 hole filled."));
    QVERIFY(m_f->canvas().camera().view() == view);
    QVERIFY(edgesAreAsTheButtonSays());
    m_f->window().actions().undo->trigger();
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible(); }, 20000));
    QVERIFY(saysThatThereIsNoSolid());
    QVERIFY(m_f->canvas().camera().view() == view);
    QVERIFY(edgesAreAsTheButtonSays());
    m_f->session().playback().setTime(0);  // nothing brings the repaired one back
    QVERIFY(saysThatThereIsNoSolid());
    QSignalSpy refusal(&m_f->window().exporter(), &Exporter::failed);
    m_f->window().exporter().write(ExportKind::Mesh, m_f->folder().filePath(QStringLiteral("none.vtu")));
    QVERIFY(refusal.count() == 1 && refusal[0][0].toString().contains(QStringLiteral("no shape")));
    m_f->window().actions().redo->trigger();
    QVERIFY(settle(m_f->session()));
    QVERIFY(!saysThatThereIsNoSolid());
    QVERIFY(m_f->canvas().camera().view() == view);
}

int TestSurfaceWindow::greenPixels() {
    const QImage seen = m_f->canvas().grabFramebuffer();
    int count = 0;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) {
            const QColor c = seen.pixelColor(x, y);
            count += c.green() > 1.5 * c.red() && c.green() > 1.3 * c.blue() ? 1 : 0;
        }
    return count;
}

/// Checks that the axes are in the lower left corner, over any content.
bool TestSurfaceWindow::axesAreSeen() {
    QImage over(m_f->canvas().size(), QImage::Format_ARGB32_Premultiplied);
    over.fill(Qt::transparent);
    QPainter painter(&over);
    m_f->canvas().overlay().paintMarks(painter);
    painter.end();
    return qAlpha(over.pixel(46, over.height() - 46)) > 0;
}

/// The edges are off, and the button shows them.
bool TestSurfaceWindow::edgesAreAsTheButtonSays() {
    QAction* button = m_f->window().actions().showMesh;
    const QImage before = m_f->canvas().grabFramebuffer();
    button->trigger();
    const QImage with = m_f->canvas().grabFramebuffer();
    button->trigger();
    return !button->isChecked() && with != before && m_f->canvas().grabFramebuffer() == before;
}

/// Checks that no control, hint or count refers to a solid.
bool TestSurfaceWindow::saysThatThereIsNoSolid() {
    auto* cut = m_f->window().findChild<CutPanel*>();
    for (const auto* box : cut->findChildren<QDoubleSpinBox*>())
        if (box->isVisible()) return false;
    if (cut->findChild<QComboBox*>()->isEnabled()) return false;
    for (const auto* label : m_f->window().statusBar()->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("Click"))) return false;
    for (const auto* label : m_f->window().findChild<MeshPanel*>()->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("tetrahedra"))) return false;
    return !m_f->session().motion().frame();
}

/// Opens a bar without its first and its last triangle, which leaves two holes, in a cage, in the step where
/// they are filled. A red plate on the bar is mostly outside, which the window reports.
void TestSurfaceWindow::openHoles() {
    QVERIFY(m_f->open());
    m_f->session().document().undoStack()->setClean();
    QFile good(m_f->folder().filePath(QStringLiteral("bar.obj")));
    QVERIFY(good.open(QIODevice::ReadOnly));
    QByteArray text = good.readAll();
    text.truncate(text.lastIndexOf("f "));
    const qsizetype first = text.indexOf("\nf ");
    text.remove(first, text.indexOf('\n', first + 1) - first);
    QFile bad(m_f->folder().filePath(QStringLiteral("holes.obj")));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(text);
    bad.close();
    m_f->window().openPath(bad.fileName());
    const auto domain = [&] { return m_f->domain(); };
    QVERIFY(QTest::qWaitFor([&] { return domain().path.ends_with("holes.obj"); }, 20000));
    QVERIFY(settle(m_f->session()));
    auto* panel = m_f->window().findChild<SurfacePanel*>();
    m_f->window().tools().setMode(Mode::Mesh);
    settleLayout(*panel);
    const QPushButton* fix = button(QStringLiteral("Fix this one"));
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible() && fix->isEnabled(); }, 20000));
}

QPushButton* TestSurfaceWindow::button(const QString& name) {
    for (auto* one : m_f->window().findChild<SurfacePanel*>()->findChildren<QPushButton*>())
        if (one->text() == name) return one;
    return nullptr;
}

bool TestSurfaceWindow::says(const QString& words) {
    return std::ranges::any_of(m_f->window().findChild<SurfacePanel*>()->findChildren<QLabel*>(),
                               [&](const QLabel* label) { return label->text().contains(words); });
}

/// The faults are fixed one after the other.
void TestSurfaceWindow::singleFaultsAreFixedOneByOne() {
    openHoles();
    const auto domain = [&] { return m_f->domain(); };
    auto* panel = m_f->window().findChild<SurfacePanel*>();
    QPushButton* fix = button(QStringLiteral("Fix this one"));
    QVERIFY(says(QStringLiteral("It would add triangles (1). It would leave 1 of 2 faults.")));
    QTest::mouseClick(button(QStringLiteral("Show them")), Qt::LeftButton);
    m_f->picture(QStringLiteral("fix-seen"));
    QVERIFY(QTest::qWaitFor([&] { return greenPixels() > 50; }, 20000));  // what would close this hole
    QTest::mouseClick(fix, Qt::LeftButton);
    QCOMPARE(domain().fixes.size(), std::size_t(1));
    QVERIFY(!domain().repair && !fix->isEnabled());
    QVERIFY(settle(m_f->session()));
    const QString last = QStringLiteral("It would add triangles (1). It would leave 0 of 1 faults.");
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible() && says(last); }, 20000));
    m_f->picture(QStringLiteral("fix-next"));
    QVERIFY(QTest::qWaitFor([&] { return greenPixels() > 50; }, 20000));  // the next one is looked at
    QVERIFY(button(QStringLiteral("Show them"))->isChecked());
    QTest::mouseClick(fix, Qt::LeftButton);
    QCOMPARE(domain().fixes.size(), std::size_t(2));
    QVERIFY(settle(m_f->session()));
    QVERIFY(QTest::qWaitFor([&] { return !panel->isVisible(); }, 20000));
    QVERIFY(QTest::qWaitFor(
        [&] {
            return m_f->session().motion().frame<3>() && !m_f->session().motion().frame<3>()->built->cage;
        },
        20000));
    const QString told = m_f->window().banner().text().section('\n', 0, 0);
    QCOMPARE(told, QStringLiteral("The surface was repaired: 2 single steps."));
    m_f->window().actions().undo->trigger();
    QCOMPARE(domain().fixes.size(), std::size_t(1));
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible() && says(last); }, 20000));
    m_f->window().actions().undo->trigger();
    QCOMPARE(domain().fixes.size(), std::size_t(0));
    QVERIFY(settle(m_f->session()));
    // Both are fixed at once, as announced, in one step.
    QPushButton* all = button(QStringLiteral("Fix all"));
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible() && fix->isEnabled(); }, 20000));
    QVERIFY(all->isEnabled());
    if (!button(QStringLiteral("Show them"))->isChecked())
        QTest::mouseClick(button(QStringLiteral("Show them")), Qt::LeftButton);
    const QString both = QStringLiteral("It would add triangles (2). It would leave 0 of 2 faults.");
    QVERIFY(QTest::qWaitFor([&] { return all->toolTip().contains(both); }, 20000));
    // Both are highlighted in the view while the pointer is on the button.
    m_f->actions().front->trigger();
    const QImage one = m_f->canvas().grabFramebuffer();
    QEnterEvent enter(all->rect().center(), all->rect().center(), all->mapToGlobal(all->rect().center()));
    QCoreApplication::sendEvent(all, &enter);
    const QImage seen = m_f->canvas().grabFramebuffer();
    m_f->picture(QStringLiteral("all-fixes-seen"));
    QVERIFY(seen != one);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(all, &leave);
    QVERIFY(m_f->canvas().grabFramebuffer() == one);
    QTest::mouseClick(all, Qt::LeftButton);
    QCOMPARE(domain().fixes.size(), std::size_t(2));
    QVERIFY(settle(m_f->session()));
    QVERIFY(QTest::qWaitFor([&] { return !panel->isVisible(); }, 20000));
    m_f->window().actions().undo->trigger();
    QCOMPARE(domain().fixes.size(), std::size_t(0));
    m_f->window().actions().redo->trigger();
    QCOMPARE(domain().fixes.size(), std::size_t(2));
    QVERIFY(settle(m_f->session()));
}

/// A fault is shown in place of the solid; choosing a tool returns to the solid. In a window without room for
/// panels beside the view, the panel with the reason opens over it.
void TestSurfaceWindow::reasonIsSeenInANarrowWindow() {
    openHoles();
    m_f->window().tools().setMode(Mode::Pins);
    m_f->window().resize(1024, 640);
    auto* panel = m_f->window().findChild<SurfacePanel*>();
    QTRY_VERIFY(m_f->window().width() <= 1024 && !panel->isVisible());
    QVERIFY(!m_f->window().findChild<DistortionPanel*>()->isVisible());
    for (QPushButton* button : m_f->window().banner().findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("See Why")) QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(panel->isVisible() && m_f->window().tools().mode() == Mode::Mesh);
    QTRY_VERIFY(!button(QStringLiteral("Fix this one"))->visibleRegion().isEmpty());
}

void TestSurfaceWindow::deskLeavesTheSolidToTools() {
    openHoles();
    const QString verdict = QStringLiteral("“Repair” does not help: the cage carries the surface as it is.");
    m_f->window().findChild<SurfacePanel*>()->findChild<QSpinBox*>()->setValue(2);
    QVERIFY(QTest::qWaitFor([&] { return says(verdict); }, 20000));
    QPushButton* shows = button(QStringLiteral("Show them"));
    shows->setFocus();
    const QImage off = shows->grab().toImage();
    QTest::mouseClick(shows, Qt::LeftButton);
    QVERIFY(shows->isChecked() && shows->grab().toImage() != off);  // its state is seen
    m_f->picture(QStringLiteral("desk-shows"));
    const QPointF middle(m_f->canvas().rect().center());
    m_f->actions().front->trigger();
    m_f->window().actions().fit->trigger();
    QVERIFY(!m_f->canvas().touch(middle));
    const Eigen::Matrix4d view = m_f->canvas().camera().view();
    m_f->window().tools().setMode(Mode::Pins);
    m_f->window().actions().pinTool->trigger();
    QVERIFY(m_f->canvas().touch(middle));
    QVERIFY(!shows->isChecked() && m_f->canvas().camera().view() == view);
    m_f->click(middle.toPoint());
    QCOMPARE(m_f->handles().size(), std::size_t(1));
    // The same holds within the step.
    m_f->window().tools().setMode(Mode::Mesh);
    QTest::mouseClick(shows, Qt::LeftButton);
    QVERIFY(shows->isChecked());
    m_f->tool("measure")->trigger();
    QVERIFY(!shows->isChecked() && m_f->canvas().touch(middle));
}

/// Faults that are not known yet are searched for on request, with a message; then the whole solid is shown.
void TestSurfaceWindow::allAreFixedOnceThatIsKnown() {
    openHoles();
    QTest::mouseClick(button(QStringLiteral("Show them")), Qt::LeftButton);
    QTest::mouseClick(button(QStringLiteral("Show them")), Qt::LeftButton);
    QSpinBox* limit = m_f->window().findChild<SurfacePanel*>()->findChild<QSpinBox*>();
    limit->setValue(limit->value() + 1);  // what was known is no more
    QPushButton* all = button(QStringLiteral("Fix all"));
    QPushButton* one = button(QStringLiteral("Fix this one"));
    const int place = one->y();
    const double whole = m_f->canvas().camera().pixelSize(m_f->canvas().size());
    m_f->canvas().camera().zoom(4, {100, 100}, m_f->canvas().size());
    all->setFocus();
    QVERIFY(all->hasFocus());
    QTest::keyClick(all, Qt::Key_Space);
    QVERIFY(says(QStringLiteral("Looking for what fixes all of these")));
    QVERIFY(!all->isEnabled() && !one->isEnabled());
    const QWidget* focused = m_f->window().focusWidget();  // not the button that takes the cage away
    QVERIFY(focused != nullptr);
    QCOMPARE(focused->accessibleName(), QStringLiteral("Next place"));
    settleLayout(*one);
    QCOMPARE(one->y(), place);  // more or fewer words move nothing
    const auto fixes = [&] { return m_f->domain().fixes.size(); };
    QVERIFY(QTest::qWaitFor([&] { return fixes() == 2; }, 20000));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().motion().frame<3>() && !m_f->session().motion().frame<3>()->built->cage);
    const double seen = m_f->canvas().camera().pixelSize(m_f->canvas().size());
    QVERIFY2(std::abs(seen / whole - 1) < 0.2, qPrintable(QString("%1 of %2").arg(seen).arg(whole)));
}

/// The note is complete from its first appearance.
void TestSurfaceWindow::noteOfWorkIsWhole() {
    QVERIFY(m_f->open());
    auto* note = m_f->window().findChild<WorkNote*>();
    Document& document = m_f->session().document();
    Domain fine = document.domain();
    fine.vertices = 60000;
    document.changeDomain(QStringLiteral("Fine"), fine);
    QVERIFY(QTest::qWaitFor([&] { return note->isVisible(); }, 20000));
    for (const QLabel* label : note->findChildren<QLabel*>())
        QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
    // A longer text has its width at once.
    const auto* words = note->findChild<QLabel*>();
    const int around = note->width() - words->minimumWidth();
    fine.vertices = 1000000;
    document.changeDomain(QStringLiteral("Finer"), fine);
    QVERIFY(words->text().contains(QStringLiteral("1,000,000")));
    QCOMPARE(note->width(), words->minimumWidth() + around);
    m_f->session().motion().cancelWork();
    QVERIFY(settle(m_f->session()));
}

/// The earlier mesh is reused for another energy, but not for another number of vertices.
void TestSurfaceWindow::noteTellsMeshesFromMotions() {
    QVERIFY(m_f->open());
    QVERIFY(settle(m_f->session()));
    auto* note = m_f->window().findChild<WorkNote*>();
    Document& document = m_f->session().document();
    Design design = document.design();
    design.material.phi += 0.2;
    note->show();
    document.changeDesign(QStringLiteral("Energy"), design);
    QVERIFY(m_f->session().motion().isBusy());
    QVERIFY2(note->text().startsWith(QStringLiteral("Computing the motion")), qPrintable(note->text()));
    QVERIFY(settle(m_f->session()));
    Domain fine = document.domain();
    fine.vertices += 100;
    note->show();
    document.changeDomain(QStringLiteral("Fine"), fine);
    QVERIFY2(note->text().startsWith(QStringLiteral("Meshing")), qPrintable(note->text()));
    QVERIFY(settle(m_f->session()));
}

/// A fork of known size is in a cage that closes its slot; its facts and its worst cell are shown.
void TestSurfaceWindow::factsAreReportedAndGapsAreOpened() {
    QVERIFY(m_f->open());
    auto* panel = m_f->window().findChild<FactsPanel*>();
    const auto text = [&](const char* name) {
        QString plain = panel->findChild<QLabel*>(QLatin1String(name))->text();
        return plain.replace(QRegularExpression("<[^>]*>|&nbsp;"), " ").simplified();
    };
    const auto button = [&](const char* name) {
        for (QPushButton* one : panel->findChildren<QPushButton*>())
            if (one->text() == QLatin1String(name)) return one;
        return static_cast<QPushButton*>(nullptr);
    };
    m_f->window().tools().setMode(Mode::Mesh);
    m_f->window().findChild<FoldingSection*>(QStringLiteral("facts"))->setOpen(true);
    QVERIFY(QTest::qWaitFor([&] { return text("factsOfFile").contains("size 4 × 1 × 1 area 18"); }, 20000));
    m_f->session().document().undoStack()->setClean();
    const Surface fork = test::fork(0.1);
    QFile file(m_f->folder().filePath(QStringLiteral("fork.off")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QTextStream out(&file);
    out << "OFF\n# unit: cm\n" << fork.points.cols() << ' ' << fork.triangles.size() << " 0\n";
    for (const auto& p : fork.points.colwise()) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& [a, b, c] : fork.triangles) out << "3 " << a << ' ' << b << ' ' << c << '\n';
    out.flush();
    file.close();
    m_f->window().openPath(file.fileName());
    ShapeSession& session = m_f->session();
    Document& document = session.document();
    QVERIFY(QTest::qWaitFor([&] { return document.domain().path.ends_with("fork.off"); }, 20000));
    Domain caged = document.domain();
    caged.fit = Fit::Cage;
    caged.vertices = 1000;
    document.changeDomain(QStringLiteral("Caged"), caged);
    QVERIFY(settle(session));
    m_f->window().tools().setMode(Mode::Mesh);
    QVERIFY(QTest::qWaitFor([&] { return text("factsOfFile").contains(" cm "); }, 20000));
    // 0.5 × 1 × 1 without a slot of 0.1 × 0.8 × 1; the slot's sides add 1.6.
    QCOMPARE(text("factsOfFile"),
             QStringLiteral(
                 "Surface of the file size 0.5 × 1 × 1 cm area 5.44 cm² volume 0.42 cm³ triangles 28 edges "
                 "0.1 to 1.414 cm mean edge 0.7689 cm parts 1 boundary loops 0 genus 0 crossing pairs 0"));
    QCOMPARE(text("factsOfCage"), QStringLiteral("Cage closed gaps 1 narrowest 0.1"));
    QVERIFY(text("factsOfCells").startsWith(QStringLiteral("Tetrahedra worst ratio 0.")));
    QSignalSpy wanted(panel, &FactsPanel::cellWanted);
    const SavedCamera before = m_f->canvas().camera().saved();
    QTest::mouseClick(button("Next gap"), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    const auto frame = session.motion().frame<3>();
    const Cell<3> cell = frame->rest->cells[wanted[0][0].toInt()];
    Vec3 centre = Vec3::Zero();
    for (const int v : cell) centre += frame->rest->points.col(v) / 4;
    QVERIFY((centre - frame->built->cage->gaps[0].place).norm() < frame->built->cage->edge);
    QVERIFY(m_f->canvas().camera().saved() != before);
    m_f->picture(QStringLiteral("gap-seen"));
    QTest::mouseClick(button("Worst cell"), Qt::LeftButton);
    QCOMPARE(wanted[1][0].toInt(), frame->built->verdict->worstCell);
    QTest::mouseClick(button("Open the widest"), Qt::LeftButton);
    QCOMPARE(document.domain().vertices, frame->built->cage->opener.vertices);
    QVERIFY(document.domain().vertices > 1000);
    QVERIFY(settle(session));
    QVERIFY(session.motion().frame<3>()->built->cage &&
            session.motion().frame<3>()->built->cage->gaps.empty());
    QVERIFY(QTest::qWaitFor([&] { return !button("Next gap")->isVisible(); }, 20000));
}

/// Pins are placed on the visible surface, not at a hidden corner of the cage, also when they snap.
void TestSurfaceWindow::pinsAreSetOnCagedSurfaces() {
    QFile whole(m_f->writeBar()), open(m_f->folder().filePath(QStringLiteral("open.obj")));
    QVERIFY(whole.open(QIODevice::ReadOnly) && open.open(QIODevice::WriteOnly));
    const QByteArray text = whole.readAll().trimmed();
    open.write(text.left(text.lastIndexOf("\nf ") + 1));  // without its last triangle
    open.close();
    m_f->window().openPath(open.fileName());
    QVERIFY(QTest::qWaitFor([&] { return !m_f->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->session().motion().frame<3>()->built->cage);
    m_f->actions().front->trigger();
    QAction* snap = nullptr;
    for (QAction* action : m_f->window().findChild<QToolBar*>(QStringLiteral("optionRow"))->actions())
        if (action->text() == QStringLiteral("S&nap")) snap = action;
    QVERIFY(snap);
    for (const bool snaps : {true, false}) {
        snap->setChecked(snaps);
        const Vec3 at(snaps ? 0.7 : -0.9, -0.5, 0.1);
        QTest::mouseClick(&m_f->canvas(), Qt::LeftButton, {}, m_f->at(at));
        const auto pins = m_f->session().gestures().pins();
        QCOMPARE(pins.size(), snaps ? 1U : 2U);
        const double pixel = m_f->canvas().pixelSize(at);
        QVERIFY(std::abs(pins.back().centre.y() + 0.5) < 1e-6);
        QVERIFY((pins.back().centre - at).norm() < 1.5 * pixel);
    }
}

void TestSurfaceWindow::detailedSurfaceIsShownAndTellsItsNotices() {
    m_f->writeBar();
    const auto write = [&](const char* name, const QByteArray& text) {
        QFile file(m_f->folder().filePath(QString::fromLatin1(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("plate.mtl", "newmtl red\nKd 1 0 0\n"));
    QVERIFY(write("plate.obj",
                  "mtllib plate.mtl\nusemtl red\nv -1 -0.4 0.6\nv 1 -0.4 0.6\nv 1 0.4 0.6\nv -1 0.4 0.6\n"
                  "f 1 2 3 4\n"));
    QVERIFY(write("bar.wend",
                  R"({"format": "wend", "version": 1, "domain": {"surface": "bar.obj", "vertices": 300,
                  "detail": "plate.obj"}, "handles": [{"name": "all", "at": {"region": {"box": {"min":
                  [-3, -1, -1], "max": [3, 1, 1]}}}, "motion": [{"kind": "translate", "by": [0, 5, 0], "time":
                  [0, 1]}]}], "time": {"end": 1}})"));
    m_f->window().openPath(m_f->folder().filePath(QStringLiteral("bar.wend")));
    QVERIFY(QTest::qWaitFor([&] { return !m_f->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_f->session()));
    QVERIFY(m_f->window().banner().isVisible() &&
            m_f->window().banner().text().contains(QStringLiteral("outside")));
    QAction* detail = m_f->actions().detail;
    QVERIFY(detail->isEnabled() && detail->isChecked());
    const auto isRed = [&] {
        const QColor c = m_f->canvas().grabFramebuffer().pixelColor(m_f->at({0, 5, 0.6}));
        return c.red() > 90 && c.green() < 60;
    };
    // The view is framed on the solid as it is shown: at the end of its motion.
    QVERIFY((m_f->canvas().camera().pivot() - Vec3(0, 5, 0)).norm() < 0.2);
    m_f->actions().top->trigger();
    QVERIFY(isRed());
    QCOMPARE(m_f->canvas().solid().triangles(), 2);
    detail->trigger();
    QVERIFY(!isRed());
    QVERIFY(m_f->canvas().solid().triangles() > 100);
    detail->trigger();
    m_f->window().actions().showMap->setChecked(true);  // the colours of the map lie on it
    QVERIFY(!isRed());
    m_f->window().actions().showMap->setChecked(false);
    m_f->actions().cut->trigger();  // the section is the solid's
    m_f->canvas().grabFramebuffer();
    QVERIFY(m_f->canvas().solid().triangles() > 2);
    m_f->window().actions().closeFile->trigger();
    QVERIFY(m_f->session().document().isEmpty() && !m_f->window().banner().isVisible());
}

QTEST_MAIN(TestSurfaceWindow)
#include "test_surface_window.moc"
