#include "app/view/notices/soft_edge_offer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/document/design.h"
#include "app/document/domain.h"
#include "app/document/edits/document.h"
#include "app/document/edits/setting_edits.h"
#include "app/document/in_background.h"
#include "app/view/notices/info_banner.h"
#include "warp/convert.h"

namespace wend {

namespace {

constexpr double kFaint = 0.01;        // opacity above which the wider outline includes a pixel
constexpr float kLeastMissed = 0.02F;  // less is not missed
constexpr double kMuch = 0.01;         // of the pixels within

enum Pixel : std::uint8_t { Nothing, Faint, Within };

class PixelKinds {
  public:
    PixelKinds(const Image& picture, double threshold)
        : m_width(picture.width),
          m_height(picture.height),
          m_kinds(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)) {
        const auto channels = static_cast<std::size_t>(picture.channels);
        std::vector<float> row(static_cast<std::size_t>(m_width) * channels);
        std::size_t at = 0;
        for (int y = 0; y < m_height; ++y) {
            loadRow(picture, y, row.data());
            for (std::size_t i = channels - 1; i < row.size(); i += channels)
                m_kinds[at++] = row[i] >= static_cast<float>(threshold) ? Within
                                : row[i] > kLeastMissed                 ? Faint
                                                                        : Nothing;
        }
    }
    std::size_t count(Pixel kind) const {
        return static_cast<std::size_t>(std::ranges::count(m_kinds, kind));
    }
    /// Counts faint pixels farther than `reach` pixels from the outline.
    std::size_t countFar(int reach) const {
        std::size_t count = 0;
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) count += at(x, y) == Faint && isFar(x, y, reach);
        return count;
    }

  private:
    Pixel at(int x, int y) const {
        return static_cast<Pixel>(m_kinds[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                          static_cast<std::size_t>(x)]);
    }
    bool isFar(int x, int y, int reach) const {
        for (int v = std::max(0, y - reach); v <= std::min(m_height - 1, y + reach); ++v)
            for (int u = std::max(0, x - reach); u <= std::min(m_width - 1, x + reach); ++u)
                if (at(u, v) == Within) return false;
        return true;
    }

    int m_width, m_height;
    std::vector<std::uint8_t> m_kinds;
};

}  // namespace

bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    const PixelKinds pixels(picture, outline.threshold);
    const double much = kMuch * static_cast<double>(pixels.count(Within));
    if (static_cast<double>(pixels.count(Faint)) <= much) return false;
    return static_cast<double>(pixels.countFar(static_cast<int>(std::ceil(outline.margin)))) > much;
}

SoftEdgeOffer::SoftEdgeOffer(Document& document, InfoBanner& banner, QObject* parent)
    : QObject(parent), m_document(document), m_banner(banner) {
    connect(&m_document, &Document::opened, this, &SoftEdgeOffer::look);
    connect(&m_document, &Document::projectChanged, this, &SoftEdgeOffer::follow);
}

bool SoftEdgeOffer::isDue() const {
    if (m_document.isEmpty() || !m_document.picture()) return false;
    const Domain& domain = m_document.domain();
    return domain.kind == DomainKind::Image && domain.outline == OutlineKind::Alpha &&
           domain.alpha.threshold > kFaint;
}

/// Saved projects are not asked again. The check runs in the background for large pictures.
void SoftEdgeOffer::look() {
    m_isOffered = false;
    if (!isDue() || !m_document.path().isEmpty() || !m_document.design<2>().handles.empty()) return;
    const auto picture = m_document.picture();
    inBackground(
        this, [picture, outline = m_document.domain().alpha] { return cutsSoftEdges(*picture, outline); },
        [this, picture](bool cuts) {
            if (cuts && m_document.picture() == picture && isDue()) offer();
        });
}

void SoftEdgeOffer::offer() {
    m_isOffered = true;
    const auto take = [this] { changeSetting(m_document, "domain.outline.threshold", kFaint); };
    m_banner.tell(InfoBanner::Topic::SoftEdges,
                  tr("Soft edges or shadows of this picture reach beyond the cut-out, and are cut off."),
                  {{tr("Include Them"), take}});
}

void SoftEdgeOffer::follow() {
    if (!m_isOffered || isDue()) return;
    m_isOffered = false;
    m_banner.clear(InfoBanner::Topic::SoftEdges);
}

}  // namespace wend
