#pragma once

#include <QObject>
#include <memory>

#include "app/session/shape_session.h"
#include "app/view/volume/volume_view.h"
#include "core/meshing/surface_faults.h"

namespace wend {

class SolidCanvas;
class SurfacePanel;

/// Shows a surface while it is becoming a solid. When it cannot become one, or not without a cage: looks at
/// it again in the background, shows it with what is wrong in it, and does what the panel offers.
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
        std::vector<FaultKind> faults;
        Surface repaired;      // what the repair would leave …
        RepairReport report;   // … and what it would do
        SurfaceProblems left;  // in the repaired surface
        QString error;
    };
    void preview();
    void look();
    void take(const std::shared_ptr<const Found>& found);
    void takeShape();
    void showSurface();
    VolumePicture picture(const std::vector<bool>& kept, const std::vector<int>& chosen) const;
    Vec<3> directionToWrong() const;
    void showCase(int kind, int number);
    void showSolid();
    void fitCage(bool cage);
    void saveList();
    void repair(int largestHole);
    void showRepair(bool shown);
    QString repairText() const;

    ShapeSession& m_session;
    SurfacePanel& m_panel;
    QWidget& m_window;
    SolidCanvas* m_canvas = nullptr;
    std::shared_ptr<const Found> m_found;
    std::shared_ptr<const void> m_shape;  // the last one that was seen
    bool m_isCaged = false;               // it is embedded in a cage
};

}  // namespace wend
