#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/file/project_writer.h"
#include "app/session/opening.h"
#include "app/window/files/file_workflow.h"
#include "app/window/files/start_page.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "tests/support/dialogs.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Opening files and recovering work after a crash: nothing is lost without a question.
class TestFileWorkflow : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void recoveredWorkOpensAsUnsaved();
    void theCopyStaysUntilThereIsANewOne();
    void aFailedRecoveryKeepsTheCopy();
    void lostWorkWaitsAsACard();
    void lostWorkIsReportedBesideAnotherFile();
    void changesDuringAReadingAreAskedFor();
    void samplesOpenAsCopies();
    void savingWithoutChangesWritesNothing();

  private:
    QString leaveLostWork(const QString& picture);
    QAbstractButton* lostCard(const char* name);
    bool recover();
    Document& document() { return m_window->session().document(); }

    std::unique_ptr<TestFolder> m_folder;
    QString m_copies;
    std::unique_ptr<MainWindow> m_window;
};

void TestFileWorkflow::init() {
    m_folder = std::make_unique<TestFolder>();
    m_copies = m_folder->filePath("copies");
    QDir().mkpath(m_copies);
    m_window = std::make_unique<MainWindow>();
    m_window->show();
}

void TestFileWorkflow::cleanup() {
    if (!document().isEmpty()) document().undoStack()->setClean();
    m_window.reset();
}

/// A project with one pin that was never saved.
QString TestFileWorkflow::leaveLostWork(const QString& picture) {
    const auto project = newProject();
    domainOf(*project).path = picture.toStdString();
    OpenedFile file;
    file.project = project;
    Document work;
    work.open(file);
    addPin(work, {40, 20}, "Pin 1");
    const QString copy = m_copies + "/lost.wend";
    writeProject(copy.toStdString(), *work.project());
    QSettings origin(m_copies + "/lost.ini", QSettings::IniFormat);
    origin.setValue("source", picture);
    return copy;
}

QAbstractButton* TestFileWorkflow::lostCard(const char* name) {
    m_window->files().guardWork(m_copies);
    auto* button = m_window->findChild<QAbstractButton*>(QString::fromLatin1(name));
    return button && QTest::qWaitFor([=] { return button->isVisible(); }, 20000) ? button : nullptr;
}

bool TestFileWorkflow::recover() {
    QAbstractButton* card = lostCard("lostCard");
    if (card) QTest::mouseClick(card, Qt::LeftButton);
    return card;
}

void TestFileWorkflow::recoveredWorkOpensAsUnsaved() {
    const QString picture = writeCutOut(*m_folder);
    leaveLostWork(picture);
    QVERIFY(recover());
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    QCOMPARE(document().design().handles.size(), std::size_t(1));
    QVERIFY(document().isModified());
    QVERIFY(document().path().isEmpty());
    QCOMPARE(document().source(), picture);
}

void TestFileWorkflow::theCopyStaysUntilThereIsANewOne() {
    const QString copy = leaveLostWork(writeCutOut(*m_folder));
    QVERIFY(recover());
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    QVERIFY(QFile::exists(copy));
    QVERIFY(QTest::qWaitFor([&] { return !QFile::exists(copy); }, 20000));
    QCOMPARE(QDir(m_copies).entryList({"*.wend"}).size(), 1);  // the new one
}

void TestFileWorkflow::aFailedRecoveryKeepsTheCopy() {
    const QString copy = leaveLostWork(m_folder->filePath("gone.png"));
    QVERIFY(recover());
    QVERIFY(QTest::qWaitFor([&] { return !m_window->banner().text().isEmpty(); }, 20000));
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    addPin(document(), {40, 20}, "Pin 1");
    QVERIFY(QTest::qWaitFor([&] { return QDir(m_copies).entryList({"*.wend"}).size() == 2; }, 20000));
    QVERIFY(QFile::exists(copy));
}

/// Nothing is asked at the start: the work waits as the first card, and is discarded only for good.
void TestFileWorkflow::lostWorkWaitsAsACard() {
    const QString copy = leaveLostWork(writeCutOut(*m_folder));
    QVERIFY(lostCard("lostCard"));
    QVERIFY(!QApplication::activeModalWidget());
    const QPoint card = m_window->findChild<QAbstractButton*>("lostCard")->mapTo(m_window.get(), QPoint());
    for (const FileCard* other : m_window->findChildren<FileCard*>())
        QVERIFY(other->mapTo(m_window.get(), QPoint()).y() >= card.y());
    const auto press = [&](const QString& answer) {
        answerNext(m_window.get(), answer);
        QTest::mouseClick(m_window->findChild<QAbstractButton*>("discardLost"), Qt::LeftButton);
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    press("Cancel");
    QVERIFY(QFile::exists(copy));
    press("Discard");
    QVERIFY(QTest::qWaitFor([&] { return !QFile::exists(copy); }, 20000));
    QVERIFY(!m_window->findChild<QAbstractButton*>("lostCard"));
    QVERIFY(document().isEmpty());
}

/// The requested file is opened; the banner mentions the unsaved work and recovers it.
void TestFileWorkflow::lostWorkIsReportedBesideAnotherFile() {
    leaveLostWork(writeCutOut(*m_folder));
    m_window->files().guardWork(m_copies);
    m_window->files().tellLostWhenOpened();
    m_window->openPath(writeCutOut(*m_folder, "other.png"));
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    QVERIFY(m_window->banner().text().contains("bar.png"));
    QVERIFY(document().design().handles.empty());
    QPushButton* recover = nullptr;
    for (auto* button : m_window->banner().findChildren<QPushButton*>())
        if (button->text() == "Recover") recover = button;
    QVERIFY(recover);
    QVERIFY(m_window->banner().property("offers").toBool());  // in the colour of news
    QTest::mouseClick(recover, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return document().design().handles.size() == 1; }, 20000));
    QVERIFY(document().isModified());
    QVERIFY(m_window->files().lost().isEmpty());
}

void TestFileWorkflow::changesDuringAReadingAreAskedFor() {
    const QString picture = writeCutOut(*m_folder);
    m_window->openPath(picture);
    QVERIFY(QTest::qWaitFor([&] { return !document().isEmpty(); }, 20000));
    const int generation = document().generation();
    QSignalSpy finished(&m_window->files(), &FileWorkflow::openingChanged);
    m_window->openPath(picture);  // nothing is changed yet: not asked
    addPin(document(), {40, 20}, "Pin 1");
    answerNext(m_window.get(), "Cancel");
    QVERIFY(QTest::qWaitFor([&] { return finished.size() == 2; }, 20000));  // and the question is answered
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
