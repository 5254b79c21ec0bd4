#pragma once

#include <QWidget>

class QToolButton;

namespace wend {

class Actions;
class Toolbox;

/// The row below the menus: files and undo at the left, the steps of the work in the middle, what is seen and
/// the export at the right. In a narrow window the steps' names get less room first, then what has a menu or
/// a key as well goes; never the steps, and never the export.
class ModeRow : public QWidget {
    Q_OBJECT

  public:
    ModeRow(const Actions& actions, const Toolbox& tools, QWidget* parent = nullptr);
    QToolButton* exportButton() const { return m_export; }
    /// How large a pixel of the picture is on the screen; 0: there is none.
    void showZoom(double zoom);
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* side(const QList<QAction*>& actions, Qt::Alignment to);
    QToolButton* button(QAction* action, QWidget* parent);
    QWidget* steps(const Toolbox& tools);
    QToolButton* makeExport(const Actions& actions);
    QToolButton* makeZoom(const Actions& actions);
    void collapse();

    std::vector<QToolButton*> m_steps;
    std::vector<QToolButton*> m_spare;  // those that go, the first one first
    QToolButton *m_zoom = nullptr, *m_export = nullptr;
};

}  // namespace wend
