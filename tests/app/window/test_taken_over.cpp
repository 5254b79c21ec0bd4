// Data that the document takes from other files: another picture, the motion of another project, a group of
// the mesh's file as a pin.

#include <QApplication>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

#include "app/engine/shape/shape.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/group_list.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/file/project_writer.h"
#include "app/project/file/text_file.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"
#include "app/window/files/taken_over.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "app/window/properties.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"
#include "warp/image.h"

using namespace wend;
using namespace wend::test;

class TestTakenOver : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void aRepaintedPictureIsOffered();
    void keepingLeavesIt();
    void aLargerPictureTakesThePinsAlong();
    void otherProportionsAreRefused();
    void aPictureOfAnotherSizeIsFittedWhenOpened();
    void oldProjectsStayAsTheyAre();
    void drawingsHaveAnySize_data();
    void drawingsHaveAnySize();
    void sizesOfDrawingsFollowEachOther();
    void motionOfAnotherProject();
    void exportChoicesBelongToTheDocument();
    void groupsBecomePins();

  private:
    Document& document() { return m_window->session().document(); }
    bool open(const QString& path) {
        m_window->openPath(path);
        return QTest::qWaitFor([&] { return !document().isEmpty() && document().source() == path; }, 20000) &&
               settle(m_window->session());
    }
    QPushButton* remedy(const char* text) {
        for (auto* button : m_window->banner().findChildren<QPushButton*>())
            if (button->text() == text && button->isVisible()) return button;
        return nullptr;
    }
    bool hasSaid(const char* what) {
        return QTest::qWaitFor([&] { return m_window->banner().text().contains(what); }, 20000);
    }
    PictureKeeper& pictures() { return *m_window->findChild<PictureKeeper*>(); }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

/// Writes the cut-out in other colours, or at another size.
void repaint(const QString& path, const QSize& size = {}) {
    QImage image(path);
    if (size.isValid()) image = image.scaled(size);
    image.invertPixels();
    image.save(path);
}

}  // namespace

void TestTakenOver::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1500, 950);  // with the properties beside the shape
    m_window->show();
}

void TestTakenOver::cleanup() {
    if (!document().isEmpty()) document().undoStack()->setClean();
    m_window.reset();
}

void TestTakenOver::aRepaintedPictureIsOffered() {
    const QString path = writeCutOut(*m_folder);
    QVERIFY(open(path));
    const auto before = document().picture();
    repaint(path);
    QVERIFY(hasSaid("was changed by another program"));
    QTest::mouseClick(remedy("Reload"), Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return document().picture() != before; }, 20000));
    QVERIFY(settle(m_window->session()));
    QCOMPARE(m_window->banner().text(), QString());
    QVERIFY(document().picture()->data != before->data);
    QCOMPARE(posed<2>(m_window->session().motion().frame())->built->picture, document().picture());
    document().undoStack()->undo();
    QCOMPARE(document().picture(), before);
    document().undoStack()->redo();
    QVERIFY(document().picture() != before);
}

void TestTakenOver::keepingLeavesIt() {
    const QString path = writeCutOut(*m_folder);
    QVERIFY(open(path));
    const auto before = document().picture();
    repaint(path);
    QVERIFY(hasSaid("was changed by another program"));
    QTest::mouseClick(remedy("Keep"), Qt::LeftButton);
    QCOMPARE(m_window->banner().text(), QString());
    QCOMPARE(document().picture(), before);
    QVERIFY(!document().isModified());
}

void TestTakenOver::aLargerPictureTakesThePinsAlong() {
    QVERIFY(open(writeCutOut(*m_folder)));
    addPin(document(), {60, 80}, "left");
    const QString large = writeCutOut(*m_folder, "large.png");
    repaint(large, {720, 480});
    QSignalSpy fits(m_window->actions().fit, &QAction::triggered);
    pictures().replace(large);
    QVERIFY(
        QTest::qWaitFor([&] { return document().picture() && document().picture()->width == 720; }, 20000));
    const auto placed = [&] { return std::get<std::vector<Vec3>>(document().design().handles[0].at)[0]; };
    QCOMPARE(placed(), Vec3(180, 240, 0));
    QCOMPARE(document().domain().path, large.toStdString());
    QVERIFY(hasSaid("720 × 480"));
    QCOMPARE(fits.count(), 1);  // all of it is seen
    QVERIFY(settle(m_window->session()));
    document().undoStack()->undo();
    QCOMPARE(placed(), Vec3(60, 80, 0));
    QCOMPARE(document().picture()->width, 240);
}

