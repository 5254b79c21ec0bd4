#include "app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>

#include "core/base/last_act.h"
#include "core/base/printable.h"

namespace wend {
namespace {

std::array<char, 512> currentFile{};  // no memory is needed to read it

void say(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

Terminal::Terminal(Progress progress, bool quiet)
    : m_quiet(quiet),
      m_shown(!quiet &&
              (progress == Progress::Shown || (progress == Progress::Automatic && isatty(STDERR_FILENO)))),
      m_interactive(isatty(STDERR_FILENO)) {}

Terminal::~Terminal() {
    clearLine();
}

void Terminal::progress(const std::string& work, double fraction) {
    const std::scoped_lock lock(m_mutex);
    const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
    if (!m_shown || (percent == m_lastPercent && work == m_lastWork)) return;
    m_lastPercent = percent;
    m_lastWork = work;
    const std::string line = printable(work) + " " + std::to_string(percent) + " %";
    if (!m_interactive) return say(line + "\n");
    say("\r" + line + std::string(m_width > line.size() ? m_width - line.size() : 0, ' '));
    m_width = line.size();
}

void Terminal::warn(const std::string& text) {
    const std::scoped_lock lock(m_mutex);
    if (m_quiet) return;
    clearLine();
    say("wend: " + printable(text) + "\n");
}

void Terminal::tell(const std::string& text) {
    if (m_shown) warn(text);
}

void Terminal::end(const std::string& text) {
    const std::scoped_lock lock(m_mutex);
    m_shown = false;
    clearLine();
    error(text);
}

void Terminal::error(const std::string& text) {
    say("wend: " + printable(text) + "\n");
}

void Terminal::setFile(const std::string& path) {
    const std::string name = printable(path).substr(0, currentFile.size() - 1);
    *std::ranges::copy(name, currentFile.begin()).out = '\0';
}

void Terminal::lastWord(const char* what, int code) noexcept {
    static std::atomic_flag said;  // several threads may find out at once
    while (said.test_and_set()) pause();
    const char* separator = currentFile[0] != 0 ? ": " : "";
    const std::array<const char*, 5> parts{"wend: ", currentFile.data(), separator, what, "\n"};
    for (const char* part : parts)
        if (write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
    endProcess(code);
}

void Terminal::clearLine() {
    if (m_interactive && m_width > 0) say("\r" + std::string(m_width, ' ') + "\r");
    m_width = 0;
}

}  // namespace wend
