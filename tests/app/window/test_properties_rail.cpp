#include <QApplication>
#include <QToolButton>
#include <QTreeWidget>

#include "app/panels/material_panel.h"
#include "app/panels/pin_list.h"
#include "app/window/properties.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The properties in a narrow window, in a very wide one, and when they are hidden.
class TestPropertiesRail : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void narrowWindowsHaveARail_data() { pictureAndSolid(); }
    void narrowWindowsHaveARail();
    void railIsClosedByClicksElsewhere_data() { pictureAndSolid(); }
    void railIsClosedByClicksElsewhere();
    void propertiesAreHiddenForGood();
    void railHasTheSectionsOfTheStep_data() { pictureAndSolid(); }
    void railHasTheSectionsOfTheStep();
    void pinsStandBesideInAWideWindow();

  private:
    static void pictureAndSolid();
    bool open(bool solid) { return solid ? m_f->open() : m_f->openPicture(); }
    Toolbox& tools() { return m_f->window().tools(); }
    bool isInView(const QWidget& widget);
    PropertiesRail& rail() { return *m_f->window().findChild<PropertiesRail*>(); }
    QToolButton& railButton(const char* name) {
        for (auto* one : rail().findChildren<QToolButton*>())
            if (one->accessibleName() == QLatin1String(name)) return *one;
        throw std::logic_error(name);
    }

    std::unique_ptr<SolidFixture> m_f;
};

void TestPropertiesRail::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestPropertiesRail::pictureAndSolid() {
    QTest::addColumn<bool>("solid");
    QTest::newRow("picture") << false;
    QTest::newRow("solid") << true;
}

bool TestPropertiesRail::isInView(const QWidget& widget) {
    const QRect window(m_f->window().mapToGlobal(QPoint()), m_f->window().size());
    return !widget.visibleRegion().isEmpty() && widget.visibleRegion().boundingRect() == widget.rect() &&
           window.contains(QRect(widget.mapToGlobal(QPoint()), widget.size()));
}

/// The rail is 44 pixels wide, with a button for Keep first; a click opens the properties beside it, over the
/// view.
void TestPropertiesRail::narrowWindowsHaveARail() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    m_f->window().resize(1024, 640);
    settleLayout(m_f->window());
    Properties& side = m_f->window().properties();
    QVERIFY(!side.isVisible());
    QCOMPARE(rail().width(), 44);
    QCOMPARE(rail().geometry().right(), rail().parentWidget()->rect().right());
    const int canvas = m_f->view().width();
    QVERIFY(canvas > 900);
    QToolButton& keep = railButton("Keep");
    QVERIFY(isInView(keep));
    QTest::mouseClick(&keep, Qt::LeftButton);
    settleLayout(side);
    QVERIFY(side.isVisible() && keep.isChecked());
    QVERIFY(isInView(*side.findChild<MaterialPanel*>()));
    QCOMPARE(side.geometry().right() + 1, rail().geometry().left());
    QCOMPARE(m_f->view().width(), canvas);  // it lies over the view
    QTest::mouseClick(&railButton("Pins"), Qt::LeftButton);
    QVERIFY(side.isVisible() && !keep.isChecked() && railButton("Pins").isChecked());
    QTest::mouseClick(&railButton("Pins"), Qt::LeftButton);
    QVERIFY(!side.isVisible());
    QTest::keyClick(&m_f->view(), Qt::Key_F4);
    QVERIFY(side.isVisible() && m_f->window().actions().showProperties->isChecked());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!side.isVisible() && !m_f->window().actions().showProperties->isChecked());
    QVERIFY(m_f->view().hasFocus());
    m_f->window().resize(1366, 768);
    settleLayout(m_f->window());
    QVERIFY(side.isVisible() && !keep.isVisible());
    QCOMPARE(side.geometry(), rail().geometry());
}

