#pragma once

#include <QActionGroup>
#include <map>

#include "app/window/actions/action_maker.h"
#include "app/window/actions/tool_table.h"

namespace wend {

/// The tools as actions, one of which is active, and the steps of the work, one of which is current and
/// remembers its tool. Activating a tool of another step switches to that step.
class Toolbox : public ActionMaker {
    Q_OBJECT

  public:
    explicit Toolbox(QObject* parent);

    QAction* action(const QString& id) const;
    QAction* modeAction(Mode mode) const { return m_modes.at(mode); }
    Mode mode() const { return m_mode; }
    void setMode(Mode mode);
    int dimension() const { return m_dimension; }
    /// 0: nothing is open. A shape begins with its pins.
    void setDimension(int dimension);
    /// Returns the active tool; null if it does not apply to the document.
    const ToolKind* current() const;
    bool isChosen(const char* id) const;
    /// Returns the tools of a step for the open document.
    QList<QAction*> toolsOf(Mode mode) const;
    /// Tools under the step that they are first of, for a menu.
    QList<QAction*> toolsFirstIn(Mode mode) const;
    /// Shares keys with other actions: a key belongs to the current step's tools first, then to these, then
    /// to the tools of other steps.
    void shareKeysWith(const QList<ActionMaker*>& others);
    /// Assigns the keys anew, after an action got others.
    void shareKeys();
    /// Returns the tools, the steps and the actions that keys are shared with.
    QList<QAction*> actionsWithKeys() const;
    /// Returns whether two actions may have the same key: tools of different steps, or one for pictures and
    /// one for solids.
    bool canShareKeys(const QAction& one, const QAction& other) const;

  signals:
    /// Emitted when the tool, the step or the dimension changed.
    void changed();

  private:
    void makeModes();
    void makeTool(const ToolKind& kind);
    bool fits(const ToolKind& kind) const;
    QAction* toolFor(Mode mode) const;
    void choose(const ToolKind& kind);
    void show();

    QActionGroup* m_group;
    std::map<Mode, QAction*> m_modes;
    std::map<Mode, QAction*> m_last;  // the tool that each step had last
    std::vector<QAction*> m_tools;    // in the order of the table
    QList<ActionMaker*> m_others;
    Mode m_mode = Mode::Pins;
    int m_dimension = 0;
};

}  // namespace wend