void TestTakenOver::otherProportionsAreRefused() {
    QVERIFY(open(writeCutOut(*m_folder)));
    const auto before = document().project();
    const QString square = writeCutOut(*m_folder, "square.png");
    repaint(square, {300, 300});
    pictures().replace(square);
    QVERIFY(hasSaid("other proportions"));
    QCOMPARE(document().project(), before);
}

/// The project records the size that it was made for.
void TestTakenOver::aPictureOfAnotherSizeIsFittedWhenOpened() {
    const QString path = writeCutOut(*m_folder), project = m_folder->filePath("bar.wend");
    QVERIFY(open(path));
    addPin(document(), {60, 80}, "left");
    document().save(project);
    document().close();
    repaint(path, {480, 320});
    QVERIFY(open(project));
    QCOMPARE(std::get<std::vector<Vec3>>(document().design().handles[0].at)[0], Vec3(120, 160, 0));
    QVERIFY(hasSaid("480 × 320"));
}

/// Older projects are saved without keys that they did not have.
void TestTakenOver::oldProjectsStayAsTheyAre() {
    const QString path = writeCutOut(*m_folder), project = m_folder->filePath("bar.wend");
    QVERIFY(open(path));
    addPin(document(), {60, 80}, "left");
    Project old = *document().project();
    old.domain.size = {};
    writeProject(project.toStdString(), old);
    const std::string before = readTextFile(project.toStdString());
    document().close();
    QVERIFY(open(project));
    document().save(project);
    QCOMPARE(readTextFile(project.toStdString()), before);
}

void TestTakenOver::drawingsHaveAnySize_data() {
    QTest::addColumn<QByteArray>("shapes");
    QTest::addColumn<int>("parts");
    const QByteArray disc = "<circle cx='20' cy='20' r='12'/>",
                     eye = "<rect x='24' y='12' width='8' height='8'/>";
    QTest::newRow("one sheet") << QByteArray("<g>" + disc + eye + "</g>") << 0;
    QTest::newRow("parts") << QByteArray("<g id='body'>" + disc + "</g><g id='eye'>" + eye + "</g>") << 2;
}

/// Pins are at the same places of the drawing, at once and when the project is opened again.
void TestTakenOver::drawingsHaveAnySize() {
    QFETCH(QByteArray, shapes);
    QFETCH(int, parts);
    const QString path = m_folder->filePath("drawing.svg");
    writeTextFile(path.toStdString(), "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>" +
                                          shapes.toStdString() + "</svg>");
    QVERIFY(open(path));
    QCOMPARE(int(document().domain().parts.size()), parts);
    QCOMPARE(document().domain().size, (DrawnSize{1040, 1040}));  // 26 for 1
    QStringList offered;
    for (const auto* button : m_window->banner().findChildren<QAbstractButton*>()) offered << button->text();
    QVERIFY2(offered.contains("Another Size…"), qPrintable(offered.join(", ")));
    addPin(document(), {520, 520}, "middle");
    pictures().redraw({400, 400});
    QVERIFY(
        QTest::qWaitFor([&] { return document().picture() && document().picture()->width == 400; }, 20000));
    const auto placed = [&] { return std::get<std::vector<Vec3>>(document().design().handles[0].at)[0]; };
    QVERIFY((placed() - Vec3(200, 200, 0)).norm() < 1e-9);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(canvasSize(*posed<2>(m_window->session().motion().frame())->built), (std::array{400, 400}));
    const QString project = m_folder->filePath("drawing.wend");
    document().save(project);
    QVERIFY(open(project));
    QCOMPARE(canvasSize(*posed<2>(m_window->session().motion().frame())->built), (std::array{400, 400}));
    QVERIFY((placed() - Vec3(200, 200, 0)).norm() < 1e-9);
}

