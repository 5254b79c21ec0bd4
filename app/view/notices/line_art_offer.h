#pragma once

#include <QObject>

#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;
class InfoBanner;

/// Returns whether most of what the outline encloses is empty: thin strokes around areas without fill.
bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline);

/// Offers to fill the holes of a cut-out of ink without fill, of which only the strokes would bend, as wires
/// do, until that is done, declined or no longer matters.
class LineArtOffer : public QObject {
    Q_OBJECT

  public:
    LineArtOffer(Document& document, InfoBanner& banner, QObject* parent);

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
