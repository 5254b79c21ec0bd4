#include "app/session/pins/pin_traits.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/pin_edits.h"
#include "app/project/edits/timing_edits.h"

namespace wend {

namespace {

/// `step` with the pins' names in the place of %1.
template <class Change>
void change(ShapeSession& session, const std::vector<int>& pins, const QString& step, const Change& change) {
    const Design& design = session.document().design();
    const bool changes = std::any_of(pins.begin(), pins.end(), [&](int pin) {
        PinTraits traits = traitsOf(design, pin);
        change(traits);
        return traits != traitsOf(design, pin);
    });
    if (changes)
        session.document().changeDesign(step.contains("%1") ? step.arg(session.nameOf(pins)) : step,
                                        withTraits(design, pins, change));
}

}  // namespace

void setLocked(ShapeSession& session, const std::vector<int>& pins, bool locked) {
    change(session, pins, locked ? ShapeSession::tr("Lock %1") : ShapeSession::tr("Unlock %1"),
           [locked](PinTraits& traits) { traits.locked = locked; });
}

void setHidden(ShapeSession& session, const std::vector<int>& pins, bool hidden) {
    change(session, pins, hidden ? ShapeSession::tr("Hide %1") : ShapeSession::tr("Show %1"),
           [hidden](PinTraits& traits) { traits.hidden = hidden; });
}

void setGroup(ShapeSession& session, const std::vector<int>& pins, const QString& name) {
    change(session, pins, name.isEmpty() ? ShapeSession::tr("Ungroup %1") : ShapeSession::tr("Group %1"),
           [group = name.toStdString()](PinTraits& traits) { traits.group = group; });
}

void renameGroup(ShapeSession& session, const QString& group, const QString& name) {
    change(session, handlesOfGroup(session.document().design(), group.toStdString()),
           ShapeSession::tr("Rename group"),
           [group = name.toStdString()](PinTraits& traits) { traits.group = group; });
}

void setColour(ShapeSession& session, const std::vector<int>& pins, std::optional<unsigned> colour) {
    change(session, pins, ShapeSession::tr("Colour %1"),
           [colour](PinTraits& traits) { traits.colour = colour; });
}

void holdThroughout(ShapeSession& session, const std::vector<int>& pins) {
    const double end = session.document().end();
    Design next = session.document().design();
    for (const int pin : pins)
        if (!session.isLocked(pin)) next = withHold(next, pin, {0, end}, end);
    session.document().changeDesign(
        ShapeSession::tr("Pin %1 for the whole animation").arg(session.nameOf(pins)), std::move(next));
}

bool canHoldLonger(const ShapeSession& session, const std::vector<int>& pins) {
    return std::any_of(pins.begin(), pins.end(), [&](int pin) {
        const Document& document = session.document();
        const MotionTime hold = holdOf(document.design(), pin);
        return (hold.start > 0 || hold.end < document.end()) && !session.isLocked(pin);
    });
}

void setLinked(ShapeSession& session, const std::vector<int>& pins, bool linked) {
    const Design& design = session.document().design();
    session.document().changeDesign(
        (linked ? ShapeSession::tr("Link %1") : ShapeSession::tr("Unlink %1")).arg(session.nameOf(pins)),
        linked ? withLink(design, pins) : withoutLink(design, pins));
}

}  // namespace wend
