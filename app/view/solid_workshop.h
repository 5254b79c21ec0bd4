#pragma once

#include <memory>

#include "app/tools/area_tool.h"
#include "app/tools/solid_pin_tool.h"
#include "app/view/paint_map.h"
#include "app/view/solid_actions.h"

class QLabel;
class QToolBar;
class QVBoxLayout;

namespace wend {

class Actions;
class CutPanel;
class DetailChooser;
class DistortionPanel;
class HandlePanel;
class MeasurePanel;
class PaintPanel;
class RegionPanel;
class SizePanel;
class SolidCanvas;
class StatusFields;
class SurfaceCheck;
class SurfacePanel;

/// What the window has for solids: their view (made when the first solid is opened, since it needs OpenGL),
/// tools, actions and panels.
class SolidWorkshop : public QObject {
    Q_OBJECT

  public:
    struct Surroundings {
        ShapeSession& session;
        Actions& actions;
        DistortionPanel& distortion;
        StatusFields& fields;
    };
    SolidWorkshop(const Surroundings& around, QWidget& window);
    ~SolidWorkshop() override;

    SolidActions& actions() { return *m_actions; }
    /// Adds tools and panels to those of the window; hidden until a solid is open.
    void furnish(QToolBar& tools, QVBoxLayout& panels);
    /// A solid is shown from now on, or no more. The view is then there, or a text that says why not.
    void setActive(bool active);
    bool isActive() const { return m_isActive; }
    /// What pointer and keys do, as rich text.
    static QString keys();
    /// Asks for size and name and writes the view as a picture.
    void exportPicture();
    /// The page of the window; null before the first solid.
    QWidget* page() const { return m_page; }
    /// Null where OpenGL is missing.
    SolidCanvas* canvas() const { return m_canvas; }

  signals:
    void hintChanged(QString hint);
    void menuWanted(QPoint global, wend::MenuPlace place);
    void failed(QString text);
    void done(QString text);
    /// What the user should hear of a new mesh.
    void told(QString text);

  private:
    void makePage();
    void connectView();
    void connectTools();
    void makeBrushes();
    void connectCut();
    void connectDetail();
    void showDomain();
    void showMaps();
    void chooseTool();
    void showCut();
    void holdBeyondCut();
    void tellOfShape();

    Surroundings m_around;
    QWidget& m_window;
    SolidActions* m_actions;
    CutPanel* m_cutPanel;
    HandlePanel* m_handlePanel;
    RegionPanel* m_regionPanel;
    MeasurePanel* m_measurePanel;
    PaintPanel* m_paintPanel;
    SizePanel* m_sizePanel;
    SurfacePanel* m_surfacePanel;
    SurfaceCheck* m_check;
    DetailChooser* m_detail;
    std::vector<QWidget*> m_panels;
    QWidget* m_page = nullptr;
    SolidCanvas* m_canvas = nullptr;
    bool m_isActive = false;
    int m_lastCut = 2;
    std::shared_ptr<const void> m_told;  // the rest mesh whose notices were told
    bool m_hasTold = false;              // and there were some
    Manipulator m_manipulator;
    PaintMap m_paintMap;
    std::vector<std::pair<QAction*, std::unique_ptr<SolidTool>>> m_tools;
};

}  // namespace wend
