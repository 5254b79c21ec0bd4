#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wend::formats {

/// Reads the files in a ZIP archive in memory, stored or deflated. Throws InputError for a damaged one, and
/// for more bytes than meshes have.
class ZipArchive {
  public:
    explicit ZipArchive(std::string_view bytes);

    /// Returns the content of a file, whatever the case of its name; nothing if there is none.
    std::optional<std::string> file(const std::string& name) const;

  private:
    /// The record of a file in the central directory.
    struct Entry {
        std::size_t header;            // where its local header begins
        std::size_t packed, unpacked;  // bytes
        unsigned method, checksum;
    };
    std::string_view m_bytes;
    std::map<std::string, Entry> m_entries;  // by lower-case names
};

}  // namespace wend::formats
