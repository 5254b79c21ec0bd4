#include "app/window/actions/actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QUndoStack>

#include "app/style/theme.h"
#include "app/window/actions/bars.h"
#include "app/window/actions/language_choice.h"
#include "app/window/actions/look_choices.h"
#include "app/window/actions/toolbox.h"

namespace wend {

Actions::Actions(QUndoStack& undoStack, Toolbox& tools, QObject* parent)
    : ActionMaker(parent),
      selectTool(tools.action(QStringLiteral("select"))),
      pinTool(tools.action(QStringLiteral("pin"))),
      lassoTool(tools.action(QStringLiteral("outlineLasso"))),
      recent(std::make_unique<QMenu>()),
      samples(std::make_unique<QMenu>()),
      exports(std::make_unique<QMenu>()),
      backdrop(new BackdropChoice(this)),
      languages(new LanguageChoice(this)),
      speed(std::make_unique<QMenu>()),
      markSizes(std::make_unique<QMenu>()),
      m_tools(tools) {
    makeFile();
    makeEdit(undoStack);
    makeView();
    makeMotion();
    makeHelp();
    setHasFile(false, false, false, false);
    setHasSelection(false);
    setHasMotion(false);
}

void Actions::makeFile() {
    open = add("open", {tr("&Open…"), tr("Open a picture, a mesh, a surface or a project")},
               QKeySequence::Open, "open");
    save = add("save", {tr("&Save"), tr("Save the project")}, QKeySequence::Save, "save");
    saveAs =
        add("saveAs", {tr("Save &As…"), tr("Save the project under another name")}, QKeySequence::SaveAs);
    replacePicture =
        add("replacePicture",
            {tr("Re&place Picture…"),
             tr("Bend another picture of the same proportions in the place of this one; pins and "
                "motions stay, and are scaled if it is larger or smaller")},
            {});
    drawingSize =
        add("drawingSize",
            {tr("&Drawing Size…"),
             tr("Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it")},
            {});
    exportPicture = add("exportPicture", {tr("&Picture…"), tr("Write the bent picture at its full size")},
                        QKeySequence(tr("Ctrl+E")), "export");
    exportFilm =
        add("exportFilm", {tr("&Film…"), tr("Write the motion as a film: MP4, WebM, QuickTime, GIF …")}, {});
    exportFrames =
        add("exportFrames", {tr("&Sequence…"), tr("Write the motion as a sequence of pictures or meshes")},
            QKeySequence(tr("Ctrl+Shift+E")), "frames");
    exportStMap =
        add("exportStMap",
            {tr("ST &Map…"), tr("Write where each pixel comes from, for compositing programs")}, {});
    exportMesh = add("exportMesh", {tr("&Mesh…"), tr("Write the bent mesh as OBJ, PLY, VTU …")}, {});
    exportView =
        add("exportView", {tr("&View…"), tr("Write the view as a picture, as large as you like")}, {});
    exports->setTitle(tr("&Export"));
    exports->addActions({exportPicture, exportFilm, exportFrames, exportStMap, exportMesh, exportView});
    closeFile = add("closeFile", {tr("&Close"), tr("Close the file and go back to the start page")},
                    QKeySequence::Close);
    quit = add("quit", {tr("&Quit"), tr("Leave Wend")}, QKeySequence::Quit);
    quit->setMenuRole(QAction::QuitRole);
    recent->setTitle(tr("Open &Recent"));
    samples->setTitle(tr("Open Sa&mple"));
}

void Actions::makeEdit(QUndoStack& stack) {
    undo = stack.createUndoAction(this, tr("&Undo"));
    redo = stack.createRedoAction(this, tr("&Redo"));
    adopt(undo, "undo", {QKeySequence(QKeySequence::Undo)});
    adopt(redo, "redo", {QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    undo->setProperty("iconName", "undo");
    redo->setProperty("iconName", "redo");
    undo->setStatusTip(tr("Undo the last step"));
    redo->setStatusTip(tr("Redo what was undone"));
    history = add("history", {tr("&History…"), tr("Show the undo history, and go back to any step")},
                  QKeySequence(tr("Ctrl+H")));
    selectAll = add("selectAll", {tr("Select &All Pins"), tr("Select all pins")}, QKeySequence::SelectAll);
    selectNone =
        add("selectNone", {tr("Select &None"), tr("Select no pin")}, QKeySequence(tr("Ctrl+Shift+A")));
    remove = add("remove", {tr("&Remove Pins"), tr("Remove the selected pins; what has already moved stays")},
                 QKeySequence::Delete, "remove");
    makePart =
        add("makePart",
            {tr("Make a &Part"),
             tr("What is drawn as the outline becomes a part that bends by itself, or what you draw next; "
                "what is behind it is filled")},
            QKeySequence(tr("Ctrl+J")), "make-part");
}

void Actions::makeView() {
    showMesh = addToggle("showMesh", {tr("&Edges"), tr("Show the edges of the mesh")}, QKeySequence(tr("M")),
                         "mesh");
    showMap = addToggle("showMap", {tr("&Colour Overlay"), tr("Colour the shape by what changed")},
                        QKeySequence(tr("D")), "distortion");
    showMarks = addToggle(
        "showMarks", {tr("&Stiffness Marks"), tr("Show where the shape is stiff, and along which direction")},
        QKeySequence(tr("Shift+S")), "marks");
    showArrows =
        addToggle("showArrows", {tr("&Velocity Arrows"), tr("Show where the shape moves at this time")},
                  QKeySequence(tr("Shift+V")));
    hideOverlays =
        addToggle("hideOverlays",
                  {tr("&Hide Pins and Overlays"), tr("Show the bare picture; hold H to do so for a moment")},
                  QKeySequence(tr("Shift+H")), "hide");
    showRest = addToggle(
        "showRest",
        {tr("&Before"), tr("Show the shape as it was before it was bent; hold \\ to do so for a moment")}, {},
        "compare");
    compare = addToggle(
        "compare",
        {tr("&Compare Energies"),
         tr("Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape")},
        QKeySequence(tr("Y")));
    fit = add("fit", {tr("&Fit"), tr("Show the whole picture")}, QKeySequence(tr("F")), "fit");
    actualSize = add("actualSize", {tr("&Actual Size"), tr("One pixel of the picture on one of the screen")},
                     QKeySequence(tr("1")), "zoom-100");
    zoomIn = add("zoomIn", {tr("Zoom &In"), tr("Look closer")}, QKeySequence::ZoomIn);
    zoomOut = add("zoomOut", {tr("Zoom &Out"), tr("See more")}, QKeySequence::ZoomOut);
    fullScreen =
        addToggle("fullScreen", {tr("Full &Screen"), tr("Use the whole screen")}, QKeySequence(Qt::Key_F11));
    showProperties = addToggle(
        "showProperties",
        {tr("&Properties"), tr("Show the properties on the right, or give their room to the shape")},
        QKeySequence(Qt::Key_F4));
    showProperties->setChecked(true);
    systemLook =
        addToggle("systemLook", {tr("Like the &Desktop"), tr("Light or dark, like the desktop")}, {});
    lightLook = addToggle("lightLook", {tr("&Light"), tr("Dark on light")}, {});
    darkLook = addToggle("darkLook", {tr("&Dark"), tr("Light on dark")}, {});
    fillFactors(*markSizes, {100, 150, 200, 300});
    markSizes->setTitle(tr("Size of M&arks"));
    markSizes->menuAction()->setStatusTip(
        tr("How large pins, rings and curves are drawn, so that they are easy to see and to hit"));
    oneOf({systemLook, lightLook, darkLook});
    systemLook->setChecked(true);
}

void Actions::makeMotion() {
    play = add("play", {tr("&Play"), tr("Play or pause the motion; tapping the space bar does so, too")},
               QKeySequence(tr("K")), "play");
    loop = addToggle("loop", {tr("&Loop"), tr("Start over at the end")}, QKeySequence(tr("Shift+L")), "loop");
    toStart = add("toStart", {tr("To the &Start"), tr("Show the shape at rest")}, QKeySequence(Qt::Key_Home),
                  "first-frame");
    toEnd = add("toEnd", {tr("To the &End"), tr("Show the end of the motion")}, QKeySequence(Qt::Key_End),
                "last-frame");
    record = addToggle(
        "record",
        {tr("&Record"), tr("Record every drag as it happens, in real time; Ctrl does so for one drag")},
        QKeySequence(tr("Ctrl+R")), "record");
    poseHere =
        addToggle("poseHere",
                  {tr("&Pose at This Time"),
                   tr("In the step Animate, a drag sets where pins are at the time shown, and what they do "
                      "before and after stays; off: it leads them on to the end of the film")},
                  QKeySequence(tr("Shift+T")), "pose-here");
    poseHere->setChecked(true);
    keepWay =
        addToggle("keepWay",
                  {tr("Keep the Pa&th"),
                   tr("A drag that follows another of the same pins at the end of the film leads them on "
                      "by a second; off: it corrects that move, which becomes straight")},
                  {});
    onionSkin = addToggle(
        "onionSkin",
        {tr("&Onion Skin"), tr("Show the shape as it was a little before and as it is a little after")},
        QKeySequence(tr("Shift+N")), "onion");
    fillFactors(*speed, {25, 50, 100, 200});
    speed->menuAction()->setStatusTip(
        tr("How fast the motion plays, and how fast time goes while drags are recorded"));
    speed->menuAction()->setToolTip(speed->menuAction()->statusTip());
    setSpeed(1);
    settle =
        add("settle", {tr("Rela&x"), tr("Let the shape relax at the end, with the pins where they are")}, {});
    applyMotion = add("applyMotion",
                      {tr("&Apply Motion…"),
                       tr("Move this shape as another project moves its own: pins of the same name, with "
                          "lengths in proportion to the sizes of both shapes")},
                      {});
}

/// Adds a menu of factors, of which one is checked, initially the default.
void Actions::fillFactors(QMenu& menu, const QList<int>& percents) {
    auto* group = new QActionGroup(&menu);
    for (const int percent : percents) {
        QAction* one = menu.addAction(tr("%1 %").arg(percent));
        one->setData(percent / 100.0);
        one->setCheckable(true);
        one->setChecked(percent == 100);
        group->addAction(one);
    }
}

void Actions::setSpeed(double factor) {
    speed->setTitle(tr("Speed: %1 %").arg(qRound(100 * factor)));
}

void Actions::setPlaying(bool playing) {
    play->setIcon(
        wendIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"), QApplication::palette()));
    play->setText(playing ? tr("&Pause") : tr("&Play"));
}

void Actions::makeHelp() {
    manual = add("manual", {tr("&Manual"), tr("How it works, page by page, with a search")},
                 QKeySequence(Qt::Key_F1), "help");
    tutorial =
        add("tutorial", {tr("&Tutorial"), tr("The first five minutes, on a sample, step by step")}, {});
    shortcuts = add("shortcuts", {tr("&Keys and Mouse"), tr("What the mouse and the keys do")},
                    QKeySequence(tr("?")));
    chooseKeys = add("chooseKeys", {tr("&Keyboard Shortcuts…"), tr("Give actions other keys")}, {});
    about = add("about", {tr("&About Wend"), tr("Version and licence")}, {});
    about->setMenuRole(QAction::AboutRole);
}

void Actions::fillMenuBar(QMainWindow& window, QMenu* more, QMenu* curve, const QList<QMenu*>& edits) {
    QMenu* file = window.menuBar()->addMenu(tr("&File"));
    file->addAction(open);
    file->addMenu(recent.get());
    file->addMenu(samples.get());
    file->addSeparator();
    file->addActions({save, saveAs, replacePicture, drawingSize});
    file->addSeparator();
    file->addMenu(exports.get());
    file->addSeparator();
    file->addActions({closeFile, quit});
    QMenu* edit = window.menuBar()->addMenu(tr("&Edit"));
    edit->addActions({undo, redo, history});
    edit->addSeparator();
    edit->addActions({selectAll, selectNone, remove, makePart});
    for (QMenu* menu : edits) edit->addMenu(menu);
    edit->addSeparator();
    edit->addAction(chooseKeys);
    QMenu* view = window.menuBar()->addMenu(tr("&View"));
    view->addActions({showMesh, showMap, showMarks, showArrows, hideOverlays, showRest, compare});
    view->addSeparator();
    view->addActions({fit, actualSize, zoomIn, zoomOut});
    view->addSeparator();
    view->addMenu(backdrop->menu());
    QMenu* appearance = view->addMenu(tr("A&ppearance"));
    appearance->addActions({systemLook, lightLook, darkLook});
    appearance->addSeparator();
    appearance->addMenu(markSizes.get());
    view->addMenu(languages->menu());
    view->addActions({showProperties, fullScreen});
    fillTools(*window.menuBar()->addMenu(tr("&Tools")));
    window.menuBar()->addMenu(more);
    QMenu* motion = window.menuBar()->addMenu(tr("&Motion"));
    motion->addActions({play, loop, toStart, toEnd});
    motion->addMenu(speed.get());
    motion->addSeparator();
    motion->addActions({record, poseHere, keepWay, onionSkin, settle});
    motion->addMenu(curve);
    motion->addSeparator();
    motion->addAction(applyMotion);
    window.menuBar()->addMenu(tr("&Help"))->addActions({tutorial, manual, shortcuts, about});
    for (const QAction* one : window.menuBar()->actions()) makeLettersUnique(*one->menu());
    new MenuReasons(&window);
}

/// Lists the steps, and under each the tools that belong to it first.
void Actions::fillTools(QMenu& menu) const {
    for (const Mode mode : kModes) menu.addAction(m_tools.modeAction(mode));
    for (const Mode mode : kModes)
        if (const QList<QAction*> tools = m_tools.toolsFirstIn(mode); !tools.isEmpty()) {
            menu.addSection(m_tools.modeAction(mode)->text());
            menu.addActions(tools);
        }
}

void Actions::setHasFile(bool has, bool hasPicture, bool hasDrawing, bool isSolid) {
    const QString why = tr("Open a picture first.");
    for (QAction* action : {save, saveAs, closeFile, exportMesh, selectAll, selectNone, showMesh, showMap,
                            showMarks, showArrows, hideOverlays, showRest, compare, fit, zoomIn, zoomOut,
                            showProperties, record, applyMotion})
        enable(action, has, why);
    enable(actualSize, has && !isSolid, has ? tr("A solid has no pixels.") : why);
    const QString noPicture = tr("This project has no picture.");
    enable(exportPicture, has && hasPicture && !isSolid,
           isSolid ? tr("A solid has no pixels: export the view.") : (has ? noPicture : why));
    enable(exportView, has && isSolid, has ? tr("For a picture, export the picture itself.") : why);
    enable(exportFrames, has, why);
    enable(exportFilm, has && (hasPicture || isSolid), has ? noPicture : why);
    enable(replacePicture, has && hasPicture && !isSolid, has ? noPicture : why);
    enable(drawingSize, has && hasDrawing,
           has ? tr("This picture is no SVG drawing: its pixels are what it has.") : why);
    for (QAction* action : {exportStMap, makePart}) enable(action, has && hasPicture, has ? noPicture : why);
    const QList<QKeySequence> key = {QKeySequence(tr("Ctrl+E"))};  // exports the shown view
    setKeysOf(exportPicture, isSolid ? QList<QKeySequence>() : key);
    setKeysOf(exportView, isSolid ? key : QList<QKeySequence>());
}

void Actions::resetView() {
    for (QAction* action :
         {showMesh, showMap, showMarks, showArrows, hideOverlays, showRest, compare, record, onionSkin})
        action->setChecked(false);
}

void Actions::setHasSelection(bool has) {
    enable(remove, has, tr("Select a pin first."));
}

void Actions::setHasMotion(bool has) {
    for (QAction* action : {play, loop, toStart, toEnd, onionSkin})
        enable(action, has, tr("Nothing moves yet: drag a pin."));
    for (QAction* action : {exportFilm, exportFrames})
        if (!has) enable(action, false, tr("Nothing moves yet: drag a pin."));
}

}  // namespace wend
