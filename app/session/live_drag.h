#pragma once

#include <vector>

#include "app/document/grip.h"
#include "app/session/shape.h"
#include "core/integration/drag_flow.h"

namespace wend {

/// The flow while a drag goes on: the dragged handles go straight from where they are to the newest target,
/// all others hold still: a preview, replaced by the exact motion after the release.
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
    /// A drag of some handles, by their index, from a pose.
    void begin(std::vector<int> dragged, const Grip& grip, const Points<Dim>& pose);
    Step follow(const Amount& amount);
    const Points<Dim>& pose() const { return m_flow.pose(); }

  private:
    double length(const Amount& way) const;

    Shape<Dim> m_shape;
    double m_size;
    std::vector<Handle<Dim>> m_handles;
    std::vector<int> m_dragged;
    DragFlow<Dim> m_flow;
    Grip m_grip;
    Amount m_amount = Amount::Zero();
};

}  // namespace wend
