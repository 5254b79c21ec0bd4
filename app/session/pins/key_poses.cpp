#include "app/session/pins/key_poses.h"

#include <algorithm>
#include <set>

#include "app/project/design.h"
#include "app/session/pins/mirroring.h"

namespace wend {

namespace {

std::vector<Vec3> startsOf(const ShapeSession& session) {
    std::vector<Vec3> starts;
    for (int h = 0; h < session.pins().count(); ++h) {
        const auto own = session.pins().pathStarts(h);
        starts.push_back(own.empty() ? Vec3(Vec3::Zero()) : meanOf(own));
    }
    return starts;
}

}  // namespace

std::vector<CopiedKey> copyKeys(const ShapeSession& session, const std::vector<KeyId>& keys) {
    return copiedKeys(session.document().design(), keys, startsOf(session));
}

std::vector<CopiedKey> mirroredKeys(const ShapeSession& session, std::vector<CopiedKey> copies) {
    const FramePtr frame = session.motion().frame();
    if (!frame) return {};
    const Mirror mirror = mirrorOf(*frame);
    const std::vector<int> images = mirrorImages(*frame, session.document().design().handles);
    for (CopiedKey& copy : copies) {
        copy.handle = images.at(static_cast<std::size_t>(copy.handle));
        copy.offset = mirror.along(copy.offset);
    }
    return copies;
}

std::vector<CopiedKey> forSelected(const ShapeSession& session, const std::vector<CopiedKey>& copies) {
    std::set<int> from;
    for (const CopiedKey& copy : copies) from.insert(copy.handle);
    const std::vector<int> to = session.selection().handles();
    if (from.size() != 1 || to.empty() || std::ranges::count(to, *from.begin()) > 0) return copies;
    std::vector<CopiedKey> others;
    for (CopiedKey copy : copies)
        for (const int handle : to) copy.handle = handle, others.push_back(copy);
    return others;
}

std::vector<KeyId> pasteKeys(ShapeSession& session, std::vector<CopiedKey> copies, double time,
                             const QString& step) {
    Document& document = session.document();
    std::set<int> locked;
    for (const CopiedKey& copy : copies)
        if (!locked.contains(copy.handle) && !session.gestures().mayChange(copy.handle))
            locked.insert(copy.handle);
    std::erase_if(copies, [&](const CopiedKey& copy) { return locked.contains(copy.handle); });
    std::vector<KeyId> pasted;
    const auto next = withKeysPasted(*document.project(), copies, time, startsOf(session), pasted);
    if (pasted.size() < copies.size())
        session.document().notify(ShapeSession::tr(
            "No pose was set where a pin begins, rotates or does not hold: show another time."));
    session.playback().setPlaying(false);
    if (!pasted.empty()) document.change(step, next);
    return pasted;
}

void easeMotions(ShapeSession& session, const std::vector<MotionId>& motions, const Progress& progress,
                 const QString& step, const QString& mergeKey) {
    Document& document = session.document();
    session.playback().setPlaying(false);
    document.changeDesign(step, withProgress(document.design(), motions, progress, startsOf(session)),
                          mergeKey);
}

}  // namespace wend
