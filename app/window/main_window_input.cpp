#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusTipEvent>
#include <QToolBar>
#include <QToolButton>

#include "app/panels/fields/energy_slider.h"
#include "app/session/opening.h"
#include "app/style/theme.h"
#include "app/window/actions/actions.h"
#include "app/window/compare_view.h"
#include "app/window/files/file_workflow.h"
#include "app/window/files/start_page.h"
#include "app/window/main_window.h"
#include "app/window/properties_rail.h"
#include "app/window/status_fields.h"

namespace wend {

bool MainWindow::event(QEvent* event) {
    if (event->type() != QEvent::StatusTip) return QMainWindow::event(event);
    m_fields->showTip(static_cast<QStatusTipEvent*>(event)->tip());
    return true;
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_rail->fitTo(width());
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) m_actions->fullScreen->setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
}

/// Escape, where nothing else has a use for it, gives the keyboard back to the view.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
    focusView();
}

/// Focuses the shape, or the start page.
void MainWindow::focusView() {
    m_pages->currentWidget()->setFocus();
}

/// Moves the focus to the view when the focused widget is hidden: Qt would choose an arbitrary one.
void MainWindow::followFocus(const QWidget* from, const QWidget* to) {
    if (isAncestorOf(from) && isAncestorOf(to) && !from->isVisibleTo(this)) focusView();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(m_files->mayLeave());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (EnergySlider::phiIn(event->mimeData())) return event->acceptProposedAction();
    const QString path =
        event->mimeData()->hasUrls() ? event->mimeData()->urls().first().toLocalFile() : QString();
    if (!mayBeOpened(path)) return;
    event->acceptProposedAction();
    m_start->setDropHighlighted(true);
    const auto count = event->mimeData()->urls().size();
    m_fields->showTip(count > 1 ? tr("Let go to open %n pictures as parts", nullptr, static_cast<int>(count))
                                : tr("Let go to open “%1”").arg(QFileInfo(path).fileName()));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    m_start->setDropHighlighted(false);
    m_fields->showTip({});
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (const auto phi = EnergySlider::phiIn(event->mimeData())) {
        const QPoint at = m_compare->mapFrom(this, event->position().toPoint());
        if (m_compare->rect().contains(at)) m_compare->split(*phi);
        return;
    }
    m_start->setDropHighlighted(false);
    m_fields->showTip({});
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) paths << url.toLocalFile();
    m_files->openAll(paths);
    event->acceptProposedAction();
}

void MainWindow::showTitle() {
    const Document& document = m_session.document();
    setWindowTitle(document.isEmpty() ? QStringLiteral("Wend[*]")
                                      : tr("%1[*] – Wend").arg(document.displayName()));
    setWindowModified(document.isModified());
}

/// Styles the button that Qt adds to a tool bar that is too short.
void MainWindow::showMoreArrows() {
    for (QToolBar* bar : {m_topBar, m_toolBar})
        if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
            const bool down = bar->orientation() == Qt::Vertical;
            more->setIcon(
                wendIcon(down ? QStringLiteral("more-down") : QStringLiteral("more-right"), palette()));
            more->setToolTip(tr("More"));
            more->setAccessibleName(tr("More"));
        }
}

}  // namespace wend
