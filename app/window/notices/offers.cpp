#include "app/window/notices/offers.h"

#include <algorithm>

#include "app/base/in_background.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/document.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/part_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/window/notices/picture_checks.h"
#include "warp/drawn_picture.h"

namespace wend {

namespace {

constexpr double kFaint = 0.01;  // opacity above which the wider outline includes a pixel

bool isDrawingFile(const QString& path) {
    try {
        return isDrawing(path.toStdString());
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

Offers::Offers(Document& document, InfoBanner& banner, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_banner(banner),
      m_all{border(), softEdges(), lineArt(), drawing(), parts()} {
    connect(&m_document, &Document::opened, this, &Offers::look);
    connect(&m_document, &Document::projectChanged, this, &Offers::follow);
}

bool Offers::isCutOut() const {
    if (m_document.isEmpty() || !m_document.picture()) return false;
    const Domain& domain = m_document.domain();
    return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Alpha;
}

Offers::Offer Offers::border() {
    const auto matters = [this] {
        if (m_document.isEmpty() || !m_document.picture()) return false;
        const Domain& domain = m_document.domain();
        return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Frame &&
               domain.parts.empty() && domain.border == Border::Free && hasOpaqueEdges(*m_document.picture());
    };
    const auto hold = [this] {
        changeSetting(m_document, "domain.border", static_cast<double>(Border::Fixed));
    };
    const Words words{
        tr("This picture fills its frame. If its border is held, it bends inside and no gap opens "
           "at the edges."),
        {{tr("Hold the Border"), hold}}};
    return {InfoBanner::Topic::Border, matters, {}, [words] { return words; }};
}

Offers::Offer Offers::softEdges() {
    const auto matters = [this] { return isCutOut() && m_document.domain().alpha.threshold > kFaint; };
    const auto take = [this] { changeSetting(m_document, "domain.outline.threshold", kFaint); };
    const Words words{tr("Soft edges or shadows of this picture reach beyond the cut-out, and are cut off."),
                      {{tr("Include Them"), take}}};
    return {InfoBanner::Topic::SoftEdges, matters, cutsSoftEdges, [words] { return words; }};
}

Offers::Offer Offers::lineArt() {
    const auto matters = [this] {
        return isCutOut() && m_document.domain().alpha.holes == OutlineHoles::Kept;
    };
    const auto fill = [this] { changeSetting(m_document, "domain.outline.from", double(kFilledCutOut)); };
    const Words words{
        tr("This picture is mostly thin lines, and only the lines would bend. Filled holes bend what "
           "they enclose, too."),
        {{tr("Fill the Holes"), fill}}};
    return {InfoBanner::Topic::LineArt, matters, isLineArt, [words] { return words; }};
}

Offers::Offer Offers::parts() {
    const auto matters = [this] {
        return !m_document.isEmpty() && !m_document.domain().parts.empty() &&
               !m_document.source().endsWith(QStringLiteral(".wend"));
    };
    const auto flatten = [this] {
        m_document.change(tr("Open flattened"),
                          withoutParts(*m_document.project(), m_document.source().toStdString()));
    };
    const auto words = [this, flatten]() -> Words {
        const std::vector<PicturePart>& parts = m_document.domain().parts;
        const int count = static_cast<int>(parts.size());
        if (std::ranges::any_of(parts, [](const PicturePart& part) { return part.layer.empty(); }))
            return {tr("%n pictures were opened as parts: each bends by itself. Join them where they "
                       "meet, under Parts.",
                       nullptr, count),
                    {}};
        return {tr("%n layers were opened as parts: each bends by itself. Join them where they meet, under "
                   "Parts.",
                   nullptr, count),
                m_isDrawing ? QList<InfoBanner::Remedy>{{tr("Open Flattened"), flatten}, sizeButton()}
                            : QList<InfoBanner::Remedy>{{tr("Open Flattened"), flatten}}};
    };
    return {InfoBanner::Topic::Parts, matters, {}, words};
}

InfoBanner::Remedy Offers::sizeButton() {
    return {tr("Another Size…"), [this] { emit sizeWanted(); }};
}

/// One of several layers has the button beside the line about its parts.
Offers::Offer Offers::drawing() {
    const auto matters = [this] {
        return m_isDrawing && !m_document.isEmpty() && m_document.picture() &&
               m_document.domain().parts.empty();
    };
    const auto words = [this]() -> Words {
        const Image& picture = *m_document.picture();
        return {tr("This drawing became a picture of %1 × %2 pixels.").arg(picture.width).arg(picture.height),
                {sizeButton()}};
    };
    return {InfoBanner::Topic::Drawing, matters, {}, words};
}

/// Large pictures take a while to check.
void Offers::look() {
    m_made.clear();
    m_isDrawing = false;
    if (!m_document.path().isEmpty()) return;
    m_isDrawing = isDrawingFile(m_document.source());
    for (const Offer& offer : m_all) {
        if (!offer.matters() || !m_document.design().handles.empty()) continue;
        if (!offer.isCalledFor) {
            make(offer);
            continue;
        }
        const auto picture = m_document.picture();
        inBackground(
            this,
            [picture, outline = m_document.domain().alpha, check = offer.isCalledFor] {
                return check(*picture, outline);
            },
            [this, picture, &offer](bool isCalledFor) {
                if (isCalledFor && m_document.picture() == picture && offer.matters()) make(offer);
            });
    }
}

void Offers::make(const Offer& offer) {
    m_made.insert(offer.topic);
    const Words words = offer.words();
    m_banner.tell(offer.topic, words.text, words.remedies);
}

void Offers::follow() {
    for (const Offer& offer : m_all)
        if (m_made.contains(offer.topic) && !offer.matters()) {
            m_made.erase(offer.topic);
            m_banner.clear(offer.topic);
        }
}

}  // namespace wend
