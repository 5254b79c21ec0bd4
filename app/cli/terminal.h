#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace wend {

/// Writes to standard error: one line for each error and warning, and a line of progress that is overwritten.
class Terminal {
  public:
    enum class Progress { Automatic, Shown, Hidden };  // Automatic: on a terminal
    Terminal(Progress progress, bool quiet);
    ~Terminal();

    /// Called from any thread, as often as one likes.
    void progress(const std::string& work, double fraction);
    void warn(const std::string& text);
    /// Writes to the stream on which progress is shown.
    void tell(const std::string& text);
    /// Writes over the line of progress, otherwise like error().
    void end(const std::string& text);

    /// Writes "wend: text" as one line, whatever the text contains.
    static void error(const std::string& text);
    /// Sets the file that is being worked on, which lastWord() names.
    static void setFile(const std::string& path);
    /// Says one line about the file and ends the process with that exit code: from any thread, and when there
    /// is no memory left. Nothing is cleaned up; what was being written was not yet in its place.
    [[noreturn]] static void lastWord(const char* what, int code) noexcept;

  private:
    void clearLine();

    bool m_quiet, m_shown, m_interactive;
    std::mutex m_mutex;
    std::string m_lastWork;
    int m_lastPercent = -1;
    std::size_t m_width = 0;
};

}  // namespace wend
