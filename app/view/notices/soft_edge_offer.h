#pragma once

#include <QObject>

#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;
class InfoBanner;

/// Returns whether the outline cuts off a wide soft edge, a glow or a shadow.
bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline);

/// Offers to include faint surroundings that the outline cuts off: it follows nearly opaque pixels, so that
/// limbs stay apart.
class SoftEdgeOffer : public QObject {
    Q_OBJECT

  public:
    SoftEdgeOffer(Document& document, InfoBanner& banner, QObject* parent);

  private:
    bool isDue() const;
    void look();
    void offer();
    void follow();

    Document& m_document;
    InfoBanner& m_banner;
    bool m_isOffered = false;
};

}  // namespace wend
