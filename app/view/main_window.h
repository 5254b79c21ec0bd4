#pragma once

#include <QDeadlineTimer>
#include <QMainWindow>
#include <memory>

#include "app/panels/theme.h"
#include "app/session/shape_session.h"
#include "app/tools/hold_tool.h"
#include "app/tools/pin_tool.h"

class QStackedWidget;

namespace wend {

class Actions;
class BusyNote;
class ContextMenu;
class CurveActions;
class CurveEditing;
class ShapeCanvas;
class DistortionPanel;
class Exporter;
class FileWorkflow;
class InfoBanner;
class MaterialPanel;
class MeshPanel;
class PinList;
class SolidWorkshop;
class StartPage;
class StatusFields;
class TimeStrip;
class WorkNote;

/// The window: start page or workshop, with tools on the left, properties on the right and time below.
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
    MaterialPanel& materialPanel() { return *m_material; }
    SolidWorkshop& solids() { return *m_solids; }
    DistortionPanel& distortionPanel() { return *m_distortion; }
    WorkNote& work() { return *m_work; }
    InfoBanner& banner() { return *m_banner; }

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void makeToolBars();
    QWidget* makeSidePanel();
    void makeCentre();
    void connectFiles();
    void connectEdit();
    void connectView();
    void connectMotion();
    void connectHelp();
    void tell(const QString& text);
    void showDocument();
    void addSolidPage();
    void showWork();
    CurveEditing* currentCurve();
    void fitToScreen();
    void makeHoldTools();
    void choosePictureTool();
    void showTitle();
    void showSelection();
    void setAppearance(Appearance appearance);
    void updateIcons();
    void showMoreArrows();
    void showKeys();
    void showAbout();

    ShapeSession m_session;
    Actions* m_actions;
    CurveActions* m_curves = nullptr;
    ContextMenu* m_menu = nullptr;
    FileWorkflow* m_files;
    Exporter* m_exporter;
    ShapeCanvas* m_canvas;
    StartPage* m_start;
    InfoBanner* m_banner;
    TimeStrip* m_time;
    MaterialPanel* m_material;
    MeshPanel* m_mesh;
    DistortionPanel* m_distortion;
    PinList* m_pins;
    StatusFields* m_fields = nullptr;
    SolidWorkshop* m_solids = nullptr;
    QStackedWidget* m_pages;
    BusyNote* m_note;
    WorkNote* m_work;
    QString m_told;  // in the status bar: stays a while, though hints of buttons come and go
    QDeadlineTimer m_toldUntil;
    QString m_hint;     // the last one of a button or field
    QString m_opening;  // the file that is being read
    QWidget* m_side = nullptr;
    QToolBar* m_topBar = nullptr;
    QToolBar* m_toolBar = nullptr;
    std::unique_ptr<PinTool> m_pinTool, m_selectTool;
    std::vector<std::pair<QAction*, std::unique_ptr<HoldTool>>> m_holdTools;
    QPalette m_systemPalette;
};

}  // namespace wend
