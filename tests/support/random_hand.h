#pragma once

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QWheelEvent>
#include <cstdio>
#include <functional>
#include <random>

#include "app/window/compare_view.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "tests/support/solid_fixture.h"

namespace wend::test {

/// A hand that does anything at any time: strokes with any tool, interrupted by keys, the wheel, other tools,
/// undo and fields of panels. It avoids actions that open or write files, that replace the window's contents,
/// or that drag data out of it.
class RandomHand {
  public:
    RandomHand(MainWindow& window, unsigned seed) : m_window(window), m_random(seed) {
        Actions& a = window.actions();
        m_left = {a.open,          a.save,       a.saveAs,       a.closeFile,   a.quit,
                  a.exportPicture, a.exportMesh, a.exportFrames, a.exportStMap, a.exportView,
                  a.manual,        a.tutorial,   a.shortcuts,    a.about,       a.fullScreen,
                  a.history,       a.darkLook,   a.lightLook,    a.systemLook};
        for (const QMenu* files : {a.recent.get(), a.samples.get()}) m_left += files->actions();
        QObject::connect(&m_closing, &QTimer::timeout, &m_closing, &RandomHand::closePopup);
        m_closing.start(100);  // a button's menu keeps the hand until it is closed
    }

    /// Does one action; if `tells`, prints its name to standard error.
    void act(bool tells) {
        m_tells = tells;
        closePopup();
        if (!QTest::qWaitFor([] { return !QApplication::activeModalWidget(); }, 60000))
            qWarning("a dialog stays open");
        const int which = upTo(100);
        if (upTo(30) == 0) m_window.actions().fit->trigger();  // or it strays out of sight
        if (which < 45)
            stroke();
        else if (which < 50)
            doubleClick();
        else if (which < 58)
            click(Qt::RightButton);
        else
            shortDeed();
        for (int i = upTo(4); i > 0; --i) QCoreApplication::processEvents();
    }
    /// Releases everything that is pressed and closes everything that is open.
    void letGo() {
        while (QApplication::activePopupWidget()) closePopup();
        if (m_held != 0) releaseKey();
        m_window.session().playback().setPlaying(false);
    }
    /// Returns the last actions, one a line.
    QString lately() const { return m_lately.join('\n'); }

  private:
    int upTo(int n) { return n < 1 ? 0 : static_cast<int>(m_random() % static_cast<unsigned>(n)); }
    double unit() { return upTo(10001) / 10000.0; }
    template <class T>
    T oneOf(std::initializer_list<T> all) {
        return all.begin()[upTo(static_cast<int>(all.size()))];
    }
    void tell(const QString& what) {
        m_lately << what;
        if (m_lately.size() > 30) m_lately.removeFirst();
        if (m_tells) std::fprintf(stderr, "  %s\n", qPrintable(what));
    }
    Qt::KeyboardModifiers modifiers() {
        Qt::KeyboardModifiers all;
        for (const auto& [one, percent] :
             {std::pair{Qt::ShiftModifier, 15}, {Qt::ControlModifier, 12}, {Qt::AltModifier, 8}})
            if (upTo(100) < percent) all |= one;
        return all;
    }

