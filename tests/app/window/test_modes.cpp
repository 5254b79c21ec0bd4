#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextTable>
#include <QToolBar>
#include <QToolButton>

#include "app/panels/cut_out_panel.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/measure_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/paint_panel.h"
#include "app/panels/pin_list.h"
#include "app/panels/region_list.h"
#include "app/session/pins/pin_shapes.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"
#include "app/window/help/help.h"
#include "app/window/help/shortcuts.h"
#include "app/window/properties.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"
#include "tests/support/whole_texts.h"

using namespace wend;
using namespace wend::test;

/// The tools and panels of each step of the work, in a window with a picture or a solid.
class TestModes : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void stepsHaveTheirToolsAndPanels_data();
    void stepsHaveTheirToolsAndPanels();
    void toolsBringTheirPanelIntoView();
    void stepsRememberTheirTool_data();
    void stepsRememberTheirTool();
    void toolsBringTheirStep();
    void keysAreUnique_data();
    void keysAreUnique();
    void everyToolIsInTheMenus();
    void selectingMovesNothing_data();
    void selectingMovesNothing();
    void numbersOfTheOutlineAreOfPictures_data();
    void numbersOfTheOutlineAreOfPictures();
    void nothingIsBelowTheFold_data();
    void nothingIsBelowTheFold();
    void narrowWindowsKeepStepsAndExport();
    void cheatSheetHasEveryKey_data();
    void cheatSheetHasEveryKey();
    void manualIsWithinTheProgram();
    void manualShowsItsPictures();
    void manualHasAStyle();
    void manualIsSearchedOnAllPages();
    void backslashShowsTheShapeBefore_data();
    void backslashShowsTheShapeBefore();
    void everythingHasAName_data();
    void everythingHasAName();

  private:
    static void pictureAndSolid();
    bool open(bool solid) { return solid ? m_f->open() : m_f->openPicture(); }
    Toolbox& tools() { return m_f->window().tools(); }
    QToolBar& bar() { return *m_f->window().findChild<QToolBar*>(QStringLiteral("toolBar")); }
    QAction* tool(const char* id) { return tools().action(QString::fromLatin1(id)); }
    template <class Panel>
    bool shows() {
        return m_f->window().properties().findChild<Panel*>()->isVisible();
    }
    bool isInView(const QWidget& widget);

    std::unique_ptr<SolidFixture> m_f;
};

void TestModes::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestModes::pictureAndSolid() {
    QTest::addColumn<bool>("solid");
    QTest::newRow("picture") << false;
    QTest::newRow("solid") << true;
}

bool TestModes::isInView(const QWidget& widget) {
    const QRect window(m_f->window().mapToGlobal(QPoint()), m_f->window().size());
    return !widget.visibleRegion().isEmpty() && widget.visibleRegion().boundingRect() == widget.rect() &&
           window.contains(QRect(widget.mapToGlobal(QPoint()), widget.size()));
}

void TestModes::stepsHaveTheirToolsAndPanels_data() {
    pictureAndSolid();
}

/// The keys and the row of steps agree. The Keep panel is there wherever the shape is changed.
void TestModes::stepsHaveTheirToolsAndPanels() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    QCOMPARE(tools().mode(), Mode::Pins);  // where work begins
    QScrollBar& scroll = *m_f->window()
                              .properties()
                              .findChild<QScrollArea*>(QString(), Qt::FindDirectChildrenOnly)
                              ->verticalScrollBar();
    for (const Mode mode : kModes) {
        scroll.setValue(scroll.maximum());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key(Qt::Key_1 + static_cast<int>(mode)),
                        Qt::ControlModifier);
        QCOMPARE(tools().mode(), mode);
        QVERIFY(tools().modeAction(mode)->isChecked());
        settleLayout(m_f->window().properties());
        QCOMPARE(scroll.value(), 0);  // a step is seen from its top
        QVERIFY(!bar().actions().isEmpty());
        QCOMPARE(bar().actions(), tools().toolsOf(mode));
        for (QAction* one : bar().actions())
            QVERIFY2(one->isVisible() && one->isEnabled(), one->objectName().toUtf8());
        QVERIFY(bar().actions().contains(tool(tools().current()->id)));
        QCOMPARE(shows<MaterialPanel>(), mode != Mode::Export);
        QCOMPARE(shows<MeshPanel>(), mode == Mode::Mesh);
        QCOMPARE(shows<PinList>(), mode == Mode::Pins);
        QCOMPARE(shows<ExportPanel>(), mode == Mode::Export);
        QCOMPARE(shows<DistortionPanel>(), mode != Mode::Export);
        QCOMPARE(shows<PaintPanel>(), mode == Mode::Paint);
        QCOMPARE(shows<CutPanel>(), solid && mode == Mode::Mesh);
    }
    if (!solid) return;
    tools().setMode(Mode::Pins);  // what is cut open has its numbers in every step
    m_f->actions().cut->trigger();
    QVERIFY(shows<CutPanel>());
}

