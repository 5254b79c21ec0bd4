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

}  // namespace wend
