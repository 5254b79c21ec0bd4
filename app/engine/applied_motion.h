#pragma once

#include <stop_token>
#include <string>

#include "app/engine/motion_transfer.h"

namespace wend {

/// Returns the project, whose files are relative to `folder`, with the motion of the project in file
/// `source`; see withMotionOf(). Both shapes are built for that. Thread-safe. Throws InputError, and
/// Cancelled when stopped.
TransferredMotion withMotionOf(const std::string& source, const Project& target, const std::string& folder,
                               std::stop_token stop = {});

}  // namespace wend
