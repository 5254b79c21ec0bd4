#include "core/base/file_access.h"

#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace wend {

namespace {

constexpr const char* kAccessList = "system.posix_acl_access";

/// umask() itself cannot be asked without being changed, for all threads.
mode_t userMask() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("Umask:")) return static_cast<mode_t>(std::stoul(line.substr(6), nullptr, 8));
    return 077;
}

/// Attributes and the access list, as far as this user may. A list that the folder gave to the new file would
/// let in others than the old file did.
void copyAttributes(const std::string& from, int to) {
    std::string names(64 * 1024, '\0');
    const ssize_t size = listxattr(from.c_str(), names.data(), names.size());
    names.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    bool hasList = false;
    for (std::size_t at = 0; at < names.size();) {
        const std::string name = names.c_str() + at;
        at += name.size() + 1;
        std::string value(64 * 1024, '\0');
        const ssize_t length = getxattr(from.c_str(), name.c_str(), value.data(), value.size());
        if (length < 0 || name.starts_with("security.")) continue;
        fsetxattr(to, name.c_str(), value.data(), static_cast<std::size_t>(length), 0);
        hasList = hasList || name == kAccessList;
    }
    if (!hasList) fremovexattr(to, kAccessList);
}

bool takeOwner(int descriptor, const struct stat& old) {
    return fchown(descriptor, old.st_uid, old.st_gid) == 0 ||
           fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) == 0;
}

/// Returns a mode in which the group has only the rights that everyone has.
mode_t withoutGroup(mode_t mode) {
    return (mode & 0707) | (mode & 070 & ((mode & 07) << 3));
}

}  // namespace

Message whyKept(const std::string& target) {
    struct stat status {};
    if (lstat(target.c_str(), &status) != 0)
        return errno == ENOENT ? Message() : Message(std::strerror(errno));
    if (stat(target.c_str(), &status) != 0)
        return errno == ENOENT ? Message() : Message(std::strerror(errno));
    if (!S_ISREG(status.st_mode)) return {};
    const bool writable = (status.st_mode & 0222) != 0 && access(target.c_str(), W_OK) == 0;
    if (writable) return {};
    return sentence("Core", "is read-only: make it writable first, or choose another name");
}

/// Copies owner, permissions, access list and attributes of an existing target, as far as the user may.
void takeAccess(int descriptor, const std::string& target, Access access) {
    struct stat old {};
    if (stat(target.c_str(), &old) != 0) {
        fchmod(descriptor, access == Access::Private ? 0600 : 0666 & ~userMask());
        return;
    }
    const mode_t mode = old.st_mode & 0777;
    const bool owned = takeOwner(descriptor, old);
    if (owned && access == Access::Usual) copyAttributes(target, descriptor);
    if (!owned) fremovexattr(descriptor, kAccessList);
    // Last, since other owners and lists change the rights.
    fchmod(descriptor, access == Access::Private ? 0600 : owned ? mode : withoutGroup(mode));
}

}  // namespace wend
