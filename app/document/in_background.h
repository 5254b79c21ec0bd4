#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

class QObject;

namespace wend {

/// Work in a thread of the pool, or none; copies stand for the same work.
class BackgroundWork {
  public:
    /// Puts `work` into the pool; `take` is called in the thread of `context` afterwards, unless that is gone
    /// by then. What the work throws is lost. Call it in that thread.
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
