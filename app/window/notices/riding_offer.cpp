#include "app/window/notices/riding_offer.h"

#include <algorithm>

#include "app/session/shape_session.h"
#include "app/window/notices/info_banner.h"

namespace wend {

RidingOffer::RidingOffer(ShapeSession& session, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_session(session), m_banner(banner) {
    connect(&session.document(), &Document::opened, this, [this] {
        m_told = 0;
        m_lookedAt.reset();
    });
    connect(&session, &ShapeSession::frameChanged, this, &RidingOffer::look);
}

/// Looks at every project once, when its motion is there.
void RidingOffer::look() {
    const Document& document = m_session.document();
    if (document.isEmpty() || document.dimension() != 2 || m_session.isDragging() || m_session.isBusy() ||
        m_session.isStale() || document.project() == m_lookedAt || !(m_session.playback().end() > 0))
        return;
    m_lookedAt = document.project();
    const std::vector<StrayPart> strays = strayParts(m_session);
    if (strays.empty()) m_banner.clear(InfoBanner::Topic::Riding);
    if (!strays.empty() && strays.size() != m_told) offer(strays);
    m_told = strays.size();
}

void RidingOffer::offer(const std::vector<StrayPart>& strays) {
    const auto count = static_cast<int>(strays.size());
    const std::string& host = strays.front().host;
    const bool isOneHost =
        !host.empty() && std::ranges::all_of(strays, [&](const StrayPart& one) { return one.host == host; });
    const QString name = QString::fromStdString(host);
    const QString one = isOneHost
                            ? tr("A part has no pin and stays behind: let it ride on “%1”?").arg(name)
                            : tr("A part has no pin and stays behind: let it ride on what is beside it?");
    const QString many =
        isOneHost
            ? tr("%n parts have no pin and stay behind: let them ride on “%1”?", nullptr, count).arg(name)
            : tr("%n parts have no pin and stay behind: let them ride on what is beside them?", nullptr,
                 count);
    const auto ride = [this, strays] {
        Document& document = m_session.document();
        m_banner.clear(InfoBanner::Topic::Riding);
        if (document.project() == m_lookedAt)
            document.change(tr("Let parts ride"), withRiders(*document.project(), strays));
    };
    m_banner.tell(InfoBanner::Topic::Riding, count == 1 ? one : many,
                  {{count == 1 ? tr("Let It Ride") : tr("Let Them Ride"), ride}});
}

}  // namespace wend
