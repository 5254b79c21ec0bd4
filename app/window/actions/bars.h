#pragma once

#include <QAction>
#include <QList>
#include <QMenu>
#include <QObject>
#include <QToolBar>
#include <QWidget>
#include <memory>

#include "app/tools/tool.h"
#include "app/tools/tool_kind.h"

class QToolButton;

namespace wend {

class Actions;
class BrushActions;
class CurveActions;
class DepthActions;
class Document;
class PictureActions;
class PinActions;
class SolidActions;
class Toolbox;

/// The context menu for a pin, a curve or the canvas.
class ContextMenu : public QObject {
    Q_OBJECT

  public:
    struct Offers {
        const Document& document;
        Actions& actions;
        CurveActions& curves;
        DepthActions& depth;
        PinActions& pins;
    };
    ContextMenu(const Offers& offers, QObject* parent);

  public slots:
    void popUp(const QPoint& global, wend::MenuPlace place);

  private:
    void offerPin();
    void offerCanvas();

    Offers m_offers;
    std::unique_ptr<QMenu> m_menu;
};

/// Makes mnemonics of a menu and its submenus unique in any language: an entry whose letter is taken gets
/// another letter of its text.
void makeLettersUnique(QMenu& menu);

/// Shows why a menu entry is disabled while the pointer rests on it, because status tips do not cover
/// disabled entries.
class MenuReasons : public QObject {
    Q_OBJECT

  public:
    /// Watches all menus.
    explicit MenuReasons(QObject* parent);

  private:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

/// The row below the menus: files and undo on the left, the steps in the middle, view and export on the
/// right. In a narrow window first the names of the steps shrink, then buttons disappear that have a menu or
/// shortcut; never the steps or the export.
class ModeRow : public QWidget {
    Q_OBJECT

  public:
    ModeRow(const Actions& actions, const Toolbox& tools, QWidget* parent = nullptr);
    QToolButton* exportButton() const { return m_export; }
    /// Shows the size of a picture's pixel on the screen; 0 for none.
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
    std::vector<QToolButton*> m_spare;  // hidden first to last
    QToolButton *m_zoom = nullptr, *m_export = nullptr;
};

/// The options beside tools' names.
struct ToolOptions {
    const SolidActions& solids;
    const PictureActions& outline;
    const PinActions& pins;
    const BrushActions& brush;

    /// A null action separates.
    QList<QAction*> of(const ToolKind& kind) const;

  private:
    QList<QAction*> of(ToolOption option) const;
};

/// The options row of the active tool: its name, its hint and its options; in the step Animate also those of
/// the film.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const Actions& actions, const ToolOptions& options, QWidget* parent);

  private:
    void showTool();
    void showMotion();

    const Toolbox& m_tools;
    const Actions& m_actions;
    ToolOptions m_options;
};

}  // namespace wend
