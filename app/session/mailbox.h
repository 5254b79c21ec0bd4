#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <variant>

#include "app/document/grip.h"
#include "app/session/shape_builder.h"

namespace wend {

/// What the window asks of the compute thread.
struct SetShape {
    ShapeInputs inputs;
};
struct BeginDrag {
    std::vector<int> handles;
    Grip grip = {};
};
struct DragTo {
    std::vector<Amount> amounts;  // from where the drag began, one per sample of the pointer
    int lastSample = 0;
};
struct EndDrag {
    bool keep = true;  // the shape as the preview has it, until the exact motion is there
};
using Request = std::variant<SetShape, BeginDrag, DragTo, EndDrag>;

/// Holds the newest request of each kind: a shape replaces the one before it, targets of a drag are put
/// together.
class Mailbox {
  public:
    void post(Request request);
    /// Waits for a request; nothing if there is none and `wait` is false, or when `stop` was requested.
    std::optional<Request> take(bool wait, std::stop_token stop);
    /// A token that is stopped as soon as there is a request, or at once if there is one.
    std::stop_token interruption();
    void interrupt();

  private:
    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::deque<Request> m_requests;
    std::stop_source m_interruption;
};

}  // namespace wend
