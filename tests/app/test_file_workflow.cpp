#include <QAbstractButton>
#include <QFileDialog>
#include <QMessageBox>
#include <QSignalSpy>

#include "app/document/handle_edits.h"
#include "app/session/opening.h"
#include "app/view/file_workflow.h"
#include "app/view/info_banner.h"
#include "app/view/main_window.h"
#include "tests/support/dialogs.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Opening, and getting back what a crash has left: nothing is lost unasked.
class TestFileWorkflow : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void recoveredWorkOpensAsUnsaved();
    void theCopyStaysUntilThereIsANewOne();
    void aFailedRecoveryKeepsTheCopy();
    void theQuestionStandsInTheMiddle();
    void laterKeepsAndDiscardDiscards();
    void changesDuringAReadingAreAskedFor();
    void samplesOpenAsCopies();
    void savingWithoutChangesWritesNothing();

  private:
    QString leaveLostWork(const QString& picture);
    bool guard(const QString& answer);
    Document& document() { return m_window->session().document(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_copies;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

/// Presses the button of this name in the next message box.
void answerNext(QObject* scope, const QString& name) {
    withNext<QMessageBox>(scope, [name](QMessageBox& box) {
        for (QAbstractButton* button : box.buttons())
            if (button->text().remove('&') == name) return button->click();
        box.reject();
    });
}

}  // namespace

void TestFileWorkflow::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_copies = m_folder->filePath("copies");
    QDir().mkpath(m_copies);
    isolateSettings(*m_folder);
    m_window = std::make_unique<MainWindow>();
    m_window->show();
}

void TestFileWorkflow::cleanup() {
    if (!document().isEmpty()) document().undoStack()->setClean();
    m_window.reset();
}

/// A project with one pin that was never saved.
QString TestFileWorkflow::leaveLostWork(const QString& picture) {
    Project project;
    project.domain.path = picture.toStdString();
    project = withPin(project, {40, 20}, "Pin 1");
    const QString copy = m_copies + "/lost.wend";
    writeProject(copy.toStdString(), project);
    QSettings origin(m_copies + "/lost.ini", QSettings::IniFormat);
    origin.setValue("source", picture);
    return copy;
}

bool TestFileWorkflow::guard(const QString& answer) {
    answerNext(m_window.get(), answer);
    return m_window->files().guardWork(m_copies);
}

void TestFileWorkflow::recoveredWorkOpensAsUnsaved() {
    const QString picture = writeCutOut(*m_folder);
    leaveLostWork(picture);
    QVERIFY(guard("Recover"));
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    QCOMPARE(document().design().handles.size(), std::size_t(1));
    QVERIFY(document().isModified());
    QVERIFY(document().path().isEmpty());
    QCOMPARE(document().source(), picture);
}

void TestFileWorkflow::theCopyStaysUntilThereIsANewOne() {
    const QString copy = leaveLostWork(writeCutOut(*m_folder));
    QVERIFY(guard("Recover"));
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    QVERIFY(QFile::exists(copy));
    QVERIFY(QTest::qWaitFor([&] { return !QFile::exists(copy); }, 20000));
    QCOMPARE(QDir(m_copies).entryList({"*.wend"}).size(), 1);  // the new one
}

void TestFileWorkflow::aFailedRecoveryKeepsTheCopy() {
    const QString copy = leaveLostWork(m_folder->filePath("gone.png"));
    QVERIFY(guard("Recover"));
    QVERIFY(QTest::qWaitFor([&] { return !m_window->banner().text().isEmpty(); }, 20000));
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    document().change("Pin", withPin(*document().project(), {40, 20}, "Pin 1"));
    QVERIFY(QTest::qWaitFor([&] { return QDir(m_copies).entryList({"*.wend"}).size() == 2; }, 20000));
    QVERIFY(QFile::exists(copy));
}

/// Window managers place a window when it is shown already.
void TestFileWorkflow::theQuestionStandsInTheMiddle() {
    leaveLostWork(writeCutOut(*m_folder));
    MainWindow window;
    window.resize(600, 400);
    window.move(0, 0);
    window.show();
    const auto place = [&window] { window.move(170, 90); };
    QMetaObject::invokeMethod(&window, place, Qt::QueuedConnection);
    QPoint off(1000, 1000);
    withNext<QMessageBox>(&window, [&](QMessageBox& box) {
        off = box.geometry().center() - window.geometry().center();
        box.reject();
    });
    QVERIFY(!window.files().guardWork(m_copies));
    constexpr int kFrame = 20;  // Qt guesses how wide it will be
    QVERIFY2(std::abs(off.x()) <= kFrame, qPrintable(QString::number(off.x())));
}

void TestFileWorkflow::laterKeepsAndDiscardDiscards() {
    const QString copy = leaveLostWork(writeCutOut(*m_folder));
    QVERIFY(!guard("Later"));
    QVERIFY(QFile::exists(copy));
    QVERIFY(!guard("Discard"));
    QVERIFY(!QFile::exists(copy));
    QVERIFY(document().isEmpty());
}

void TestFileWorkflow::changesDuringAReadingAreAskedFor() {
    const QString picture = writeCutOut(*m_folder);
    m_window->openPath(picture);
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    const int generation = document().generation();
    QSignalSpy finished(&m_window->files(), &FileWorkflow::openingChanged);
    m_window->openPath(picture);  // nothing is changed yet: not asked
    document().change("Pin", withPin(*document().project(), {40, 20}, "Pin 1"));
    answerNext(m_window.get(), "Cancel");
    QVERIFY(QTest::qWaitFor([&] { return finished.size() == 2; }, 20000));
    QTest::qWait(300);
    QCOMPARE(document().generation(), generation);
    QCOMPARE(document().design().handles.size(), std::size_t(1));
}

void TestFileWorkflow::samplesOpenAsCopies() {
    const QString sample = samplePaths().at(0);
    m_window->openPath(sample);
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 60000));
    QVERIFY(document().path().isEmpty());
    QVERIFY(!document().isModified());
    QString proposed;
    withNext<QFileDialog>(m_window.get(), [&](QFileDialog& dialog) {
        proposed = dialog.selectedFiles().value(0);
        dialog.reject();
    });
    QVERIFY(!m_window->files().save());
    QVERIFY(!proposed.isEmpty());
    QVERIFY(QFileInfo(proposed).absolutePath() != QFileInfo(sample).absolutePath());
}

void TestFileWorkflow::savingWithoutChangesWritesNothing() {
    writeCutOut(*m_folder);
    const QString path = m_folder->filePath("bar.wend");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": "wend", "version": 1, "domain": {"image": "bar.png"}})");
    file.close();
    m_window->openPath(path);
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    const QDateTime before = QFileInfo(path).lastModified();
    const auto size = QFileInfo(path).size();
    QVERIFY(m_window->files().save());
    QCOMPARE(QFileInfo(path).size(), size);
    QCOMPARE(QFileInfo(path).lastModified(), before);
}

QTEST_MAIN(TestFileWorkflow)
#include "test_file_workflow.moc"
