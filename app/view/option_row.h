#pragma once

#include <QToolBar>

namespace wend {

class SolidActions;
class Toolbox;

/// The row of the tool that is chosen: its name, what it does, and its options.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const SolidActions& solids, QWidget* parent);

  private:
    void showTool();

    const Toolbox& m_tools;
    const SolidActions& m_solids;
};

}  // namespace wend
