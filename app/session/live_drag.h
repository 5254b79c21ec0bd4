#pragma once

#include <optional>
#include <vector>

#include "app/document/grip.h"
#include "app/session/shape.h"
#include "core/integration/drag_flow.h"

namespace wend {

/// The flow while a drag goes on: the dragged handles go straight from where they are to the newest target,
/// all others hold still, or go on as they do when a recording tells the time: a preview, replaced by the
/// exact motion after the release.
template <int Dim>
class LiveDrag {
  public:
    struct Step {
        Amount amount;  // how far the handles are from where the drag began
        bool stopped = false;
        std::string message;
        double pinError = 0;
    };

    /// `handles` hold the shape; their motions do not matter. Analyzes at once, so that a drag begins
    /// promptly.
    LiveDrag(const Shape<Dim>& shape, std::vector<Handle<Dim>> handles);

    /// True if a drag of these handles can begin without another analysis.
    bool fits(const Shape<Dim>& shape, const std::vector<Handle<Dim>>& handles) const;
    /// A drag of some handles, by their index, from a pose that is that of a time. `handles`: all with the
    /// motions that they have now; none: they have none.
    void begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose,
               const std::vector<Handle<Dim>>& handles = {}, double time = 0);
    /// With a time the other handles are where they are then.
    Step follow(const Amount& amount, std::optional<double> time = {});
    const Points<Dim>& pose() const { return m_flow.pose(); }

  private:
    double length(const Amount& change) const;
    std::vector<typename DragFlow<Dim>::Alongside> othersUntil(double time) const;

    Shape<Dim> m_shape;
    double m_size;
    std::vector<Handle<Dim>> m_handles;
    std::vector<int> m_dragged;
    DragFlow<Dim> m_flow;
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
