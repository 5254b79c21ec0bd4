#include "app/document/in_background.h"

#include <QRunnable>
#include <QThreadPool>
#include <condition_variable>
#include <mutex>

#include "app/document/hand_over.h"

namespace wend {

namespace {

/// The pool hands a runnable to its threads under locks of Qt's, which the thread sanitizer does not see. It
/// sees this one: what was written before it is held is there for who holds it next.
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
    BackgroundReceiver* receiver = nullptr;  // null once it is gone
};

/// Lives with the context, and goes with it.
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
        const auto take = std::move(m_take);  // what is taken may be the end of the context
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
        m_work = {};  // what it holds goes before anybody who waits goes on
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
