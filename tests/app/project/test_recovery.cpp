#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/recovery.h"
#include "app/project/file/project_reader.h"
#include "tests/support/projects.h"

using namespace wend;

/// Copies of unsaved work: they exist while they are needed, and are found after a crash.
class TestRecovery : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void aChangeIsCopied();
    void copiesArePrivate();
    void savingAndUndoingTakeTheCopyAway();
    void runningProgramsLoseNothing();
    void anUnwritableFolderIsReportedOnce();
    void recoveredWorkIsUnsaved();

  private:
    void addPin();
    void addPinAndWait(Recovery& recovery);
    QStringList filesLeft() const { return QDir(m_folder->path()).entryList(QDir::Files); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Document> m_document;
};

namespace {

/// Makes the remains of a crash from a copy: everything but the lock of a living process.
QString crashed(const QString& copy, const QString& folder) {
    const QString base = QDir(folder).filePath(QStringLiteral("crashed"));
    QFile::copy(copy, base + ".wend");
    QFile::copy(QString(copy).replace(".wend", ".ini"), base + ".ini");
    return base + ".wend";
}

}  // namespace

void TestRecovery::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_document = std::make_unique<Document>();
    OpenedFile file;
    const auto project = newProject();
    domainOf(*project).path = "/pictures/frog.png";
    file.project = project;
    file.path = QStringLiteral("/pictures/frog.wend");
    file.source = file.path;
    m_document->open(std::move(file));
}

void TestRecovery::addPin() {
    test::addPin(*m_document, {1, 2}, freeName(namesOf(m_document->design().handles), "Pin"));
}

void TestRecovery::addPinAndWait(Recovery& recovery) {
    QSignalSpy written(&recovery, &Recovery::written);
    addPin();
    QVERIFY(written.wait());
}

void TestRecovery::aChangeIsCopied() {
    Recovery recovery(*m_document, m_folder->path(), 0);
    addPinAndWait(recovery);
    QCOMPARE(designOf(*readProject(recovery.copy().toStdString()).project).handles.size(), std::size_t(1));
    addPinAndWait(recovery);
    QCOMPARE(designOf(*readProject(recovery.copy().toStdString()).project).handles.size(), std::size_t(2));
}

/// Only the user can read unsaved work, in whatever folder the copies were before.
void TestRecovery::copiesArePrivate() {
    const QString folder = m_folder->filePath(QStringLiteral("copies"));
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(QFile::setPermissions(folder, QFile::Permissions(0x7755)));
    Recovery recovery(*m_document, folder, 0);
    addPinAndWait(recovery);
    const auto rights = [](QFile::Permissions all) { return static_cast<int>(all) & 0x7077; };
    QCOMPARE(rights(QFile::permissions(folder)), 0x7000);
    const QFileInfoList files = QDir(folder).entryInfoList(QDir::Files | QDir::Hidden);
    QCOMPARE(files.size(), 3);
    for (const QFileInfo& info : files) QCOMPARE(rights(info.permissions()), 0x6000);
}

void TestRecovery::savingAndUndoingTakeTheCopyAway() {
    {
        Recovery recovery(*m_document, m_folder->path(), 0);
        addPinAndWait(recovery);
        m_document->undoStack()->undo();
        QCOMPARE(filesLeft(), QStringList());
        addPinAndWait(recovery);
        QTemporaryDir elsewhere;
        m_document->save(elsewhere.filePath("saved.wend"));
        QCOMPARE(filesLeft(), QStringList());
        addPinAndWait(recovery);
        QCOMPARE(filesLeft().size(), 3);
    }
    QCOMPARE(filesLeft(), QStringList());  // the end of the program
}

void TestRecovery::runningProgramsLoseNothing() {
    Recovery recovery(*m_document, m_folder->path(), 0);
    addPinAndWait(recovery);
    QVERIFY(Recovery::lostIn(m_folder->path()).isEmpty());
    QTemporaryDir after;
    crashed(recovery.copy(), after.path());
    const QList<LostWork> lost = Recovery::lostIn(after.path());
    QCOMPARE(lost.size(), 1);
    QCOMPARE(lost[0].path, m_document->path());
    QCOMPARE(lost[0].source, m_document->source());
    Recovery::discard(lost[0].copy);
    QCOMPARE(QDir(after.path()).entryList(QDir::Files), QStringList());
}

void TestRecovery::anUnwritableFolderIsReportedOnce() {
    QFile file(m_folder->filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    Recovery recovery(*m_document, m_folder->filePath("file/folder"), 0);
    QSignalSpy failed(&recovery, &Recovery::failed);
    addPin();
    QVERIFY(failed.wait());
    addPin();
    QVERIFY(!failed.wait(200));
}

void TestRecovery::recoveredWorkIsUnsaved() {
    OpenedFile file;
    file.project = newProject();
    file.recoveredFrom = QStringLiteral("copy.wend");
    m_document->open(std::move(file));
    QVERIFY(m_document->isModified());
    Recovery recovery(*m_document, m_folder->path(), 0);
    addPinAndWait(recovery);
    m_document->undoStack()->undo();
    QVERIFY(m_document->isModified());
    QVERIFY(!filesLeft().isEmpty());
}

QTEST_GUILESS_MAIN(TestRecovery)
#include "test_recovery.moc"
