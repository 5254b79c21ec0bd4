#include <QAbstractButton>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <fstream>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/window/actions/actions.h"
#include "app/window/export/export_panel.h"
#include "app/window/export/exporter.h"
#include "app/window/files/file_workflow.h"
#include "app/window/files/project_watch.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "tests/support/dialogs.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Other programs write, move or empty files that the window has open: nothing is lost without a question,
/// and the banner disappears once it no longer applies.
class TestFilesOnDisk : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void changesByOthersAreReported();
    void reloadingTakesThem();
    void keepingMineSavesOverThem();
    void savingAsksFirst();
    void twoWindowsOnOneProject();
    void ownSavesAreNoChange();
    void aFailedSaveIsForgottenByTheNext();
    void linesHoldEachForItself();
    void projectsDoNotReplaceTheirPicture();
    void transparentPicturesAreReported();
    void movedPicturesAreFound();
    void ownFilesAreAskedFor();
    void namesGetTheirExtensionBeforeTheQuestion();
    void factsOfFlatMeshesAreShown();

  private:
    void openProject();
    void pin(double x) { addPin(document(), {x, 80}, "Pin"); }
    /// Replaces the old file by a new one, as another program would.
    void writeAsOther(int vertices);
    bool told(const QString& part) {
        return QTest::qWaitFor([&] { return m_window->banner().text().contains(part); }, 60000);
    }
    bool isOpen(const QString& name) {
        return QTest::qWaitFor([&] { return document().displayName() == name; }, 60000);
    }
    bool opened(int generation) {
        return QTest::qWaitFor([&] { return document().generation() > generation; }, 60000);
    }
    void press(const QString& name);
    Document& document() { return m_window->session().document(); }
    QString file(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

std::size_t pinsIn(const QString& path) {
    return designOf(*readProject(path.toStdString()).project).handles.size();
}

}  // namespace

void TestFilesOnDisk::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1000, 700);
    m_window->show();
}

void TestFilesOnDisk::cleanup() {
    if (!document().isEmpty()) document().undoStack()->setClean();
    m_window.reset();
}

void TestFilesOnDisk::openProject() {
    writeProject(file("bar.wend").toStdString(), *barProject(writeCutOut(*m_folder)));
    m_window->openPath(file("bar.wend"));
    QVERIFY(isOpen("bar.wend"));
}

void TestFilesOnDisk::writeAsOther(int vertices) {
    writeProject(file("bar.wend").toStdString(), *barProject(file("bar.png"), vertices));
}

void TestFilesOnDisk::press(const QString& name) {
    for (QPushButton* button : m_window->banner().findChildren<QPushButton*>())
        if (button->isVisible() && button->text() == name) return button->click();
    QFAIL(qPrintable("no button " + name));
}

void TestFilesOnDisk::changesByOthersAreReported() {
    openProject();
    QVERIFY(m_window->banner().text().isEmpty());
    const std::string before = readTextFile(file("bar.wend").toStdString());
    writeAsOther(321);
    QVERIFY(told("bar.wend"));
    QVERIFY(told("another program"));
    writeTextFile(file("bar.wend").toStdString(), before);  // and back
    QVERIFY(QTest::qWaitFor([&] { return m_window->banner().text().isEmpty(); }, 60000));
}

void TestFilesOnDisk::reloadingTakesThem() {
    openProject();
    pin(40);
    writeAsOther(321);
    QVERIFY(told("another program"));
    const int generation = document().generation();
    answerNext(m_window.get(), "Cancel");
    press("Reload");
    QCOMPARE(document().design().handles.size(), std::size_t(1));
    answerNext(m_window.get(), "Reload");
    press("Reload");
    QVERIFY(opened(generation));
    QCOMPARE(document().domain().vertices, 321);
    QVERIFY(m_window->banner().text().isEmpty() && !document().isModified());
}

void TestFilesOnDisk::keepingMineSavesOverThem() {
    openProject();
    writeAsOther(321);
    QVERIFY(told("another program"));
    press("Keep Mine");
    QVERIFY(m_window->banner().text().isEmpty());
    QVERIFY(document().isModified());  // so that there is something to save
    QVERIFY(m_window->files().save());
    QCOMPARE(domainOf(*readProject(file("bar.wend").toStdString()).project).vertices, 400);
}

/// The question is asked even before the banner has appeared.
void TestFilesOnDisk::savingAsksFirst() {
    openProject();
    pin(40);
    writeAsOther(321);
    answerNext(m_window.get(), "Cancel");
    QVERIFY(!m_window->files().save());
    QCOMPARE(domainOf(*readProject(file("bar.wend").toStdString()).project).vertices, 321);
    QVERIFY(document().isModified());
    answerNext(m_window.get(), "Keep Mine");
    QVERIFY(m_window->files().save());
    QCOMPARE(domainOf(*readProject(file("bar.wend").toStdString()).project).vertices, 400);
    QCOMPARE(pinsIn(file("bar.wend")), std::size_t(1));
    QVERIFY(QTest::qWaitFor([&] { return m_window->banner().text().isEmpty(); }, 60000));
}

