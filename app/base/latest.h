#pragma once

#include <QString>
#include <concepts>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "app/base/in_background.h"
#include "app/base/said.h"
#include "core/base/error.h"

namespace wend {

/// The result of background work, or its error. (Futures would slice the exception.)
template <class Value>
struct Answer {
    Value value{};
    QString problem;  // in the user's language
    bool stopped = false;
};

/// Questions that are answered in the background, of which only the newest counts: the next one, drop() and
/// the end of this object stop the work on the one before, and its answer is not taken. It may only be used
/// in the thread of its context.
class Latest {
  public:
    /// `context` must outlive this object, such as its owner does.
    explicit Latest(QObject* context) : m_context(context) {}
    ~Latest() { drop(); }
    Latest(const Latest&) = delete;
    Latest& operator=(const Latest&) = delete;

    /// Runs `work` in the pool, with a std::stop_token if it takes one; `take` gets an Answer with its
    /// result.
    template <class Work, class Take>
    void ask(Work work, Take take) {
        drop();
        m_stop = std::stop_source();
        inBackground(
            m_context, [work = std::move(work), stop = m_stop.get_token()] { return answerOf(work, stop); },
            [take = std::move(take), stop = m_stop.get_token()](const auto& answer) {
                if (!stop.stop_requested()) take(answer);
            });
    }

    void drop() { m_stop.request_stop(); }

  private:
    template <class Work>
    static auto answerOf(const Work& work, const std::stop_token& stop) {
        const auto run = [&] {
            if constexpr (std::invocable<Work, std::stop_token>)
                return work(stop);
            else
                return work();
        };
        using Found = Answer<std::invoke_result_t<decltype(run)>>;
        try {
            return Found{run(), {}, false};
        } catch (const Cancelled&) {
            return Found{{}, {}, true};
        } catch (const std::exception& error) {
            return Found{{}, said(error), false};
        }
    }

    QObject* m_context;
    std::stop_source m_stop{std::nostopstate};  // of the newest question
};

}  // namespace wend
