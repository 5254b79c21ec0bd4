#pragma once

#include <QActionGroup>
#include <QMenu>
#include <memory>

#include "app/view/action_maker.h"

class QMainWindow;
class QUndoStack;

namespace wend {

/// Everything that can be done in the window, with name, shortcut and explanation. What a disabled action
/// waits for stands in its tooltip.
class Actions : public ActionMaker {
    Q_OBJECT

  public:
    Actions(QUndoStack& undo, QObject* parent);

    QAction *open, *save, *saveAs, *closeFile, *quit;
    QAction *exportPicture, *exportMesh, *exportFrames, *exportStMap;
    QAction *undo, *redo, *selectAll, *selectNone, *remove;
    QAction *selectTool, *pinTool;
    QAction *showMesh, *showMap, *hideOverlays, *fit, *actualSize, *zoomIn, *zoomOut, *fullScreen;
    QAction *play, *loop, *toStart, *toEnd, *settle;
    QAction *systemLook, *lightLook, *darkLook;
    QAction *about, *shortcuts;
    QActionGroup* tools;  // one of them is chosen
    const std::unique_ptr<QMenu> recent, samples;

    /// Menus of the whole program, in the order of the work.
    /// `more` stands between those of the view and of the motion; `curve` within that of the motion, `hold`
    /// behind the tools for pins.
    void fillMenuBar(QMainWindow& window, QMenu* more, QMenu* curve, const QList<QAction*>& hold);
    /// What needs a shape, a selection, a motion.
    void setHasFile(bool has, bool hasPicture, bool isSolid);
    void setHasSelection(bool has);
    /// What is shown of a document, and the tool, as at the start: another document is seen as it is.
    void resetView();
    void setHasMotion(bool has);

  private:
    void makeFile();
    void makeEdit(QUndoStack& undo);
    void makeView();
    void makeMotion();
    void makeHelp();
};

}  // namespace wend
