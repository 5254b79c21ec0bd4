#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QUndoStack>

#include "app/document/design.h"
#include "app/panels/fields/energy_slider.h"
#include "app/panels/material_panel.h"
#include "app/session/opening.h"
#include "app/view/actions/actions.h"
#include "app/view/actions/toolbox.h"
#include "app/view/canvas/canvas.h"
#include "app/view/files/file_workflow.h"
#include "app/view/help/first_tips.h"
#include "app/view/help/tutorial.h"
#include "app/view/main_window.h"
#include "tests/support/dialogs.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The tutorial, taken by hand: each page turns when what it says is done, and not before.
class TestTutorial : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void isTakenByHand();
    void endsWithItsButtonAndWithAnotherFile();
    void practiceIsLeftUnasked();
    void picturesOfSamplesAreNotSavedAmongThem();
    void tipsGoWhenTheyAreFollowed();
    void tipsKnowADragOfWhatHasMoved();
    void tipsAreSwitchedOff();

  private:
    FirstTips& tip() { return *m_window->findChild<FirstTips*>(); }
    bool says(const QString& text) {
        return QTest::qWaitFor([&] { return tip().isVisible() && tip().text() == text; }, 20000);
    }
    QPoint pointed(const QPointF& at) { return m_canvas->mapTo(tip().parentWidget(), at).toPoint(); }
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

/// Nothing lies over it.
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
    QCOMPARE(document.design<2>().handles.size(), std::size_t(5));
    QCOMPARE(card().page(), 2);  // it was not dragged yet
    drag(1703, 363, 1850, 800);
    QCOMPARE(card().page(), 3);
    const double phi = document.design<2>().material.phi;
    QTest::mouseClick(m_window->materialPanel().energySlider()->findChildren<QToolButton*>().last(),
                      Qt::LeftButton);
    QVERIFY(document.design<2>().material.phi != phi);
    QCOMPARE(card().page(), 4);
    m_canvas->setFocus();
    press(Qt::Key_D);
    QCOMPARE(card().page(), 5);
    press(Qt::Key_3, Qt::ControlModifier);
    QVERIFY(settle(session));
    const Vec<2> neck = session.frame<2>()->pose.col(0);  // wherever it is now, it is of the shape
    drag(neck.x(), neck.y(), neck.x() + 20, neck.y() + 20);
    QCOMPARE(document.design<2>().material.regions.size(), std::size_t(1));
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

/// What the tutorial had one do is nobody's work; what is done with it later is, and then the question says
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

/// Each is beside what it speaks of, and never comes again.
void TestTutorial::tipsGoWhenTheyAreFollowed() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(says("Click the shape to pin it"));
    QVERIFY(settle(m_window->session()));
    const Points<2> rest = m_window->session().frame<2>()->pose;
    const Vec<2> low = rest.rowwise().minCoeff(), high = rest.rowwise().maxCoeff();
    const double y = (low.y() + high.y()) / 2, left = low.x() + 0.1 * (high.x() - low.x()),
                 right = low.x() + 0.9 * (high.x() - low.x());
    click(left, y);
    click(right, y);
    QVERIFY(says("Drag the pin"));
    QVERIFY(settle(m_window->session()));
    for (const char* other : {"lasso", "pen"}) {  // which do not drag it
        m_window->tools().setMode(other == QByteArray("pen") ? Mode::Animate : Mode::Pins);
        m_window->tools().action(other)->trigger();
        QTRY_VERIFY2(!tip().isVisible(), other);
        m_window->tools().action("select")->trigger();
        QVERIFY(says("Drag the pin"));
    }
    for (QAction* without : {m_window->actions().showRest, m_window->actions().hideOverlays}) {  // pins
        without->setChecked(true);
        QTRY_VERIFY(!tip().isVisible());
        without->setChecked(false);
        QVERIFY(says("Drag the pin"));
    }
    m_window->tools().setMode(Mode::Pins);
    m_window->tools().action("pin")->trigger();
    const auto above = [&] {
        return tip().geometry().center().y() - pointed(m_canvas->toWidget({right, y})).y();
    };
    QTRY_VERIFY(std::abs(above()) <= 1);  // of whole pixels
    const int gap = tip().geometry().left() - pointed(m_canvas->toWidget({right, y})).x();
    QVERIFY2(gap > 0 && gap < 20, qPrintable(QString::number(gap)));
    m_canvas->zoomBy(0.8);  // it goes along
    QTRY_COMPARE(tip().geometry().left() - pointed(m_canvas->toWidget({right, y})).x(), gap);
    drag(right, y, right, y + 0.3 * (high.x() - low.x()));
    QVERIFY(says("Change what the shape keeps"));
    QCOMPARE(tip().geometry().right(), tip().parentWidget()->rect().right() - 2);
    auto* tiles = m_window->materialPanel().energySlider();
    QTest::mouseClick(tiles->findChildren<QToolButton*>().last(), Qt::LeftButton);
    QTRY_VERIFY(!tip().isVisible());
    QVERIFY(!m_window->actions().tips->isChecked());
    m_window->session().document().undoStack()->setClean();
    m_window = std::make_unique<MainWindow>();  // the program again
    m_window->show();
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(settle(m_window->session()));
    QTest::qWait(200);
    QVERIFY(!tip().isVisible());
    m_window->actions().tips->trigger();
    QVERIFY(says("Click the shape to pin it"));
}

/// As in a sample, whose pins come with their motions.
void TestTutorial::tipsKnowADragOfWhatHasMoved() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(says("Click the shape to pin it"));
    QVERIFY(settle(m_window->session()));
    const Points<2> rest = m_window->session().frame<2>()->pose;
    const Vec<2> low = rest.rowwise().minCoeff(), high = rest.rowwise().maxCoeff(), size = high - low;
    const double y = low.y() + 0.5 * size.y(), x = low.x() + 0.9 * size.x();
    click(low.x() + 0.1 * size.x(), y);
    click(x, y);
    drag(x, y, x, y + 0.3 * size.y());
    QVERIFY(settle(m_window->session()));
    for (int i = 0; i < 2; ++i) m_window->actions().tips->trigger();  // all of them again
    QVERIFY(says("Drag the pin"));
    drag(x, y + 0.3 * size.y(), x, y + 0.5 * size.y());
    QVERIFY(says("Change what the shape keeps"));
}

void TestTutorial::tipsAreSwitchedOff() {
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(says("Click the shape to pin it"));
    // The pointer goes through it.
    m_canvas = &m_window->canvas();
    QCOMPARE(m_window->childAt(tip().mapTo(m_window.get(), tip().rect().center())), m_canvas);
    m_window->actions().tips->trigger();
    QVERIFY(!tip().isVisible());
    m_window->actions().tips->trigger();
    QVERIFY(says("Click the shape to pin it"));
    begin();  // the tutorial says more
    QVERIFY(!tip().isVisible());
}

QTEST_MAIN(TestTutorial)
#include "test_tutorial.moc"
