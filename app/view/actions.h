#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QObject>

class QMainWindow;
class QUndoStack;

namespace wend {

/// Everything that can be done in the window, with name, shortcut and explanation. What a disabled action
/// waits for stands in its tooltip.
class Actions : public QObject {
    Q_OBJECT

  public:
    Actions(QUndoStack& undo, QObject* parent);

    QAction *open, *save, *saveAs, *closeFile, *quit;
    QAction *exportPicture, *exportMesh, *exportFrames, *exportStMap;
    QAction *undo, *redo, *selectAll, *selectNone, *remove;
    QAction *selectTool, *pinTool;
    QAction *showMesh, *showMap, *hideOverlays, *fit, *actualSize, *zoomIn, *zoomOut, *fullScreen;
    QAction *play, *loop, *toStart, *toEnd;
    QAction *systemLook, *lightLook, *darkLook;
    QAction *about, *shortcuts;
    QMenu* recent;
    QMenu* samples;

    /// Menus of the whole program, in the order of the work.
    void fillMenuBar(QMainWindow& window);
    void setIcons(const QPalette& palette);
    /// What needs a shape, a selection, a motion.
    void setHasFile(bool has, bool hasPicture);
    void setHasSelection(bool has);
    void setHasMotion(bool has);

  private:
    struct Words {
        QString name, help;
    };
    QAction* add(const Words& words, const QKeySequence& keys, const QString& icon = {});
    QAction* addToggle(const Words& words, const QKeySequence& keys, const QString& icon = {});
    void makeFile();
    void makeEdit(QUndoStack& undo);
    void makeView();
    void makeMotion();
    void makeHelp();
    void enable(QAction* action, bool enabled, const QString& whyNot);
    void describe(QAction* action, const QString& extra = {});
};

}  // namespace wend
