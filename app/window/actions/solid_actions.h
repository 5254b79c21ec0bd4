#pragma once

#include <QActionGroup>
#include <QMenu>
#include <array>
#include <memory>

#include "app/project/solid_view.h"
#include "app/window/actions/action_maker.h"

namespace wend {

class Toolbox;

/// Commands for solids, hidden for pictures.
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
    /// Sets whether the solid has a surface besides its tetrahedra.
    void setHasDetail(bool has);
    /// Sets whether that surface was chosen by the user.
    void setHasChosenDetail(bool has);
    /// Sets whether the tetrahedra are generated.
    void setMeshed(bool meshed);
    void setUpAxis(UpAxis axis);
    /// Resets the view options of a solid.
    void resetView();

  private:
    void makeGrabbing();
    void makeView();
    void makeMenu();

    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
