#pragma once

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <functional>

/// Answers to dialogs that a test is about to open.

namespace wend::test {

/// Calls `act` with the next dialog of this kind, whenever it opens, unless `scope` is destroyed before.
template <typename Dialog, typename Act>
void withNext(QObject* scope, Act act) {
    auto* timer = new QTimer(scope);
    QObject::connect(timer, &QTimer::timeout, scope, [timer, act] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        timer->stop();
        timer->deleteLater();
        act(*dialog);
    });
    timer->start(50);
}

/// Passes any open dialog to `act` repeatedly until `scope` is destroyed, even while a dialog that `act` has
/// opened waits. (A QTimer does not fire within its own slot.)
inline void whileAsked(QObject* scope, const std::function<void(QWidget&)>& act) {
    QTimer::singleShot(50, scope, [scope, act] {
        whileAsked(scope, act);
        if (QWidget* dialog = QApplication::activeModalWidget()) act(*dialog);
    });
}

/// Presses the button of this name in the next message box.
inline void answerNext(QObject* scope, const QString& name) {
    withNext<QMessageBox>(scope, [name](QMessageBox& box) {
        for (QAbstractButton* button : box.buttons())
            if (button->text().remove('&') == name) return button->click();
        box.reject();
    });
}

/// Types the path into the next file dialog and confirms.
inline void nameNextFile(QObject* scope, const QString& path) {
    withNext<QFileDialog>(scope, [path](QFileDialog& dialog) {
        auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
    });
}

}  // namespace wend::test
