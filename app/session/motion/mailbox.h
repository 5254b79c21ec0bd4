#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <variant>

#include "app/document/edits/grip.h"
#include "app/session/motion/frame.h"
#include "app/session/shape/shape_builder.h"

namespace wend {

/// What the window asks of the compute thread.
struct SetShape {
    ShapeInputs inputs;
};
struct BeginDrag {
    std::vector<int> handles;
    Grip grip = {};
    int gesture = 0;   // its number: frames tell what they belong to
    int revision = 0;  // of the shape that the handles are of
    FramePtr from;     // what is seen: the drag begins there, whatever is still being computed
    double time = 0;   // of the motion, when it begins
};
struct DragTo {
    Amount amount = Amount::Zero();   // from where the drag began
    int sample = 0;                   // its number in the gesture
    std::optional<double> time = {};  // of the motion: of a recording, to which the others go on
};
struct EndDrag {};
/// For a velocity field at a frame of the motion: its own, or how far some handles take everything along
/// (docs/method.md, section 5).
struct AskField {
    FramePtr frame;
    int revision = 0;
    std::vector<int> influenceOf = {};
    int number = 0;  // of the question, for its answer
};
struct CancelWork {};  // what is being made is not wanted any more, and nothing else is
using Request = std::variant<SetShape, BeginDrag, DragTo, EndDrag, AskField, CancelWork>;

/// What waits to be done, in order. Of shapes that follow each other only the newest is kept, and of
/// questions for a field and targets of a drag as well: the preview goes straight to where the pointer is.
class Mailbox {
  public:
    void post(Request request);
    /// Waits for a request; nothing if there is none and `wait` is false, or when `stop` was requested.
    std::optional<Request> take(bool wait, std::stop_token stop);
    /// A token that is stopped as soon as there is a request, or at once if there is one.
    std::stop_token interruption();
    /// From now on every token is stopped.
    void close();

  private:
    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::deque<Request> m_requests;
    std::stop_source m_interruption;
    bool m_closed = false;
};

}  // namespace wend
