// The keyboard focus: on the next likely widget when the window opens, and back on the shape when the focused
// widget disappears.
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QToolButton>

#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/notices/info_banner.h"
#include "app/window/properties.h"
#include "tests/support/window_test.h"

using namespace wend;
using namespace wend::test;

class TestFocus : public WindowTest {
    Q_OBJECT
  private slots:
    void init() { begin(); }
    void cleanup() { end(); }
    void startPageBeginsWithOpening();
    void pressedButtonsOfTheBannerGiveItBack_data();
    void pressedButtonsOfTheBannerGiveItBack();
    void restOfTheBannerKeepsIt();
    void hiddenPanelsGiveItBack();
    void closedFilesGiveItToTheStartPage();
};

void TestFocus::startPageBeginsWithOpening() {
    auto* open = m_window->findChild<QPushButton*>(QStringLiteral("startOpen"));
    QVERIFY(open->hasFocus());
    m_window->findChild<QPushButton*>(QStringLiteral("startTutorial"))->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(open->hasFocus());
}

void TestFocus::pressedButtonsOfTheBannerGiveItBack_data() {
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("space bar") << true;
}
void TestFocus::pressedButtonsOfTheBannerGiveItBack() {
    QFETCH(bool, byKey);
    open();
    InfoBanner& banner = m_window->banner();
    const auto pressed = [&](QAbstractButton* button) {
        button->setFocus();
        if (!button->hasFocus()) return false;
        byKey ? QTest::keyClick(button, Qt::Key_Space) : QTest::mouseClick(button, Qt::LeftButton);
        return !banner.isVisible() && m_window->canvas().hasFocus();
    };
    const auto goes = [&banner] { banner.clear(InfoBanner::Topic::Border); };
    banner.tell(InfoBanner::Topic::Border, QStringLiteral("An offer."), {{QStringLiteral("Take it"), goes}});
    QVERIFY(pressed(banner.findChild<QPushButton*>()));
    banner.tell(InfoBanner::Topic::Mesh, QStringLiteral("A remark."));
    QVERIFY(pressed(banner.findChild<QToolButton*>()));
}

/// Closing one line of the banner moves the focus to the next.
void TestFocus::restOfTheBannerKeepsIt() {
    open();
    InfoBanner& banner = m_window->banner();
    banner.tell(InfoBanner::Topic::Mesh, QStringLiteral("First."));
    banner.tell(InfoBanner::Topic::Export, QStringLiteral("Second."));
    auto* close = banner.findChild<QToolButton*>();
    close->setFocus();
    QTest::keyClick(close, Qt::Key_Space);
    QVERIFY(banner.text() == QStringLiteral("First.") && close->hasFocus());
    QTest::keyClick(close, Qt::Key_Space);
    QVERIFY(m_window->canvas().hasFocus());
}

/// The focus returns whether one step's panel or all panels are hidden.
void TestFocus::hiddenPanelsGiveItBack() {
    open();
    const auto focusedIn = [this](Mode mode) {
        m_window->tools().modeAction(mode)->trigger();
        for (QComboBox* box : m_window->properties().findChildren<QComboBox*>()) {
            if (!box->isVisible() || !box->isEnabled()) continue;
            box->setFocus();
            return box->hasFocus();
        }
        return false;
    };
    QVERIFY(focusedIn(Mode::Mesh));
    m_window->tools().modeAction(Mode::Export)->trigger();
    QVERIFY(m_window->canvas().hasFocus());
    QVERIFY(focusedIn(Mode::Mesh));
    m_window->actions().showProperties->trigger();
    QVERIFY(m_window->canvas().hasFocus());
}

void TestFocus::closedFilesGiveItToTheStartPage() {
    open();
    m_window->session().document().undoStack()->setClean();
    m_window->actions().closeFile->trigger();
    QVERIFY(m_window->findChild<QPushButton*>(QStringLiteral("startOpen"))->hasFocus());
}

QTEST_MAIN(TestFocus)
#include "test_focus.moc"
