#pragma once

#include <optional>
#include <vector>

#include "app/session/shape_session.h"

namespace wend {

/// Each of these is one undo step for all the pins that are given, and none where nothing changes.

void setLocked(ShapeSession& session, const std::vector<int>& pins, bool locked);
void setHidden(ShapeSession& session, const std::vector<int>& pins, bool hidden);
/// An empty name: they leave their groups.
void setGroup(ShapeSession& session, const std::vector<int>& pins, const QString& name);
void renameGroup(ShapeSession& session, const QString& group, const QString& name);
/// Without a colour they have that of their place in the list.
void setColour(ShapeSession& session, const std::vector<int>& pins, std::optional<unsigned> colour);
/// They hold from the start of the film to its end, except those that are locked.
void holdThroughout(ShapeSession& session, const std::vector<int>& pins);
/// Whether that would change anything.
bool canHoldLonger(const Document& document, const std::vector<int>& pins);
void setLinked(ShapeSession& session, const std::vector<int>& pins, bool linked);

}  // namespace wend
