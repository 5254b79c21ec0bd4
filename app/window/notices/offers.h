#pragma once

#include <QObject>
#include <functional>
#include <set>
#include <vector>

#include "app/window/notices/info_banner.h"
#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;

/// Offers to hold the border of a photograph, to include soft edges, to fill the holes of line art, to draw
/// an SVG drawing in another size, or to open layers as one picture when a file was opened. An offer is shown
/// until it is accepted, declined or irrelevant. Nothing is offered for saved projects.
class Offers : public QObject {
    Q_OBJECT

  public:
    Offers(Document& document, InfoBanner& banner, QObject* parent);

  signals:
    /// The size of the drawing is to be asked for.
    void sizeWanted();

  private:
    struct Words {
        QString text;
        QList<InfoBanner::Remedy> remedies;
    };
    struct Offer {
        InfoBanner::Topic topic;
        /// Whether it matters for the document as it is.
        std::function<bool()> matters;
        /// Whether the picture calls for it; asked in the background. None: whenever it matters.
        std::function<bool(const Image&, const AlphaOutlineOptions&)> isCalledFor;
        std::function<Words()> words;
    };

    Offer border();
    Offer softEdges();
    Offer lineArt();
    Offer parts();
    Offer drawing();
    InfoBanner::Remedy sizeButton();
    void look();
    void follow();
    void make(const Offer& offer);
    /// Whether the outline of the document's picture is made of its alpha.
    bool isCutOut() const;

    Document& m_document;
    InfoBanner& m_banner;
    const std::vector<Offer> m_all;
    bool m_isDrawing = false;            // what was opened
    std::set<InfoBanner::Topic> m_made;  // and neither taken nor withdrawn
};

}  // namespace wend
