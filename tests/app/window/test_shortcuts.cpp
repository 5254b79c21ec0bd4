#include <QApplication>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>

#include "app/window/actions/toolbox.h"
#include "app/window/help/shortcuts.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// The user assigns other keys to actions, in the dialog, by pressing them.
class TestShortcuts : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void idsAreUnique();
    void chosenKeysWorkAndAreRemembered();
    void keysAreTakenFromTheirAction();
    void toolsOfOtherStepsKeepTheirKeys();
    void keysOfTheCanvasAreRefused();
    void standardKeysComeBack();
    void searchFindsActionsAndKeys();

  private:
    /// Opens the dialog by its action, and shows it to `act`.
    void inDialog(const std::function<void(ShortcutDialog&)>& act);
    static void choose(ShortcutDialog& dialog, QAction* action);
    /// Presses keys in the field and waits until it has taken them.
    static void press(ShortcutDialog& dialog, Qt::Key key, Qt::KeyboardModifiers modifiers);
    static void click(ShortcutDialog& dialog, const QString& name);
    static QString note(const ShortcutDialog& dialog);
    Actions& actions() { return m_f->window().actions(); }
    QAction* tool(const char* id) { return m_f->window().tools().action(QString::fromLatin1(id)); }

    std::unique_ptr<SolidFixture> m_f;
};

void TestShortcuts::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    QVERIFY(m_f->openPicture());
}

void TestShortcuts::inDialog(const std::function<void(ShortcutDialog&)>& act) {
    bool opened = false;
    withNext<ShortcutDialog>(&m_f->window(), [&](ShortcutDialog& dialog) {
        opened = true;
        act(dialog);
        dialog.reject();
    });
    actions().chooseKeys->trigger();
    QVERIFY(opened);
    m_f->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestShortcuts::choose(ShortcutDialog& dialog, QAction* action) {
    auto* list = dialog.findChild<QTreeWidget*>();
    for (QTreeWidgetItemIterator at(list); *at; ++at)
        if ((*at)->data(0, Qt::UserRole).value<QAction*>() == action) return list->setCurrentItem(*at);
    QFAIL(qPrintable(action->objectName()));
}

void TestShortcuts::press(ShortcutDialog& dialog, Qt::Key key, Qt::KeyboardModifiers modifiers) {
    auto* edit = dialog.findChild<QKeySequenceEdit*>();
    QSignalSpy changed(edit, &QKeySequenceEdit::keySequenceChanged);
    edit->setFocus();
    QTest::keyClick(edit, key, modifiers);
    QVERIFY(changed.wait(10000));
}

void TestShortcuts::click(ShortcutDialog& dialog, const QString& name) {
    for (auto* button : dialog.findChildren<QPushButton*>())
        if (QString(button->text()).remove('&') == name) return button->click();
    QFAIL(qPrintable(name));
}

QString TestShortcuts::note(const ShortcutDialog& dialog) {
    for (const auto* label : dialog.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
        return label->text();
    return {};
}

/// Two actions with one id would share the stored key.
void TestShortcuts::idsAreUnique() {
    QSet<QString> seen;
    for (const QAction* action : m_f->window().tools().actionsWithKeys()) {
        const QString id =
            QString::fromLatin1(action->parent()->metaObject()->className()) + '/' + action->objectName();
        QVERIFY2(!action->objectName().isEmpty() && !seen.contains(id), qPrintable(action->text()));
        seen << id;
    }
    QVERIFY(seen.size() > 100);
}

void TestShortcuts::chosenKeysWorkAndAreRemembered() {
    const QKeySequence keys(Qt::CTRL | Qt::ALT | Qt::Key_B);
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, actions().showMesh);
        press(dialog, Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
    });
    QCOMPARE(actions().showMesh->shortcuts(), QList{keys});
    QVERIFY(actions().showMesh->toolTip().contains(keys.toString(QKeySequence::NativeText)));
    QVERIFY(CheatSheet::text(*m_f->window().menuBar(), 2).contains(keys.toString(QKeySequence::NativeText)));
    const bool was = actions().showMesh->isChecked();
    QTest::keyClick(&m_f->window(), Qt::Key_M);
    QCOMPARE(actions().showMesh->isChecked(), was);
    QTest::keyClick(&m_f->window(), Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(actions().showMesh->isChecked(), !was);

    QCOMPARE(QSettings().value("keys/Actions/showMesh").toStringList(), QStringList{"Ctrl+Alt+B"});
    MainWindow next;
    QCOMPARE(next.actions().showMesh->shortcuts(), QList{keys});
}

void TestShortcuts::keysAreTakenFromTheirAction() {
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, actions().fit);
        press(dialog, Qt::Key_M, {});
        QCOMPARE(note(dialog), QStringLiteral("Taken from “Edges”."));
    });
    QCOMPARE(actions().fit->shortcuts(), QList{QKeySequence(Qt::Key_M)});
    QVERIFY(actions().showMesh->shortcuts().isEmpty());
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, actions().fit);
        click(dialog, QStringLiteral("None"));
    });
    QVERIFY(actions().fit->shortcuts().isEmpty());
}

