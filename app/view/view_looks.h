#pragma once

#include <QWidget>

namespace wend {

class Actions;
class CompareView;
class EnergySlider;
class Properties;
class ShapeCanvas;
class ShapeSession;
class SolidWorkshop;

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
    void connectLooks(ShapeCanvas& canvas);
    void connectComparison();
    void connectLeaning(EnergySlider& tiles);
    void connectHiding(QWidget& window);

    Parts m_parts;
    int m_pulledFrom = 0;  // where the pointer was on the screen when a drag began
};

}  // namespace wend