    /// Returns the view of the shape, or its other half where two are compared.
    QWidget* view() {
        CompareView& halves = m_window.compared();
        const bool other = halves.isSplit() && upTo(3) == 0;
        if (m_window.session().document().dimension() == 2)
            return other ? &halves.picture() : &m_window.canvas();
        return other && halves.solid() ? halves.solid() : m_window.solids().canvas();
    }
    /// Returns the widget for strokes: mostly the view, sometimes the tracks.
    QWidget* place() {
        auto* tracks = m_window.findChild<TrackView*>();
        if (tracks->isVisible() && upTo(4) == 0) return tracks->viewport();
        if (upTo(25) == 0) return m_window.findChild<TimeStrip*>()->slider();
        return view();
    }
    QPointF onShape() {
        ShapeSession& session = m_window.session();
        if (const auto frame = session.motion().frame<2>())
            return m_window.canvas().toWidget(frame->pose.col(upTo(static_cast<int>(frame->pose.cols()))));
        if (const auto frame = session.motion().frame<3>())
            return m_window.solids().canvas()->toWidget(
                frame->pose.col(upTo(static_cast<int>(frame->pose.cols()))));
        return {};
    }
    QPointF onPin() {
        ShapeSession& session = m_window.session();
        const auto pins = session.gestures().pins();
        if (pins.empty()) return onShape();
        const Vec3 at = pins[upTo(static_cast<int>(pins.size()))].centre;
        return session.document().dimension() == 2 ? m_window.canvas().onScreen(at)
                                                   : m_window.solids().canvas()->onScreen(at);
    }
    /// Returns a place of a widget: on the shape, on a pin, on its edge, outside, anywhere.
    QPointF spot(const QWidget& widget) {
        const int which = upTo(100);
        const bool isView = &widget != m_window.findChild<TimeStrip*>()->slider() &&
                            !qobject_cast<TrackView*>(widget.parentWidget());
        if (isView && which < 45) return onShape() + QPointF(upTo(7) - 3, upTo(7) - 3);
        if (isView && which < 75) return onPin() + QPointF(upTo(5) - 2, upTo(5) - 2);
        const double w = widget.width(), h = widget.height();
        if (which < 82) return {oneOf({0.0, w - 1, w / 2}), oneOf({0.0, h - 1, h / 2})};
        if (which < 86) return {(3 * unit() - 1) * w, (3 * unit() - 1) * h};
        return {unit() * w, unit() * h};
    }

