#pragma once

#include <QPainter>
#include <QPixmap>
#include <optional>

#include "app/panels/look/theme.h"
#include "app/view/canvas/view_transform.h"

namespace wend {

/// Under a picture that lets something through, from the corner of its paper on.
void fillWithChecks(QPainter& painter, const QRectF& paper, const Theme& theme);

/// What lies under the shape: the workspace and, of a picture, the paper on it.
class Ground {
  public:
    struct Look {
        ViewTransform view;
        QSize size;  // of the widget
        double ratio = 1;
        std::optional<QRectF> paper;  // in the picture's pixels
        QColor colour;                // of the paper; none: checks
        bool dark = false;
        bool operator==(const Look&) const = default;
    };

    /// `keeps`: painted once for a look, for a shape that moves over it.
    void paint(QPainter& painter, const Look& look, const Theme& theme, bool keeps);

  private:
    static void draw(QPainter& painter, const Look& look, const Theme& theme);

    Look m_look;
    QPixmap m_kept;
};

}  // namespace wend
