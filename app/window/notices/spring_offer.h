#pragma once

#include <QObject>

#include "app/project/pin.h"

namespace wend {

class InfoBanner;
class ShapeSession;

/// Returns whether a handle that has moved ends where it began.
bool comesBack(const Pin& handle);

/// Offers to let the shape spring back fully where it does not spring back at all, and a handle ends where it
/// began or the film loops: the shape would end elsewhere.
class SpringOffer : public QObject {
    Q_OBJECT

  public:
    SpringOffer(ShapeSession& session, InfoBanner& banner, QObject* parent);

  private:
    bool isDue() const;
    void follow();

    ShapeSession& m_session;
    InfoBanner& m_banner;
    bool m_isOffered = false, m_isDeclined = false;
};

}  // namespace wend
