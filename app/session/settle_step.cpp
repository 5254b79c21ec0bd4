#include "app/session/settle_step.h"

#include <cmath>

#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/project.h"
#include "app/session/shape_session.h"

namespace wend {

bool canSettle(const Document& document) {
    return !document.isEmpty() && motionEnd(*document.project()) > 0 &&
           std::isfinite(settingOf(document, "material.memory"));
}

void settleAtEnd(Document& document, Playback& playback) {
    if (!canSettle(document)) return;
    Project next = *document.project();
    appendSettling(next, motionEnd(next));
    document.change(ShapeSession::tr("Relax"), std::move(next));
    playback.setTime(playback.end());
}

}  // namespace wend
