// Every window, dialog and card in every language: no word is cut off, and every widget that takes the
// keyboard has an accessible name. The tests run once for each scale of the desktop.

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QMessageBox>
#include <QScopeGuard>
#include <QTextBrowser>
#include <QTranslator>

#include "app/panels/fields/panel_parts.h"
#include "app/panels/layer_panel.h"
#include "app/panels/surface_panel.h"
#include "app/project/design.h"
#include "app/window/compare_view.h"
#include "app/window/export/export_form.h"
#include "app/window/export/exporter.h"
#include "app/window/export/picture_dialog.h"
#include "app/window/files/file_workflow.h"
#include "app/window/help/help.h"
#include "app/window/help/shortcuts.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/notes.h"
#include "app/window/properties.h"
#include "tests/support/dialogs.h"
#include "tests/support/layers.h"
#include "tests/support/solid_fixture.h"
#include "tests/support/whole_texts.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr QSize kSmallest(1024, 640);  // that the window is made for: the properties lie over the view
constexpr QSize kSmall(1366, 728);     // a usual small screen, with a bar of the desktop

}  // namespace

class TestWholeTexts : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void cleanup();
    void faultsAreFound();
    void startPage_data() { languages(); }
    void startPage();
    void dialogsOfPictures_data() { languages(); }
    void dialogsOfPictures();
    void questions_data() { languages(); }
    void questions();
    void cardsOverTheView_data() { languages(); }
    void cardsOverTheView();
    void stepsOfPictures_data() { languages(); }
    void stepsOfPictures();
    void layersAreAboveTheFold_data() { languages(); }
    void layersAreAboveTheFold();
    void stepsOfSolids_data() { languages(); }
    void stepsOfSolids();
    void repairOfASurface_data() { languages(); }
    void repairOfASurface();

  private:
    static void languages();
    bool makeWindow();
    void resize(const QSize& size);
    /// Checks the texts of a visible window.
    void look(const QString& what, const QWidget& at);
    void lookAtSteps(const QString& what);
    /// Checks the dialog that `open` opens, and cancels it.
    void lookAsked(const QString& what, const std::function<void()>& open);
    void bend();
    void paintLayers();
    MainWindow& window() { return m_f->window(); }

    QTranslator m_words, m_qtWords;
    QStringList m_wrong, m_told;
    QSize m_size;
    std::unique_ptr<SolidFixture> m_f;
};

void TestWholeTexts::languages() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de", "fr", "es", "ja", "zh_CN"}) QTest::newRow(language) << language;
}

void TestWholeTexts::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_wrong.clear();
    m_told.clear();
}

void TestWholeTexts::cleanup() {
    m_f.reset();
    for (QTranslator* one : {&m_words, &m_qtWords}) QApplication::removeTranslator(one);
}

