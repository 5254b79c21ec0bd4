#pragma once

#include <map>
#include <optional>

#include "app/tools/tool.h"
#include "app/views/volume/solid_look.h"
#include "app/window/actions/solid_actions.h"
#include "app/window/export/picture_dialog.h"

namespace wend {

class Actions;
class DetailChooser;
class Exporter;
class InfoBanner;
class Properties;
class ShapeSession;
class SolidCanvas;
class SurfaceCheck;
class Viewport;

/// The window's support of solids: their view (made for the first solid, since it needs OpenGL) and their
/// commands.
class SolidWorkshop : public QObject {
    Q_OBJECT

  public:
    struct Surroundings {
        ShapeSession& session;
        Actions& actions;
        SolidActions& solids;
        Properties& properties;
        Exporter& exporter;
        InfoBanner& banner;
    };
    SolidWorkshop(const Surroundings& around, QWidget& window);

    SolidActions& actions() { return m_actions; }
    /// Shows or hides the view of solids. If it cannot be made, its page has a text that says why.
    void setActive(bool active);
    bool isActive() const { return m_isActive; }
    /// Shows the domain's panels once the tools for solids exist.
    void showDomain();
    /// Returns to the solid after a change of tool or step.
    void takeUpTool();
    /// Asks for size and name and writes the view as a picture.
    void exportView();
    /// Does the same for a film of the motion.
    void exportFilm();
    /// Returns the solid from the direction of the view, as files show it: without map and cut. Null without
    /// a solid.
    QImage smallView(const QSize& size);
    /// Connects the view options of a canvas, for both halves.
    void connectLooks(wend::SolidCanvas* canvas);
    /// Returns the page of the window; null before the first solid.
    QWidget* page() const { return m_page; }
    /// Returns null if OpenGL is missing.
    SolidCanvas* canvas() const { return m_canvas; }

  signals:
    /// Emitted when the view of solids has been made.
    void viewportMade(wend::Viewport& view);

  private:
    void askForView(const std::optional<FilmSubject>& film);
    void makePage();
    void connectView();
    void connectNavigation();
    void connectCut();
    void showCut();
    void showFailure(const QString& text);
    void holdBeyondCut();

    Surroundings m_around;
    QWidget& m_window;
    SolidActions& m_actions;
    SurfaceCheck* m_check;
    DetailChooser* m_detail;
    QWidget* m_page = nullptr;
    SolidCanvas* m_canvas = nullptr;
    bool m_isActive = false;
    int m_lastCut = 2;
    PlainView m_plain;
    std::map<bool, PictureSettings> m_settings;  // of exported views, and with true of films
};

}  // namespace wend
