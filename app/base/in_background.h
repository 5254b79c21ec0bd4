#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

class QObject;

namespace wend {

/// A handle of work in the pool, or of none; copies refer to the same work.
class BackgroundWork {
  public:
    /// Runs `work` in the pool, then `take` in the thread of `context` unless that is destroyed by then.
    /// Exceptions of the work are dropped. Call this in the thread of `context`.
    static BackgroundWork start(QObject* context, std::function<void()> work, std::function<void()> take);

    bool isRunning() const;
    /// Returns when the work is done; its result is still taken from the event loop.
    void wait() const;

  private:
    struct State;
    friend class BackgroundRunnable;
    friend class BackgroundReceiver;

    std::shared_ptr<State> m_state;
};

/// `take` gets the result of `work`, unless that threw. All else as BackgroundWork::start().
template <class Work, class Take>
BackgroundWork inBackground(QObject* context, Work work, Take take) {
    auto result = std::make_shared<std::optional<std::invoke_result_t<Work>>>();
    return BackgroundWork::start(
        context, [result, work = std::move(work)] { result->emplace(work()); },
        [result, take = std::move(take)] {
            if (*result) take(**result);
        });
}

}  // namespace wend
