#include "app/panels/layer_items.h"

#include <QListWidget>
#include <QPainter>

#include "app/style/colours.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kLayerSwatch = 12;
constexpr int kLayerId = Qt::UserRole + 1;

/// Adds a white rim for selected rows.
QIcon rimmed(const QPixmap& swatch) {
    QIcon icon(swatch);
    QPixmap selected = swatch;
    QPainter painter(&selected);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawRect(selected.rect().adjusted(1, 1, -1, -1));
    painter.end();
    icon.addPixmap(selected, QIcon::Selected);
    return icon;
}

}  // namespace

QIcon layerSwatch(const MaterialPaint& paint, int dimension) {
    QPixmap pixmap(kLayerSwatch, kLayerSwatch);
    pixmap.fill(paint.phi ? energyColour(stopOfPhi(*paint.phi, dimension)) : kStiffColour);
    return rimmed(pixmap);
}

QIcon graySwatch() {
    QPixmap pixmap(kLayerSwatch, kLayerSwatch);
    QLinearGradient gradient(0, 0, kLayerSwatch, 0);
    gradient.setColorAt(0, Qt::black);
    gradient.setColorAt(1, Qt::white);
    QPainter(&pixmap).fillRect(pixmap.rect(), gradient);
    return rimmed(pixmap);
}

void setLayerOf(QListWidgetItem& item, Id layer) {
    item.setData(kLayerId, static_cast<qulonglong>(layer));
}

Id layerOf(const QListWidgetItem* item) {
    return item ? Id{item->data(kLayerId).toULongLong()} : Id::None;
}

void EyeDelegate::drawCheck(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                            Qt::CheckState state) const {
    const bool seen = state == Qt::Checked;
    const bool selected = option.state & QStyle::State_Selected;
    const QIcon icon = wendIcon(seen ? QStringLiteral("show") : QStringLiteral("hide"),
                                selected ? primaryPalette(option.palette) : option.palette);
    icon.paint(painter, rect, Qt::AlignCenter, seen ? QIcon::Normal : QIcon::Disabled);
}

}  // namespace wend
