#include "app/base/in_background.h"

#include <QRunnable>
#include <QThreadPool>
#include <condition_variable>
#include <mutex>

#include "app/base/hand_over.h"

namespace wend {

namespace {

/// Establishes the happens-before edge that TSan cannot see in Qt's locks.
std::mutex& poolMutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

class BackgroundReceiver;

struct BackgroundWork::State {
    std::mutex mutex;
    std::condition_variable done;
    bool isDone = false;
    BackgroundReceiver* receiver = nullptr;  // null after its destruction
};

/// A child of the context, destroyed with it.
class BackgroundReceiver : public HandOver {
  public:
    BackgroundReceiver(QObject* context, std::shared_ptr<BackgroundWork::State> state,
                       std::function<void()> take)
        : HandOver(context), m_state(std::move(state)), m_take(std::move(take)) {
        m_state->receiver = this;
    }
    ~BackgroundReceiver() override {
        const std::lock_guard lock(m_state->mutex);
        m_state->receiver = nullptr;
    }

    void take() {
        deleteLater();
        const auto take = std::move(m_take);  // the call may destroy the context
        take();
    }

  private:
    std::shared_ptr<BackgroundWork::State> m_state;
    std::function<void()> m_take;
};

class BackgroundRunnable : public QRunnable {
  public:
    BackgroundRunnable(std::shared_ptr<BackgroundWork::State> state, std::function<void()> work)
        : m_state(std::move(state)), m_work(std::move(work)) {
        const std::lock_guard membersAreSeen(poolMutex());
    }

    void run() override {
        { const std::lock_guard seeingMembers(poolMutex()); }
        try {
            m_work();
        } catch (...) {  // nothing is taken then
        }
        m_work = {};  // releases its captures before waiting threads continue
        const std::lock_guard lock(m_state->mutex);
        m_state->isDone = true;
        m_state->done.notify_all();
        if (auto* receiver = m_state->receiver) receiver->call([receiver] { receiver->take(); });
    }

  private:
    std::shared_ptr<BackgroundWork::State> m_state;
    std::function<void()> m_work;
};

BackgroundWork BackgroundWork::start(QObject* context, std::function<void()> work,
                                     std::function<void()> take) {
    BackgroundWork started;
    started.m_state = std::make_shared<State>();
    new BackgroundReceiver(context, started.m_state, std::move(take));
    QThreadPool::globalInstance()->start(new BackgroundRunnable(started.m_state, std::move(work)));
    return started;
}

bool BackgroundWork::isRunning() const {
    if (!m_state) return false;
    const std::lock_guard lock(m_state->mutex);
    return !m_state->isDone;
}

void BackgroundWork::wait() const {
    if (!m_state) return;
    std::unique_lock lock(m_state->mutex);
    m_state->done.wait(lock, [this] { return m_state->isDone; });
}

}  // namespace wend
