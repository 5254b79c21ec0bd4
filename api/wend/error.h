#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "wend/export.h"

namespace wend {

/// Input that makes no sense, or a file that cannot be read or written. what() is one line that names the
/// vertex, cell, handle or file.
class WEND_API InvalidInput : public std::runtime_error {
  public:
    /// @param what one line
    explicit InvalidInput(const std::string& what);
    ~InvalidInput() override;
};

/// The machine has not the memory. what() is one line, with how much is needed where that is known.
class WEND_API InsufficientMemory : public std::bad_alloc {
  public:
    /// @param what one line
    /// @param needed in bytes; 0 if it is not known.
    InsufficientMemory(const std::string& what, double needed);
    ~InsufficientMemory() override;

    /// Returns the message, one line.
    const char* what() const noexcept override;
    /// The bytes that are needed; 0 if it is not known.
    double needed() const { return m_needed; }

  private:
    std::string m_what;
    double m_needed;
};

/// Reading, writing, meshing or warping was stopped by the caller's std::stop_token. Flow::run() returns
/// Ending::Cancelled instead.
class WEND_API Interrupted : public std::exception {
  public:
    ~Interrupted() override;
    /// "interrupted".
    const char* what() const noexcept override;
};

}  // namespace wend
