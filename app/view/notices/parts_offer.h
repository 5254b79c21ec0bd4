#pragma once

#include <QObject>

namespace wend {

class Document;
class InfoBanner;

/// Says that a file with layers was opened as parts, and offers the picture of all of them in their place,
/// until that is done, declined or irrelevant.
class PartsOffer : public QObject {
    Q_OBJECT

  public:
    PartsOffer(Document& document, InfoBanner& banner, QObject* parent);

  private:
    void offer();
    void follow();
    void flatten();

    Document& m_document;
    InfoBanner& m_banner;
    bool m_isOffered = false;
};

}  // namespace wend
