#pragma once

#include "app/tools/picture_shape_view.h"
#include "app/tools/solid_shape_view.h"
#include "app/tools/tool.h"

namespace wend {

/// A tool with the view that it works on: of any shape, or of pictures or solids alone.
template <class View = ShapeView>
class ShapeTool : public Tool {
  public:
    explicit ShapeTool(View& view) : m_view(view) {}

  protected:
    View& view() const { return m_view; }
    ShapeSession& session() const { return m_view.session(); }
    /// Returns the frame of a picture or solid; null if the document has another dimension.
    FramePtr frame() const { return m_view.frame(); }

  private:
    View& m_view;
};

}  // namespace wend
