#pragma once

#include <stop_token>

#include "bench/bench.h"

namespace wend {

/// Collects the rows of a case, and reports each one at once.
class BenchRecorder {
  public:
    BenchRecorder(BenchTable& table, const BenchOptions& options) : m_table(table), m_options(options) {}

    void begin(BenchCase heading);
    /// Throws Cancelled if the user has had enough.
    void add(BenchRow row);
    void remark(const std::string& text) const;

    /// Returns the number of repeats; it is less for work that takes longer than a second.
    int repeats(double expectedSeconds) const;
    const std::stop_token& stop() const { return m_options.stop; }

  private:
    BenchTable& m_table;
    const BenchOptions& m_options;
};

}  // namespace wend
