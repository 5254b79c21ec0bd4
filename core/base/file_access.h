#pragma once

#include <string>

#include "core/base/message.h"

namespace wend {

/// The permissions of a new file: those of the user's umask, or private.
enum class Access { Usual, Private };

/// Returns why this file must not be replaced; empty if it may be, or does not exist. Read-only files are
/// kept even for root.
Message whyKept(const std::string& target);

/// Gives an open private file the owner, permissions, access list and attributes of the file that it replaces
/// or, if there is none, those of a new one. If the group cannot be kept, its permissions are not given to
/// another group.
void takeAccess(int descriptor, const std::string& target, Access access);

}  // namespace wend
