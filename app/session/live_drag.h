#pragma once

#include <vector>

#include "app/session/shape_builder.h"
#include "core/integration/drag_flow.h"

namespace wend {

/// The flow while a drag goes on: the dragged handles go straight from where they are to the newest target,
/// all others hold still: a preview, replaced by the exact motion after the release.
class LiveDrag {
  public:
    struct Step {
        Vec<2> offset;  // how far the handles are from where the drag began
        bool stopped = false;
        std::string message;
        double pinError = 0;
    };

    /// `handles` hold the shape; their motions do not matter. Analyzes at once, so that a drag begins
    /// promptly.
    LiveDrag(const BuiltShape& shape, std::vector<Handle<2>> handles);

    /// True if a drag of these handles can begin without another analysis.
    bool fits(const BuiltShape& shape, const std::vector<Handle<2>>& handles) const;
    /// A drag of some handles, by their index, from a pose.
    void begin(std::vector<int> dragged, const Points<2>& pose);
    Step follow(const Vec<2>& offset);
    const Points<2>& pose() const { return m_flow.pose(); }

  private:
    BuiltShape m_shape;
    double m_diagonal;
    std::vector<Handle<2>> m_handles;
    std::vector<int> m_dragged;
    DragFlow<2> m_flow;
    Vec<2> m_offset = Vec<2>::Zero();
};

}  // namespace wend
