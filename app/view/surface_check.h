#pragma once

#include <QObject>
#include <memory>

#include "app/session/shape_session.h"
#include "core/meshing/surface.h"

namespace wend {

class SolidCanvas;
class SurfacePanel;

/// Shows a surface while it is becoming a solid. When it cannot become one: looks at it again in the
/// background, shows it with what is wrong in it, and does what the panel offers.
class SurfaceCheck : public QObject {
    Q_OBJECT

  public:
    SurfaceCheck(ShapeSession& session, SurfacePanel& panel, QWidget& window);
    void setCanvas(SolidCanvas* canvas) { m_canvas = canvas; }
    void hide();

  private:
    struct Found {
        Surface surface;
        SurfaceProblems problems;
        bool mendable = false;  // the repair would leave nothing of them
        QString error;
    };
    void preview();
    void look();
    void take(const std::shared_ptr<const Found>& found);
    void showSurface();
    Vec<3> directionToWrong() const;
    void lookAtWrong();
    void saveList();
    void repair();

    ShapeSession& m_session;
    SurfacePanel& m_panel;
    QWidget& m_window;
    SolidCanvas* m_canvas = nullptr;
    std::shared_ptr<const Found> m_found;
};

}  // namespace wend
