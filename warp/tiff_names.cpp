#include "warp/tiff_names.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

#include "core/base/error.h"

namespace wend {
namespace {

constexpr std::size_t kEntry = 12;  // bytes
constexpr std::uint16_t kPageName = 285, kText = 2;

template <class Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class Number>
Number numberAt(const std::string& bytes, std::size_t at) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

/// A TIFF file in the order of bytes of this machine, as libtiff writes it.
class OwnTiff {
  public:
    explicit OwnTiff(const std::string& path)
        : m_path(path), m_file(path, std::ios::in | std::ios::out | std::ios::binary) {
        constexpr std::uint16_t kClassic = 42;
        if (numberAt<std::uint16_t>(read(2, 2), 0) != kClassic) failForSize();
    }

    /// Puts a directory with a name in place of the one to which the link points. Returns its own link.
    std::uint64_t name(std::uint64_t link, const std::string& name) {
        const std::uint64_t at = numberAt<std::uint32_t>(read(link, 4), 0);
        if (at == 0) fail();
        const std::size_t size = kEntry * numberAt<std::uint16_t>(read(at, 2), 0);
        const std::string entries = read(at + 2, size), next = read(at + 2 + size, 4);
        std::string directory;
        append(directory, static_cast<std::uint16_t>(size / kEntry + 1));
        std::size_t before = 0;
        while (before < size && numberAt<std::uint16_t>(entries, before) < kPageName) before += kEntry;
        directory += entries.substr(0, before) + entryOf(name) + entries.substr(before) + next;
        const std::uint32_t place = add(directory);
        std::string pointer;
        append(pointer, place);
        write(link, pointer);
        return place + directory.size() - 4;
    }
    void finish() {
        m_file.close();
        if (!m_file) fail();
    }

  private:
    std::string entryOf(const std::string& name) {
        std::string text = name + '\0', entry;
        append(entry, kPageName);
        append(entry, kText);
        append(entry, static_cast<std::uint32_t>(text.size()));
        if (text.size() > 4) {
            append(entry, add(text));
        } else {
            text.resize(4);
            entry += text;
        }
        return entry;
    }
    /// Returns where the bytes are: at an even place, as the format asks for.
    std::uint32_t add(const std::string& bytes) {
        m_file.seekp(0, std::ios::end);
        const auto end = static_cast<std::uint64_t>(m_file.tellp());
        const std::uint64_t place = end + end % 2;
        if (place + bytes.size() > std::numeric_limits<std::uint32_t>::max()) failForSize();
        write(end, std::string(end % 2, '\0') + bytes);
        return static_cast<std::uint32_t>(place);
    }
    std::string read(std::uint64_t at, std::size_t size) {
        std::string bytes(size, '\0');
        m_file.seekg(static_cast<std::streamoff>(at));
        m_file.read(bytes.data(), static_cast<std::streamsize>(size));
        if (!m_file) fail();
        return bytes;
    }
    void write(std::uint64_t at, const std::string& bytes) {
        m_file.seekp(static_cast<std::streamoff>(at));
        m_file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (!m_file) fail();
    }
    [[noreturn]] void fail() const { throw InputError(m_path, "cannot be written"); }
    [[noreturn]] void failForSize() const {
        throw InputError(m_path, "cannot be written: layers of more than 4 GB do not fit into a TIFF");
    }

    std::string m_path;
    std::fstream m_file;
};

}  // namespace

void nameTiffPages(const std::string& path, const std::vector<std::string>& names) {
    OwnTiff file(path);
    std::uint64_t link = 4;
    for (const std::string& name : names) link = file.name(link, name);
    file.finish();
}

}  // namespace wend
