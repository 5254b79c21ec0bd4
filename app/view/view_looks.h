#pragma once

#include <QAction>
#include <QWidget>

namespace wend {

class Actions;
class CompareView;
class DistortionPanel;
class Properties;
class ShapeCanvas;
class ShapeSession;
class SolidWorkshop;
class Viewport;
struct Looks;

/// A view shows from now on what the actions and the map's panel say, or a single switch.
void followLooks(Viewport& view, const Actions& actions, const DistortionPanel& map);
void followLook(Viewport& view, const QAction* action, bool Looks::*look);

/// What is seen of the shape, by the actions and panels that say so: mesh, map, marks, in one view or in both
/// halves of a comparison; pins and maps hidden, and the shape as it was before.
class ViewLooks : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        ShapeSession& session;
        const Actions& actions;
        Properties& properties;
        ShapeCanvas& picture;
        CompareView& compared;
        SolidWorkshop& solids;
    };
    ViewLooks(const Parts& parts, QWidget* window);

  private:
    void connectComparison();
    void connectHiding(QWidget& window);

    Parts m_parts;
};

}  // namespace wend
