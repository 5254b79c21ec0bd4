#pragma once

#include <exception>
#include <stdexcept>
#include <string>

#include "core/base/message.h"

namespace wend {

/// Invalid input. what() is "FILE: what is wrong (and where)" on one line; the file may be empty if the
/// caller knows it (see named()).
class InputError : public std::runtime_error {
  public:
    explicit InputError(const Message& what) : std::runtime_error(what.text()), m_what(what) {}
    InputError(const std::string& file, const Message& what)
        : std::runtime_error(file.empty() ? what.text() : file + ": " + what.text()),
          m_file(file),
          m_what(what) {}

    const std::string& file() const { return m_file; }
    /// Returns what is wrong, without the file, in English and as it can be translated.
    const std::string& reason() const { return m_what.text(); }
    const Message& message() const { return m_what; }
    /// Returns the same error with the file's name, if it has none yet.
    InputError named(const std::string& file) const {
        return m_file.empty() ? InputError(file, m_what) : *this;
    }

  private:
    std::string m_file;
    Message m_what;
};

/// Thrown by long work when its stop_token requests it.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace wend
