#include "app/window/actions/toolbox.h"

#include <QCoreApplication>
#include <QSet>

namespace wend {

Toolbox::Toolbox(QObject* parent) : ActionMaker(parent), m_group(new QActionGroup(this)) {
    makeModes();
    for (const ToolKind& kind : toolTable()) makeTool(kind);
    action(QStringLiteral("pin"))->setChecked(true);
    setDimension(0);
}

void Toolbox::makeModes() {
    const std::map<Mode, Words> words = {
        {Mode::Mesh, {tr("Mesh"), tr("What bends, and how finely")}},
        {Mode::Pins, {tr("Pins"), tr("Hold parts and drag them")}},
        {Mode::Paint, {tr("Paint"), tr("What it is made of: soft, stiff, and what is kept where")}},
        {Mode::Animate, {tr("Animate"), tr("How it moves in time")}},
        {Mode::Export, {tr("Export"), tr("Write pictures, sequences, ST maps and meshes")}},
    };
    QActionGroup* group = oneOf({});
    for (const Mode mode : kModes) {
        const QString keys = QStringLiteral("Ctrl+%1").arg(static_cast<int>(mode) + 1);
        QAction* one = addToggle(QStringLiteral("step%1").arg(static_cast<int>(mode) + 1), words.at(mode),
                                 QKeySequence(keys), [this, mode] { setMode(mode); });
        m_modes[mode] = group->addAction(one);
    }
}

void Toolbox::makeTool(const ToolKind& kind) {
    QAction* tool = addToggle(
        QString::fromLatin1(kind.id),
        {QCoreApplication::translate("Tools", kind.name), QCoreApplication::translate("Tools", kind.help)},
        {}, QString::fromLatin1(kind.icon));
    setKeysOf(tool, QKeySequence::listFromString(QString::fromLatin1(kind.keys)));
    m_group->addAction(tool);
    m_tools.push_back(tool);
    onToggled(this, tool, [this, &kind](bool on) {
        if (on) choose(kind);
    });
}

QAction* Toolbox::action(const QString& id) const {
    for (QAction* tool : m_tools)
        if (tool->objectName() == id) return tool;
    return nullptr;
}

bool Toolbox::fits(const ToolKind& kind) const {
    return kind.make.of(m_dimension) != nullptr;
}

const ToolKind* Toolbox::current() const {
    for (std::size_t i = 0; i < m_tools.size(); ++i)
        if (m_tools[i]->isChecked() && m_dimension > 0 && fits(toolTable()[i])) return &toolTable()[i];
    return nullptr;
}

bool Toolbox::isChosen(const char* id) const {
    const ToolKind* kind = current();
    return kind && qstrcmp(kind->id, id) == 0;
}

QList<QAction*> Toolbox::toolsOf(Mode mode) const {
    QList<QAction*> tools;
    for (std::size_t i = 0; i < m_tools.size(); ++i)
        if (toolTable()[i].modes.has(mode) && fits(toolTable()[i])) tools << m_tools[i];
    return tools;
}

QList<QAction*> Toolbox::toolsFirstIn(Mode mode) const {
    QList<QAction*> tools;
    for (std::size_t i = 0; i < m_tools.size(); ++i)
        if (toolTable()[i].modes.first() == mode) tools << m_tools[i];
    return tools;
}

void Toolbox::choose(const ToolKind& kind) {
    if (!kind.modes.has(m_mode)) m_mode = kind.modes.first();
    m_last[m_mode] = action(QString::fromLatin1(kind.id));
    show();
}

/// Returns the step's last tool, its first tool, or the select tool.
QAction* Toolbox::toolFor(Mode mode) const {
    if (const auto last = m_last.find(mode); last != m_last.end() && last->second->isEnabled())
        return last->second;
    for (std::size_t i = 0; i < m_tools.size(); ++i)
        if (toolTable()[i].begins.has(mode) && fits(toolTable()[i])) return m_tools[i];
    return action(QStringLiteral("select"));
}

void Toolbox::setMode(Mode mode) {
    m_mode = mode;
    QAction* tool = toolFor(mode);
    tool->isChecked() ? show() : tool->setChecked(true);
}

void Toolbox::setDimension(int dimension) {
    m_dimension = dimension;
    m_last.clear();
    const QString why = dimension == 0   ? tr("Open a picture first.")
                        : dimension == 2 ? tr("Open a solid first.")
                                         : tr("Open a picture first.");
    for (std::size_t i = 0; i < m_tools.size(); ++i) {
        m_tools[i]->setVisible(fits(toolTable()[i]));
        enable(m_tools[i], dimension > 0 && fits(toolTable()[i]), why);
    }
    for (const auto& [mode, action] : m_modes) enable(action, dimension > 0, tr("Open a picture first."));
    setMode(Mode::Pins);
}

void Toolbox::show() {
    m_modes.at(m_mode)->setChecked(true);
    shareKeys();
    emit changed();
}

void Toolbox::shareKeysWith(const QList<ActionMaker*>& others) {
    m_others = others;
    shareKeys();
}

QList<QAction*> Toolbox::actionsWithKeys() const {
    QList<QAction*> actions = own();
    for (const ActionMaker* maker : m_others) actions << maker->own();
    return actions;
}

bool Toolbox::canShareKeys(const QAction& one, const QAction& other) const {
    if (one.isVisible() != other.isVisible()) return true;
    const auto kindOf = [this](const QAction& action) -> const ToolKind* {
        const auto at = std::ranges::find(m_tools, &action);
        return at != m_tools.end() ? &toolTable()[static_cast<std::size_t>(at - m_tools.begin())] : nullptr;
    };
    const ToolKind *a = kindOf(one), *b = kindOf(other);
    return a && b &&
           std::ranges::none_of(kModes, [&](Mode mode) { return a->modes.has(mode) && b->modes.has(mode); });
}

void Toolbox::shareKeys() {
    QList<QAction*> inOrder = toolsOf(m_mode);
    for (ActionMaker* maker : m_others) inOrder << maker->own();
    for (QAction* tool : m_tools)
        if (!inOrder.contains(tool)) inOrder << tool;
    QSet<QKeySequence> taken;
    for (QAction* action : inOrder) {
        if (!action->isVisible()) continue;
        QList<QKeySequence> keys;
        for (const QKeySequence& key : keysOf(*action))
            if (!taken.contains(key)) keys << key;
        taken.unite({keys.begin(), keys.end()});
        useKeys(action, keys);
    }
}

}  // namespace wend
