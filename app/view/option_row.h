#pragma once

#include <QToolBar>

namespace wend {

class PictureActions;
class SolidActions;
class Toolbox;

/// The row of the tool that is chosen: its name, what it does, and its options.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const SolidActions& solids, const PictureActions& outline,
              QWidget* parent);

  private:
    void showTool();

    const Toolbox& m_tools;
    const SolidActions& m_solids;
    const PictureActions& m_pictureActions;
};

}  // namespace wend
