#pragma once

#include <QPainter>
#include <QPixmap>
#include <optional>

#include "app/style/theme.h"
#include "app/views/canvas/view_transform.h"

namespace wend {

/// Fills with checks, starting at the corner of the paper.
void fillWithChecks(QPainter& painter, const QRectF& paper, const Theme& theme);

/// The background of a shape: the workspace and, for a picture, its paper.
class Ground {
  public:
    struct Look {
        ViewTransform view;
        QSize size;  // of the widget
        double ratio = 1;
        std::optional<QRectF> paper;  // in the picture's pixels
        QColor colour;                // of the paper; none: checks
        bool dark = false;
        QColor checks = {};  // the first of their colours
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
