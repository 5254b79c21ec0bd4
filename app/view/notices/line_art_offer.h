#pragma once

#include <QObject>

#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;
class InfoBanner;

/// Returns whether most of what the outline encloses is empty: thin strokes around areas without fill.
bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline);

/// Of ink without fill only the strokes would bend, as wires do: offers to fill the holes of such a cut-out
/// until that is done, declined or does not matter any more.
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
