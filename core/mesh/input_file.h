#pragma once

#include <cstdint>
#include <new>
#include <string>

namespace wend {

/// There is not enough memory for a file. what() is "FILE: why", one line.
class OutOfMemory : public std::bad_alloc {
  public:
    explicit OutOfMemory(const std::string& file, const std::string& why = "does not fit into memory")
        : m_what(file + ": " + why) {}
    const char* what() const noexcept override { return m_what.c_str(); }

  private:
    std::string m_what;
};

/// A file of somebody else's, opened for reading: the one way in for everything that Wend reads. Only regular
/// files come through. A pipe, a device or a socket might never answer or never end, so these and folders are
/// refused before anything is read.
class InputFile {
  public:
    /// Throws InputError(path, reason).
    explicit InputFile(std::string path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return m_path; }
    std::uint64_t size() const { return m_size; }
    /// The bytes from `offset` on, fewer where the file ends. Throws InputError(path, reason), OutOfMemory,
    /// and Cancelled after stopReading().
    std::string bytes(std::uint64_t offset, std::uint64_t count) const;
    std::string bytes() const { return bytes(0, m_size); }

  private:
    std::string m_path;
    std::uint64_t m_size = 0;
    int m_descriptor = -1;
};

/// The whole of a regular file. Throws as InputFile does.
std::string readInput(const std::string& path);

/// From now on (true), or no longer, reading throws Cancelled: for handlers of signals.
void stopReading(bool stop) noexcept;
/// Throws Cancelled if it has been asked for: for readers that open files by themselves.
void requireReading();

}  // namespace wend
