#include "app/panels/layer_items.h"

#include <QPainter>

#include "app/panels/theme.h"
#include "app/session/accent.h"
#include "app/session/energy_stops.h"

namespace wend {

namespace {

constexpr int kSwatch = 12;

}  // namespace

template <int Dim>
QIcon layerSwatch(const MaterialPaint<Dim>& paint) {
    QPixmap pixmap(kSwatch, kSwatch);
    pixmap.fill(paint.phi ? energyColour(stopOfPhi(*paint.phi, Dim)) : kStiffColour);
    return pixmap;
}

template QIcon layerSwatch<2>(const MaterialPaint<2>&);
template QIcon layerSwatch<3>(const MaterialPaint<3>&);

QIcon graySwatch() {
    QPixmap pixmap(kSwatch, kSwatch);
    QLinearGradient gradient(0, 0, kSwatch, 0);
    gradient.setColorAt(0, Qt::black);
    gradient.setColorAt(1, Qt::white);
    QPainter(&pixmap).fillRect(pixmap.rect(), gradient);
    return pixmap;
}

void EyeDelegate::drawCheck(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                            Qt::CheckState state) const {
    const bool seen = state == Qt::Checked;
    const QIcon icon = wendIcon(seen ? QStringLiteral("show") : QStringLiteral("hide"), option.palette);
    icon.paint(painter, rect, Qt::AlignCenter, seen ? QIcon::Normal : QIcon::Disabled);
}

}  // namespace wend
