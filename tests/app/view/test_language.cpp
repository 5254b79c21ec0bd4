#include <QMenuBar>
#include <QSettings>
#include <QTemporaryDir>

#include "app/document/design.h"
#include "app/session/opening.h"
#include "app/view/actions/actions.h"
#include "app/view/actions/language_choice.h"
#include "app/view/actions/toolbox.h"
#include "app/view/files/file_workflow.h"
#include "app/view/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The language of the window is chosen in its menu, and spoken at once by a window in its place.
class TestLanguage : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void chosenLanguageIsSpoken_data();
    void chosenLanguageIsSpoken();
    void unknownLanguageIsTheDesktops();
    void englishDesktopsSpeakEnglish();
    void choosingWhatIsSpokenChangesNothing();
    void nextWindowTakesAllOver_data();
    void nextWindowTakesAllOver();
    void nextWindowShowsTheSame();
    void nextWindowIsEmptyAsWell();
    void namesOfSamplesAreSpoken();

  private:
    QAction* language(const QString& name) const;
    WindowState leaveFor(const QString& name);
    void open();

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<SpokenLanguage> m_spoken;
    std::unique_ptr<MainWindow> m_window;
};

void TestLanguage::init() {
    m_folder = std::make_unique<TestFolder>();
    QSettings().remove("language");
}

void TestLanguage::cleanup() {
    if (m_window && !m_window->session().document().isEmpty())
        m_window->session().document().undoStack()->setClean();
    m_window.reset();
    m_spoken.reset();
    QLocale::setDefault(QLocale::system());
}

QAction* TestLanguage::language(const QString& name) const {
    for (QAction* one : m_window->actions().languages->menu()->actions())
        if (one->text() == name) return one;
    return nullptr;
}

void TestLanguage::open() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
    QVERIFY(settle(m_window->session()));
}

void TestLanguage::chosenLanguageIsSpoken_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("half");
    QTest::newRow("de") << "de"
                        << "Deutsch"
                        << "Datei"
                        << "0,5";
    QTest::newRow("en") << "en"
                        << "English"
                        << "File"
                        << "0.5";
    QTest::newRow("es") << "es"
                        << "Español"
                        << "Archivo"
                        << "0,5";
    QTest::newRow("fr") << "fr"
                        << "Français"
                        << "Fichier"
                        << "0,5";
    QTest::newRow("ja") << "ja"
                        << "日本語"
                        << "ファイル"
                        << "0.5";
    QTest::newRow("zh_CN") << "zh_CN"
                           << "简体中文"
                           << "文件"
                           << "0.5";
}

/// Chosen in one window, spoken by the next one, with the numbers of that country; and it is marked there.
void TestLanguage::chosenLanguageIsSpoken() {
    QFETCH(QString, code);
    QFETCH(QString, name);
    QFETCH(QString, file);
    QFETCH(QString, half);
    m_window = std::make_unique<MainWindow>();
    language(name)->trigger();
    QCOMPARE(QSettings().value("language").toString(), code);
    m_window.reset();
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    const QString first = m_window->menuBar()->actions().first()->text().remove('&');
    QVERIFY2(first.startsWith(file), qPrintable(first));
    QVERIFY(language(name)->isChecked());
    QCOMPARE(QLocale().toString(0.5), half);
}

void TestLanguage::unknownLanguageIsTheDesktops() {
    QSettings().setValue("language", "tlh");
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    QVERIFY(m_window->actions().languages->menu()->actions().first()->isChecked());
}

/// Also where they would like another language second best: on such a one this is run once more.
void TestLanguage::englishDesktopsSpeakEnglish() {
    if (!qEnvironmentVariable("LANGUAGE").startsWith("en")) QSettings().setValue("language", "en");
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    QCOMPARE(m_window->menuBar()->actions().first()->text().remove('&'), QStringLiteral("File"));
}

void TestLanguage::choosingWhatIsSpokenChangesNothing() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    m_window->actions().languages->menu()->actions().first()->trigger();
    QCoreApplication::processEvents();
    QVERIFY(m_window->isVisible() && !m_window->again());
}

/// The window closes and asks nothing; the next one speaks the language.
WindowState TestLanguage::leaveFor(const QString& name) {
    language(name)->trigger();
    const bool closed = QTest::qWaitFor([this] { return !m_window->isVisible(); }, 20000);
    const std::optional<WindowState> left = m_window->again();
    if (!closed || !left) return {};
    m_window.reset();
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    m_window->takeOver(*left);
    m_window->show();
    return *left;
}

