#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

#include "app/view/actions.h"
#include "app/view/file_workflow.h"
#include "app/view/info_banner.h"
#include "app/view/language_choice.h"
#include "app/view/main_window.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The language of the window is chosen in its menu, and spoken from the next start.
class TestLanguage : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void chosenLanguageIsSpoken_data();
    void chosenLanguageIsSpoken();
    void unknownLanguageIsTheDesktops();
    void englishDesktopsSpeakEnglish();
    void choiceIsToldAndTakenBack();
    void newStartKeepsTheFile();
    void newStartAsksForUnsavedWork();

  private:
    QAction* language(const QString& name) const;
    QPushButton* again() const { return m_window->banner().findChild<QPushButton*>(); }
    void open();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SpokenLanguage> m_spoken;
    std::unique_ptr<MainWindow> m_window;
};

void TestLanguage::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    isolateSettings(*m_folder);
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

/// One line, in the language that was chosen, until this one is chosen again.
void TestLanguage::choiceIsToldAndTakenBack() {
    m_window = std::make_unique<MainWindow>();
    QAction* const before = m_window->actions().languages->menu()->actions().first();
    QVERIFY(before->isChecked());
    language(QStringLiteral("Deutsch"))->trigger();
    QVERIFY2(m_window->banner().text().contains(QStringLiteral("Deutsch")),
             qPrintable(m_window->banner().text()));
    QVERIFY(again());
    language(QStringLiteral("English"))->trigger();
    QVERIFY(m_window->banner().text().contains(QStringLiteral("English")));
    before->trigger();
    QVERIFY(m_window->banner().text().isEmpty());
}

void TestLanguage::newStartKeepsTheFile() {
    open();
    language(QStringLiteral("Deutsch"))->trigger();
    QVERIFY(!m_window->again());
    again()->click();
    QVERIFY(!m_window->isVisible());
    QCOMPARE(*m_window->again(), QStringList(m_folder->filePath("bar.png")));
}

/// Who would rather keep it stays where they are.
void TestLanguage::newStartAsksForUnsavedWork() {
    open();
    m_window->session().addPin({100, 80});
    language(QStringLiteral("Deutsch"))->trigger();
    for (const auto answer : {QMessageBox::Cancel, QMessageBox::Discard}) {
        bool asked = false;
        QTimer::singleShot(0, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            asked = box != nullptr;
            if (box) box->button(answer)->click();
        });
        again()->click();
        QVERIFY(asked);
        const bool leaves = answer == QMessageBox::Discard;
        QCOMPARE(m_window->isVisible(), !leaves);
        QCOMPARE(m_window->again().has_value(), leaves);
    }
}

QTEST_MAIN(TestLanguage)
#include "test_language.moc"
