#include "app/session/pins/key_poses.h"

#include <algorithm>
#include <set>

#include "app/project/design.h"
#include "app/session/pins/mirroring.h"

namespace wend {

namespace {

template <int Dim>
std::vector<Vec<Dim>> startsOf(const ShapeSession& session) {
    std::vector<Vec<Dim>> starts;
    for (int h = 0; h < session.handleCount(); ++h) {
        const auto own = session.pathStarts<Dim>(h);
        starts.push_back(own.empty() ? Vec<Dim>(Vec<Dim>::Zero()) : meanOf<Dim>(own));
    }
    return starts;
}

template <int Dim>
std::vector<CopiedKey> mirroredKeysOf(const ShapeSession& session, std::vector<CopiedKey> copies) {
    const auto frame = session.frame<Dim>();
    if (!frame) return {};
    const Mirror<Dim> mirror = mirrorOf<Dim>(*frame->rest);
    const std::vector<int> images = mirrorImages<Dim>(*frame, session.document().design<Dim>().handles);
    for (CopiedKey& copy : copies) {
        copy.handle = images.at(static_cast<std::size_t>(copy.handle));
        copy.offset = amountOf<Dim>(mirror.along(copy.offset.template head<Dim>()));
    }
    return copies;
}

}  // namespace

std::vector<CopiedKey> copyKeys(const ShapeSession& session, const std::vector<KeyId>& keys) {
    const Document& document = session.document();
    return document.dimension() == 2 ? copiedKeys<2>(document.design<2>(), keys, startsOf<2>(session))
                                     : copiedKeys<3>(document.design<3>(), keys, startsOf<3>(session));
}

std::vector<CopiedKey> mirroredKeys(const ShapeSession& session, std::vector<CopiedKey> copies) {
    return session.document().dimension() == 2 ? mirroredKeysOf<2>(session, std::move(copies))
                                               : mirroredKeysOf<3>(session, std::move(copies));
}

std::vector<CopiedKey> forSelected(const ShapeSession& session, const std::vector<CopiedKey>& copies) {
    std::set<int> from;
    for (const CopiedKey& copy : copies) from.insert(copy.handle);
    const std::vector<int>& to = session.selection().handles();
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
        if (!locked.contains(copy.handle) && !session.mayChange(copy.handle)) locked.insert(copy.handle);
    std::erase_if(copies, [&](const CopiedKey& copy) { return locked.contains(copy.handle); });
    std::vector<KeyId> pasted;
    const auto next =
        document.dimension() == 2
            ? withKeysPasted<2>(*document.project(), copies, time, startsOf<2>(session), pasted)
            : withKeysPasted<3>(*document.project(), copies, time, startsOf<3>(session), pasted);
    if (pasted.size() < copies.size())
        emit session.notice(ShapeSession::tr(
            "No pose was set where a pin begins, rotates or does not hold: show another time."));
    session.playback().setPlaying(false);
    if (!pasted.empty()) document.change(step, next);
    return pasted;
}

void easeMotions(ShapeSession& session, const std::vector<MotionId>& motions, const Progress& progress,
                 const QString& step, const QString& mergeKey) {
    Document& document = session.document();
    session.playback().setPlaying(false);
    if (document.dimension() == 2)
        document.changeDesign(
            step, withProgress<2>(document.design<2>(), motions, progress, startsOf<2>(session)), mergeKey);
    else
        document.changeDesign(
            step, withProgress<3>(document.design<3>(), motions, progress, startsOf<3>(session)), mergeKey);
}

}  // namespace wend