/// A click on the view closes the properties and sets no pin; one on a bar has its usual effect.
void TestPropertiesRail::railIsClosedByClicksElsewhere() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    m_f->window().resize(1024, 640);
    settleLayout(m_f->window());
    tools().setMode(Mode::Pins);
    QWidget& view = m_f->view();
    const QPoint on = solid ? m_f->at({-1, -0.5, 0}) : m_f->window().canvas().toWidget({40, 80}).toPoint();
    const auto project = m_f->session().document().project();
    const auto pins = [&] { return m_f->session().gestures().pins().size(); };
    QTest::mouseClick(&railButton("Pins"), Qt::LeftButton);
    QTest::mouseMove(&view, on);
    QTest::mouseClick(&view, Qt::LeftButton, {}, on);
    QVERIFY(!rail().isOpen());
    QCOMPARE(m_f->session().document().project(), project);
    QTest::mouseClick(&view, Qt::LeftButton, {}, on);  // and the next one does
    QTRY_COMPARE(pins(), std::size_t(1));
    QVERIFY(settle(m_f->session()));
    // The release below, which would select a pin, is not delivered either.
    m_f->session().selection().clear();
    QTest::mouseClick(&railButton("Pins"), Qt::LeftButton);
    QTest::mouseClick(&view, Qt::LeftButton, {}, on);
    QVERIFY(!rail().isOpen());
    QVERIFY(m_f->session().selection().isEmpty());
    QTest::mouseClick(&view, Qt::LeftButton, {}, on);
    QVERIFY(!m_f->session().selection().isEmpty());
    QTest::mouseClick(&railButton("Pins"), Qt::LeftButton);
    for (QToolButton* step : m_f->window().findChildren<QToolButton*>())
        if (step->defaultAction() == tools().modeAction(Mode::Mesh)) QTest::mouseClick(step, Qt::LeftButton);
    QVERIFY(!rail().isOpen());
    QCOMPARE(tools().mode(), Mode::Mesh);
}

/// F4 hides the properties in a window that has the room; the next window remembers it.
void TestPropertiesRail::propertiesAreHiddenForGood() {
    QVERIFY(open(false));
    m_f->window().resize(1366, 768);
    Properties& side = m_f->window().properties();
    QAction* shown = m_f->window().actions().showProperties;
    QVERIFY(side.isVisible() && shown->isChecked());
    QTest::keyClick(&m_f->view(), Qt::Key_F4);
    settleLayout(m_f->window());
    QVERIFY(!side.isVisible() && !shown->isChecked() && rail().isCollapsed());
    QTest::mouseClick(&railButton("Keep"), Qt::LeftButton);
    QVERIFY(side.isVisible());
    MainWindow next;
    QVERIFY(next.findChild<PropertiesRail*>()->isCollapsed());
    QTest::keyClick(&m_f->view(), Qt::Key_Escape);
    QTest::keyClick(&m_f->view(), Qt::Key_F4);
    QVERIFY(side.isVisible() && shown->isChecked() && !rail().isCollapsed());
}

/// Each section that is not empty has its button, with the same accessible name. Sections without content,
/// such as the surface faults of a sound solid, have none.
void TestPropertiesRail::railHasTheSectionsOfTheStep() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    m_f->window().resize(1024, 640);
    const auto names = [&] {
        settleLayout(m_f->window());
        QStringList all;
        for (const QToolButton* button : rail().findChildren<QToolButton*>())
            if (button->isVisible()) all << button->accessibleName();
        all.sort();
        return all;
    };
    tools().setMode(Mode::Pins);
    QCOMPARE(names(), QStringList({"Advanced", "Keep", "Pins", "Selection", "What changed"}));
    tools().setMode(Mode::Paint);
    QCOMPARE(names(), QStringList({"Advanced", "Keep", "Layers", "Paint", "What changed"}));
    tools().setMode(Mode::Export);
    QCOMPARE(names(), QStringList({"Export"}));
}

/// The pins are beside the view in every step, so that its size stays.
void TestPropertiesRail::pinsStandBesideInAWideWindow() {
    QVERIFY(open(false));
    m_f->window().resize(3840, 1000);
    Properties& side = m_f->window().properties();
    auto& pins = *side.findChild<PinList*>();
    for (const Mode mode : kModes) {
        tools().setMode(mode);
        settleLayout(m_f->window());
        QCOMPARE(side.width(), 640);
        QVERIFY(isInView(pins));
        QCOMPARE(pins.mapTo(&side, QPoint()).x(), 1);
        QVERIFY(pins.height() > 700 && pins.list()->height() > 600);
    }
    m_f->window().resize(1600, 1000);
    settleLayout(m_f->window());
    QCOMPARE(side.width(), 304);
    QVERIFY(!pins.isVisible());  // while what is written is chosen
    tools().setMode(Mode::Pins);
    settleLayout(side);
    QVERIFY(isInView(pins) && pins.height() < 200);
    const auto* selection = side.findChild<QWidget*>(QStringLiteral("selectionArea"));
    QVERIFY(pins.mapTo(&side, QPoint()).y() < selection->mapTo(&side, QPoint()).y());
}

QTEST_MAIN(TestPropertiesRail)
#include "test_properties_rail.moc"