/// A key may belong to different tools in different steps, as the default keys do.
void TestShortcuts::toolsOfOtherStepsKeepTheirKeys() {
    QAction *pen = tool("pen"), *eraser = tool("eraser");
    const QList<QKeySequence> before = ActionMaker::keysOf(*eraser);
    QCOMPARE(before.size(), 1);
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, pen);
        press(dialog, before[0][0].key(), before[0][0].keyboardModifiers());
    });
    QCOMPARE(ActionMaker::keysOf(*pen), before);
    QCOMPARE(ActionMaker::keysOf(*eraser), before);
    m_f->window().tools().setMode(Mode::Animate);
    QCOMPARE(pen->shortcuts(), before);
    m_f->window().tools().setMode(Mode::Paint);
    QCOMPARE(eraser->shortcuts(), before);
}

void TestShortcuts::keysOfTheCanvasAreRefused() {
    const QList<QKeySequence> before = actions().fit->shortcuts();
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, actions().fit);
        press(dialog, Qt::Key_H, {});
        QCOMPARE(note(dialog), QStringLiteral("H cannot be chosen: the canvas uses it."));
        press(dialog, Qt::Key_BracketLeft, {});
    });
    QCOMPARE(actions().fit->shortcuts(), before);
    QVERIFY(!QSettings().contains("keys/Actions/fit"));
}

void TestShortcuts::standardKeysComeBack() {
    const QList<QKeySequence> redo = actions().redo->shortcuts(), fit = actions().fit->shortcuts();
    QCOMPARE(redo.size(), 2);
    inDialog([&](ShortcutDialog& dialog) {
        choose(dialog, actions().redo);
        press(dialog, Qt::Key_F9, {});
        choose(dialog, actions().fit);
        press(dialog, Qt::Key_F10, {});
        choose(dialog, actions().redo);
        QCOMPARE(actions().redo->shortcuts(), QList{QKeySequence(Qt::Key_F9)});
        click(dialog, QStringLiteral("Standard"));
        QCOMPARE(ActionMaker::keysOf(*actions().redo), redo);
    });
    QCOMPARE(QKeySequence::listToString(actions().redo->shortcuts()), QKeySequence::listToString(redo));
    QVERIFY(!QSettings().contains("keys/Actions/redo"));
    QCOMPARE(actions().fit->shortcuts(), QList{QKeySequence(Qt::Key_F10)});
    inDialog([&](ShortcutDialog& dialog) { click(dialog, QStringLiteral("All Standard")); });
    QCOMPARE(actions().fit->shortcuts(), fit);
    QVERIFY(QSettings().allKeys().filter("keys/").isEmpty());
}

void TestShortcuts::searchFindsActionsAndKeys() {
    inDialog([&](ShortcutDialog& dialog) {
        const auto found = [&] {
            QStringList names;
            for (QTreeWidgetItemIterator at(dialog.findChild<QTreeWidget*>()); *at; ++at)
                if ((*at)->parent() && !(*at)->isHidden()) names << (*at)->text(0);
            return names;
        };
        auto* field = dialog.findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
        const qsizetype all = found().size();
        QVERIFY(all > 80);
        field->setText(QStringLiteral("onion"));
        QCOMPARE(found(), QStringList{"Onion Skin"});
        field->setText(QStringLiteral("Ctrl+J"));
        QCOMPARE(found(), QStringList{"Make a Part"});
        field->clear();
        QCOMPARE(found().size(), all);
    });
}

QTEST_MAIN(TestShortcuts)
#include "test_shortcuts.moc"