    void send(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
              Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
        QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, keys);
        event.setTimestamp(m_clock += 20 + static_cast<ulong>(upTo(100)));
        QApplication::sendEvent(&widget, &event);
    }
    void stroke() {
        QPointer<QWidget> on = place();
        if (!on || !on->isVisible()) return;
        const Qt::MouseButton button = upTo(10) > 0 ? Qt::LeftButton : Qt::MiddleButton;
        const Qt::KeyboardModifiers keys = modifiers();
        QPointF at = spot(*on);
        tell(QStringLiteral("stroke on %1 at %2, %3 with %4, %5")
                 .arg(on->metaObject()->className())
                 .arg(at.x())
                 .arg(at.y())
                 .arg(button)
                 .arg(keys));
        send(*on, QEvent::MouseMove, at, Qt::NoButton, {}, keys);
        send(*on, QEvent::MouseButtonPress, at, button, button, keys);
        const bool isUpset = upTo(2) == 0;
        const int moves = upTo(9);
        for (int i = 0; on && i < moves; ++i) {
            at = upTo(8) == 0 ? spot(*on) : at + QPointF(upTo(41) - 20, upTo(41) - 20);
            send(*on, QEvent::MouseMove, at, Qt::NoButton, button, keys);
            if (upTo(3) == 0) QCoreApplication::processEvents();
            if (isUpset && upTo(5) == 0) {
                tell(QStringLiteral("in its middle:"));
                shortDeed();
            }
        }
        closePopup();
        if (!on) return;
        if (upTo(6) == 0) {  // another button comes and goes first
            send(*on, QEvent::MouseButtonPress, at, Qt::RightButton, button | Qt::RightButton, keys);
            send(*on, QEvent::MouseButtonRelease, at, Qt::RightButton, button, keys);
        }
        send(*on, QEvent::MouseButtonRelease, at, button, {}, upTo(8) == 0 ? modifiers() : keys);
    }
    void click(Qt::MouseButton button) {
        QWidget* on = place();
        if (!on->isVisible()) return;
        const QPointF at = spot(*on);
        const Qt::KeyboardModifiers keys = modifiers();
        tell(QStringLiteral("click on %1 at %2, %3 with %4")
                 .arg(on->metaObject()->className())
                 .arg(at.x())
                 .arg(at.y())
                 .arg(button));
        send(*on, QEvent::MouseButtonPress, at, button, button, keys);
        send(*on, QEvent::MouseButtonRelease, at, button, {}, keys);
        if (button != Qt::RightButton || upTo(2) > 0) return;
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) choose(menu->actions());
    }
    void doubleClick() {
        QWidget* on = view();
        if (!on->isVisible()) return;
        const QPointF at = spot(*on);
        tell(QStringLiteral("double click at %1, %2").arg(at.x()).arg(at.y()));
        send(*on, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, {});
        send(*on, QEvent::MouseButtonRelease, at, Qt::LeftButton, {}, {});
        send(*on, QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton, {});
        send(*on, QEvent::MouseButtonRelease, at, Qt::LeftButton, {}, {});
    }
    void wheel() {
        QWidget* on = view();
        const QPointF at = spot(*on);
        tell(QStringLiteral("wheel"));
        QWheelEvent event(at, on->mapToGlobal(at), {}, {0, 120 * (upTo(5) - 2)}, Qt::NoButton, modifiers(),
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(on, &event);
    }

    /// Does an action that is possible in the middle of a stroke, too.
    void shortDeed() {
        using Deed = void (RandomHand::*)();
        static constexpr std::pair<int, Deed> kDeeds[] = {
            {24, &RandomHand::pressKey},  {12, &RandomHand::chooseTool}, {6, &RandomHand::chooseStep},
            {12, &RandomHand::goInSteps}, {8, &RandomHand::wheel},       {12, &RandomHand::chooseAction},
            {10, &RandomHand::useField},  {8, &RandomHand::clickPanel},  {5, &RandomHand::clickList},
            {6, &RandomHand::changeTime}, {5, &RandomHand::changeFocus}, {2, &RandomHand::resize}};
        int left = 0;
        for (const auto& [weight, deed] : kDeeds) left += weight;
        left = upTo(left);
        for (const auto& [weight, deed] : kDeeds)
            if ((left -= weight) < 0) return (this->*deed)();
    }
    void pressKey() {
        if (m_held != 0 && upTo(2) == 0) return releaseKey();
        const Qt::KeyboardModifiers keys = modifiers();
        const int which = upTo(10);
        const int key = which < 2 ? oneOf({Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Return, Qt::Key_Backspace})
                        : which < 4 ? oneOf({Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
                        : which < 5 ? oneOf({Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Home, Qt::Key_End,
                                             Qt::Key_BracketLeft, Qt::Key_BracketRight, Qt::Key_F2,
                                             Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Minus, Qt::Key_Period})
                        : which < 6 ? Qt::Key_0 + upTo(10)
                        : which < 7 ? oneOf({Qt::Key_Space, Qt::Key_Backslash, Qt::Key_H})
                                    : Qt::Key_A + upTo(26);
        const QKeySequence sequence(static_cast<int>(keys) | key);
        for (const QAction* one : m_left)
            if (one->shortcuts().contains(sequence)) return;
        tell(QStringLiteral("key %1").arg(sequence.toString()));
        if (which == 6 && m_held == 0) {
            m_held = key;
            QTest::keyPress(m_window.windowHandle(), static_cast<Qt::Key>(key), keys);
        } else {
            QTest::keyClick(m_window.windowHandle(), static_cast<Qt::Key>(key), keys);
        }
    }
    void releaseKey() {
        tell(QStringLiteral("key up"));
        QTest::keyRelease(m_window.windowHandle(), static_cast<Qt::Key>(std::exchange(m_held, 0)));
    }
    void chooseTool() {
        Toolbox& tools = m_window.tools();
        choose(tools.toolsOf(tools.mode()));
    }
    void chooseStep() { choose({m_window.tools().modeAction(kModes[upTo(int(std::size(kModes)))])}); }
    /// Triggers some action of the menus and tool bars.
    void chooseAction() { choose(m_window.findChildren<QAction*>()); }
    void choose(QList<QAction*> from) {
        from.removeIf([this](const QAction* one) {
            return !one->isEnabled() || !one->isVisible() || one->menu() || one->isSeparator() ||
                   m_left.contains(one) || qobject_cast<QToolBar*>(one->parent());
        });
        if (from.isEmpty()) return;
        QPointer<QAction> one = from[upTo(static_cast<int>(from.size()))];
        tell(QStringLiteral("action %1").arg(one->text()));
        one->trigger();
    }
    void goInSteps() {
        QUndoStack& stack = *m_window.session().document().undoStack();
        const int which = upTo(8);
        tell(QStringLiteral("steps, %1 of %2: %3").arg(stack.index()).arg(stack.count()).arg(which));
        if (which < 4)
            stack.undo();
        else if (which < 7)
            stack.redo();
        else
            stack.setIndex(upTo(stack.count() + 1));
    }
    template <class Field>
    QList<Field*> fields() {
        QList<Field*> seen = m_window.properties().findChildren<Field*>();
        seen += m_window.findChild<TimeStrip*>()->findChildren<Field*>();
        seen += m_window.compared().findChildren<Field*>();
        seen.removeIf([](const Field* one) { return !one->isVisible() || !one->isEnabled(); });
        return seen;
    }
    template <class Field>
    Field* oneField() {
        const auto all = fields<Field>();
        return all.isEmpty() ? nullptr : all[upTo(static_cast<int>(all.size()))];
    }
    /// Uses sliders, lists and boxes with numbers, by the keyboard.
    void useField() {
        QWidget* field = nullptr;
        const int which = upTo(3);
        if (which == 0) field = oneField<QAbstractSlider>();
        if (which == 1) field = oneField<QComboBox>();
        if (which == 2) field = oneField<QAbstractSpinBox>();
        if (!field) return;
        tell(QStringLiteral("field %1 %2").arg(field->metaObject()->className(), field->accessibleName()));
        field->setFocus();
        QWindow* window = m_window.windowHandle();
        if (which == 2 && upTo(2) == 0) {
            static_cast<QAbstractSpinBox*>(field)->selectAll();
            const char* text = oneOf({"0", "1", "2", "0.5", "-1", "3", "", "1e9", "45"});
            for (const char* c = text; *c; ++c) QTest::keyClick(window, *c);
            QTest::keyClick(window, upTo(2) == 0 ? Qt::Key_Return : Qt::Key_Tab);
        } else {
            QTest::keyClick(window, oneOf({Qt::Key_Up, Qt::Key_Down, Qt::Key_Left, Qt::Key_Right}));
        }
    }
    void clickPanel() {
        QList<QAbstractButton*> buttons = fields<QAbstractButton>();
        buttons.removeIf([this](const QAbstractButton* one) {
            const auto* tool = qobject_cast<const QToolButton*>(one);
            return tool && m_left.contains(tool->defaultAction());
        });
        if (buttons.isEmpty()) return;
        QAbstractButton* one = buttons[upTo(static_cast<int>(buttons.size()))];
        tell(QStringLiteral("button %1 %2").arg(one->text(), one->accessibleName()));
        one->click();
    }
    /// Clicks a list of pins or of layers.
    void clickList() {
        QList<QAbstractItemView*> lists = fields<QAbstractItemView>();
        if (lists.isEmpty()) return;
        QAbstractItemView* list = lists[upTo(static_cast<int>(lists.size()))];
        QWidget* port = list->viewport();
        const QPointF at(unit() * port->width(), unit() * std::min(port->height(), 160));
        tell(QStringLiteral("list at %1, %2").arg(at.x()).arg(at.y()));
        const Qt::MouseButton button = upTo(5) == 0 ? Qt::RightButton : Qt::LeftButton;
        const Qt::KeyboardModifiers keys = modifiers();
        send(*port, QEvent::MouseButtonPress, at, button, button, keys);
        send(*port, QEvent::MouseButtonRelease, at, button, {}, keys);
    }
    void changeTime() {
        Playback& playback = m_window.session().playback();
        tell(QStringLiteral("time"));
        if (upTo(3) == 0)
            m_window.actions().play->trigger();
        else
            playback.setTime(oneOf({0.0, 0.5, 1.0, unit(), unit()}) * playback.end());
    }
    void changeFocus() {
        tell(QStringLiteral("focus"));
        QWidget* focus = QApplication::focusWidget();
        const int which = upTo(3);
        if (which == 0 && focus) {
            QFocusEvent out(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
            QApplication::sendEvent(focus, &out);
            QEvent leave(QEvent::Leave);
            QApplication::sendEvent(view(), &leave);
        } else if (which == 1) {
            m_window.properties().pins().list()->setFocus();
        } else {
            view()->setFocus();
        }
    }
    void resize() {
        tell(QStringLiteral("size"));
        m_window.resize(900 + upTo(600), 600 + upTo(350));
    }
    static void closePopup() {
        if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    }

    MainWindow& m_window;
    std::mt19937 m_random;
    QList<QAction*> m_left;  // what it leaves alone
    QStringList m_lately;
    QTimer m_closing;
    ulong m_clock = 1000;
    int m_held = 0;  // a key that is down
    bool m_tells = false;
};

}  // namespace wend::test
