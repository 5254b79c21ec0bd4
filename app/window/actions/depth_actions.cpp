#include "app/window/actions/depth_actions.h"

#include <QApplication>
#include <QInputDialog>
#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/value_edits.h"
#include "app/project/options/options.h"
#include "app/session/calm_follower.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

/// The least or the largest order that there is, 0 among them.
double extreme(const ValueLayers& depth, bool maximum) {
    double order = 0;
    for (const ValueLayer& layer : depth)
        order = maximum ? std::max(order, layer.value) : std::min(order, layer.value);
    return order;
}

}  // namespace

DepthActions::DepthActions(ShapeSession& session, QObject* parent)
    : ActionMaker(parent), m_session(session), m_menu(new QMenu) {
    front =
        add("front",
            {tr("Bring to &Front"), tr("Where the shape covers itself, what is around the selected pins lies "
                                       "in front of all else")},
            QKeySequence(tr("Ctrl+Shift+]")));
    behind =
        add("behind",
            {tr("Send to &Back"), tr("Where the shape covers itself, what is around the selected pins lies "
                                     "behind all else")},
            QKeySequence(tr("Ctrl+Shift+[")));
    plain =
        add("plain", {tr("As &Drawn"), tr("What is around the selected pins has no order of its own")}, {});
    number = add("number",
                 {tr("&Number…"),
                  tr("Give what is around the selected pins an order: the greater number lies in front")},
                 {});
    m_menu->setTitle(tr("&Depth"));
    m_menu->addActions({front, behind, plain, number});
    connect(front, &QAction::triggered, this,
            [this] { bring(extreme(m_session.document().depth(), true) + 1); });
    connect(behind, &QAction::triggered, this,
            [this] { bring(extreme(m_session.document().depth(), false) - 1); });
    connect(plain, &QAction::triggered, this, [this] { bring(0); });
    connect(number, &QAction::triggered, this, &DepthActions::askNumber);
    new CalmFollower(
        m_session.motion(), this, [this] { refresh(); }, &m_session.gestures(), &ShapeGesture::pinsChanged,
        &m_session.motion(), &ShapeMotion::frameChanged);
    refresh();
}

void DepthActions::refresh() {
    const bool flat = m_session.document().dimension() == 2 && m_session.motion().frame();
    const bool can = flat && !m_session.selection().isEmpty();
    const QString why = m_session.document().dimension() == 3 ? tr("A solid has depth of its own.")
                                                              : tr("Select a pin first.");
    for (QAction* action : {front, behind, plain, number}) enable(action, can, why);
}

void DepthActions::bring(double order) {
    Document& document = m_session.document();
    const double most = option("depth[].order").range.max;
    order = std::clamp(order, -most, most);
    document.changeDepth(order > 0   ? tr("Bring to front")
                         : order < 0 ? tr("Send to back")
                                     : tr("Depth as drawn"),
                         withHandleDepth(document.depth(), document.design(), m_session.selection().handles(),
                                         order, m_session.motion().frame()->diagonal));
}

void DepthActions::askNumber() {
    const Document& document = m_session.document();
    const Pin& first = document.design().handles[m_session.selection().handles().front()];
    const double now = depthOfHandle(document.depth(), first.name).value_or(0);
    const Range range = option("depth[].order").range;
    bool given = false;
    const double order = QInputDialog::getDouble(QApplication::activeWindow(), tr("Depth"),
                                                 tr("Order (in front: greater than 0, behind: less):"), now,
                                                 range.min, range.max, 1, &given);
    if (given) bring(order);
}

}  // namespace wend
