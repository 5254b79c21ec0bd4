#include "app/view/notices/line_art_offer.h"

#include <cmath>

#include "app/document/design.h"
#include "app/document/domain.h"
#include "app/document/edits/document.h"
#include "app/document/edits/setting_edits.h"
#include "app/document/in_background.h"
#include "app/view/notices/info_banner.h"
#include "core/mesh/error.h"
#include "core/mesh/segments.h"
#include "warp/outline.h"

namespace wend {

namespace {

constexpr double kMostInk = 0.4;    // of what the strokes enclose
constexpr double kThickest = 0.04;  // of the picture's diagonal: the mean width of a stroke

struct InkMeasure {
    double area = 0, length = 0;
};

/// Measures with the even-odd rule: holes count against what they are in.
InkMeasure measured(const Outline& outline) {
    InkMeasure sum;
    for (const auto& loop : outline.loops) {
        sum.area += loopArea(loop);
        for (std::size_t k = 0; k < loop.size(); ++k)
            sum.length += (loop[(k + 1) % loop.size()] - loop[k]).norm();
    }
    sum.area = std::abs(sum.area);
    return sum;
}

}  // namespace

bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    try {
        AlphaOutlineOptions strokes = outline;
        strokes.margin = 0;
        strokes.holes = OutlineHoles::Kept;
        const InkMeasure ink = measured(outlineFromAlpha(picture, strokes));
        strokes.holes = OutlineHoles::Filled;
        const InkMeasure whole = measured(outlineFromAlpha(picture, strokes));
        const double width = ink.length > 0 ? 2 * ink.area / ink.length : 0;
        return ink.area < kMostInk * whole.area &&
               width < kThickest * std::hypot(picture.width, picture.height);
    } catch (const InputError&) {
        return false;
    }
}

LineArtOffer::LineArtOffer(Document& document, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_document(document), m_banner(banner) {
    connect(&m_document, &Document::opened, this, &LineArtOffer::look);
    connect(&m_document, &Document::projectChanged, this, &LineArtOffer::follow);
}

bool LineArtOffer::isDue() const {
    if (m_document.isEmpty() || !m_document.picture()) return false;
    const Domain& domain = m_document.domain();
    return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Alpha &&
           domain.alpha.holes == OutlineHoles::Kept;
}

/// Saved projects are not asked again. Large pictures take a while.
void LineArtOffer::look() {
    m_isOffered = false;
    if (!isDue() || !m_document.path().isEmpty() || !m_document.design<2>().handles.empty()) return;
    const auto picture = m_document.picture();
    inBackground(
        this, [picture, outline = m_document.domain().alpha] { return isLineArt(*picture, outline); },
        [this, picture](bool isDrawn) {
            if (isDrawn && m_document.picture() == picture && isDue()) offer();
        });
}

void LineArtOffer::offer() {
    m_isOffered = true;
    const auto fill = [this] { changeSetting(m_document, "domain.outline.from", double(kFilledCutOut)); };
    m_banner.tell(
        InfoBanner::Topic::LineArt,
        tr("This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they "
           "enclose, too."),
        {{tr("Fill the Holes"), fill}});
}

void LineArtOffer::follow() {
    if (!m_isOffered || isDue()) return;
    m_isOffered = false;
    m_banner.clear(InfoBanner::Topic::LineArt);
}

}  // namespace wend
