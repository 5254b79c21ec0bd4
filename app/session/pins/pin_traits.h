#pragma once

#include <optional>
#include <vector>

#include "app/session/pins.h"

namespace wend {

/// Each of these is one undo step for all given pins, and none if nothing changes.

void setLocked(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool locked);
void setHidden(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool hidden);
/// Puts the pins into a group; an empty name removes them from their groups.
void setGroup(Document& document, const ShownPins& shown, const std::vector<int>& pins, const QString& name);
void renameGroup(Document& document, const ShownPins& shown, const QString& group, const QString& name);
/// Sets the colour of pins. Pins without a colour get that of their position in the list.
void setColour(Document& document, const ShownPins& shown, const std::vector<int>& pins,
               std::optional<unsigned> colour);
/// Makes the pins hold for the whole animation, except locked ones.
void holdThroughout(Document& document, const ShownPins& shown, const std::vector<int>& pins);
/// Returns whether holdThroughout() would change anything.
bool canHoldLonger(const Document& document, const ShownPins& shown, const std::vector<int>& pins);
void setLinked(Document& document, const ShownPins& shown, const std::vector<int>& pins, bool linked);

}  // namespace wend
