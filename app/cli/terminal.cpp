#include "app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "core/mesh/printable.h"

namespace wend {
namespace {

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

void Terminal::error(const std::string& text) {
    say("wend: " + printable(text) + "\n");
}

void Terminal::clearLine() {
    if (m_interactive && m_width > 0) say("\r" + std::string(m_width, ' ') + "\r");
    m_width = 0;
}

}  // namespace wend
