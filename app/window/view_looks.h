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

/// Makes a view follow the view actions and the map's panel, or a single switch.
void followLooks(Viewport& view, const Actions& actions, const DistortionPanel& map);
void followLook(Viewport& view, const QAction* action, bool Looks::*look);

/// Connects view options with the actions and panels that set them, for one view or both halves of a
/// comparison.
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
