#pragma once

#include <QMenu>
#include <QObject>
#include <memory>

#include "app/tools/tool.h"

namespace wend {

class Actions;
class CurveActions;
class DepthActions;
class PinActions;
class ShapeSession;

/// The context menu for a pin, a curve or the canvas.
class ContextMenu : public QObject {
    Q_OBJECT

  public:
    struct Offers {
        ShapeSession& session;
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

}  // namespace wend
