#include "app/panels/list_items.h"

#include <QApplication>
#include <QListWidget>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QScrollBar>
#include <algorithm>

#include "app/style/colours.h"
#include "app/style/theme.h"
#include "warp/convert.h"

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

KeptScroll::KeptScroll(QAbstractItemView& list)
    : m_list(list), m_scrolled(list.verticalScrollBar()->value()) {}

/// Lays the new rows out first, because the range of the scroll bar follows them.
KeptScroll::~KeptScroll() {
    m_list.doItemsLayout();
    m_list.verticalScrollBar()->setValue(m_scrolled);
    if (m_list.currentIndex().isValid()) m_list.scrollTo(m_list.currentIndex());
}

void EyeDelegate::drawCheck(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                            Qt::CheckState state) const {
    const bool seen = state == Qt::Checked;
    const bool selected = option.state & QStyle::State_Selected;
    const QIcon icon = wendIcon(seen ? QStringLiteral("show") : QStringLiteral("hide"),
                                selected ? primaryPalette(option.palette) : option.palette);
    icon.paint(painter, rect, Qt::AlignCenter, seen ? QIcon::Normal : QIcon::Disabled);
}

namespace {

constexpr int kIconSamples = 224;  // along the longer side of a picture, before its empty border is cut off
constexpr int kIconScale = 2;      // pixels of the icon per pixel of the screen

QString partWords(const char* text) {
    return QCoreApplication::translate("wend::PartList", text);
}

/// Returns some pixels of the picture, evenly spaced.
QImage sampledPicture(const Image& picture) {
    const double step = std::max(1.0, std::max(picture.width, picture.height) / double(kIconSamples));
    const int width = std::max(1, static_cast<int>(picture.width / step)),
              height = std::max(1, static_cast<int>(picture.height / step));
    QImage image(width, height, QImage::Format_RGBA8888);
    std::vector<float> row(static_cast<std::size_t>(picture.width) *
                           static_cast<std::size_t>(picture.channels));
    const int colours = picture.colours();
    for (int y = 0; y < height; ++y) {
        loadRow(picture, static_cast<int>((y + 0.5) * step), row.data());
        for (int x = 0; x < width; ++x) {
            const float* pixel = row.data() + static_cast<int>((x + 0.5) * step) * picture.channels;
            const float alpha = picture.alpha ? pixel[colours] : 1;
            const auto number = [&](int c) {
                const float value = pixel[colours >= 3 ? c : 0];
                const float colour =
                    picture.alpha && !picture.unassociated && alpha > 0 ? value / alpha : value;
                return std::clamp(static_cast<int>(255 * colour + 0.5F), 0, 255);
            };
            image.setPixelColor(x, y,
                                QColor(number(0), number(1), number(2),
                                       std::clamp(static_cast<int>(255 * alpha + 0.5F), 0, 255)));
        }
    }
    return image;
}

/// Returns the box of what is not transparent.
QRect opaqueBox(const QImage& image) {
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) > 0) box |= QRect(x, y, 1, 1);
    return box;
}

constexpr int kSign = 16, kSignRoom = 24;  // pixels of the screen

QRect signRoom(const QRect& row) {
    return {row.right() + 1 - kSignRoom, row.top(), kSignRoom, row.height()};
}

}  // namespace

QString describedPart(const PicturePart& part) {
    QStringList all;
    if (part.hidden) all << partWords(QT_TRANSLATE_NOOP("wend::PartList", "hidden"));
    if (part.locked) all << partWords(QT_TRANSLATE_NOOP("wend::PartList", "locked"));
    if (!part.ridesOn.empty())
        all << partWords(QT_TRANSLATE_NOOP("wend::PartList", "rides on %1"))
                   .arg(QString::fromStdString(part.ridesOn));
    for (const Joint& joint : part.joints)
        all << partWords(QT_TRANSLATE_NOOP("wend::PartList", "joined to %1"))
                   .arg(QString::fromStdString(joint.to));
    return all.join(QStringLiteral(", "));
}

QIcon partIcon(const PicturePart& part, const Image* picture, const QPalette& palette) {
    if (!picture) return {};
    QImage seen = sampledPicture(*picture);
    const QRect box = opaqueBox(seen);
    if (!box.isEmpty()) seen = seen.copy(box);
    constexpr int kSide = kIconScale * kPartIcon, kMark = kSide / 2, kSquare = kSide / 8;
    seen = seen.scaled(kSide, kSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    const Theme theme = Theme::of(palette).behind(lightnessOf(seen));
    QPixmap drawn(kSide, kSide);
    drawn.fill(theme.checkerA);
    QPainter painter(&drawn);
    for (int y = 0; y < kSide; y += kSquare)
        for (int x = y % (2 * kSquare); x < kSide; x += 2 * kSquare)
            painter.fillRect(x, y, kSquare, kSquare, theme.checkerB);
    painter.drawImage((kSide - seen.width()) / 2, (kSide - seen.height()) / 2, seen);
    if (!part.joints.empty()) {
        const QRect at(0, kSide - kMark, kMark, kMark);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette.base());
        painter.drawEllipse(at);
        wendIcon(QStringLiteral("link"), palette).paint(&painter, at.adjusted(3, 3, -3, -3));
    }
    painter.end();
    drawn.setDevicePixelRatio(kIconScale);
    QIcon icon(drawn);
    icon.addPixmap(drawn, QIcon::Selected);
    return icon;
}

void PartRow::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem bare = option;
    const QWidget* widget = option.widget;
    widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &bare, painter, widget);
    bare.rect.setRight(signRoom(option.rect).left() - 1);
    EyeDelegate::paint(painter, bare, index);
    const bool isLocked = index.data(kLockedRole).toBool(), isChosen = option.state & QStyle::State_Selected;
    QRect sign(0, 0, kSign, kSign);
    sign.moveCenter(signRoom(option.rect).center());
    const QPalette palette = isChosen ? primaryPalette(option.palette) : option.palette;
    wendIcon(isLocked ? QStringLiteral("lock") : QStringLiteral("unlock"), palette)
        .paint(painter, sign, Qt::AlignCenter, isLocked ? QIcon::Normal : QIcon::Disabled);
}

/// Leaves a gap between the pictures of neighbouring rows.
QSize PartRow::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    constexpr int kGap = 4;  // pixels of the screen
    return EyeDelegate::sizeHint(option, index) + QSize(0, kGap);
}

bool PartRow::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                          const QModelIndex& index) {
    const bool presses = event->type() == QEvent::MouseButtonPress,
               clicks = presses || event->type() == QEvent::MouseButtonDblClick;
    if (clicks || event->type() == QEvent::MouseButtonRelease) {
        const auto& mouse = static_cast<const QMouseEvent&>(*event);
        if (mouse.button() == Qt::LeftButton && signRoom(option.rect).contains(mouse.position().toPoint())) {
            if (clicks) emit lockClicked(index.row());
            return true;
        }
    }
    QStyleOptionViewItem bare = option;
    bare.rect.setRight(signRoom(option.rect).left() - 1);
    return EyeDelegate::editorEvent(event, model, bare, index);
}

}  // namespace wend
