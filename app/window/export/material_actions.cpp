#include "app/window/export/material_actions.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>

#include "app/base/said.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/material_edits.h"
#include "app/session/opening.h"
#include "app/session/shape_session.h"
#include "app/window/export/exporter.h"
#include "core/base/error.h"

namespace wend {

MaterialActions::MaterialActions(ShapeSession& session, Exporter& exporter, QObject* parent)
    : ActionMaker(parent), m_session(session), m_menu(new QMenu) {
    using enum MaterialPart;
    bringIn[Keep] =
        add("importKeep",
            {tr("Import &Keep…"),
             tr("A grey picture over the whole, as a layer: black keeps area, white keeps angles")},
            {});
    bringIn[Stiffness] =
        add("importStiffness",
            {tr("Import &Stiffness…"), tr("A grey picture over the whole, as a layer: black is the same as "
                                          "everywhere, white is 1000 times stiffer")},
            {});
    bringIn[Direction] =
        add("importDirection",
            {tr("Import &Directions…"), tr("A grey picture over the whole, as a layer, of the direction of "
                                           "stiffness: black is level, middle grey upright")},
            {});
    cells = add("cells",
                {tr("Import Values of &Cells…"),
                 tr("φ and B of every cell from a mesh file that contains them, such as an exported one")},
                {});
    write[Keep] = add("exportKeep",
                      {tr("Export K&eep…"), tr("As a grey picture, to be edited in a paint program")}, {});
    write[Stiffness] =
        add("exportStiffness",
            {tr("Export S&tiffness…"), tr("As a grey picture, to be edited in a paint program")}, {});
    write[Direction] =
        add("exportDirection",
            {tr("Export Di&rections…"), tr("As a grey picture, to be edited in a paint program")}, {});
    m_menu->setTitle(tr("&Material"));
    for (const auto& [part, action] : bringIn) {
        m_menu->addAction(action);
        connect(action, &QAction::triggered, this, [this, part = part] { ask(part); });
    }
    m_menu->addAction(cells);
    m_menu->addSeparator();
    for (const auto& [part, action] : write) {
        m_menu->addAction(action);
        connect(action, &QAction::triggered, this,
                [&exporter, part = part] { exporter.exportMaterial(part); });
    }
    connect(cells, &QAction::triggered, this, &MaterialActions::askCells);
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &MaterialActions::refresh);
    refresh();
}

void MaterialActions::refresh() {
    const bool solid = m_session.document().dimension() == 3;
    const bool has = m_session.motion().frame() != nullptr;
    const QString why = !has ? tr("Open a picture first.")
                             : tr("For a solid, these are values of cells; they are exported with its mesh.");
    for (const auto* actions : {&bringIn, &write})
        for (const auto& [part, action] : *actions) enable(action, has && !solid, why);
    const bool isMesh = has && m_session.document().domain().kind == DomainKind::Mesh;
    enable(cells, isMesh, has ? tr("Only the cells of a mesh file stay the same.") : why);
}

void MaterialActions::ask(MaterialPart part) {
    QString title = bringIn[part]->text().remove('&');
    const QString path = QFileDialog::getOpenFileName(QApplication::activeWindow(), title,
                                                      proposedFolder(m_session.document()),
                                                      tr("Pictures (%1)").arg(pictureExtensions()));
    if (!path.isEmpty()) take(part, path);
}

void MaterialActions::take(MaterialPart part, const QString& path) try {
    readImageHeader(path.toStdString());
    Document& document = m_session.document();
    const auto& picture = document.picture();
    const auto shown = m_session.motion().frame<2>();
    if (!shown) return;
    const PictureFrame frame =
        pictureFrame(picture ? picture->width : 0, picture ? picture->height : 0, *shown->rest);
    MaterialPictures pictures;
    pictures.*fileOf(part) = path.toStdString();
    pictures.up = frame.up;
    document.changeDesign(tr("Import %1").arg(QFileInfo(path).fileName()),
                          withPictures(document.design(), QFileInfo(path).completeBaseName().toStdString(),
                                       frame.box, pictures));
} catch (const InputError& error) {
    emit failed(said(error));
}

void MaterialActions::askCells() {
    const QString path = QFileDialog::getOpenFileName(QApplication::activeWindow(), cells->text().remove('&'),
                                                      proposedFolder(m_session.document()),
                                                      tr("Values of cells (*.vtu *.vtk *.json)"));
    if (!path.isEmpty()) takeCells(path);
}

/// The values include those of the layers, which would apply twice.
void MaterialActions::takeCells(const QString& path) {
    Document& document = m_session.document();
    document.changeDesign(tr("Import %1").arg(QFileInfo(path).fileName()),
                          withCellsFile(withAllHidden(document.design()), path.toStdString()));
    emit done(tr("The layers were switched off: what was imported lies below them."));
}

}  // namespace wend