/// In a low window a tool scrolls to its panel, but not when the step changes, which starts at its top.
void TestModes::toolsBringTheirPanelIntoView() {
    QVERIFY(open(true));
    m_f->window().resize(1200, 640);
    tools().setMode(Mode::Mesh);
    settleLayout(m_f->window().properties());
    const auto comes = [this](const char* id, const QWidget& panel) {
        QVERIFY2(!panel.isVisible(), id);
        tool(id)->trigger();
        QVERIFY2(QTest::qWaitFor([&] { return isInView(panel); }, 20000), id);
    };
    comes("measure", *m_f->window().findChild<MeasurePanel*>());
    comes("sizes", m_f->window().properties().detailRegions());
    tools().setMode(Mode::Pins);
    tools().setMode(Mode::Mesh);  // with its brush
    settleLayout(m_f->window().properties());
    const auto* scroll = m_f->window().findChild<QScrollArea*>(QStringLiteral("sideScroll"));
    QVERIFY(tools().isChosen("sizes") && scroll->verticalScrollBar()->value() == 0);
}

void TestModes::stepsRememberTheirTool_data() {
    pictureAndSolid();
}

void TestModes::stepsRememberTheirTool() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    QVERIFY(tools().isChosen("pin"));
    tool("lasso")->trigger();
    tools().setMode(Mode::Mesh);
    QVERIFY(tools().isChosen("select"));
    tools().setMode(Mode::Pins);
    QVERIFY(tools().isChosen("lasso"));
    tools().setMode(Mode::Paint);
    QVERIFY(tools().isChosen("paint"));
    m_f->session().document().undoStack()->setClean();
    m_f->window().actions().closeFile->trigger();
    QVERIFY(open(solid));  // another document is seen as it is
    QVERIFY(tools().isChosen("pin") && tools().mode() == Mode::Pins);
}

/// A tool brings its step, from whichever step it is chosen.
void TestModes::toolsBringTheirStep() {
    QVERIFY(open(true));
    tools().setMode(Mode::Export);
    QTest::keyClick(&m_f->canvas(), Qt::Key_P);
    QVERIFY(tools().isChosen("pin") && tools().mode() == Mode::Pins);
    QTest::keyClick(&m_f->canvas(), Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(tools().isChosen("sizes") && tools().mode() == Mode::Mesh);
    QTest::keyClick(&m_f->canvas(), Qt::Key_B);
    QVERIFY(tools().isChosen("paint") && tools().mode() == Mode::Paint);
    QTest::keyClick(&m_f->canvas(), Qt::Key_V);
    QVERIFY(tools().isChosen("select") && tools().mode() == Mode::Paint);
}

void TestModes::keysAreUnique_data() {
    pictureAndSolid();
}

/// Keys are unique in every step, and every tool of a step has one.
void TestModes::keysAreUnique() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    for (const Mode mode : kModes) {
        tools().setMode(mode);
        QMap<QKeySequence, QAction*> owners;
        for (QAction* action : m_f->window().findChildren<QAction*>()) {
            if (!action->isVisible()) continue;
            for (const QKeySequence& key : action->shortcuts()) {
                QVERIFY2(!owners.contains(key),
                         qPrintable(key.toString() + action->text() + owners.value(key, action)->text()));
                owners[key] = action;
            }
        }
        for (QAction* action : tools().toolsOf(mode))
            QVERIFY2(!action->shortcuts().isEmpty(), qPrintable(action->text()));
    }
}

void TestModes::everyToolIsInTheMenus() {
    QVERIFY(open(true));
    QSet<const QAction*> offered;
    for (const QAction* menu : m_f->window().menuBar()->actions())
        for (const QAction* action : menu->menu()->actions()) offered << action;
    for (const ToolKind& kind : toolTable()) {
        const QAction* action = tool(kind.id);
        QVERIFY2(action && offered.contains(action), kind.id);
        QVERIFY2(!ActionMaker::helpOf(*action).isEmpty() && !action->icon().isNull(), kind.id);
    }
}

void TestModes::selectingMovesNothing_data() {
    pictureAndSolid();
}

