#include "app/window/actions/solid_actions.h"

#include "app/window/actions/toolbox.h"

namespace wend {

namespace {

/// Returns a shortcut on the numeric keypad; the digits of the main keyboard switch steps.
QKeySequence keypad(const char* keys) {
    return QKeySequence(QString::fromLatin1(keys), QKeySequence::PortableText);
}

}  // namespace

SolidActions::SolidActions(Toolbox& tools, QObject* parent)
    : ActionMaker(parent), sizes(tools.action(QStringLiteral("sizes"))), m_menu(new QMenu) {
    makeGrabbing();
    makeView();
    makeMenu();
    setShown(false);
}

void SolidActions::makeGrabbing() {
    through = addToggle(
        "through",
        {tr("Through the &Solid"), tr("Rectangle, lasso and brush also take or select what is hidden")},
        QKeySequence(tr("T")), "through");
    holdBeyond =
        add("holdBeyond",
            {tr("Grab Beyond the &Cut"), tr("Take hold of all that the cut takes away, as one handle")},
            QKeySequence(tr("Ctrl+B")));
}

void SolidActions::makeView() {
    detail = addToggle(
        "detail",
        {tr("S&kin"), tr("Show the detailed or textured surface embedded in the solid; off: the border of "
                         "the tetrahedra, which bend")},
        QKeySequence(tr("Shift+D")));
    detail->setChecked(true);
    chooseDetail = add(
        "chooseDetail",
        {tr("Choose Sk&in…"), tr("Embed a detailed, perhaps textured surface from a file in the solid")}, {});
    removeDetail = add("removeDetail",
                       {tr("Re&move Skin"), tr("Show and export the solid with its own surface again")}, {});
    flat = addToggle("flat", {tr("&Flat Faces"), tr("Shade every triangle by itself instead of smoothly")},
                     QKeySequence(tr("Shift+F")));
    orthographic = addToggle("orthographic", {tr("&Parallel View"), tr("See without perspective")},
                             QKeySequence(tr("5")));
    cut = addToggle("cut",
                    {tr("&Cut Open"), tr("Look inside along a plane; an arrow and rings move and tilt it")},
                    QKeySequence(tr("C")), "cut");
    const QString look = tr("Look along an axis of the world");
    front = add("front", {tr("&Front"), look}, QKeySequence(tr("1")));
    back = add("back", {tr("&Back"), look}, keypad("Ctrl+Num+1"));
    right = add("right", {tr("&Right"), look}, QKeySequence(tr("3")));
    left = add("left", {tr("&Left"), look}, keypad("Ctrl+Num+3"));
    top = add("top", {tr("&Top"), look}, QKeySequence(tr("7")));
    bottom = add("bottom", {tr("B&ottom"), look}, keypad("Ctrl+Num+7"));
    oblique = add("oblique", {tr("&Oblique"), tr("Look from the side and above")}, QKeySequence(tr("0")));
    const QString up = tr("Which axis of the world points up in the view; kept with the project");
    upAxes = {addToggle("upX", {tr("&X Points Up"), up}, {}), addToggle("upY", {tr("&Y Points Up"), up}, {}),
              addToggle("upZ", {tr("&Z Points Up"), up}, {})};
    oneOf({upAxes[0], upAxes[1], upAxes[2]});
    upAxes[2]->setChecked(true);
    wendKeys = addToggle(
        "wendKeys", {tr("&Wend"), tr("Right or middle button turns, with Shift moves; the wheel zooms")}, {});
    vtkKeys = addToggle(
        "vtkKeys", {tr("Like &VTK"), tr("Left button turns, middle moves, right zooms, as in ParaView")}, {});
    blenderKeys =
        addToggle("blenderKeys",
                  {tr("Like &Blender"), tr("Middle button turns, with Shift moves, with Ctrl zooms")}, {});
    oneOf({wendKeys, vtkKeys, blenderKeys});
    wendKeys->setChecked(true);
}

void SolidActions::makeMenu() {
    m_menu->setTitle(tr("&Solid"));
    m_menu->addActions({through, holdBeyond});
    m_menu->addSeparator();
    m_menu->addMenu(tr("L&ook from"))->addActions({front, back, right, left, top, bottom, oblique});
    m_menu->addMenu(tr("&Up Axis"))->addActions({upAxes[0], upAxes[1], upAxes[2]});
    m_menu->addMenu(tr("&Navigation"))->addActions({wendKeys, vtkKeys, blenderKeys});
    m_menu->addActions({detail, orthographic, flat, cut});
    m_menu->addSeparator();
    m_menu->addActions({chooseDetail, removeDetail});
}

void SolidActions::resetView() {
    detail->setChecked(true);
}

void SolidActions::setHasDetail(bool has) {
    enable(detail, has, tr("The solid has neither a detailed surface nor materials."));
}

void SolidActions::setHasChosenDetail(bool has) {
    enable(removeDetail, has, tr("No detailed surface was chosen for the solid."));
}

void SolidActions::setMeshed(bool meshed) {
    enable(sizes, meshed, tr("The mesh comes from a file and is used as it is."));
}

void SolidActions::setUpAxis(UpAxis axis) {
    upAxes[static_cast<std::size_t>(axis)]->setChecked(true);
}

void SolidActions::setShown(bool shown) {
    m_menu->menuAction()->setVisible(shown);
    for (QAction* action : findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly)) {
        action->setVisible(shown);
        enable(action, shown, tr("Open a solid first."));
    }
}

}  // namespace wend
