#pragma once

#include <QTimer>

#include "app/base/in_background.h"
#include "app/engine/shape/pose_faults.h"
#include "app/session/shape_session.h"

namespace wend {

/// Checks the shown pose for faults in a background thread, once it is at rest.
class PoseWatch : public QObject {
    Q_OBJECT

  public:
    explicit PoseWatch(ShapeSession& session, QObject* parent = nullptr);

    /// Returns null while the result is unknown, or if the dimension differs.
    template <int Dim>
    std::shared_ptr<const PoseFaults<Dim>> faults() const {
        if constexpr (Dim == 2)
            return m_flat;
        else
            return m_solid;
    }

  signals:
    void changed();

  private:
    void takeFrame();
    void look();
    template <int Dim>
    void lookAt(const PosedPtr<Dim>& frame);

    ShapeSession& m_session;
    QTimer m_due;
    BackgroundWork m_work;
    FramePtr m_seen;  // that the faults are of
    std::shared_ptr<const PoseFaults<2>> m_flat;
    std::shared_ptr<const PoseFaults<3>> m_solid;
};

}  // namespace wend
