#pragma once

#include <QObject>
#include <memory>

#include "app/session/shape_session.h"
#include "app/window/notices/info_banner.h"

namespace wend {

/// Returns buttons for a project that cannot be computed: where memory is short, a solver that needs less and
/// half as many vertices, as far as the project allows; and Undo if there is a step.
QList<InfoBanner::Remedy> problemRemedies(ShapeSession& session);

/// Messages about a new shape, once per mesh.
class ShapeNotices : public QObject {
    Q_OBJECT

  public:
    ShapeNotices(ShapeSession& session, QObject* parent);

  signals:
    /// Emits lines with their remedies; empty if there is nothing to report any more.
    void told(const QString& text, const QList<wend::InfoBanner::Remedy>& remedies);
    /// Emitted to request the reason for a cage.
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
    std::shared_ptr<const void> m_shape;  // the rest mesh that was reported
    bool m_hasTold = false;               // and there was something to say
};

}  // namespace wend
