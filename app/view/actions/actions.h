#pragma once

#include <QMenu>
#include <memory>

#include "app/view/actions/action_maker.h"

class QMainWindow;
class QUndoStack;

namespace wend {

class BackdropChoice;
class LanguageChoice;
class Toolbox;

/// Everything that can be done in the window beside its tools, with name, shortcut and explanation. What a
/// disabled action waits for stands in its tooltip.
class Actions : public ActionMaker {
    Q_OBJECT

  public:
    Actions(QUndoStack& undo, Toolbox& tools, QObject* parent);

    QAction *open, *save, *saveAs, *closeFile, *quit;
    QAction *exportPicture, *exportMesh, *exportFrames, *exportStMap, *exportView;
    QAction *undo, *redo, *selectAll, *selectNone, *remove;
    QAction *selectTool, *pinTool;  // of the tools, what others come back to
    QAction *showMesh, *showMap, *showMarks, *showArrows, *hideOverlays, *showRest, *compare;
    QAction *fit, *actualSize, *zoomIn, *zoomOut, *fullScreen, *showProperties;
    QAction *play, *loop, *toStart, *toEnd, *settle, *record, *onionSkin;
    QAction *systemLook, *lightLook, *darkLook;
    QAction *about, *manual, *tutorial, *shortcuts, *history;
    const std::unique_ptr<QMenu> recent, samples, exports;
    BackdropChoice* const backdrop;
    LanguageChoice* const languages;
    /// Of playing and recording, and of marks; the factor is the data of their actions.
    const std::unique_ptr<QMenu> speed, markSizes;

    /// Menus of the whole program, in the order of the work.
    /// `more` stands between those of the view and of the motion; `curve` within that of the motion, `edits`
    /// within Edit.
    void fillMenuBar(QMainWindow& window, QMenu* more, QMenu* curve, const QList<QMenu*>& edits);
    /// What needs a shape, a selection, a motion.
    void setHasFile(bool has, bool hasPicture, bool isSolid);
    void setHasSelection(bool has);
    /// What is shown of a document, and the tool, as at the start: another document is seen as it is.
    void resetView();
    void setHasMotion(bool has);
    void setSpeed(double factor);

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