/// Width, height and percent of the size in which a drawing opens follow each other.
void TestTakenOver::sizesOfDrawingsFollowEachOther() {
    DrawingSizeDialog dialog({2080, 1040}, {1040, 520}, nullptr);
    const auto sides = dialog.findChildren<QSpinBox*>();
    auto* percent = dialog.findChild<QDoubleSpinBox*>();
    QCOMPARE(sides.size(), 2);
    QCOMPARE(percent->value(), 200.0);
    percent->setValue(50);
    QCOMPARE(dialog.size(), (DrawnSize{520, 260}));
    sides[1]->setValue(1040);
    QCOMPARE(dialog.size(), (DrawnSize{2080, 1040}));
    QCOMPARE(percent->value(), 200.0);
}

void TestTakenOver::motionOfAnotherProject() {
    QVERIFY(open(writeCutOut(*m_folder)));
    addPin(document(), {60, 80}, "left");
    addPin(document(), {180, 80}, "right");
    Project moving = *document().project();
    moving.domain.path = m_folder->filePath("bar.png").toStdString();
    moving.design.handles[1].motions = {{Translate<3>{{0, -20, 0}}, 0, 2}};
    moving.end = 2;
    const QString file = m_folder->filePath("moving.wend");
    writeProject(file.toStdString(), moving);
    m_window->findChild<MotionChooser*>()->apply(file);
    QVERIFY(QTest::qWaitFor([&] { return document().end() == 2; }, 60000));
    const auto& handles = document().design().handles;
    QVERIFY(handles[0].motions.empty());
    QCOMPARE(std::get<Translate<3>>(handles[1].motions[0].kind).by, Vec3(0, -20, 0));
    QCOMPARE(document().undoStack()->undoText(), QString("Apply motion of moving.wend"));
    m_window->findChild<MotionChooser*>()->apply(m_folder->filePath("none.wend"));
    QVERIFY(hasSaid("This motion cannot be applied"));
}

void TestTakenOver::exportChoicesBelongToTheDocument() {
    QVERIFY(open(writeCutOut(*m_folder)));
    auto* panel = m_window->properties().findChild<ExportPanel*>();
    OptionField* outside = panel->form().field("--outside");
    const std::string usual = outside->value();
    outside->setValue("white");
    QVERIFY(outside->value() != usual);
    QVERIFY(open(writeCutOut(*m_folder, "other.png")));
    QCOMPARE(outside->value(), usual);
}

void TestTakenOver::groupsBecomePins() {
    const QString path = m_folder->filePath("strip.obj");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 1; ++j) file.write(QStringLiteral("v %1 %2 0\n").arg(i).arg(j).toUtf8());
    for (int i = 0; i < 4; ++i) {
        const int a = 2 * i + 1;
        file.write(i == 0 ? "g left\n" : i == 3 ? "g right\n" : "g middle\n");
        file.write(
            QStringLiteral("f %1 %2 %3\nf %1 %3 %4\n").arg(a).arg(a + 2).arg(a + 3).arg(a + 1).toUtf8());
    }
    file.close();
    QVERIFY(open(path));
    m_window->tools().setMode(Mode::Pins);
    GroupList& groups = m_window->properties().groups();
    QVERIFY(QTest::qWaitFor([&] { return groups.list()->count() == 3; }, 20000));
    QVERIFY(groups.list()->isVisible());
    groups.list()->setCurrentRow(0);
    QTest::mouseClick(groups.holdButton(), Qt::LeftButton);
    const auto& handles = document().design().handles;
    QCOMPARE(handles.size(), std::size_t(1));
    QCOMPARE(handles[0].name, std::string("left"));
    QCOMPARE(std::get<std::vector<int>>(handles[0].at), std::vector<int>({0, 1, 2, 3}));
    QVERIFY(toJson(*document().project()).find("\"group\": \"left\"") != std::string::npos);
    QCOMPARE(m_window->session().selection().single(), 0);
    document().undoStack()->setClean();  // nothing is asked
    QVERIFY(open(writeCutOut(*m_folder)));
    QVERIFY(!groups.list()->isVisible());
}

QTEST_MAIN(TestTakenOver)
#include "test_taken_over.moc"
