#include "app/view/notices/parts_offer.h"

#include <algorithm>

#include "app/document/domain.h"
#include "app/document/edits/document.h"
#include "app/document/edits/part_edits.h"
#include "app/view/notices/info_banner.h"

namespace wend {

PartsOffer::PartsOffer(Document& document, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_document(document), m_banner(banner) {
    connect(&m_document, &Document::opened, this, &PartsOffer::offer);
    connect(&m_document, &Document::projectChanged, this, &PartsOffer::follow);
}

/// Saved projects keep their parts: nothing is offered for them.
void PartsOffer::offer() {
    m_isOffered = !m_document.isEmpty() && m_document.path().isEmpty() &&
                  !m_document.domain().parts.empty() &&
                  !m_document.source().endsWith(QStringLiteral(".wend"));
    if (!m_isOffered) return;
    const std::vector<PicturePart>& parts = m_document.domain().parts;
    const int count = static_cast<int>(parts.size());
    const bool isOneFile =
        std::ranges::none_of(parts, [](const PicturePart& part) { return part.layer.empty(); });
    if (!isOneFile)
        return m_banner.tell(
            InfoBanner::Topic::Parts,
            tr("%n pictures were opened as parts: each bends by itself. Join them where they "
               "meet, under Parts.",
               nullptr, count));
    m_banner.tell(InfoBanner::Topic::Parts,
                  tr("%n layers were opened as parts: each bends by itself. Join them where they meet, under "
                     "Parts.",
                     nullptr, count),
                  {{tr("Open Flattened"), [this] { flatten(); }}});
}

void PartsOffer::flatten() {
    m_document.change(tr("Open flattened"),
                      withoutParts(*m_document.project(), m_document.source().toStdString()));
}

void PartsOffer::follow() {
    if (!m_isOffered || !m_document.domain().parts.empty()) return;
    m_isOffered = false;
    m_banner.clear(InfoBanner::Topic::Parts);
}

}  // namespace wend
