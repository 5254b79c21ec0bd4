#include "app/session/pins/curve_making.h"

#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"

namespace wend {

namespace {

int single(const ShapeSession& session) {
    return session.frame() ? session.singleHandle() : -1;
}

}  // namespace

bool canMakeCurve(const ShapeSession& session) {
    const int handle = single(session);
    if (handle < 0) return false;
    return canBecomeCurve(session.document().design(), handle);
}

void makeCurve(ShapeSession& session) {
    if (!canMakeCurve(session)) return;
    Document& document = session.document();
    const int handle = single(session);
    const auto starts = session.pathStarts(handle);
    if (starts.empty()) return;
    const auto path = pinPaths(document.design().handles[handle], {meanOf(starts)}, document.dimension());
    const auto next = withCurve(document.design(), handle, path.front().points.back());
    if (next) document.changeDesign(ShapeSession::tr("Edit path"), *next);
}

}  // namespace wend
