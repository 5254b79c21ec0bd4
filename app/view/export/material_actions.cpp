#include "app/view/export/material_actions.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>

#include "app/document/design.h"
#include "app/document/domain.h"
#include "app/document/edits/material_edits.h"
#include "app/document/said.h"
#include "app/session/opening.h"
#include "app/session/shape_session.h"
#include "app/view/export/exporter.h"
#include "core/mesh/error.h"

namespace wend {

MaterialActions::MaterialActions(ShapeSession& session, Exporter& exporter, QObject* parent)
    : ActionMaker(parent), m_session(session), m_menu(new QMenu) {
    using enum MaterialPart;
    bringIn[Keep] = add({tr("Bring In What Is &Kept…"),
                         tr("A gray picture over the whole, as a layer: black keeps area, white angles")},
                        {});
    bringIn[Stiffness] = add({tr("Bring In &Stiffness…"),
                              tr("A gray picture over the whole, as a layer: black is as everywhere, white "
                                 "1000 times stiffer")},
                             {});
    bringIn[Direction] = add({tr("Bring In &Directions…"),
                              tr("A gray picture over the whole, as a layer: black lies, middle gray stands, "
                                 "and what is stiff is so along it")},
                             {});
    cells = add({tr("Bring In Values of &Cells…"),
                 tr("φ and B of every cell from a mesh file that holds them, such as one that was exported")},
                {});
    write[Keep] =
        add({tr("Write What Is K&ept…"), tr("As a gray picture, to go on with in a paint program")}, {});
    write[Stiffness] =
        add({tr("Write S&tiffness…"), tr("As a gray picture, to go on with in a paint program")}, {});
    write[Direction] =
        add({tr("Write Di&rections…"), tr("As a gray picture, to go on with in a paint program")}, {});
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
    connect(&m_session, &ShapeSession::frameChanged, this, &MaterialActions::refresh);
    refresh();
}

void MaterialActions::refresh() {
    const bool solid = m_session.document().dimension() == 3;
    const bool has = m_session.frame() != nullptr;
    const QString why = !has ? tr("Open a picture first.")
                             : tr("Of a solid, values of cells; they are written with its mesh.");
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
    const auto shown = m_session.frame<2>();
    if (!shown) return;
    const PictureFrame frame =
        pictureFrame(picture ? picture->width : 0, picture ? picture->height : 0, *shown->rest);
    MaterialPictures pictures;
    pictures.*fileOf(part) = path.toStdString();
    pictures.up = frame.up;
    document.changeDesign(tr("Bring in %1").arg(QFileInfo(path).fileName()),
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

/// It holds what the layers make of the material, too: they would do so twice.
void MaterialActions::takeCells(const QString& path) {
    Document& document = m_session.document();
    document.changeDesign(tr("Bring in %1").arg(QFileInfo(path).fileName()),
                          withCellsFile(withAllHidden(document.design()), path.toStdString()));
    emit done(tr("The layers are switched off: what is brought in stands below them."));
}

}  // namespace wend
