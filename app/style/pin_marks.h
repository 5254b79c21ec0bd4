#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <functional>

#include "app/session/shape_session.h"
#include "app/style/marks.h"

namespace wend {

/// Returns the look of a pin; `area`: it is more than a point.
template <int Dim>
Marks::Pin pinLook(const ShapeSession& session, const PinView<Dim>& view, bool area, int hovered) {
    const Pin& handle = session.document().design().handles[view.handle];
    return {session.selection().contains(view.handle),
            view.handle == hovered,
            area,
            !handle.motions.empty() || session.isDragging(),
            pinColour(view.handle, handle.traits),
            handle.traits.locked};
}

/// Lines from each pin that is selected or pointed at to those that move together with it.
template <int Dim, class ToWidget>
void paintLinks(Marks& marks, const ShapeSession& session, const std::vector<PinView<Dim>>& pins, int hovered,
                const ToWidget& toWidget) {
    const auto& handles = session.document().design().handles;
    for (const PinView<Dim>& one : pins) {
        const int link = handles[one.handle].traits.link;
        if (link == 0 || (one.handle != hovered && !session.selection().contains(one.handle))) continue;
        for (const PinView<Dim>& other : pins)
            if (other.handle != one.handle && handles[other.handle].traits.link == link)
                marks.line({toWidget(one.centre), toWidget(other.centre)}, kInk, 1, Qt::DotLine);
    }
}

/// The name of a handle that does not hold at a time, and since or until when.
template <int Dim>
QString ghostName(const Pin& handle, const QString& name, double time) {
    const bool isYetToCome = time < handle.activeFrom;
    const QString when = QLocale().toString(isYetToCome ? handle.activeFrom : handle.activeTo, 'f', 2);
    return (isYetToCome ? QCoreApplication::translate("PinTool", "%1: holds from %2 s")
                        : QCoreApplication::translate("PinTool", "%1: released at %2 s"))
        .arg(name, when);
}

/// The pins of a view. Covered pins are faint and below the others; inactive ones are at the bottom.
template <int Dim>
struct PinScene {
    const ShapeSession& session;
    std::vector<PinView<Dim>> pins;
    int hovered, named;
    std::function<QPointF(const Vec<Dim>&)> toWidget;
    std::function<bool(const PinView<Dim>&)> isArea, isCovered;

    void paint(QPainter& painter, Marks& marks) {
        paintGhosts(marks);
        paintLinks<Dim>(marks, session, pins, hovered, toWidget);
        const auto seen = std::stable_partition(pins.begin(), pins.end(),
                                                [this](const auto& view) { return isCovered(view); });
        painter.setOpacity(kCoveredOpacity);
        for (auto view = pins.begin(); view != pins.end(); ++view) {
            if (view == seen) painter.setOpacity(1);
            marks.pin(toWidget(view->centre), pinLook<Dim>(session, *view, isArea(*view), hovered));
        }
        painter.setOpacity(1);
        for (const auto& view : pins)
            if (isNamed(view)) marks.name(toWidget(view.centre), view.name);
    }
    bool isNamed(const PinView<Dim>& view) const { return view.handle == hovered && view.handle == named; }
    void paintGhosts(Marks& marks) const {
        const auto ghosts = session.template ghosts<Dim>();
        const auto& handles = session.document().design().handles;
        for (const PinView<Dim>& view : ghosts)
            marks.ghost(toWidget(view.centre), session.selection().contains(view.handle),
                        view.handle == hovered);
        for (const PinView<Dim>& view : ghosts)
            if (isNamed(view))
                marks.name(toWidget(view.centre),
                           ghostName<Dim>(handles[view.handle], view.name, session.playback().time()));
    }
};

}  // namespace wend
