#include "app/session/pins/curve_making.h"

#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"

namespace wend {

namespace {

int single(const ShapeSession& session) {
    return session.frame() ? session.singleHandle() : -1;
}

template <int Dim>
void makeCurveOf(ShapeSession& session, int handle) {
    Document& document = session.document();
    const auto starts = session.pathStarts<Dim>(handle);
    if (starts.empty()) return;
    const auto path = pinPaths<Dim>(document.design<Dim>().handles[handle], {meanOf<Dim>(starts)});
    const auto next = withCurve(document.design<Dim>(), handle, path.front().points.back());
    if (next) document.changeDesign(ShapeSession::tr("Edit path"), *next);
}

}  // namespace

bool canMakeCurve(const ShapeSession& session) {
    const int handle = single(session);
    if (handle < 0) return false;
    return std::visit([handle](const auto& design) { return canBecomeCurve(design, handle); },
                      session.document().design());
}

void makeCurve(ShapeSession& session) {
    if (!canMakeCurve(session)) return;
    if (session.document().dimension() == 2)
        makeCurveOf<2>(session, single(session));
    else
        makeCurveOf<3>(session, single(session));
}

}  // namespace wend
