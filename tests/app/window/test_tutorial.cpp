#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QUndoStack>

#include "app/panels/fields/energy_slider.h"
#include "app/panels/material_panel.h"
#include "app/project/design.h"
#include "app/session/opening.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/files/file_workflow.h"
#include "app/window/help/help.h"
#include "app/window/main_window.h"
#include "tests/support/dialogs.h"
#include "tests/support/layers.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The tutorial, followed by hand: each page turns when its task is done, and not before.
class TestTutorial : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void isTakenByHand();
    void endsWithItsButtonAndWithAnotherFile();
    void practiceIsLeftUnasked();
    void picturesOfSamplesAreNotSavedAmongThem();

  private:
    void begin();
    bool isSeen();
    Tutorial& card() { return *m_window->findChild<Tutorial*>(); }
    QPushButton& button(const char* text) {
        for (auto* one : card().findChildren<QPushButton*>())
            if (one->text() == QLatin1String(text)) return *one;
        throw std::logic_error(text);
    }
    void click(double x, double y) {
        QTest::mouseClick(m_canvas, Qt::LeftButton, {}, m_canvas->toWidget({x, y}).toPoint());
    }
    void drag(double x, double y, double toX, double toY);

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
    ShapeCanvas* m_canvas = nullptr;
};

void TestTutorial::init() {
    m_window.reset();
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1366, 768);
    QVERIFY(showActive(*m_window));
    m_canvas = m_window->findChild<ShapeCanvas*>();
}

void TestTutorial::begin() {
    QTest::mouseClick(m_window->findChild<QPushButton*>(QStringLiteral("startTutorial")), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(card().isVisible(), 30000);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(card().page(), 0);
    QVERIFY(isSeen());
}

/// Checks that nothing covers it.
bool TestTutorial::isSeen() {
    const QWidget* there = m_window->childAt(card().mapTo(m_window.get(), QPoint(3, 3)));
    return there == &card();
}

void TestTutorial::drag(double x, double y, double toX, double toY) {
    const auto at = [this](double px, double py) { return m_canvas->toWidget({px, py}).toPoint(); };
    QTest::mousePress(m_canvas, Qt::LeftButton, {}, at(x, y));
    for (int k = 1; k <= 8; ++k)
        QTest::mouseMove(m_canvas, at(x + k / 8.0 * (toX - x), y + k / 8.0 * (toY - y)));
    QTest::mouseRelease(m_canvas, Qt::LeftButton, {}, at(toX, toY));
    QVERIFY(settle(m_window->session()));
}

/// The places are those of the drawing: hooves, nose, neck.
void TestTutorial::isTakenByHand() {
    begin();
    ShapeSession& session = m_window->session();
    const auto& document = session.document();
    const auto press = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(m_canvas, key, modifiers);
    };
    click(517, 2242);
    QCOMPARE(card().page(), 1);
    click(708, 2211);
    click(923, 2209);
    QCOMPARE(card().page(), 1);  // one is left
    click(1112, 2238);
    QCOMPARE(card().page(), 2);
    click(1703, 363);
    QVERIFY(settle(session));
    QCOMPARE(document.design().handles.size(), std::size_t(5));
    QCOMPARE(card().page(), 2);  // it was not dragged yet
    drag(1703, 363, 1850, 800);
    QCOMPARE(card().page(), 3);
    const double phi = document.design().material.phi;
    QTest::mouseClick(m_window->materialPanel().energySlider()->findChildren<QToolButton*>().last(),
                      Qt::LeftButton);
    QVERIFY(document.design().material.phi != phi);
    QCOMPARE(card().page(), 4);
    m_canvas->setFocus();
    press(Qt::Key_D);
    QCOMPARE(card().page(), 5);
    press(Qt::Key_3, Qt::ControlModifier);
    QVERIFY(settle(session));
    const Vec2 neck = session.motion().frame<2>()->pose.col(0);  // wherever it is now, it is of the shape
    drag(neck.x(), neck.y(), neck.x() + 20, neck.y() + 20);
    QCOMPARE(regionsIn(document.design()).size(), std::size_t(1));
    QCOMPARE(card().page(), 6);
    press(Qt::Key_K);
    QCOMPARE(card().page(), 7);
    press(Qt::Key_K);
    press(Qt::Key_5, Qt::ControlModifier);
    QCOMPARE(card().page(), 8);
    QCOMPARE(card().page() + 1, card().pageCount());
    QTest::mouseClick(&button("Done"), Qt::LeftButton);
    QVERIFY(!card().isVisible());
    QVERIFY(!document.isEmpty());  // what was made stays
}

void TestTutorial::endsWithItsButtonAndWithAnotherFile() {
    begin();
    QTest::mouseClick(&button("Skip"), Qt::LeftButton);
    QCOMPARE(card().page(), 1);
    QTest::mouseClick(&button("End"), Qt::LeftButton);
    QVERIFY(!card().isVisible());
    click(517, 2242);
    QVERIFY(!card().isVisible());
    m_window->session().document().undoStack()->undo();
    m_window->findChild<Tutorial*>()->begin();
    m_window->openPath(writeCutOut(*m_folder));
    QTRY_COMPARE(m_window->session().document().displayName(), QStringLiteral("bar.png"));
    QVERIFY(!card().isVisible());
}

/// Changes made for the tutorial are not treated as unsaved work; later ones are, and the question then says
/// that the picture stays as it is.
void TestTutorial::practiceIsLeftUnasked() {
    QStringList asked;
    whileAsked(m_window.get(), [&asked](QWidget& dialog) {
        auto* box = qobject_cast<QMessageBox*>(&dialog);
        asked << (box ? box->text() + ' ' + box->informativeText() : QString());
        static_cast<QDialog&>(dialog).reject();
    });
    begin();
    click(517, 2242);
    QVERIFY(m_window->session().document().isModified());
    const int generation = m_window->session().document().generation();
    m_window->actions().tutorial->trigger();  // from the beginning
    QTRY_VERIFY_WITH_TIMEOUT(m_window->session().document().generation() > generation, 30000);
    QVERIFY(asked.isEmpty());
    QCOMPARE(card().page(), 0);
    QVERIFY(m_window->files().recent().isEmpty());
    QVERIFY(settle(m_window->session()));
    click(517, 2242);
    QTest::mouseClick(&button("End"), Qt::LeftButton);
    QVERIFY(m_window->files().mayLeave() && asked.isEmpty());
    click(708, 2211);
    QVERIFY(!m_window->files().mayLeave());
    QCOMPARE(asked.size(), 1);
    QVERIFY2(asked[0].contains("what you made of “giraffe.png”") && asked[0].contains("stays as it is"),
             qPrintable(asked[0]));
    m_window->session().document().undoStack()->setClean();
}

void TestTutorial::picturesOfSamplesAreNotSavedAmongThem() {
    begin();
    const QString folder = proposedFolder(m_window->session().document());
    QVERIFY(folder != QFileInfo(Tutorial::picture()).absolutePath());
    QVERIFY(!folder.isEmpty());
}

QTEST_MAIN(TestTutorial)
#include "test_tutorial.moc"
