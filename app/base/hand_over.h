#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace wend {

/// Runs calls from any thread in the thread of this object, in order, one per turn of its event loop. They
/// are passed under a lock of our own, because the thread sanitizer does not see Qt's. Callers must finish
/// before this object is destroyed.
class HandOver : public QObject {
  public:
    using QObject::QObject;

    void call(std::function<void()> call);
    /// Returns whether no call is waiting.
    bool isEmpty() const;

    bool event(QEvent* event) override;

  private:
    mutable std::mutex m_mutex;
    std::deque<std::function<void()>> m_calls;
};

}  // namespace wend