void TestModes::selectingMovesNothing() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    if (solid)
        QVERIFY(m_f->holdEnds());
    else
        m_f->session().addPin({120, 80, 0});
    tools().setMode(Mode::Pins);
    QVERIFY(settle(m_f->session()));
    Selection& selection = m_f->session().selection();
    selection.set({0});
    Properties& side = m_f->window().properties();
    const auto places = [&] {
        settleLayout(side);
        QList<QRect> all;
        for (const QWidget* panel :
             std::initializer_list<QWidget*>{side.findChild<MaterialPanel*>(), side.findChild<PinList*>(),
                                             side.findChild<QWidget*>(QStringLiteral("selectionArea")),
                                             side.findChild<DistortionPanel*>()})
            all << QRect(panel->mapTo(&side, QPoint()), panel->size());
        return all;
    };
    const auto asksForAPin = [&] {
        for (const QLabel* label : side.findChildren<QLabel*>())
            if (label->isVisible() && label->text().startsWith(QStringLiteral("Select a pin"))) return true;
        return false;
    };
    const QList<QRect> before = places();
    QVERIFY(!asksForAPin());
    selection.clear();
    QCOMPARE(places(), before);
    QVERIFY(asksForAPin());
    if (solid) return;
    // There is room for the larger ones.
    m_f->session().addPin({160, 80, 0});
    widenPin(m_f->session(), 0, 20);
    selection.set({0});
    QCOMPARE(places(), before);
    selection.set({1});
    QCOMPARE(places(), before);
}

void TestModes::nothingIsBelowTheFold_data() {
    pictureAndSolid();
}

/// The settings of a cut-out's outline are beside those of the mesh, and for pictures only.
void TestModes::numbersOfTheOutlineAreOfPictures_data() {
    pictureAndSolid();
}

void TestModes::numbersOfTheOutlineAreOfPictures() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    const auto* panel = m_f->window().properties().findChild<CutOutPanel*>();
    for (const Mode mode : {Mode::Pins, Mode::Mesh, Mode::Paint}) {
        tools().setMode(mode);
        QCOMPARE(panel->isHidden(), solid || mode != Mode::Mesh);
    }
}

/// The Keep panel and the step's main panel are in view on the smallest usual screen.
void TestModes::nothingIsBelowTheFold() {
    QFETCH(bool, solid);
    m_f->window().resize(1366, 768);
    QVERIFY(open(solid));
    QCOMPARE(m_f->window().size(), QSize(1366, 768));
    Properties& side = m_f->window().properties();
    const auto check = [&](Mode mode, const QWidget* panel) {
        tools().setMode(mode);
        settleLayout(side);
        QVERIFY2(mode == Mode::Export || isInView(*side.findChild<MaterialPanel*>()), "keep");
        QVERIFY2(isInView(*panel), panel->metaObject()->className());
    };
    check(Mode::Mesh, side.findChild<MeshPanel*>());
    check(Mode::Pins, side.findChild<PinList*>());
    check(Mode::Pins, side.findChild<QWidget*>(QStringLiteral("selectionArea")));
    check(Mode::Animate, side.findChild<QWidget*>(QStringLiteral("selectionArea")));
    check(Mode::Animate, side.findChild<QWidget*>(QStringLiteral("memorySlider")));
    check(Mode::Export, side.findChild<ExportPanel*>());
    check(Mode::Paint, side.findChild<PaintPanel*>());
}

void TestModes::narrowWindowsKeepStepsAndExport() {
    QVERIFY(open(false));
    const auto visible = [&](const QAction* action) {
        for (const QToolButton* button : m_f->window().findChildren<QToolButton*>())
            if (button->defaultAction() == action && isInView(*button)) return true;
        return false;
    };
    for (const int width : {1600, 1280, 1024, 800, 640}) {
        m_f->window().resize(width, 700);
        settleLayout(m_f->window());
        for (const Mode mode : kModes) QVERIFY2(visible(tools().modeAction(mode)), QByteArray::number(width));
        const auto* button = m_f->window().findChild<QToolButton*>(QStringLiteral("exportButton"));
        QVERIFY2(isInView(*button), QByteArray::number(width));
        if (width >= 1024)
            QVERIFY(visible(m_f->window().actions().undo) && visible(m_f->window().actions().open));
    }
}

void TestModes::cheatSheetHasEveryKey_data() {
    pictureAndSolid();
}

