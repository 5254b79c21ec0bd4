#pragma once

#include <QMainWindow>
#include <memory>

#include "app/session/shape_session.h"

class QStackedWidget;

namespace wend {

class Actions;
class AppearanceChoice;
class BrushActions;
class CompareView;
class ContextMenu;
class CurveActions;
class DepthActions;
class DistortionPanel;
class Exporter;
class FileWorkflow;
class InfoBanner;
class MaterialActions;
class MaterialPanel;
class ModeRow;
class OptionRow;
class PictureActions;
class PinActions;
class Properties;
class PropertiesRail;
class ShapeCanvas;
class SolidActions;
class SolidWorkshop;
class StartPage;
class StatusFields;
class TimeStrip;
class Toolbox;
class TrackView;
class Tutorial;
class Viewport;
class WorkNote;
class Workspace;

/// The window: start page or workshop, with the steps of the work above, the tools of the current one on the
/// left, properties on the right and time below.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    void openPath(const QString& path);

    ShapeSession& session() { return m_session; }
    ShapeCanvas& canvas() { return *m_canvas; }
    Actions& actions() { return *m_actions; }
    CurveActions& curves() { return *m_curves; }
    FileWorkflow& files() { return *m_files; }
    Exporter& exporter() { return *m_exporter; }
    Toolbox& tools() { return *m_tools; }
    Properties& properties() { return *m_properties; }
    MaterialPanel& materialPanel();
    SolidWorkshop& solids() { return *m_solids; }
    DistortionPanel& distortionPanel();
    MaterialActions& materialActions() { return *m_material; }
    CompareView& compared() { return *m_compare; }
    WorkNote& work() { return *m_work; }
    InfoBanner& banner() { return *m_banner; }

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QToolBar* makeBar(Qt::ToolBarArea area, const QString& title, const char* name);
    void makeToolBars();
    void makeCentre();
    void connectFiles();
    void connectEdit();
    void connectView();
    void connectViewport(Viewport& view);
    void connectComparison();
    void connectHiding();
    void connectFilm();
    void takeCycle();
    void showDocument();
    void showTools();
    void showTitle();
    void showSelection();
    void updateIcons();
    void showMoreArrows();
    void focusView();
    void followFocus(const QWidget* from, const QWidget* to);

    ShapeSession m_session;
    Toolbox* m_tools;
    Actions* m_actions;
    SolidActions* m_solidActions;
    DepthActions* m_depth;
    PinActions* m_pins;
    MaterialActions* m_material = nullptr;
    Exporter* m_exporter;
    Properties* m_properties;
    PropertiesRail* m_rail = nullptr;
    PictureActions* m_pictureActions;
    BrushActions* m_brush;
    CurveActions* m_curves = nullptr;
    ContextMenu* m_menu = nullptr;
    InfoBanner* m_banner;
    FileWorkflow* m_files;
    ShapeCanvas* m_canvas;
    CompareView* m_compare = nullptr;
    StartPage* m_start;
    TrackView* m_tracks;
    TimeStrip* m_time;
    StatusFields* m_fields = nullptr;
    SolidWorkshop* m_solids = nullptr;
    QStackedWidget* m_pages;
    WorkNote* m_work;
    Tutorial* m_tutorial;
    ModeRow* m_modes = nullptr;
    QToolBar* m_topBar = nullptr;
    QToolBar* m_toolBar = nullptr;
    OptionRow* m_options = nullptr;
    std::unique_ptr<Workspace> m_workspace;
    AppearanceChoice* m_appearance;
    bool m_hasCycle = false;
};

/// Opens the window, with the file that the first argument names, if any; returns the program's exit code.
int runWindow(int argc, char** argv);

}  // namespace wend
