#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>

#include "app/project/design.h"
#include "app/session/opening.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/language_choice.h"
#include "app/window/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The language of the window is chosen in its menu and applies from the next start on.
class TestLanguage : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void chosenLanguageIsSpoken_data();
    void chosenLanguageIsSpoken();
    void unknownLanguageIsTheDesktops();
    void englishDesktopsSpeakEnglish();
    void changeIsAnnounced();
    void namesOfSamplesAreSpoken();

  private:
    QAction* language(const QString& name) const;

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

/// The language chosen in one window is used by the next one, with the numbers of that country, and is marked
/// there.
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

/// English desktops get English, even if they list another language second: this runs once more on such a
/// one.
void TestLanguage::englishDesktopsSpeakEnglish() {
    if (!qEnvironmentVariable("LANGUAGE").startsWith("en")) QSettings().setValue("language", "en");
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    QCOMPARE(m_window->menuBar()->actions().first()->text().remove('&'), QStringLiteral("File"));
}

/// The status bar says when the language changes; nothing is said when the spoken language is chosen.
void TestLanguage::changeIsAnnounced() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    m_window->actions().languages->menu()->actions().first()->trigger();
    QCOMPARE(m_window->statusBar()->currentMessage(), QString());
    language(QStringLiteral("Deutsch"))->trigger();
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("starts")));
    QVERIFY(m_window->isVisible());
}

/// The names of samples are translated, those of the user's own files are not.
void TestLanguage::namesOfSamplesAreSpoken() {
    QSettings().setValue("language", "de");
    m_spoken = std::make_unique<SpokenLanguage>();
    m_window = std::make_unique<MainWindow>();
    const auto nameOfFirst = [this](const QString& path) {
        const int before = m_window->session().document().generation();
        m_window->openPath(path);
        const auto isOpen = [&] { return m_window->session().document().generation() > before; };
        if (!QTest::qWaitFor(isOpen, 20000)) return QString();
        return QString::fromStdString(m_window->session().document().design().handles.front().name);
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