void TestFilesOnDisk::twoWindowsOnOneProject() {
    openProject();
    MainWindow second;
    second.show();
    second.openPath(file("bar.wend"));
    Document& theirs = second.session().document();
    QVERIFY(QTest::qWaitFor([&] { return !theirs.isEmpty(); }, 60000));
    pin(40);
    addPin(theirs, {200, 80}, "Other");
    QVERIFY(second.files().save());
    QVERIFY(told("another program or window"));
    answerNext(m_window.get(), "Cancel");
    QVERIFY(!m_window->files().save());
    QCOMPARE(pinsIn(file("bar.wend")), std::size_t(1));
    QCOMPARE(second.banner().text(), QString());
}

void TestFilesOnDisk::ownSavesAreNoChange() {
    openProject();
    const auto* watch = m_window->files().findChild<ProjectWatch*>();
    QVERIFY(watch);
    QSignalSpy changes(watch, &ProjectWatch::changed);
    for (const double x : {40, 120, 200}) {
        pin(x);
        QVERIFY(m_window->files().save());
        QVERIFY(!watch->isChanged());
        QVERIFY2(m_window->banner().text().isEmpty(), qPrintable(m_window->banner().text()));
    }
    QCOMPARE(pinsIn(file("bar.wend")), std::size_t(3));
    writeAsOther(321);
    QVERIFY(told("another program"));  // by now the watch has looked
    QCOMPARE(changes.size(), 1);
}

void TestFilesOnDisk::aFailedSaveIsForgottenByTheNext() {
    openProject();
    QDir folder(m_folder->path());
    pin(40);
    QVERIFY(folder.mkdir("kept"));
    document().save(file("kept/bar.wend"));
    pin(200);
    QVERIFY(folder.rename("kept", "away"));
    QVERIFY(!m_window->files().save());
    QVERIFY(m_window->banner().text().contains("not saved"));
    withNext<QFileDialog>(m_window.get(), [](QFileDialog& dialog) { dialog.reject(); });
    press("Save As…");  // what mends it stands beside it
    QVERIFY(m_window->banner().text().contains("not saved"));
    QVERIFY(folder.rename("away", "kept"));
    QVERIFY(m_window->files().save());
    QCOMPARE(m_window->banner().text(), QString());
    QCOMPARE(pinsIn(file("kept/bar.wend")), std::size_t(2));
}

void TestFilesOnDisk::linesHoldEachForItself() {
    using Topic = InfoBanner::Topic;
    InfoBanner banner;
    banner.tell(Topic::Shape, "no shape");
    banner.tell(Topic::Saving, "not saved");
    QCOMPARE(banner.text(), QString("not saved"));
    banner.clear(Topic::Saving);
    QCOMPARE(banner.text(), QString("no shape"));  // which still holds
    banner.tell(Topic::Export, "not written");
    banner.clear(Topic::Shape);
    QCOMPARE(banner.text(), QString("not written"));
    banner.clear(Topic::Export);
    QVERIFY(banner.text().isEmpty() && banner.isHidden());
}

void TestFilesOnDisk::projectsDoNotReplaceTheirPicture() {
    const QString picture = writeCutOut(*m_folder);
    const std::string before = readTextFile(picture.toStdString());
    m_window->openPath(picture);
    QVERIFY(isOpen("bar.png"));
    QObject scope;
    bool typed = false;
    whileAsked(&scope, [&](QWidget& asks) {
        if (auto* box = qobject_cast<QMessageBox*>(&asks)) return box->button(QMessageBox::Yes)->click();
        auto* name = asks.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        if (!name || std::exchange(typed, true)) return;
        name->setText(picture);
        QTest::keyClick(name, Qt::Key_Return);
    });
    QVERIFY(!m_window->files().saveAs());
    QVERIFY(typed && m_window->banner().text().contains("bar.png"));
    QVERIFY(readTextFile(picture.toStdString()) == before);
}

void TestFilesOnDisk::transparentPicturesAreReported() {
    QImage nothing(60, 40, QImage::Format_ARGB32);
    nothing.fill(Qt::transparent);
    nothing.save(file("nothing.png"));
    m_window->openPath(file("nothing.png"));
    QVERIFY(told("Nothing to see in this picture."));
    QVERIFY(document().isEmpty());
    press("Use Whole Frame");
    QVERIFY(opened(0));
    QCOMPARE(document().domain().outline, OutlineKind::Frame);
    QVERIFY(m_window->banner().text().isEmpty());
    m_window->openPath(file("nothing.png"));
    QVERIFY(told("Nothing to see"));
    withNext<QFileDialog>(m_window.get(), [](QFileDialog& dialog) { dialog.reject(); });
    press("Open Another…");
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(isOpen("bar.png"));
    QVERIFY(m_window->banner().text().isEmpty());
}

