#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wend {

/// A file that is written in pieces at any offset and remembers its first error. Every write appears to
/// succeed until finish(), because some picture libraries ignore failures and others end the process.
class CheckedFile {
  public:
    /// Creates or empties the file, with permissions for this user alone.
    explicit CheckedFile(const std::string& path);
    ~CheckedFile();
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;

    /// Writes bytes at an offset. A failure is reported by finish() alone.
    void write(std::int64_t at, const void* bytes, std::size_t size);
    /// Reads back written bytes, and returns their number.
    std::size_t read(std::int64_t at, void* bytes, std::size_t size);
    /// Returns the end of the last written byte.
    std::int64_t size() const { return m_end; }
    /// Returns whether a write has failed.
    bool failed() const { return m_error != 0; }
    /// Flushes and closes the file. Returns the first error, such as "No space left on device"; empty on
    /// success.
    std::string finish();

  private:
    void flush();
    void put(std::int64_t at, const char* bytes, std::size_t size);
    void fail(int error);

    int m_descriptor = -1;
    int m_error = 0;              // the first one
    std::int64_t m_bufferAt = 0;  // where the buffer belongs …
    std::string m_buffer;         // … since some libraries write byte by byte
    std::int64_t m_end = 0;
};

/// Writes a whole file. Returns the error like CheckedFile::finish(), or an empty string.
std::string writeBytes(const std::string& path, std::string_view bytes);

}  // namespace wend
