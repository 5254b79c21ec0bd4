#include "app/session/pins/pin_traits.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/pin_edits.h"
#include "app/project/edits/timing_edits.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

/// `step` with the pins' names in the place of %1.
template <class Change>
void change(Document& document, const ShownPins& shown, const std::vector<int>& pins, const QString& step,
            const Change& change) {
    const Design& design = document.design();
    const bool changes = std::any_of(pins.begin(), pins.end(), [&](int pin) {
        PinTraits traits = traitsOf(design, pin);
        change(traits);
        return traits != traitsOf(design, pin);
    });
    if (changes)
        document.changeDesign(step.contains("%1") ? step.arg(shown.nameOf(pins)) : step,
                              withTraits(design, pins, change));
}

}  // namespace

void setLocked(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool locked) {
    change(document, shown, pins, locked ? ShapeSession::tr("Lock %1") : ShapeSession::tr("Unlock %1"),
           [locked](PinTraits& traits) { traits.locked = locked; });
}

void setHidden(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool hidden) {
    change(document, shown, pins, hidden ? ShapeSession::tr("Hide %1") : ShapeSession::tr("Show %1"),
           [hidden](PinTraits& traits) { traits.hidden = hidden; });
}

void setGroup(Document& document, const ShownPins& shown, const std::vector<int>& pins, const QString& name) {
    change(document, shown, pins,
           name.isEmpty() ? ShapeSession::tr("Ungroup %1") : ShapeSession::tr("Group %1"),
           [group = name.toStdString()](PinTraits& traits) { traits.group = group; });
}

void renameGroup(Document& document, const ShownPins& shown, const QString& group, const QString& name) {
    change(document, shown, handlesOfGroup(document.design(), group.toStdString()),
           ShapeSession::tr("Rename group"),
           [group = name.toStdString()](PinTraits& traits) { traits.group = group; });
}

void setColour(Document& document, const ShownPins& shown, const std::vector<int>& pins,
               std::optional<unsigned> colour) {
    change(document, shown, pins, ShapeSession::tr("Colour %1"),
           [colour](PinTraits& traits) { traits.colour = colour; });
}

void holdThroughout(Document& document, const ShownPins& shown, const std::vector<int>& pins) {
    const double end = document.end();
    Design next = document.design();
    for (const int pin : pins)
        if (!shown.isLocked(pin)) next = withHold(next, pin, {0, end}, end);
    document.changeDesign(ShapeSession::tr("Pin %1 for the whole animation").arg(shown.nameOf(pins)),
                          std::move(next));
}

bool canHoldLonger(const Document& document, const ShownPins& shown, const std::vector<int>& pins) {
    return std::any_of(pins.begin(), pins.end(), [&](int pin) {
        const MotionTime hold = holdOf(document.design(), pin);
        return (hold.start > 0 || hold.end < document.end()) && !shown.isLocked(pin);
    });
}

void setLinked(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool linked) {
    const Design& design = document.design();
    document.changeDesign(
        (linked ? ShapeSession::tr("Link %1") : ShapeSession::tr("Unlink %1")).arg(shown.nameOf(pins)),
        linked ? withLink(design, pins) : withoutLink(design, pins));
}

}  // namespace wend
