#pragma once

#include <QMenu>
#include <memory>

#include "app/window/actions/action_maker.h"

class QMainWindow;
class QUndoStack;

namespace wend {

class BackdropChoice;
class LanguageChoice;
class Toolbox;

/// All actions of the window besides its tools, with name, shortcut and help. The tooltip of a disabled
/// action gives the reason.
class Actions : public ActionMaker {
    Q_OBJECT

  public:
    Actions(QUndoStack& undo, Toolbox& tools, QObject* parent);

    QAction *open, *save, *saveAs, *replacePicture, *drawingSize, *closeFile, *quit;
    QAction *exportPicture, *exportMesh, *exportFilm, *exportFrames, *exportStMap, *exportView;
    QAction *undo, *redo, *selectAll, *selectNone, *remove, *makePart;
    QAction *selectTool, *pinTool, *lassoTool;  // tools that others return to, or begin with
    QAction *showMesh, *showMap, *showMarks, *showArrows, *hideOverlays, *showRest, *compare;
    QAction *fit, *actualSize, *zoomIn, *zoomOut, *fullScreen, *showProperties;
    QAction *play, *loop, *toStart, *toEnd, *settle, *record, *poseHere, *keepWay, *onionSkin, *applyMotion;
    QAction *systemLook, *lightLook, *darkLook;
    QAction *about, *manual, *tutorial, *shortcuts, *chooseKeys, *history;
    const std::unique_ptr<QMenu> recent, samples, exports;
    BackdropChoice* const backdrop;
    LanguageChoice* const languages;
    /// Menus of factors for playback speed and size of marks; the factor is the action's data.
    const std::unique_ptr<QMenu> speed, markSizes;

    /// Fills the menu bar in the order of the work. `more` is inserted between View and Motion, `curve` into
    /// Motion, `edits` into Edit.
    void fillMenuBar(QMainWindow& window, QMenu* more, QMenu* curve, const QList<QMenu*>& edits);
    /// Enables what needs a shape, a selection or a motion.
    void setHasFile(bool has, bool hasPicture, bool hasDrawing, bool isSolid);
    void setHasSelection(bool has);
    /// Resets view options and the tool for another document.
    void resetView();
    void setHasMotion(bool has);
    void setSpeed(double factor);
    void setPlaying(bool playing);

  private:
    void makeFile();
    void makeEdit(QUndoStack& undo);
    void makeView();
    void makeMotion();
    void makeHelp();
    static void fillFactors(QMenu& menu, const QList<int>& percents);
    void fillTools(QMenu& menu) const;

    Toolbox& m_tools;
};

}  // namespace wend