void TestLanguage::nextWindowTakesAllOver_data() {
    QTest::addColumn<bool>("saved");
    QTest::newRow("saved once") << true;
    QTest::newRow("never saved") << false;
}

/// What is unsaved, what can be undone and done again, the step of the work, and the place on the screen.
void TestLanguage::nextWindowTakesAllOver() {
    QFETCH(bool, saved);
    open();
    m_window->setGeometry(60, 50, 900, 640);
    const auto pins = [this] { return m_window->session().document().design<2>().handles.size(); };
    const auto undo = [this]() -> QUndoStack& { return *m_window->session().document().undoStack(); };
    m_window->session().addPin({60, 80});
    const QString file = m_folder->filePath("bar.wend");
    if (saved) m_window->session().document().save(file);
    m_window->session().addPin({100, 80});
    m_window->session().addPin({180, 80});
    undo().undo();
    m_window->tools().setMode(Mode::Paint);
    const std::shared_ptr<const Project> before = m_window->session().document().project();
    const QRect place = m_window->geometry();
    const QString step = undo().undoText();
    QVERIFY(leaveFor(QStringLiteral("Deutsch")).file.project == before);
    QVERIFY(m_window->menuBar()->actions().first()->text().remove('&').startsWith(QStringLiteral("Datei")));
    const Document& document = m_window->session().document();
    QVERIFY(document.project() == before && document.isModified() && document.picture());
    QCOMPARE(document.path(), saved ? file : QString());
    QCOMPARE(m_window->geometry(), place);
    QCOMPARE(m_window->tools().mode(), Mode::Paint);
    QCOMPARE(undo().undoText(), step);
    undo().redo();
    QCOMPARE(pins(), std::size_t(3));
    undo().undo();
    undo().undo();
    QCOMPARE(pins(), std::size_t(1));
    QCOMPARE(document.isModified(), !saved);
    undo().undo();
    QVERIFY(pins() == 0 && !undo().canUndo());
    QCOMPARE(document.isModified(), saved);
    QVERIFY(settle(m_window->session()));
    undo().setClean();
}

/// The pins that are selected, and the time in the middle of the film.
void TestLanguage::nextWindowShowsTheSame() {
    open();
    ShapeSession& first = m_window->session();
    for (const double x : {60.0, 120.0, 180.0}) first.addPin({x, 80});
    first.selection().set({2});
    first.beginDrag();
    first.dragTo({180, 50});
    first.endDrag(0.5);
    QVERIFY(settle(first));
    first.selection().set({0, 2});
    first.playback().setTime(0.4);
    QVERIFY(settle(first));
    const Points<2> pose = first.frame<2>()->pose;
    leaveFor(QStringLiteral("Deutsch"));
    ShapeSession& next = m_window->session();
    QVERIFY(settle(next));
    QCOMPARE(next.selection().handles(), (std::vector<int>{0, 2}));
    QCOMPARE(next.playback().time(), 0.4);
    QVERIFY(QTest::qWaitFor([&] { return next.frame<2>()->pose == pose; }, 20000));
    next.document().undoStack()->setClean();
}

void TestLanguage::nextWindowIsEmptyAsWell() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(!leaveFor(QStringLiteral("Deutsch")).file.project);
    QVERIFY(m_window->isVisible() && m_window->session().document().isEmpty());
    QVERIFY(leaveFor(QStringLiteral("English")).geometry.size() > 0);  // and back
    QCOMPARE(m_window->menuBar()->actions().first()->text().remove('&'), QStringLiteral("File"));
}

/// Of the user's own files they stay as they are.
void TestLanguage::namesOfSamplesAreSpoken() {
    QSettings().setValue("language", "de");
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    const auto nameOfFirst = [this](const QString& path) {
        const int before = m_window->session().document().generation();
        m_window->openPath(path);
        const auto isOpen = [&] { return m_window->session().document().generation() > before; };
        if (!QTest::qWaitFor(isOpen, 20000)) return QString();
        return QString::fromStdString(m_window->session().document().design<2>().handles.front().name);
    };
    QString giraffe;
    for (const QString& path : samplePaths())
        if (path.endsWith(QStringLiteral("giraffe.wend"))) giraffe = path;
    QCOMPARE(nameOfFirst(giraffe), QStringLiteral("Hinterhuf"));
    const QFileInfo info(giraffe);
    for (const char* name : {"giraffe.wend", "giraffe.png"})
        QVERIFY(QFile::copy(info.dir().filePath(name), m_folder->filePath(name)));
    QCOMPARE(nameOfFirst(m_folder->filePath("giraffe.wend")), QStringLiteral("hind hoof"));
}

QTEST_MAIN(TestLanguage)
#include "test_language.moc"
