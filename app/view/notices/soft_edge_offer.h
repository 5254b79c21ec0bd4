#pragma once

#include <QObject>

#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;
class InfoBanner;

/// Whether the outline leaves out much that is faint: a wide soft edge, a glow, a shadow.
bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline);

/// The outline runs along what is nearly opaque, so that limbs come apart; what is fainter and farther away
/// is cut off. Where a picture with much of that is opened, this offers to take it along.
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
