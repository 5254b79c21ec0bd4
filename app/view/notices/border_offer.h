#pragma once

#include <QObject>

namespace wend {

class Document;
class InfoBanner;

/// A photograph has no transparency around what it shows, and a bent one leaves gaps beside it: where such a
/// picture is opened, this offers to hold its border, until that is done, declined, or does not matter any
/// more.
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
