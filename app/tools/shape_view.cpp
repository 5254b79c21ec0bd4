#include "app/tools/shape_view.h"

#include "app/session/shape_session.h"

namespace wend {

FramePtr ShapeView::frame() {
    const FramePtr shown = session().motion().frame();
    return shown && shown->dimension == dimension() ? shown : FramePtr();
}

}  // namespace wend
