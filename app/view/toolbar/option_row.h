#pragma once

#include <QToolBar>

#include "app/view/toolbar/tool_options.h"

namespace wend {

class Actions;
class Toolbox;

/// The row of the tool that is chosen: its name, what it does, and its options; in the step Animate those of
/// the film as well.
class OptionRow : public QToolBar {
    Q_OBJECT

  public:
    OptionRow(const Toolbox& tools, const Actions& actions, const ToolOptions& options, QWidget* parent);

  private:
    void showTool();
    void showMotion();

    const Toolbox& m_tools;
    const Actions& m_actions;
    ToolOptions m_options;
};

}  // namespace wend
