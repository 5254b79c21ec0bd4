#include "core/base/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>

namespace wend {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Returns the number after a word at the beginning of a line: "MemAvailable:   123 kB".
std::optional<double> numberAfter(const std::string& path, std::string_view word) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        std::string first;
        double number = 0;
        if (fields >> first >> number && first == word) return number;
    }
    return std::nullopt;
}

/// Returns the only number of a file; nothing where it says "max", or if there is no such file.
std::optional<double> numberIn(const std::string& path) {
    std::ifstream file(path);
    double number = 0;
    if (file >> number) return number;
    return std::nullopt;
}

double availableInSystem(const std::string& root) {
    const auto kilobytes = numberAfter(root + "/proc/meminfo", "MemAvailable:");
    return kilobytes ? 1024 * *kilobytes : kUnknown;
}

double leftOfAddresses(const std::string& root) {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
    const double pages = numberIn(root + "/proc/self/statm").value_or(0);
    return std::max(0.0,
                    static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

/// How the two versions of control groups name what they hold.
struct GroupFiles {
    const char *limit, *usage, *cache;
};
constexpr GroupFiles kFirst{"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kSecond{"/memory.max", "/memory.current", "inactive_file"};

/// Returns what a control group leaves; its cache of unused files counts as free, because it is dropped when
/// memory is needed.
double leftOf(const std::string& folder, const GroupFiles& files) {
    const auto limit = numberIn(folder + files.limit), usage = numberIn(folder + files.usage);
    if (!limit || !usage) return kUnknown;
    const double cache = numberAfter(folder + "/memory.stat", files.cache).value_or(0);
    return std::max(0.0, *limit - std::max(0.0, *usage - cache));
}

/// Returns the least of what a group and those around it leave, up to the mount's root, since the limit of
/// each holds. In a container the path may be one of the host: then only the root is there.
double leftOfGroups(const std::string& mount, std::string path, const GroupFiles& files) {
    double least = leftOf(mount, files);
    while (!path.empty() && path != "/") {
        least = std::min(least, leftOf(mount + path, files));
        path.erase(path.find_last_of('/'));
    }
    return least;
}

/// Returns the least of what the control groups of the process leave. The lines of its list are "0::/path" in
/// the second version and "4:memory:/path" in the first.
double leftOfControlGroups(const std::string& root) {
    double least = kUnknown;
    std::ifstream file(root + "/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string kinds = "," + line.substr(first + 1, second - first - 1) + ",";
        const std::string path = line.substr(second + 1);
        if (kinds == ",,") least = std::min(least, leftOfGroups(root + "/sys/fs/cgroup", path, kSecond));
        if (kinds.find(",memory,") != std::string::npos)
            least = std::min(least, leftOfGroups(root + "/sys/fs/cgroup/memory", path, kFirst));
    }
    return least;
}

}  // namespace

NotEnoughMemory::NotEnoughMemory(double needed, double free)
    : m_needed(needed),
      m_free(free),
      m_what("needs about " + byteText(needed) + " of memory; " + byteText(free) + " are free") {}

double freeMemory(const std::string& root) {
    return std::min({availableInSystem(root), leftOfAddresses(root), leftOfControlGroups(root)});
}

void requireMemory(double bytes) {
    const double free = freeMemory();
    if (bytes > free) throw NotEnoughMemory(bytes, free);
}

std::string byteText(double bytes) {
    const bool large = bytes >= 1e9;
    const double unit = large ? 1e9 : bytes >= 1e6 ? 1e6 : 1e3;
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), bytes / unit,
                                   std::chars_format::fixed, large ? 1 : 0);
    return std::string(digits.data(), end.ptr) + (large ? " GB" : unit == 1e6 ? " MB" : " kB");
}

}  // namespace wend
