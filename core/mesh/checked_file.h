#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wend {

/// A file that is written piece by piece, at any place, and remembers the first thing that goes wrong. To its
/// user every write looks like success until finish(): some of the libraries that write pictures do not look
/// at the outcome, others end the process.
class CheckedFile {
  public:
    /// Empties the file, or makes it, for this user alone.
    explicit CheckedFile(const std::string& path);
    ~CheckedFile();
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;

    void write(std::int64_t at, const void* bytes, std::size_t size);
    /// What was written there; how many bytes of it there are.
    std::size_t read(std::int64_t at, void* bytes, std::size_t size);
    /// Up to the last byte that was written.
    std::int64_t size() const { return m_end; }
    bool failed() const { return m_error != 0; }
    /// Writes what still waits, and closes. What went wrong at any time, such as "No space left on device";
    /// empty if all is in the file.
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

/// The whole file. What went wrong, or empty, as CheckedFile::finish() tells it.
std::string writeBytes(const std::string& path, std::string_view bytes);

}  // namespace wend
