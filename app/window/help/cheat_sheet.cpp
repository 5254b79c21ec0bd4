#include "app/window/help/cheat_sheet.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <array>

#include "app/panels/fields/panel_parts.h"
#include "app/window/actions/action_maker.h"

namespace wend {

namespace {

constexpr int kColumns = 3;

struct Group {
    QString title;
    QStringList rows;
};

QString row(const QString& keys, const QString& what) {
    return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
}

QString plain(const QString& name) {
    return withoutKey(name).remove(QStringLiteral("…"));
}

QString keysOf(const QAction& action) {
    const auto own = ActionMaker::keysOf(action);
    return QKeySequence::listToString(own.isEmpty() ? action.shortcuts() : own, QKeySequence::NativeText);
}

/// Submenus are listed with their menu; shortcuts are grouped under its name.
void collect(const QMenu& menu, Group& group) {
    QString section;
    for (const QAction* action : menu.actions()) {
        if (action->isSeparator()) section = plain(action->text());
        if (!action->isVisible() || action->isSeparator()) continue;
        const QString keys = keysOf(*action);
        if (action->menu()) collect(*action->menu(), group);
        if (action->menu() || keys.isEmpty()) continue;
        if (!section.isEmpty())
            group.rows << QStringLiteral("<tr><td></td><td><i>%1</i></td></tr>").arg(section.toHtmlEscaped());
        section.clear();
        group.rows << row(keys, plain(action->text()));
    }
}

Group pointer(int dimension) {
    const auto say = [](const char* text) { return QCoreApplication::translate("CheatSheet", text); };
    Group group{say(QT_TRANSLATE_NOOP("CheatSheet", "Pointer")), {}};
    const auto add = [&](const char* does, const char* what) { group.rows << row(say(does), say(what)); };
    add(QT_TRANSLATE_NOOP("CheatSheet", "Click"), QT_TRANSLATE_NOOP("CheatSheet", "sets a pin"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Drag a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "moves it; Esc puts it back"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click"),
        QT_TRANSLATE_NOOP("CheatSheet", "selects several pins"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Digits while dragging"),
        QT_TRANSLATE_NOOP("CheatSheet", "set the number; Enter confirms it"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Wheel"), QT_TRANSLATE_NOOP("CheatSheet", "zooms to the pointer"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "[ and ]"), QT_TRANSLATE_NOOP("CheatSheet", "size of a brush"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Alt-right-drag a brush"),
        QT_TRANSLATE_NOOP("CheatSheet", "changes its size and hardness"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click with the brush"),
        QT_TRANSLATE_NOOP("CheatSheet", "paints a straight line"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Arrow keys without a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "move a cross, Enter clicks there"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Tap the space bar"),
        QT_TRANSLATE_NOOP("CheatSheet", "plays or pauses; held, it moves the view"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Hold H"),
        QT_TRANSLATE_NOOP("CheatSheet", "hides pins and overlays"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Hold \\"),
        QT_TRANSLATE_NOOP("CheatSheet", "shows the shape before it was bent"));
    if (dimension == 3) {
        add(QT_TRANSLATE_NOOP("CheatSheet", "X, Y, Z while dragging"),
            QT_TRANSLATE_NOOP("CheatSheet", "lock an axis"));
        add(QT_TRANSLATE_NOOP("CheatSheet", "Right or middle button"),
            QT_TRANSLATE_NOOP("CheatSheet", "turns the view; with Shift, moves it"));
        add(QT_TRANSLATE_NOOP("CheatSheet", "Middle click"),
            QT_TRANSLATE_NOOP("CheatSheet", "sets the point to turn around"));
        return group;
    }
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+Shift-drag a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "widens it to a circle"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Drag the ring's dot or square"),
        QT_TRANSLATE_NOOP("CheatSheet", "rotates or scales; Shift snaps to 15°"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Arrow keys"),
        QT_TRANSLATE_NOOP("CheatSheet", "nudge by a pixel, with Shift by ten"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Middle button"), QT_TRANSLATE_NOOP("CheatSheet", "pans"));
    return group;
}

/// The keys of the tracks, which belong to no menu of the window.
Group tracks() {
    const auto say = [](const char* text) { return QCoreApplication::translate("CheatSheet", text); };
    Group group{say(QT_TRANSLATE_NOOP("CheatSheet", "Tracks")), {}};
    const auto add = [&](const char* does, const char* what) { group.rows << row(say(does), say(what)); };
    add(QT_TRANSLATE_NOOP("CheatSheet", "Up, Down"), QT_TRANSLATE_NOOP("CheatSheet", "choose a pin"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Left, Right"), QT_TRANSLATE_NOOP("CheatSheet", "show another time"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Alt+Left, Alt+Right"),
        QT_TRANSLATE_NOOP("CheatSheet", "move the chosen bars or keys"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click, or a frame"),
        QT_TRANSLATE_NOOP("CheatSheet", "chooses several"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "E"), QT_TRANSLATE_NOOP("CheatSheet", "opens their easing curve"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+C, Ctrl+V"),
        QT_TRANSLATE_NOOP("CheatSheet", "copy keys, paste them at the time shown"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+Shift+V"),
        QT_TRANSLATE_NOOP("CheatSheet", "pastes them mirrored"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Del"), QT_TRANSLATE_NOOP("CheatSheet", "removes them"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "I, O"),
        QT_TRANSLATE_NOOP("CheatSheet", "begin and end the cycle here"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-drag the numbers"),
        QT_TRANSLATE_NOOP("CheatSheet", "marks the cycle"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift+M"), QT_TRANSLATE_NOOP("CheatSheet", "adds a marker"));
    return group;
}

}  // namespace

QString CheatSheet::text(const QMenuBar& menus, int dimension) {
    QList<Group> groups = {pointer(dimension), tracks()};
    for (const QAction* menu : menus.actions()) {
        if (!menu->isVisible() || !menu->menu()) continue;
        Group group{plain(menu->text()), {}};
        collect(*menu->menu(), group);
        if (!group.rows.isEmpty()) groups << group;
    }
    // The longest ones first, each into the column that is shortest.
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.rows.size() > b.rows.size(); });
    QStringList columns(kColumns);
    std::array<qsizetype, kColumns> heights{};
    for (const Group& group : groups) {
        const auto at = std::min_element(heights.begin(), heights.end());
        *at += group.rows.size() + 2;
        columns[at - heights.begin()] += QStringLiteral("<h4>%1</h4><table cellspacing='3'>%2</table>")
                                             .arg(group.title.toHtmlEscaped(), group.rows.join(QString()));
    }
    return QStringLiteral("<table width='100%'><tr><td>%1</td></tr></table>")
        .arg(columns.join(QStringLiteral("</td><td>&nbsp;&nbsp;</td><td>")));
}

CheatSheet::CheatSheet(const QMenuBar& menus, int dimension, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keys and Mouse"));
    auto* sheet = new QTextBrowser(this);
    sheet->setHtml(text(menus, dimension));
    sheet->setFrameShape(QFrame::NoFrame);
    sheet->setAccessibleName(windowTitle());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(sheet, 1);
    column->addWidget(buttons);
    resize(QSize(1060, 700).boundedTo(parent->size()));
}

}  // namespace wend
