#include "app/window/help/side_windows.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QUndoView>
#include <QVBoxLayout>

#include "app/session/shape_session.h"
#include "app/window/actions/actions.h"
#include "app/window/help/cheat_sheet.h"
#include "app/window/help/manual_window.h"
#include "app/window/help/shortcut_dialog.h"

namespace wend {

SideWindows::SideWindows(ShapeSession& session, const Actions& actions, Toolbox& tools, QMainWindow& window)
    : QObject(&window), m_session(session), m_tools(tools), m_window(window) {
    connect(actions.manual, &QAction::triggered, this, &SideWindows::showManual);
    connect(actions.shortcuts, &QAction::triggered, this, &SideWindows::showKeys);
    connect(actions.chooseKeys, &QAction::triggered, this, &SideWindows::chooseKeys);
    connect(actions.history, &QAction::triggered, this, &SideWindows::showHistory);
    connect(actions.about, &QAction::triggered, this, &SideWindows::showAbout);
}

/// Shows the single manual window where it was.
void SideWindows::showManual() {
    auto* manual = m_window.findChild<ManualWindow*>();
    if (!manual) manual = new ManualWindow(&m_window);
    manual->show();
    manual->raise();
    manual->activateWindow();
}

void SideWindows::showKeys() {
    CheatSheet(*m_window.menuBar(), m_session.document().dimension(), &m_window).exec();
}

void SideWindows::chooseKeys() {
    ShortcutDialog(*m_window.menuBar(), m_tools, &m_window).exec();
}

/// Shows the undo history; a click moves to that step.
void SideWindows::showHistory() {
    auto* history = m_window.findChild<QDialog*>(QStringLiteral("history"));
    if (!history) {
        history = new QDialog(&m_window, Qt::Tool);
        history->setObjectName(QStringLiteral("history"));
        history->setWindowTitle(tr("History"));
        auto* steps = new QUndoView(m_session.document().undoStack(), history);
        steps->setEmptyLabel(tr("As it was opened"));
        steps->setAccessibleName(tr("History"));
        steps->setAccessibleDescription(tr("What was done; a click goes back or forward to that step."));
        steps->setFrameShape(QFrame::NoFrame);
        auto* column = new QVBoxLayout(history);
        column->setContentsMargins(0, 0, 0, 0);
        column->addWidget(steps);
        history->resize(260, 360);
    }
    history->show();
    history->raise();
    history->activateWindow();
    history->findChild<QUndoView*>()->setFocus();
}

void SideWindows::showAbout() {
    QMessageBox::about(&m_window, tr("About Wend"),
                       tr("<h3>Wend %1</h3><p>Bends pictures and solids by letting them flow.</p>"
                          "<p>After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies "
                          "for Continuous Shape "
                          "Deformation, 2013.</p><p>Free software under the GNU Affero General Public "
                          "License, version 3 or later.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

}  // namespace wend
