#pragma once

#include <chrono>
#include <functional>
#include <mutex>

#include "core/solver/field_progress.h"

namespace wend {

/// The progress of a step whose fields are being computed.
struct Within {
    double time;  // between the ends of the step, by the work that is done; of a run it never falls
    FieldWork work;
    double part;  // of this work, in [0, 1]
};

/// Counts the fields of a step and reports its progress. tell() may be called from any thread.
class StepProgress {
  public:
    using Sink = std::function<void(const Within&)>;

    /// Starts a run at a time. The sink is called at most once per `every`, by one thread at a time.
    void start(double time, Sink sink, std::chrono::milliseconds every);
    void stop() { start(0, {}, {}); }
    /// Starts an attempt at a step, which is expected to take as many fields as the last one that succeeded.
    void begin(double from, double to);
    /// Ends an attempt that has succeeded.
    void succeed() { m_expected = m_fields; }
    /// Counts a field as done.
    void fieldDone();
    /// Reports the fraction of some work on the current field that is done. A field that needs a factor or
    /// levels has 60 % of its work in these. A step that takes more fields than expected stays at its last
    /// part.
    void tell(FieldWork work, double part);

  private:
    static constexpr int kFields = 7;  // of the first step

    std::mutex m_mutex;
    Sink m_sink;
    std::chrono::milliseconds m_every{};
    std::chrono::steady_clock::time_point m_last;
    double m_from = 0, m_to = 0, m_reported = 0;
    int m_fields = 0, m_expected = kFields;
    bool m_setUp = false;  // for this field a factor or levels were made
};

}  // namespace wend
