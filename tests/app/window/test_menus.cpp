#include <QAbstractButton>
#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScopeGuard>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>

#include "app/engine/motion/drag_gesture.h"
#include "app/project/design.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/main_window.h"
#include "app/window/notices/info_banner.h"
#include "tests/support/projects.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// Keys and menus of the whole window, wherever the focus is.
class TestMenus : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void altKeysOpenMenus();
    void lettersAreUnique_data();
    void lettersAreUnique();
    void holdingHWorksEverywhere();
    void lettersAreTypedWhereTextIs();
    void exportIsAMenu();
    void deleteRemovesAllThatAreSelected();
    void refusedDragsStayWithTheShape();

  private:
    QPoint at(double x, double y) const { return m_window->canvas().toWidget({x, y}).toPoint(); }
    void click(Qt::MouseButton button, double x, double y, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseMove(&m_window->canvas(), at(x, y));
        QTest::mouseClick(&m_window->canvas(), button, keys, at(x, y));
    }
    QMenu* popup() const { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); }
    const std::vector<Pin>& handles() { return m_window->session().document().design().handles; }

    std::unique_ptr<TestFolder> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestMenus::init() {
    m_folder = std::make_unique<TestFolder>();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1100, 800);
    QVERIFY(showActive(*m_window));
    m_window->openPath(writeCutOut(*m_folder));
    QVERIFY(QTest::qWaitFor([&] { return !m_window->session().document().isEmpty(); }, 20000));
    setVertices(m_window->session().document(), 300);
    QVERIFY(settle(m_window->session()));
    m_window->canvas().setFocus();
}

void TestMenus::cleanup() {
    if (QMenu* open = popup()) open->close();
    if (!m_window->session().document().isEmpty()) m_window->session().document().undoStack()->setClean();
    m_window.reset();
}

/// No panel has the key of a menu, whether it is visible now or belongs to other documents.
void TestMenus::altKeysOpenMenus() {
    QMap<QString, QString> menus;
    for (const QAction* action : m_window->menuBar()->actions())
        menus[QKeySequence::mnemonic(action->text()).toString()] = action->text();
    QVERIFY(menus.contains("Alt+E") && menus.contains("Alt+V") && menus.contains("Alt+M"));
    const auto isFree = [&menus](const QString& text) {
        return !menus.contains(QKeySequence::mnemonic(text).toString());
    };
    for (const QLabel* label : m_window->findChildren<QLabel*>())
        QVERIFY2(!label->buddy() || isFree(label->text()), qPrintable(label->text()));
    for (const QAbstractButton* button : m_window->findChildren<QAbstractButton*>())
        QVERIFY2(qobject_cast<const QToolButton*>(button) || isFree(button->text()),
                 qPrintable(button->text()));
    for (const Qt::Key key : {Qt::Key_E, Qt::Key_V, Qt::Key_M}) {
        QTest::keyClick(m_window.get(), key, Qt::AltModifier);
        QVERIFY(QTest::qWaitFor([&] { return popup() != nullptr; }, 5000));
        QCOMPARE(QKeySequence::mnemonic(popup()->title()), QKeySequence(Qt::ALT | key));
        popup()->close();
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(QTest::qWaitFor([&] { return popup() == nullptr; }, 5000));
    }
}

void TestMenus::lettersAreUnique_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "";
    for (const char* language : {"de", "fr", "es", "ja", "zh_CN"}) QTest::newRow(language) << language;
}

namespace {

/// Returns the entries of a menu and its submenus that share a letter.
QStringList sharedLetters(const QMenu& menu) {
    QStringList shared;
    QMap<QString, QString> owner;
    for (const QAction* action : menu.actions()) {
        if (action->menu()) shared += sharedLetters(*action->menu());
        const QString letter = QKeySequence::mnemonic(action->text()).toString();
        if (letter.isEmpty() || !action->isVisible()) continue;
        if (owner.contains(letter))
            shared << menu.title() + ": " + letter + ": " + owner[letter] + ", " + action->text();
        owner[letter] = action->text();
    }
    return shared;
}

}  // namespace

/// A letter opens one entry, and does not cycle among several.
void TestMenus::lettersAreUnique() {
    QFETCH(QString, language);
    QTranslator translator;
    if (!language.isEmpty()) {
        QVERIFY(translator.load(":/i18n/wend_" + language + ".qm"));
        QVERIFY(QApplication::installTranslator(&translator));
    }
    const auto back = qScopeGuard([&translator] { QApplication::removeTranslator(&translator); });
    const MainWindow window;
    QStringList shared;
    for (const QAction* action : window.menuBar()->actions()) shared += sharedLetters(*action->menu());
    QVERIFY2(shared.isEmpty(), qPrintable(shared.join('\n')));
}

void TestMenus::holdingHWorksEverywhere() {
    click(Qt::LeftButton, 120, 80);
    QVERIFY(settle(m_window->session()));
    ShapeCanvas& canvas = m_window->canvas();
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QPoint ring = at(120, 80) + QPoint(7, 0);  // of the pin
    const auto view = [&] { return canvas.grab().toImage().pixel(ring); };
    const QRgb shown = view();
    QList<QWidget*> places{&canvas};
    for (QWidget* widget : m_window->findChildren<QWidget*>())
        if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() & Qt::TabFocus &&
            !qobject_cast<QLineEdit*>(widget))
            places << widget;
    QVERIFY(places.size() > 8);
    for (QWidget* place : places) {
        place->setFocus();
        QTest::keyPress(place, Qt::Key_H);
        const bool hidden = view() != shown;
        QTest::keyRelease(place, Qt::Key_H);
        QVERIFY2(hidden, place->metaObject()->className());
        QVERIFY2(view() == shown, place->metaObject()->className());
    }
    // It does not show items that were hidden permanently.
    m_window->actions().hideOverlays->setChecked(true);
    QTest::keyClick(&canvas, Qt::Key_H);
    QVERIFY(view() != shown);
    m_window->actions().hideOverlays->setChecked(false);
    QVERIFY(view() == shown);
}