void TestFilesOnDisk::movedPicturesAreFound() {
    openProject();
    QDir folder(m_folder->path());
    QVERIFY(folder.mkdir("moved") && folder.rename("bar.png", "moved/bar.png"));
    MainWindow again;
    again.show();
    again.openPath(file("bar.wend"));
    QVERIFY(QTest::qWaitFor([&] { return again.banner().text() == "bar.png has moved."; }, 60000));
    nameNextFile(&again, file("moved/bar.png"));
    auto* find = again.banner().findChild<QPushButton*>();
    QCOMPARE(find->text(), QString("Find It…"));
    find->click();
    Document& found = again.session().document();
    QVERIFY(QTest::qWaitFor([&] { return !found.isEmpty(); }, 60000));
    QVERIFY(found.picture() && again.banner().text().isEmpty());
    QVERIFY(found.isModified());
    QVERIFY(again.files().save());
    QCOMPARE(domainOf(*readProject(file("bar.wend").toStdString()).project).path,
             std::string("moved/bar.png"));
}

void TestFilesOnDisk::ownFilesAreAskedFor() {
    const QString picture = writeCutOut(*m_folder);
    m_window->openPath(picture);
    QVERIFY(isOpen("bar.png"));
    Exporter& exporter = m_window->exporter();
    QVERIFY(exporter.mayReplace(ExportKind::Picture, file("other.png"), 1));
    const QString link = file("link.png");
    QVERIFY(QFile::link(picture, link));
    for (const QString& path : {picture, link, m_folder->path() + "/./bar.png"}) {
        QString asked;
        withNext<QMessageBox>(m_window.get(), [&](QMessageBox& box) {
            asked = box.text();
            box.reject();
        });
        QVERIFY2(!exporter.mayReplace(ExportKind::Picture, path, 1), qPrintable(path));
        QVERIFY2(asked.contains(QStringLiteral("picture that this project bends")), qPrintable(asked));
    }
    // Frames that exist, and one that is the picture.
    QVERIFY(QFile::copy(picture, file("f_0002.png")));
    int questions = 0;
    for (const int count : {2, 3}) {
        withNext<QMessageBox>(m_window.get(), [&](QMessageBox& box) {
            ++questions;
            for (QAbstractButton* button : box.buttons())
                if (button->text() == QStringLiteral("Replace")) return button->click();
        });
        QVERIFY(exporter.mayReplace(ExportKind::Frames, file("f_####.png"), count));
    }
    QCOMPARE(questions, 1);
}

/// The question whether to replace a file appears for old.png when “old” was typed.
void TestFilesOnDisk::namesGetTheirExtensionBeforeTheQuestion() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(isOpen("bar.png"));
    QVERIFY(settle(m_window->session()));
    writeTextFile(file("old.png").toStdString(), "precious");
    QString question;
    bool typed = false;
    QObject scope;
    whileAsked(&scope, [&](QWidget& asks) {
        if (auto* options = qobject_cast<ExportDialog*>(&asks)) {
            typed ? options->reject() : options->accept();
        } else if (auto* box = qobject_cast<QMessageBox*>(&asks)) {
            question = box->text();
            box->button(QMessageBox::No)->click();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(&asks)) {
            if (std::exchange(typed, true)) return dialog->reject();
            auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            name->setText(file("old"));
            QTest::keyClick(name, Qt::Key_Return);
        }
    });
    m_window->actions().exportPicture->trigger();
    QVERIFY2(question.contains(QStringLiteral("old.png")), qPrintable(question));
    QCOMPARE(readTextFile(file("old.png").toStdString()), std::string("precious"));
}

/// The facts about a file are shown for flat shapes as for solids; those of one file disappear when the next
/// is opened.
void TestFilesOnDisk::factsOfFlatMeshesAreShown() {
    std::ofstream(file("hanging.off").toStdString())
        << "OFF\n7 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0\n2 2 0\n1 2 0\n"
           "3 0 1 2\n3 0 2 3\n3 2 4 5\n3 2 5 6\n";
    std::ofstream(file("square.off").toStdString())
        << "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    m_window->openPath(file("hanging.off"));
    QVERIFY(told("A part is joined to the rest at a single point"));
    QVERIFY(m_window->banner().property("offers").toBool());  // nothing has gone wrong
    const auto button = [this](const char* text) -> QPushButton* {
        for (auto* one : m_window->banner().findChildren<QPushButton*>())
            if (one->text() == QLatin1String(text)) return one;
        return nullptr;
    };
    QTest::mouseClick(button("Pin It"), Qt::LeftButton);
    QVERIFY(m_window->banner().text().isEmpty());
    const auto& handles = m_window->session().document().design().handles;
    QCOMPARE(handles.size(), std::size_t(1));
    QCOMPARE(std::get<std::vector<int>>(handles[0].at).size(), std::size_t(3));  // it neither moves nor turns
    m_window->session().document().undoStack()->undo();
    QVERIFY(m_window->session().document().design().handles.empty());
    m_window->session().document().undoStack()->setClean();
    m_window->openPath(file("square.off"));
    QVERIFY(isOpen("square.off"));
    QVERIFY(QTest::qWaitFor([&] { return m_window->session().motion().frame() != nullptr; }, 60000));
    QVERIFY(m_window->banner().text().isEmpty());
}

QTEST_MAIN(TestFilesOnDisk)
#include "test_files_on_disk.moc"
