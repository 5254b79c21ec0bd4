#pragma once

namespace wend {

/// Whether small movements that only please may be made: not where the desktop, or the user, wants less
/// motion.
bool isLively();
/// By the user; the desktop's wish holds in any case.
void setLively(bool lively);

}  // namespace wend
