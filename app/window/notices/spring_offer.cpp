#include "app/window/notices/spring_offer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/engine/motion/playback.h"
#include "app/project/design.h"
#include "app/project/edits/document.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/session/shape_session.h"
#include "app/window/notices/info_banner.h"
#include "core/base/error.h"
#include "core/motion/constraints.h"

namespace wend {

namespace {

constexpr double kBack = 1e-6;  // relative to how far the map was from the identity
constexpr int kSamples = 64;

}  // namespace

bool comesBack(const Pin& handle) {
    const auto isField = [](const PinMotion& motion) {
        return std::holds_alternative<FieldMotion<3>>(motion.kind);
    };
    if (handle.motions.empty() || std::ranges::any_of(handle.motions, isField)) return false;
    try {
        const HandleTimeline<3> timeline(handleIn<3>(handle));
        const double from = handle.motions.front().start, to = handle.motions.back().end;
        double farthest = 0, atEnd = 0;
        for (int k = 0; k <= kSamples; ++k) {
            const auto map = timeline.bodyAt(from + (to - from) * k / kSamples, Side::Before).position;
            atEnd = map.b.norm() + (map.A - Mat<3>::Identity()).norm();
            farthest = std::max(farthest, atEnd);
        }
        return atEnd < kBack * farthest;
    } catch (const InputError&) {
        return false;  // the motion itself says so
    }
}

SpringOffer::SpringOffer(ShapeSession& session, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_session(session), m_banner(banner) {
    connect(&m_session.document(), &Document::opened, this, [this] {
        m_isOffered = m_isDeclined = false;
        follow();
    });
    connect(&m_session.document(), &Document::projectChanged, this, &SpringOffer::follow);
    connect(&m_session.playback(), &Playback::loopsChanged, this, &SpringOffer::follow);
}

bool SpringOffer::isDue() const {
    const Document& document = m_session.document();
    if (document.isEmpty() || settingOf(document, "material.memory") != 0) return false;
    if (motionEnd(*document.project()) <= 0) return false;
    if (m_session.playback().loops()) return true;
    return std::ranges::any_of(document.design().handles, comesBack);
}

/// The offer is made once for a document.
void SpringOffer::follow() {
    const bool isDue = this->isDue();
    if (isDue == m_isOffered || (isDue && m_isDeclined)) return;
    m_isOffered = isDue;
    if (!isDue) return m_banner.clear(InfoBanner::Topic::Spring);
    m_isDeclined = true;
    const auto take = [this] {
        changeSetting(m_session.document(), "material.memory", std::numeric_limits<double>::infinity());
    };
    m_banner.tell(
        InfoBanner::Topic::Spring,
        tr("What comes back leaves the shape a little different, so that a loop jumps. If the shape "
           "springs back fully, it is as it was."),
        {{tr("Spring Back Fully"), take}});
}

}  // namespace wend
