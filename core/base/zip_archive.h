#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/message.h"

namespace wend {

/// Reads files of a ZIP archive.
class ZipArchive {
  public:
    /// Throws InputError(path, reason), as all of this.
    explicit ZipArchive(const std::string& path);

    static constexpr std::uint64_t kLongest = std::uint64_t(2) << 30;  // bytes of a file in an archive

    /// Returns the file of that name, in upper or lower case, or its first bytes; nothing if there is none.
    std::optional<std::string> file(const std::string& name, std::uint64_t most = kLongest) const;

    [[noreturn]] void fail(const Message& why) const;

  private:
    std::string m_path;
    std::unique_ptr<void, int (*)(void*)> m_zip;
};

}  // namespace wend
