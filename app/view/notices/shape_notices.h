#pragma once

#include <QObject>
#include <memory>

#include "app/session/shape_session.h"
#include "app/view/notices/info_banner.h"

namespace wend {

/// What the user should hear of a shape that was made: once for every mesh, whatever its dimension.
class ShapeNotices : public QObject {
    Q_OBJECT

  public:
    ShapeNotices(ShapeSession& session, QObject* parent);

  signals:
    /// Line by line, with what mends it; empty where there is nothing to say any more.
    void told(const QString& text, const QList<wend::InfoBanner::Remedy>& remedies);
    /// Why a cage was taken is to be seen.
    void reasonWanted();

  private:
    void follow();
    template <int Dim>
    void tell();
    template <int Dim>
    QString hangingText() const;
    template <int Dim>
    void pinHanging();

    ShapeSession& m_session;
    std::shared_ptr<const void> m_shape;  // the rest mesh that was told of
    bool m_hasTold = false;               // and there was something to say
};

}  // namespace wend