/// Makes the window in the language of the row, as at the start of the program.
bool TestWholeTexts::makeWindow() {
    QFETCH(QString, language);
    if (language != "en") {
        if (!m_words.load(":/i18n/wend_" + language + ".qm")) return false;
        QApplication::installTranslator(&m_words);
        if (m_qtWords.load("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QApplication::installTranslator(&m_qtWords);
    }
    m_f = std::make_unique<SolidFixture>();
    resize(kSmallest);
    return QTest::qWaitForWindowActive(&window(), 20000);
}

void TestWholeTexts::resize(const QSize& size) {
    m_size = size;
    window().resize(size);
}

void TestWholeTexts::look(const QString& what, const QWidget& at) {
    QStringList wrong;
    const auto isWhole = [&] {  // the room of one part may follow from that of another
        settleLayout(at);
        wrong = cutOff(at) + nameless(at);
        if (&at == &window() && at.size() != m_size)
            wrong << QStringLiteral("the window has grown to %1 × %2").arg(at.width()).arg(at.height());
        return wrong.isEmpty();
    };
    static_cast<void>(QTest::qWaitFor(isWhole, 3000));
    for (const QString& line : wrong) {
        if (m_told.contains(line)) continue;
        m_told << line;
        m_wrong << what + QStringLiteral(": ") + line;
    }
    if (!qEnvironmentVariableIsSet("WEND_TEST_PICTURES")) return;
    const QString name = QString("%1-%2").arg(QString::fromUtf8(QTest::currentDataTag()), what);
    const_cast<QWidget&>(at).grab().save(qEnvironmentVariable("WEND_TEST_PICTURES") + '/' + name + ".png");
}

void TestWholeTexts::lookAsked(const QString& what, const std::function<void()>& open) {
    bool seen = false;
    withNext<QDialog>(&window(), [&](QDialog& dialog) {
        seen = true;
        look(what, dialog);
        dialog.reject();
    });
    open();
    QVERIFY2(seen, qPrintable(what));
}

/// Checks the options of every tool, then every section of the properties.
void TestWholeTexts::lookAtSteps(const QString& what) {
    resize(kSmall);
    for (const Mode mode : kModes) {
        window().tools().setMode(mode);
        for (QAction* tool : window().tools().toolsOf(mode)) {
            tool->trigger();
            settleLayout(window().properties());
            look(QString("%1-%2-%3").arg(what).arg(int(mode)).arg(tool->objectName()), window());
        }
    }
    resize(kSmallest);
    auto& rail = *window().findChild<PropertiesRail*>();
    for (const Mode mode : kModes) {
        window().tools().setMode(mode);
        settleLayout(window());
        for (QToolButton* button : rail.findChildren<QToolButton*>()) {
            if (!button->isVisible()) continue;
            QTest::mouseClick(button, Qt::LeftButton);
            QVERIFY(rail.isOpen() && window().properties().isVisible());
            look(QString("%1-%2-rail %3").arg(what).arg(int(mode)).arg(button->accessibleName()), window());
        }
        rail.close();
    }
}

/// Sets two pins, drags the right one, and selects both.
void TestWholeTexts::bend() {
    ShapeSession& session = m_f->session();
    session.addPin({40, 80, 0});
    session.addPin({200, 80, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    session.gestures().moveBy({0, 20, 0});
    session.gestures().end(0.5);
    QVERIFY(settle(session));
}

void TestWholeTexts::paintLayers() {
    const auto project = copyOf(*m_f->session().document().project());
    auto& layers = designOf(*project).material.layers;
    layers.push_back(layerWith("Neck and shoulders", {{Box<3>{{0, 0, 0}, {100, 160, 0}}, 3}, 1.5}));
    layers.push_back(layerWith("Tail", {{Box<3>{{100, 0, 0}, {240, 160, 0}}}, {}, Stiffness{{1, 0, 0}, 20}}));
    m_f->session().document().change(QStringLiteral("Layers"), project);
    QVERIFY(settle(m_f->session()));
    window().properties().layers().list()->setCurrentRow(0);
}

/// The checks of the tests below detect faults.
void TestWholeTexts::faultsAreFound() {
    QDialog dialog;
    auto* narrow = new QPushButton(QStringLiteral("What does not have the room"), &dialog);
    auto* low =
        new QLabel(QStringLiteral("Words of more than one line, as they are where they are many"), &dialog);
    auto* on = new QLabel(QStringLiteral("Over it"), &dialog);
    auto* field = new QLineEdit(&dialog);
    dialog.resize(300, 200);
    dialog.show();
    narrow->setGeometry(0, 0, 60, 30);
    low->setWordWrap(true);
    low->setGeometry(0, 50, 100, 18);
    on->setGeometry(50, 55, 80, 20);
    field->setGeometry(0, 100, 80, 24);
    QCOMPARE(cutOff(dialog).size(), 3);
    QCOMPARE(nameless(dialog).size(), 1);
    narrow->resize(narrow->sizeHint());
    low->resize(100, low->heightForWidth(100));
    on->setGeometry(250, 180, 80, 20);
    QCOMPARE(cutOff(dialog).size(), 1);  // beyond the dialog's border
    on->setGeometry(210, 170, 80, 20);
    field->setAccessibleName(QStringLiteral("Name"));
    QCOMPARE(cutOff(dialog), QStringList());
    QCOMPARE(nameless(dialog), QStringList());
}

/// The start page lists recent files and work to be recovered.
void TestWholeTexts::startPage() {
    QVERIFY(makeWindow());
    look(QStringLiteral("start"), window());
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

void TestWholeTexts::dialogsOfPictures() {
    QVERIFY(makeWindow() && m_f->openPicture());
    bend();
    Actions& a = window().actions();
    for (const auto& [action, name] : {std::pair{a.exportPicture, "export picture"},
                                       {a.exportFrames, "export frames"},
                                       {a.exportStMap, "export map"},
                                       {a.exportMesh, "export mesh"},
                                       {a.shortcuts, "keys"},
                                       {a.about, "about"}})
        lookAsked(QString::fromLatin1(name), [action = action] { action->trigger(); });
    a.manual->trigger();
    auto* manual = window().findChild<ManualWindow*>();
    auto* field = manual->findChild<QLineEdit*>();
    field->setText(QStringLiteral("what stands nowhere"));
    QTest::keyClick(field, Qt::Key_Return);
    look(QStringLiteral("manual"), *manual);
    manual->close();
    a.history->trigger();
    auto* history = window().findChild<QDialog*>(QStringLiteral("history"));
    look(QStringLiteral("history"), *history);
    history->close();
    PictureDialog view({1600, 900}, true, &window());
    view.show();
    view.findChild<QSpinBox*>()->setValue(9999999);  // and why not
    look(QStringLiteral("export view"), view);
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

void TestWholeTexts::questions() {
    QVERIFY(makeWindow() && m_f->openProject(2, 300));
    bend();
    const QString path = m_f->session().document().path();
    lookAsked(QStringLiteral("leave"), [this] { window().actions().closeFile->trigger(); });
    lookAsked(QStringLiteral("replace"),
              [&] { window().exporter().mayReplace(ExportKind::Picture, path, 0); });
    lookAsked(QStringLiteral("discard"), [this] {
        window().files().discard({{}, QStringLiteral("/a/bar.wend"), {}, {}});
    });
    QFile file(path);
    QVERIFY(file.open(QIODevice::Append) && file.write("\n") == 1);
    file.close();
    InfoBanner& banner = window().banner();
    QVERIFY(QTest::qWaitFor([&] { return banner.isVisible(); }, 20000));
    look(QStringLiteral("changed on disk"), window());
    lookAsked(QStringLiteral("overwrite"), [this] { window().actions().save->trigger(); });
    lookAsked(QStringLiteral("reload"),
              [&] { QTest::mouseClick(banner.findChildren<QPushButton*>().first(), Qt::LeftButton); });
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

void TestWholeTexts::cardsOverTheView() {
    QVERIFY(makeWindow());
    window().actions().tutorial->trigger();
    auto& card = *window().findChild<Tutorial*>();
    QVERIFY(QTest::qWaitFor([&] { return card.isVisible(); }, 30000));
    for (int page = 0; page < card.pageCount(); ++page) {
        QVERIFY(settle(m_f->session()));
        look(QStringLiteral("tutorial %1").arg(page + 1), window());
        QTest::mouseClick(card.findChildren<QPushButton*>().first(), Qt::LeftButton);
    }
    QVERIFY(!card.isVisible());
    QVERIFY(settle(m_f->session()));
    window().compared().split(0.5);
    QVERIFY(settle(window().compared().comparison().other()));
    look(QStringLiteral("compare"), window());
    window().compared().join();
    m_f->session().document().undoStack()->setClean();
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

void TestWholeTexts::stepsOfPictures() {
    QVERIFY(makeWindow() && m_f->openPicture());
    bend();
    paintLayers();
    window().properties().findChild<FoldingSection*>()->setOpen(true);
    lookAtSteps(QStringLiteral("picture"));
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

/// The list with its buttons fits on a small screen without scrolling.
void TestWholeTexts::layersAreAboveTheFold() {
    QVERIFY(makeWindow() && m_f->openPicture());
    paintLayers();
    resize(kSmall);
    window().tools().setMode(Mode::Paint);
    settleLayout(window().properties());
    for (const char* name : {"layerUp", "layerDown", "layerRemove"}) {
        const auto* button = window().findChild<QToolButton*>(QLatin1String(name));
        QTRY_VERIFY2(button->visibleRegion().boundingRect() == button->rect(), name);
    }
}

void TestWholeTexts::stepsOfSolids() {
    QVERIFY(makeWindow() && m_f->open());
    QVERIFY(m_f->holdEnds());
    window().properties().findChild<FoldingSection*>()->setOpen(true);
    m_f->actions().cut->trigger();
    // Only layouts count here; to draw the solid on a processor takes most of the time.
    window().findChild<VolumeView*>()->setUpdatesEnabled(false);
    lookAtSteps(QStringLiteral("solid"));
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

/// The surface has a hole and is in a cage; then it has none.
void TestWholeTexts::repairOfASurface() {
    QVERIFY(makeWindow());
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("open.obj")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0.2\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    file.close();
    QFile project(folder.filePath(QStringLiteral("open.wend")));
    QVERIFY(project.open(QIODevice::WriteOnly));
    project.write(R"({"format": "wend", "version": 1, "domain": {"surface": "open.obj", "vertices": 400,
                      "cage": false}})");
    project.close();
    resize(kSmall);
    window().openPath(project.fileName());
    const auto* panel = window().findChild<SurfacePanel*>();
    QVERIFY(QTest::qWaitFor([&] { return panel->isVisible() && window().banner().isVisible(); }, 20000));
    look(QStringLiteral("surface"), window());
    QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join('\n')));
}

QTEST_MAIN(TestWholeTexts)
#include "test_whole_texts.moc"