void TestMenus::lettersAreTypedWhereTextIs() {
    QLineEdit name(m_window.get());
    name.show();
    name.setFocus();
    QTest::keyClick(&name, Qt::Key_H);
    QCOMPARE(name.text(), QString("h"));
}

void TestMenus::exportIsAMenu() {
    const Actions& actions = m_window->actions();
    auto* button = m_window->findChild<QToolButton*>(QStringLiteral("exportButton"));
    QVERIFY(button && button->isVisible() && button->menu() == actions.exports.get());
    const QList<QAction*> all = button->menu()->actions();
    for (QAction* one : {actions.exportPicture, actions.exportFrames, actions.exportStMap, actions.exportMesh,
                         actions.exportView})
        QVERIFY(all.contains(one));
    QVERIFY(actions.exportPicture->isEnabled() && actions.exportMesh->isEnabled());
    QVERIFY(!actions.exportFrames->isEnabled());
    QVERIFY(actions.exportFrames->toolTip().contains("drag a pin"));
    // The same happens beside the entry.
    button->menu()->popup({100, 100});
    const auto tipOf = [&](QAction* entry) {
        QToolTip::hideText();
        if (!QTest::qWaitFor([] { return !QToolTip::isVisible(); })) return QStringLiteral("the last one");
        const QPoint at = button->menu()->actionGeometry(entry).center();
        QHelpEvent help(QEvent::ToolTip, at, button->menu()->mapToGlobal(at));
        QApplication::sendEvent(button->menu(), &help);
        return QToolTip::text();
    };
    QVERIFY(tipOf(actions.exportFrames).contains("drag a pin"));
    QCOMPARE(tipOf(actions.exportMesh), QString());
    button->menu()->close();
}

void TestMenus::deleteRemovesAllThatAreSelected() {
    for (const double x : {40, 90, 150, 200}) click(Qt::LeftButton, x, 80);
    QVERIFY(settle(m_window->session()));
    const std::string first = handles()[0].name, third = handles()[2].name;
    click(Qt::LeftButton, 90, 80);
    click(Qt::LeftButton, 200, 80, Qt::ShiftModifier);
    QCOMPARE(m_window->session().selection().handles().size(), std::size_t(2));
    QTest::keyClick(m_window.get(), Qt::Key_Delete);
    QVERIFY(settle(m_window->session()));
    QCOMPARE(handles().size(), std::size_t(2));
    QCOMPARE(handles()[0].name, first);
    QCOMPARE(handles()[1].name, third);
    m_window->actions().undo->trigger();  // in one step
    QCOMPARE(handles().size(), std::size_t(4));
}

/// Where the shape stops, its pin stops.
void TestMenus::refusedDragsStayWithTheShape() {
    DragGesture gesture({0}, {});
    const int first = gesture.add(Amount(10, 0, 0)), second = gesture.add(Amount(20, 0, 0));
    PosedFrame<2> frame;
    frame.live = true;
    frame.sample = first;
    frame.amount = Amount(10, 0, 0);
    gesture.follow(frame);
    QCOMPARE(gesture.amount(), Amount(20, 0, 0));  // ahead of a shape that follows
    frame.sample = second;
    frame.amount = Amount(12, 0, 0);
    frame.stopped = true;
    gesture.follow(frame);
    gesture.add(Amount(30, 0, 0));
    QCOMPARE(gesture.amount(), Amount(12, 0, 0));
    QCOMPARE(gesture.path(0.01).back(), Amount(12, 0, 0));

    // The same happens in a window: one pin is pushed through another.
    click(Qt::LeftButton, 110, 80);
    click(Qt::LeftButton, 130, 80);
    QVERIFY(settle(m_window->session()));
    ShapeSession& session = m_window->session();
    session.selection().set({1});
    session.gestures().begin();
    for (int i = 1; i <= 8; ++i) session.gestures().moveBy({-8.0 * i, 0, 0});
    QVERIFY(QTest::qWaitFor([&] { return session.motion().frame()->stopped; }, 30000));
    QVERIFY(session.gestures().drag()->isStopped());
    const auto shown = session.motion().frame<2>();
    const Vec2 pin = inPlane(session.gestures().pins()[1].centre);
    const double gap = (shown->pose.colwise() - pin).colwise().norm().minCoeff();
    QVERIFY2(gap < 1e-6, qPrintable(QString::number(gap)));

    // The banner says so from the end of the drag to the next change.
    const auto* banner = m_window->findChild<InfoBanner*>();
    const QString before = banner->text();
    QVERIFY(!before.contains(QStringLiteral("cannot go further")));
    session.gestures().end(0.1);
    QVERIFY(settle(session));
    QVERIFY2(banner->text().startsWith(QStringLiteral("Pin 2 cannot go further: ")),
             qPrintable(banner->text()));
    m_window->actions().undo->trigger();
    QCOMPARE(banner->text(), before);
}

QTEST_MAIN(TestMenus)
#include "test_menus.moc"
