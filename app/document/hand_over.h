#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace wend {

/// Calls from any thread, made in the thread of this object, one for each turn of its event loop and in their
/// order. What they carry goes over under a lock of our own: Qt's the thread sanitizer does not see. Who
/// calls must be done before this object goes.
class HandOver : public QObject {
  public:
    using QObject::QObject;

    void call(std::function<void()> call);

    bool event(QEvent* event) override;

  private:
    std::mutex m_mutex;
    std::deque<std::function<void()>> m_calls;
};

}  // namespace wend
