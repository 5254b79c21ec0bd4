#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <functional>

#include "app/session/shape_session.h"
#include "app/style/marks.h"

namespace wend {

/// Returns the look of a pin; `area`: it is more than a point.
inline Marks::Pin pinLook(const ShapeSession& session, const PinView& view, bool area, int hovered) {
    const Pin& handle = session.document().design().handles[view.handle];
    return {session.selection().contains(view.handle),
            view.handle == hovered,
            area,
            !handle.motions.empty() || session.isDragging(),
            pinColour(view.handle, handle.traits),
            handle.traits.locked};
}

/// Lines from each pin that is selected or pointed at to those that move together with it.
template <class OnScreen>
void paintLinks(Marks& marks, const ShapeSession& session, const std::vector<PinView>& pins, int hovered,
                const OnScreen& onScreen) {
    const auto& handles = session.document().design().handles;
    for (const PinView& one : pins) {
        const int link = handles[one.handle].traits.link;
        if (link == 0 || (one.handle != hovered && !session.selection().contains(one.handle))) continue;
        for (const PinView& other : pins)
            if (other.handle != one.handle && handles[other.handle].traits.link == link)
                marks.line({onScreen(one.centre), onScreen(other.centre)}, kInk, 1, Qt::DotLine);
    }
}

/// The name of a handle that does not hold at a time, and since or until when.
inline QString ghostName(const Pin& handle, const QString& name, double time) {
    const bool isYetToCome = time < handle.activeFrom;
    const QString when = QLocale().toString(isYetToCome ? handle.activeFrom : handle.activeTo, 'f', 2);
    return (isYetToCome ? QCoreApplication::translate("PinTool", "%1: holds from %2 s")
                        : QCoreApplication::translate("PinTool", "%1: released at %2 s"))
        .arg(name, when);
}

/// The pins of a view. Covered pins are faint and below the others; inactive ones are at the bottom.
struct PinScene {
    const ShapeSession& session;
    std::vector<PinView> pins;
    int hovered, named;
    std::function<QPointF(const Vec3&)> onScreen;
    std::function<bool(const PinView&)> isArea, isCovered;

    void paint(QPainter& painter, Marks& marks) {
        paintGhosts(marks);
        paintLinks(marks, session, pins, hovered, onScreen);
        const auto seen = std::stable_partition(pins.begin(), pins.end(),
                                                [this](const auto& view) { return isCovered(view); });
        painter.setOpacity(kCoveredOpacity);
        for (auto view = pins.begin(); view != pins.end(); ++view) {
            if (view == seen) painter.setOpacity(1);
            marks.pin(onScreen(view->centre), pinLook(session, *view, isArea(*view), hovered));
        }
        painter.setOpacity(1);
        for (const auto& view : pins)
            if (isNamed(view)) marks.name(onScreen(view.centre), view.name);
    }
    bool isNamed(const PinView& view) const { return view.handle == hovered && view.handle == named; }
    void paintGhosts(Marks& marks) const {
        const auto ghosts = session.ghosts();
        const auto& handles = session.document().design().handles;
        for (const PinView& view : ghosts)
            marks.ghost(onScreen(view.centre), session.selection().contains(view.handle),
                        view.handle == hovered);
        for (const PinView& view : ghosts)
            if (isNamed(view))
                marks.name(onScreen(view.centre),
                           ghostName(handles[view.handle], view.name, session.playback().time()));
    }
};

}  // namespace wend
