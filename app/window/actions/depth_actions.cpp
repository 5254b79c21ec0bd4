#include "app/window/actions/depth_actions.h"

#include <QApplication>
#include <QInputDialog>
#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/value_edits.h"
#include "app/project/options/options.h"
#include "app/session/selection.h"
#include "app/session/shape_motion.h"

namespace wend {

namespace {

/// Returns the minimum or maximum of the orders and 0.
double extreme(const ValueLayers& depth, bool maximum) {
    double order = 0;
    for (const ValueLayer& layer : depth)
        order = maximum ? std::max(order, layer.value) : std::min(order, layer.value);
    return order;
}

}  // namespace

DepthActions::DepthActions(Document& document, const Selection& selection, const ShapeMotion& motion,
                           QObject* parent)
    : ActionMaker(parent), m_document(document), m_selection(selection), m_motion(motion), m_menu(new QMenu) {
    front =
        add("front",
            {tr("Bring to &Front"), tr("Where the shape covers itself, what is around the selected pins lies "
                                       "in front of all else")},
            QKeySequence(tr("Ctrl+Shift+]")), [this] { bring(extreme(m_document.depth(), true) + 1); });
    behind =
        add("behind",
            {tr("Send to &Back"), tr("Where the shape covers itself, what is around the selected pins lies "
                                     "behind all else")},
            QKeySequence(tr("Ctrl+Shift+[")), [this] { bring(extreme(m_document.depth(), false) - 1); });
    plain = add("plain", {tr("As &Drawn"), tr("What is around the selected pins has no order of its own")},
                {}, [this] { bring(0); });
    number = add("number",
                 {tr("&Number…"),
                  tr("Give what is around the selected pins an order: the greater number lies in front")},
                 {}, [this] { askNumber(); });
    m_menu->setTitle(tr("&Depth"));
    m_menu->addActions({front, behind, plain, number});
    refresh();
}

void DepthActions::refresh() {
    const bool flat = m_document.dimension() == 2 && m_motion.frame();
    const bool can = flat && !m_selection.isEmpty();
    const QString why =
        m_document.dimension() == 3 ? tr("A solid has depth of its own.") : tr("Select a pin first.");
    for (QAction* action : {front, behind, plain, number}) enable(action, can, why);
}

void DepthActions::bring(double order) {
    const double most = option("depth[].order").range.max;
    order = std::clamp(order, -most, most);
    m_document.changeDepth(order > 0   ? tr("Bring to front")
                           : order < 0 ? tr("Send to back")
                                       : tr("Depth as drawn"),
                           withHandleDepth(m_document.depth(), m_document.design(), m_selection.handles(),
                                           order, m_motion.frame()->diagonal));
}

void DepthActions::askNumber() {
    const Pin& first = m_document.design().handles[m_selection.handles().front()];
    const double now = depthOfHandle(m_document.depth(), first.name).value_or(0);
    const Range range = option("depth[].order").range;
    bool given = false;
    const double order = QInputDialog::getDouble(QApplication::activeWindow(), tr("Depth"),
                                                 tr("Order (in front: greater than 0, behind: less):"), now,
                                                 range.min, range.max, 1, &given);
    if (given) bring(order);
}

}  // namespace wend
