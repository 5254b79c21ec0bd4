#pragma once

#include <QMenu>
#include <map>
#include <memory>

#include "app/engine/shape/material_picture.h"
#include "app/window/actions/action_maker.h"

namespace wend {

class Exporter;
class ShapeSession;

/// The material as pictures of a paint program, brought in as a layer and written out; of a solid, values of
/// its cells from a mesh file.
class MaterialActions : public ActionMaker {
    Q_OBJECT

  public:
    MaterialActions(ShapeSession& session, Exporter& exporter, QObject* parent);

    std::map<MaterialPart, QAction*> bringIn, write;
    QAction* cells;

    QMenu* menu() const { return m_menu.get(); }

    /// Adds a picture of a part of the material as the topmost layer.
    void take(MaterialPart part, const QString& path);
    void takeCells(const QString& path);

  signals:
    void failed(QString text);
    void done(QString text);

  private:
    void refresh();
    void ask(MaterialPart part);
    void askCells();

    ShapeSession& m_session;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
