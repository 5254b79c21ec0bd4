#pragma once

namespace wend {

/// Whether small movements that only please may be made: not where the desktop, or the user, wants less
/// motion.
bool isLively();
/// By the user; the desktop's wish holds all the same.
void setLively(bool lively);

}  // namespace wend