/// The cheat sheet has the keys of all steps, whichever is current.
void TestModes::cheatSheetHasEveryKey() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    QTextDocument sheet;
    sheet.setHtml(CheatSheet::text(*m_f->window().menuBar(), m_f->session().document().dimension()));
    const QString text = sheet.toPlainText();
    int seen = 0;
    for (QAction* action : m_f->window().findChildren<QAction*>()) {
        if (!action->isVisible()) continue;
        for (const QKeySequence& key : ActionMaker::keysOf(*action)) {
            QVERIFY2(text.contains(key.toString(QKeySequence::NativeText)), qPrintable(action->text()));
            QVERIFY2(text.contains(QString(action->text()).remove('&').remove(QChar(0x2026))),
                     qPrintable(action->text()));
            ++seen;
        }
    }
    QVERIFY(seen > 30);
    for (const Mode mode : kModes) {  // tools stand under their step
        const QString step = QString(tools().modeAction(mode)->text()).remove('&');
        QVERIFY2(text.count('\n' + step + '\n') >= 1 || tools().toolsFirstIn(mode).isEmpty(),
                 qPrintable(step));
    }
    QTest::keyClick(m_f->window().menuBar(), Qt::Key_Escape);
    bool opened = false;
    withNext<CheatSheet>(&m_f->window(), [&opened](CheatSheet& dialog) {
        opened = true;
        dialog.reject();
    });
    QTest::keyClick(&m_f->window(), Qt::Key_Question);
    QVERIFY(opened);
}

/// Each page that the first one links to exists.
void TestModes::manualIsWithinTheProgram() {
    QTest::keyClick(&m_f->window(), Qt::Key_F1);
    auto* manual = m_f->window().findChild<ManualWindow*>();
    QVERIFY(manual && manual->isVisible());
    const QTextBrowser& pages = *manual->pages();
    QVERIFY(pages.toPlainText().contains(QStringLiteral("Getting started")));
    QSet<QUrl> links;
    for (QTextBlock block = pages.document()->begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece)
            if (const QString to = piece.fragment().charFormat().anchorHref(); !to.isEmpty())
                links << pages.source().resolved(QUrl(to));
    QVERIFY(links.size() > 10);
    for (const QUrl& link : links) QVERIFY2(QFile::exists(':' + link.path()), qPrintable(link.toString()));
}

/// All pictures that the pages name are shown, none wider than the window.
void TestModes::manualShowsItsPictures() {
    QTest::keyClick(&m_f->window(), Qt::Key_F1);
    auto* manual = m_f->window().findChild<ManualWindow*>();
    QTextBrowser& pages = *manual->pages();
    int pictures = 0;
    for (const QString& name : QDir(QStringLiteral(":/wend/docs")).entryList({QStringLiteral("*.md")})) {
        pages.setSource(QUrl(QStringLiteral("qrc:/wend/docs/") + name));
        for (QTextBlock block = pages.document()->begin(); block.isValid(); block = block.next())
            for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
                const QTextCharFormat format = piece.fragment().charFormat();
                if (!format.isImageFormat()) continue;
                const QUrl picture(format.toImageFormat().name());
                const auto image =
                    pages.document()->resource(QTextDocument::ImageResource, picture).value<QImage>();
                QVERIFY2(!image.isNull(), qPrintable(name + ": " + picture.toString()));
                QVERIFY(image.deviceIndependentSize().width() <= pages.viewport()->width());
                ++pictures;
            }
    }
    QVERIFY2(pictures > 30, qPrintable(QString::number(pictures)));
}

/// Headings are larger than text, tables span the page, and a small picture has text beside it.
void TestModes::manualHasAStyle() {
    QTest::keyClick(&m_f->window(), Qt::Key_F1);
    QTextBrowser& pages = *m_f->window().findChild<ManualWindow*>()->pages();
    pages.setSource(QUrl(QStringLiteral("qrc:/wend/docs/meshing.md")));
    const QTextDocument& page = *pages.document();
    const auto size = [](const QTextBlock& block) {
        return block.begin().fragment().charFormat().intProperty(QTextFormat::FontPixelSize);
    };
    QCOMPARE(size(page.begin()), 26);
    QCOMPARE(size(page.begin().next()), 14);
    int tables = 0, beside = 0;
    for (const QTextFrame* frame : page.rootFrame()->childFrames())
        if (const auto* table = qobject_cast<const QTextTable*>(frame)) {
            QCOMPARE(table->format().width().type(), QTextLength::PercentageLength);
            QVERIFY(table->cellAt(0, 0).format().toTableCellFormat().bottomBorder() > 1);
            QCOMPARE(table->cellAt(1, 0).format().toTableCellFormat().bottomBorder(), 1.0);
            ++tables;
        }
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const auto* object = page.objectForFormat(piece.fragment().charFormat());
            beside += object && object->format().toFrameFormat().position() == QTextFrameFormat::FloatRight;
        }
    QVERIFY(tables > 0);
    QCOMPARE(beside, 1);
}

