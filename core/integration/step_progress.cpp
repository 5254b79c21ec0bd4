#include "core/integration/step_progress.h"

#include <algorithm>

namespace wend {
namespace {

constexpr double kSetUp = 0.6;  // of a field's work, where it needs a factor or levels of its own

}  // namespace

void StepProgress::start(double time, Sink sink, std::chrono::milliseconds every) {
    const std::scoped_lock lock(m_mutex);
    m_sink = std::move(sink);
    m_every = every;
    m_last = std::chrono::steady_clock::now();
    m_from = m_to = m_reported = time;
}

void StepProgress::begin(double from, double to) {
    const std::scoped_lock lock(m_mutex);
    m_from = from;
    m_to = to;
    m_fields = 0;
    m_setUp = false;
}

void StepProgress::fieldDone() {
    const std::scoped_lock lock(m_mutex);
    ++m_fields;
    m_setUp = false;
}

/// Reports the time that corresponds to the work done so far. If a factor or levels are made for a field,
/// they count as a fixed part of it. The reported time never decreases within a run.
void StepProgress::tell(FieldWork work, double part) {
    const std::scoped_lock lock(m_mutex);
    if (!m_sink) return;
    double ofField = part;
    if (work != FieldWork::Iterations) {
        m_setUp = true;
        ofField = kSetUp * part;
    } else if (m_setUp) {
        ofField = kSetUp + (1 - kSetUp) * part;
    }
    const double ofStep = std::min(1.0, (m_fields + ofField) / std::max(m_expected, m_fields + 1));
    m_reported = std::max(m_reported, m_from + ofStep * (m_to - m_from));
    const auto now = std::chrono::steady_clock::now();
    if (now - m_last < m_every) return;
    m_last = now;
    m_sink({m_reported, work, part});
}

}  // namespace wend
