#pragma once

#include <QObject>

namespace wend {

class Document;
class InfoBanner;

/// Offers to hold the border of an opaque picture, since bending it leaves gaps, until that is done, declined
/// or irrelevant.
class BorderOffer : public QObject {
    Q_OBJECT

  public:
    BorderOffer(Document& document, InfoBanner& banner, QObject* parent);

  private:
    bool isDue() const;
    void offer();
    void follow();

    Document& m_document;
    InfoBanner& m_banner;
    bool m_isOffered = false;
};

}  // namespace wend
