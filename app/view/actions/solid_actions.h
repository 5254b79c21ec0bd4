#pragma once

#include <QActionGroup>
#include <QMenu>
#include <array>
#include <memory>

#include "app/document/solid_view.h"
#include "app/view/actions/action_maker.h"

namespace wend {

class Toolbox;

/// What can be done with solids only; hidden while something flat is open.
class SolidActions : public ActionMaker {
    Q_OBJECT

  public:
    SolidActions(Toolbox& tools, QObject* parent);

    QAction* sizes;  // of the tools
    QAction *through, *holdBeyond;
    QAction *detail, *flat, *orthographic;
    QAction *front, *back, *right, *left, *top, *bottom, *oblique;
    std::array<QAction*, 3> upAxes;  // x, y, z
    QAction *wendKeys, *vtkKeys, *blenderKeys;
    QAction* cut;
    QAction *chooseDetail, *removeDetail;

    QMenu* menu() const { return m_menu.get(); }
    void setShown(bool shown);
    /// Whether the solid has a surface of its own, beside its tetrahedra.
    void setHasDetail(bool has);
    /// Whether that is one that was chosen for it.
    void setHasChosenDetail(bool has);
    /// Whether its tetrahedra are made here.
    void setMeshed(bool meshed);
    void setUpAxis(UpAxis axis);
    /// What is shown of a solid, as at the start.
    void resetView();

  private:
    void makeGrabbing();
    void makeView();
    void makeMenu();

    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
