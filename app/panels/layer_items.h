#pragma once

#include <QIcon>
#include <QItemDelegate>

#include "app/document/edits/material_edits.h"

namespace wend {

/// A square in the colour of what a layer keeps; of stiffness for one that is only stiff.
template <int Dim>
QIcon layerSwatch(const MaterialPaint<Dim>& paint);
/// From black to white: its values come from a picture, or differ from cell to cell.
QIcon graySwatch();

/// Draws an eye, open or closed, in the place of the box that is ticked.
class EyeDelegate : public QItemDelegate {
    Q_OBJECT

  public:
    using QItemDelegate::QItemDelegate;

  protected:
    void drawCheck(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                   Qt::CheckState state) const override;
};

}  // namespace wend
