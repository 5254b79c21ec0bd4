#pragma once

#include <optional>
#include <vector>

#include "app/engine/motion/coarse_body.h"
#include "app/project/edits/grip.h"
#include "core/integration/drag_flow.h"

namespace wend {

/// The flow during a drag: dragged handles move straight to the newest target; the others hold still, or
/// follow their motions while a recording runs. This is a preview; the exact motion replaces it after the
/// release. Large shapes are carried by a coarse body.
template <int Dim>
class LiveDrag {
  public:
    struct Step {
        Amount amount;  // how far the handles are from where the drag began
        bool stopped = false;
        Message message;
        double pinError = 0;
    };

    /// `handles` hold the shape; their motions are ignored. Analyzes immediately, so that a drag starts
    /// without delay. If a body of the shape is given, it carries the shape where possible.
    LiveDrag(const Shape<Dim>& shape, std::vector<Handle<Dim>> handles,
             std::shared_ptr<const CoarseBody<Dim>> body = nullptr);

    /// Returns whether a drag of these handles can start without another analysis.
    bool fits(const Shape<Dim>& shape, const std::vector<Handle<Dim>>& handles) const;
    /// Starts a drag of some handles, given by their indices, from a pose, which is the one at `time`.
    /// `handles` are all handles with their current motions; if empty, they have none.
    void begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose,
               const std::vector<Handle<Dim>>& handles = {}, double time = 0);
    /// If a time is given, the other handles move to where they are then.
    Step follow(const Amount& amount, std::optional<double> time = {});
    const Points<Dim>& pose() const { return m_body ? m_carried : m_flow->pose(); }
    /// Returns whether a coarse body carries the shape.
    bool rides() const { return m_body != nullptr; }

  private:
    bool ride();
    void beginFlow(const Points<Dim>& pose);
    void flowByItself();
    double length(const Amount& change) const;
    std::vector<typename DragFlow<Dim>::Alongside> othersUntil(double time) const;

    Shape<Dim> m_shape;
    double m_size;
    std::vector<Handle<Dim>> m_handles;
    std::vector<int> m_dragged;
    std::shared_ptr<const CoarseBody<Dim>> m_body;  // the body that carries the shape, or null
    typename CoarseBody<Dim>::Ride m_ride;
    typename CoarseBody<Dim>::Held m_held;
    Points<Dim> m_carried;                // by the body: the shape's pose
    std::optional<DragFlow<Dim>> m_flow;  // of the body, or of the shape
    Grip m_grip;
    Amount m_amount = Amount::Zero();
    struct Other {  // a handle that moves by itself
        int handle;
        std::vector<Trajectory<Dim>> motions;
    };
    std::vector<Other> m_others;
    double m_time = 0;
};

}  // namespace wend
