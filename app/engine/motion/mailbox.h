#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <variant>

#include "app/engine/motion/frame.h"
#include "app/engine/shape/shape_builder.h"
#include "app/project/edits/grip.h"

namespace wend {

/// Requests of the window to the compute thread.
struct SetShape {
    ShapeInputs inputs;
};
struct BeginDrag {
    std::vector<int> handles;
    Grip grip = {};
    int gesture = 0;   // number of the drag, which its frames carry
    int revision = 0;  // of the shape that the handles are of
    FramePtr from;     // the shown frame; the drag starts there, whatever is still being computed
    double time = 0;   // of the motion, when it begins
};
struct DragTo {
    Amount amount = Amount::Zero();   // from where the drag began
    int sample = 0;                   // its number in the gesture
    std::optional<double> time = {};  // time of a recording, at which the other handles are placed
};
struct EndDrag {};
/// Asks for a field at a frame of the motion: the velocity, or the influence of some handles (docs/method.md,
/// section 5).
struct AskField {
    FramePtr frame;
    int revision = 0;
    std::vector<int> influenceOf = {};
    int number = 0;  // of the question, for its answer
};
struct CancelWork {};  // cancels the current work without replacing it
using Request = std::variant<SetShape, BeginDrag, DragTo, EndDrag, AskField, CancelWork>;

/// Requests in order. Only the newest of consecutive shapes, field requests and drag targets is kept, so the
/// preview jumps to the current pointer position.
class Mailbox {
  public:
    void post(Request request);
    /// Waits for a request. Returns nothing if there is none and `wait` is false, or if `stop` was requested.
    std::optional<Request> take(bool wait, std::stop_token stop);
    /// Returns whether take() is waiting and there is no request for it.
    bool isAwaited() const;
    /// Returns a token that stops as soon as a request is waiting.
    std::stop_token interruption();
    /// Stops every token from now on.
    void close();

  private:
    mutable std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::deque<Request> m_requests;
    std::stop_source m_interruption;
    bool m_closed = false, m_isAwaited = false;
};

}  // namespace wend
