#pragma once

#include <cstdint>
#include <new>
#include <string>

namespace wend {

/// Thrown when memory is insufficient for a file. what() is "FILE: why" on one line.
class OutOfMemory : public std::bad_alloc {
  public:
    explicit OutOfMemory(const std::string& file, const std::string& why = "does not fit into memory")
        : m_what(file + ": " + why) {}
    const char* what() const noexcept override { return m_what.c_str(); }

  private:
    std::string m_what;
};

/// An input file, opened for reading: everything that Wend reads comes through this class. Only regular files
/// are accepted. Pipes, devices and sockets may block or never end, so these and folders are refused before
/// anything is read.
class InputFile {
  public:
    /// Throws InputError(path, reason).
    explicit InputFile(std::string path);
    /// Holds a file of that content, which was part of the one at `path`.
    InputFile(std::string path, std::string content);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return m_path; }
    std::uint64_t size() const { return m_size; }
    /// Returns the bytes from `offset` on, fewer if the file ends before. Throws InputError(path, reason),
    /// OutOfMemory, and Cancelled after stopReading().
    std::string bytes(std::uint64_t offset, std::uint64_t count) const;
    /// Returns all bytes.
    std::string bytes() const { return bytes(0, m_size); }

  private:
    std::string m_path;
    std::uint64_t m_size = 0;
    int m_descriptor = -1;  // none: the content is here
    std::string m_content;
};

/// Returns the content of a regular file. Throws as InputFile does.
std::string readInput(const std::string& path);

/// Makes reading throw Cancelled from now on (true), or no longer; async-signal-safe.
void stopReading(bool stop) noexcept;
/// Throws Cancelled if it has been asked for: for readers that open files by themselves.
void requireReading();

}  // namespace wend