/// Enter in the field finds the words of one page from any other; for words on no page a message appears.
void TestModes::manualIsSearchedOnAllPages() {
    QTest::keyClick(&m_f->window(), Qt::Key_F1);
    auto* manual = m_f->window().findChild<ManualWindow*>();
    const QTextBrowser& pages = *manual->pages();
    auto* field = manual->findChild<QLineEdit*>();
    auto* nowhere = manual->findChild<QLabel*>(QStringLiteral("foundNowhere"));
    QVERIFY(field && nowhere && nowhere->isHidden());
    const auto search = [&](const QString& words) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, words);
        QTest::keyClick(field, Qt::Key_Return);
    };
    for (const auto& [words, page] : {std::pair{"resilience", ""},
                                      {"Import Keep", "painting.md"},
                                      {"towel on a table", "pins-and-handles.md"},
                                      {"Going on at the first", ""}}) {
        const QUrl before = pages.source();
        search(QString::fromLatin1(words));
        const bool found = *page;
        QCOMPARE(nowhere->isHidden(), found);
        QCOMPARE(pages.source().fileName(), found ? QString::fromLatin1(page) : before.fileName());
        if (found) QCOMPARE(pages.textCursor().selectedText(), QString::fromLatin1(words));
    }
    // Each place is visited once: on the page, then on the following pages, and from the start again.
    QStringList visited;
    search(QStringLiteral("smoothing length"));
    QVERIFY(nowhere->isHidden());
    const QUrl first = pages.source();
    const int at = pages.textCursor().position();
    for (int i = 0; i < 200; ++i) {
        if (!visited.contains(pages.source().fileName())) visited << pages.source().fileName();
        QTest::keyClick(field, Qt::Key_Return);
        if (pages.source() == first && pages.textCursor().position() == at) break;
    }
    QVERIFY2(visited.size() > 1 && visited.contains(QStringLiteral("energies.md")),
             qPrintable(visited.join(' ')));
    QVERIFY(pages.source() == first && pages.textCursor().position() == at);
}

void TestModes::backslashShowsTheShapeBefore_data() {
    pictureAndSolid();
}

/// The key shows the earlier shape while it is held, without pins.
void TestModes::backslashShowsTheShapeBefore() {
    QFETCH(bool, solid);
    m_f->window().actions().hideOverlays->setChecked(true);
    QVERIFY(open(solid));
    ShapeSession& session = m_f->session();
    const auto seen = [&] {
        return solid ? m_f->canvas().grabFramebuffer() : m_f->window().canvas().grab().toImage();
    };
    const auto isSettled = [&] {  // drawn in a thread of its own, and once more in full quality
        return solid ? m_f->canvas().isSettled() : m_f->window().canvas().isSettled();
    };
    QVERIFY(QTest::qWaitFor(isSettled, 60000));
    const QImage before = seen();
    if (solid) {
        QVERIFY(m_f->holdEnds());
        session.gestures().moveAtOnce(Grip{}, {0, 0, 0.8});
    } else {
        for (const double x : {40, 200}) session.addPin({x, 80, 0});
        session.selection().set({1});
        session.gestures().moveAtOnce(Grip{}, {0, 25, 0});
    }
    QVERIFY(settle(session));
    QVERIFY(QTest::qWaitFor(isSettled, 60000));
    const QImage bent = seen();
    QVERIFY(bent != before);
    QWidget* view = solid ? static_cast<QWidget*>(&m_f->canvas()) : &m_f->window().canvas();
    QTest::keyPress(view, Qt::Key_Backslash);
    QTRY_COMPARE_WITH_TIMEOUT(seen(), before, 20000);
    QTest::keyRelease(view, Qt::Key_Backslash);
    QTRY_COMPARE_WITH_TIMEOUT(seen(), bent, 20000);
    m_f->window().actions().showRest->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(seen(), before, 20000);
    m_f->window().actions().showRest->trigger();
}

void TestModes::everythingHasAName_data() {
    pictureAndSolid();
}

/// Every widget that takes the keyboard has a name for screen readers.
void TestModes::everythingHasAName() {
    QFETCH(bool, solid);
    QVERIFY(open(solid));
    for (const Mode mode : kModes) {
        tools().setMode(mode);
        settleLayout(m_f->window().properties());
        const QStringList wrong = nameless(m_f->window());
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
}

QTEST_MAIN(TestModes)
#include "test_modes.moc"
