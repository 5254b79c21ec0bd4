#pragma once

#include <string>

namespace wend {

/// Who may read and write a new file: as the user's settings (umask) say, or this user alone.
enum class Access { Usual, Private };

/// Why this file may not be replaced; empty if it may, or is not there. What nobody may write is kept, even
/// from those who may do everything.
std::string whyKept(const std::string& target);

/// Gives an open file, made for this user alone, the owner, the rights, the access list and the attributes
/// of the file that it is to replace; or, if there is none, the rights of a new one. Where the group cannot
/// be kept, what it was allowed is not given to another one.
void takeAccess(int descriptor, const std::string& target, Access access);

}  // namespace wend
