#pragma once

#include <QToolBar>

namespace wend {

class Actions;
class PictureActions;
class SolidActions;
class Toolbox;

/// The row of the tool that is chosen: its name, what it does, and its options; in the step Animate those of
/// the film as well.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const Actions& actions, const SolidActions& solids,
              const PictureActions& outline, QWidget* parent);

  private:
    void showTool();
    void showMotion();

    const Toolbox& m_tools;
    const Actions& m_actions;
    const SolidActions& m_solids;
    const PictureActions& m_pictureActions;
};

}  // namespace wend
