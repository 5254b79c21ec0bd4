#include "app/view/notices/border_offer.h"

#include "app/document/design.h"
#include "app/document/domain.h"
#include "app/document/edits/document.h"
#include "app/document/edits/handle_edits.h"
#include "app/document/edits/setting_edits.h"
#include "app/view/notices/info_banner.h"
#include "warp/convert.h"

namespace wend {

namespace {

/// Returns whether the upper and lower edges are opaque.
bool isOpaque(const Image& picture) {
    constexpr float kFull = 0.99F;
    if (!picture.alpha) return true;
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<float> row(static_cast<std::size_t>(picture.width) * channels);
    for (const int y : {0, picture.height - 1}) {
        loadRow(picture, y, row.data());
        for (std::size_t i = channels - 1; i < row.size(); i += channels)
            if (row[i] < kFull) return false;
    }
    return true;
}

}  // namespace

BorderOffer::BorderOffer(Document& document, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_document(document), m_banner(banner) {
    connect(&m_document, &Document::opened, this, &BorderOffer::offer);
    connect(&m_document, &Document::projectChanged, this, &BorderOffer::follow);
}

/// Returns whether the whole picture, with its border, is deformed.
bool BorderOffer::isDue() const {
    if (m_document.isEmpty() || !m_document.picture()) return false;
    const Domain& domain = m_document.domain();
    return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Frame &&
           domain.border == Border::Free;
}

/// Saved projects are not asked again.
void BorderOffer::offer() {
    m_isOffered = isDue() && m_document.path().isEmpty() && m_document.design<2>().handles.empty() &&
                  isOpaque(*m_document.picture());
    if (!m_isOffered) return;
    const auto hold = [this] {
        changeSetting(m_document, "domain.border", static_cast<double>(Border::Fixed));
    };
    m_banner.tell(InfoBanner::Topic::Border,
                  tr("This picture fills its frame. If its border is held, it bends inside and no gap opens "
                     "at the edges."),
                  {{tr("Hold the Border"), hold}});
}

void BorderOffer::follow() {
    if (!m_isOffered || isDue()) return;
    m_isOffered = false;
    m_banner.clear(InfoBanner::Topic::Border);
}

}  // namespace wend
