#pragma once

#include <QPointF>
#include <QTimer>
#include <QVariantAnimation>
#include <vector>

#include "app/session/shape_session.h"

namespace wend {

/// Two small movements of pins in a view: a new one drops onto the shape, and what is dragged trembles once
/// when it can go no further. And when the name of one that is pointed at appears.
class PinAnimation : public QObject {
    Q_OBJECT

  public:
    explicit PinAnimation(ShapeSession& session);

    /// How a pin is drawn now: moved by so many pixels, and so much flatter than it is high.
    struct Look {
        QPointF shift;
        double squash = 0;
    };
    Look of(int handle) const;
    /// The pin under the pointer, −1 for none; its name is seen after a while.
    void hover(int handle);
    int named() const { return m_named; }

  signals:
    void changed();

  private:
    void takeProject();
    void takeFrame();
    void begin(QVariantAnimation& animation, std::vector<int> pins);

    ShapeSession& m_session;
    QVariantAnimation m_drop, m_tremble;  // from 0 to 1
    std::vector<int> m_pins;              // that move
    std::size_t m_count = 0;              // of the document's pins
    bool m_stopped = false;
    QTimer m_nameDue;
    int m_hovered = -1, m_named = -1;
};

}  // namespace wend
