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

    /// Returns the options of a tool; null actions are separators.
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

/// A state that is active while a key is held anywhere in a window, whatever has the focus; not in text
/// fields.
class HeldKey : public QObject {
    Q_OBJECT

  public:
    HeldKey(Qt::Key key, QWidget& window);
    bool isHeld() const { return m_held; }

  signals:
    void heldChanged(bool held);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool begins(QObject* watched, const QEvent& event) const;
    void setHeld(bool held);

    Qt::Key m_key;
    QWidget& m_window;
    bool m_held = false;
};

/// A tap of the space bar in a window: pressed and released without anything in between. Holding it until it
/// repeats is no tap, nor is it where the focused widget uses the key: a text, a button, a list.
class SpaceTap : public QObject {
    Q_OBJECT

  public:
    /// `action`: is triggered.
    SpaceTap(QWidget& window, QAction& action);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isOurs(const QObject* watched) const;
    void press(const QKeyEvent& key);
    void release(const QKeyEvent& key);

    QWidget& m_window;
    QAction& m_action;
    Qt::MouseButtons m_buttons;  // of the mouse, that are down
    bool m_down = false;
};

}  // namespace wend
