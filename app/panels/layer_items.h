#pragma once

#include <QIcon>
#include <QItemDelegate>

#include "app/project/edits/material_edits.h"

class QListWidgetItem;

namespace wend {

/// Returns a square in the colour of the layer's energy, or of stiffness if it only changes that.
QIcon layerSwatch(const MaterialPaint& paint, int dimension);
/// Returns a square from black to white, for values that come from a picture or differ per cell.
QIcon graySwatch();

/// The layer of an item of a list; Id::None for none, or without an item.
void setLayerOf(QListWidgetItem& item, Id layer);
Id layerOf(const QListWidgetItem* item);

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
