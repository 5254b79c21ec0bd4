#pragma once

#include <QActionGroup>
#include <QMenu>
#include <memory>

#include "app/view/action_maker.h"

namespace wend {

/// What can be done with solids only; hidden while something flat is open.
class SolidActions : public ActionMaker {
    Q_OBJECT

  public:
    SolidActions(QActionGroup& tools, QObject* parent);

    QAction *rectangle, *lasso, *brush, *ball, *box, *half, *paint, *sizes, *measure;
    QAction *move, *turn, *grow;
    QAction *through, *holdBeyond;
    QAction *selectRectangle, *selectLasso, *selectBrush;
    QAction *detail, *flat, *orthographic, *arrows, *ellipsoids;
    QAction *front, *back, *right, *left, *top, *bottom, *oblique;
    QAction *wendKeys, *vtkKeys, *blenderKeys;
    QAction* cut;
    QAction *chooseDetail, *removeDetail;

    QMenu* menu() const { return m_menu.get(); }
    void setShown(bool shown);
    /// Parts of a picture are held by some of the same tools.
    void setHoldsPictures(bool holds);
    /// Whether the solid has a surface of its own, beside its tetrahedra.
    void setHasDetail(bool has);
    /// Whether that is one that was chosen for it.
    void setHasChosenDetail(bool has);
    /// Whether its tetrahedra are made here.
    void setMeshed(bool meshed);
    /// What is shown of a solid, as at the start.
    void resetView();

  private:
    void makeTools(QActionGroup& tools);
    void makeModes();
    void makeView();
    void makeMenu();

    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
