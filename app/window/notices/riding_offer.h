#pragma once

#include <QObject>
#include <memory>

#include "app/session/stray_parts.h"

namespace wend {

class InfoBanner;
class ShapeSession;

/// Tells of parts and islands of a picture that no pin holds once the rest has been moved, and offers to let
/// them follow what is beside them. It is shown once for each number of such parts.
class RidingOffer : public QObject {
    Q_OBJECT

  public:
    RidingOffer(ShapeSession& session, InfoBanner& banner, QObject* parent);

  private:
    void look();
    void offer(const std::vector<StrayPart>& strays);

    ShapeSession& m_session;
    InfoBanner& m_banner;
    std::shared_ptr<const Project> m_lookedAt;
    std::size_t m_told = 0;
};

}  // namespace wend
