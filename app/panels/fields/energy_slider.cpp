#include "app/panels/fields/energy_slider.h"

#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/picture_tip.h"
#include "app/style/colours.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kStepsPerStop = 1000;
constexpr int kSnap = 45;
constexpr int kKnob = 16;
constexpr int kLabelGap = 3, kBelow = 5;
constexpr QSize kSwatchSize(26, 8);  // pixels
constexpr int kColours = 8;          // pixels: how high the band of them is
constexpr int kTileHeight = 76, kTileGap = 4;
constexpr int kTileText = 54, kTileFont = 12;  // pixels: of the narrowest tile, and as in window.qss
constexpr QSize kTilePicture(46, 48);
constexpr int kRest = 250;  // milliseconds of the pointer on a tile
constexpr double kFaint = 0.4;
constexpr const char* kMime = "application/x-wend-energy";
constexpr std::array<const char*, EnergyScale::kStops> kPictures = {"area", "length", "rigid", "angle"};

int nearestStop(int value) {
    return static_cast<int>(std::lround(static_cast<double>(value) / kStepsPerStop));
}

int snapped(int value) {
    const int stop = nearestStop(value) * kStepsPerStop;
    return std::abs(value - stop) <= kSnap ? stop : value;
}

/// Returns whether a tile's text does not fit when it is bold; window.qss makes it smaller then.
bool isLong(const QString& text) {
    QFont bold = QApplication::font();
    bold.setPixelSize(kTileFont);
    bold.setWeight(QFont::DemiBold);
    return QFontMetrics(bold).horizontalAdvance(text) > kTileText;
}

}  // namespace

EnergySlider::EnergySlider(QWidget* parent, Stops stops)
    : QWidget(parent),
      m_stops(stops),
      m_name(tr("Keep")),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_phi(0) {
    m_slider->setObjectName(QStringLiteral("energySlider"));
    m_slider->setProperty("bare", stops == Stops::Words);  // the colours are its groove
    m_slider->setRange(0, (EnergyScale::kStops - 1) * kStepsPerStop);
    m_slider->setSingleStep(50);
    m_slider->setPageStep(kStepsPerStop);
    describe(m_slider, m_name, helpText());
    showInTip(m_slider, [this] { return energyPictures(m_dimension); });
    setFocusProxy(m_slider);
    for (int i = 0; i < EnergyScale::kStops; ++i) makeStop(i);
    showPictures();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] { emit hovered(m_scale.stops().at(m_under).phi); });
    connect(m_slider, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_slider, &QSlider::valueChanged, this, &EnergySlider::choose);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setPhi(m_scale.stops()[1].phi);
}

void EnergySlider::makeStop(int stop) {
    const EnergyStop& own = m_scale.stops()[stop];
    auto* label = buttonFor<QToolButton>(
        this, "", own.name, own.shortHelp,
        [this, stop] {
            ++m_gesture;
            m_slider->setValue(stop * kStepsPerStop);
            setPhi(m_phi);
        },
        own.name);
    label->setCheckable(true);
    label->setFocusPolicy(Qt::TabFocus);
    label->setProperty("role", m_stops == Stops::Tiles ? QStringLiteral("tile") : QStringLiteral("stop"));
    label->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    label->setIconSize(m_stops == Stops::Tiles ? kTilePicture : kSwatchSize);
    if (m_stops == Stops::Words) label->setIcon(swatch(stop));
    if (m_stops == Stops::Tiles) {
        label->installEventFilter(this);
        label->setProperty("long", isLong(label->text()));
    }
    showInTip(label, [stop] { return QList<TipPicture>{energyPicture(stop)}; });
    m_labels[stop] = label;
    if (m_stops == Stops::Tiles)  // read once
        m_samples[stop] = QIcon(QStringLiteral(":/wend/keep/%1.png").arg(QLatin1String(kPictures[stop])));
}

/// Returns an icon in the colour that a stop is painted with.
QIcon EnergySlider::swatch(int stop) const {
    QPixmap pixmap(2 * kSwatchSize);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(energyColour(stop)));
    painter.drawRoundedRect(QRect(QPoint(), kSwatchSize), 3, 3);
    return pixmap;
}

void EnergySlider::setName(const QString& name) {
    m_name = name;
    describe(m_slider, m_name, helpText());
}

QSize EnergySlider::pictureSize() {
    return kTilePicture;
}

void EnergySlider::setPictures(const std::vector<QPixmap>& pictures) {
    const bool same = pictures.empty() && m_pictures.empty() && !m_stale;
    m_pictures = pictures;
    m_stale = false;
    if (!same) showPictures();
}

void EnergySlider::setPicturesStale(bool stale) {
    if (std::exchange(m_stale, stale) != stale) showPictures();
}

void EnergySlider::showPictures() {
    if (m_stops != Stops::Tiles) return;
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        const QIcon& sample = m_samples[i];
        if (m_pictures.empty())
            m_labels[i]->setIcon(sample);
        else
            m_labels[i]->setIcon(QIcon(drawn(m_pictures[i])));
    }
}

/// Returns the picture, faint if it is out of date.
QPixmap EnergySlider::drawn(const QPixmap& picture) const {
    if (!m_stale) return picture;
    QPixmap result(picture.size());
    result.setDevicePixelRatio(picture.devicePixelRatio());
    result.fill(Qt::transparent);
    QPainter painter(&result);
    painter.setOpacity(kFaint);
    painter.drawPixmap(QPointF(), picture);
    return result;
}

std::optional<double> EnergySlider::phiIn(const QMimeData* data) {
    if (!data->hasFormat(QLatin1String(kMime))) return {};
    return data->data(QLatin1String(kMime)).toDouble();
}

void EnergySlider::dragTile(int stop) {
    m_labels[stop]->setDown(false);
    auto* carried = new QMimeData;
    carried->setData(QLatin1String(kMime), QByteArray::number(m_scale.stops()[stop].phi, 'g', 17));
    QDrag drag(this);
    drag.setMimeData(carried);
    drag.setPixmap(m_labels[stop]->icon().pixmap(kTilePicture));
    drag.exec(Qt::CopyAction);
}

/// Handles hovering and dragging of tiles.
bool EnergySlider::eventFilter(QObject* watched, QEvent* event) {
    const auto it = std::find(m_labels.begin(), m_labels.end(), watched);
    if (it == m_labels.end()) return QWidget::eventFilter(watched, event);
    const int stop = static_cast<int>(it - m_labels.begin());
    if (event->type() == QEvent::Enter && isEnabled()) {
        m_under = stop;
        m_rest.start();
    } else if (event->type() == QEvent::Leave) {
        m_rest.stop();
        if (std::exchange(m_under, -1) >= 0) emit hovered(std::numeric_limits<double>::quiet_NaN());
    } else if (event->type() == QEvent::MouseButtonPress) {
        m_pressed = static_cast<QMouseEvent*>(event)->pos();
    } else if (event->type() == QEvent::MouseMove) {
        const auto& move = static_cast<QMouseEvent&>(*event);
        const int way = (move.pos() - m_pressed).manhattanLength();
        if (move.buttons() == Qt::LeftButton && way >= QApplication::startDragDistance()) {
            m_rest.stop();
            emit hovered(std::numeric_limits<double>::quiet_NaN());
            dragTile(stop);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void EnergySlider::setDimension(int dimension) {
    if (dimension == m_dimension) return;
    m_dimension = dimension;
    m_scale = EnergyScale(dimension);
    for (int i = 0; i < EnergyScale::kStops; ++i) {
        m_labels[i]->setText(m_scale.stops()[i].name);
        describe(m_labels[i], m_scale.stops()[i].name, m_scale.stops()[i].shortHelp);
    }
    describe(m_slider, m_name, helpText());
    m_stops == Stops::Tiles ? placeTiles() : placeLabels();
    setPhi(m_phi);
}

QString EnergySlider::helpText() const {
    if (m_dimension == 3)
        return tr(
            "What the shape keeps where it has to give way: from its volume, through lengths and rigid "
            "parts, to the look of its details. Between two names it is a mixture of both.");
    return tr(
        "What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to "
        "the look of its details. Between two names it is a mixture of both.");
}

void EnergySlider::choose(int value) {
    const int at = snapped(value);
    if (at != value && m_slider->isSliderDown()) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(at);
    }
    const double chosen =
        m_scale.phiAt(static_cast<double>(m_slider->isSliderDown() ? at : value) / kStepsPerStop);
    if (chosen == m_phi) return;
    setPhi(chosen);
    emit phiChosen(chosen, m_gesture);
}

void EnergySlider::setPhi(double phi) {
    m_phi = phi;
    const QSignalBlocker quiet(m_slider);
    if (!m_slider->isSliderDown())
        m_slider->setValue(static_cast<int>(std::lround(m_scale.positionOf(phi) * kStepsPerStop)));
    for (int i = 0; i < EnergyScale::kStops; ++i) m_labels[i]->setChecked(m_scale.stopAt(phi) == i);
    update();
}

int EnergySlider::tileWidth() const {
    return (width() - (EnergyScale::kStops - 1) * kTileGap) / EnergyScale::kStops;
}

/// Returns the middle of a stop, or of its tile in a row of tiles.
int EnergySlider::stopX(int stop) const {
    if (m_stops == Stops::Tiles) return stop * (tileWidth() + kTileGap) + tileWidth() / 2;
    const double span = width() - kKnob;
    return static_cast<int>(std::lround(kKnob / 2.0 + span * stop / (EnergyScale::kStops - 1)));
}

/// Aligns the slider with the centres of the first and the last tile.
void EnergySlider::placeTiles() {
    for (int i = 0; i < EnergyScale::kStops; ++i)
        m_labels[i]->setGeometry(i * (tileWidth() + kTileGap), 0, tileWidth(), kTileHeight);
    const int from = stopX(0) - kKnob / 2, to = stopX(EnergyScale::kStops - 1) + kKnob / 2;
    m_slider->setGeometry(from, kTileHeight + kTileGap, to - from, kKnob + 4);
}

/// Places labels below their stops without overlap: long names move the following labels right, and the last
/// ones back left.
void EnergySlider::placeLabels() {
    m_slider->setGeometry(0, 0, width(), kKnob + 4);
    int from = 0;
    for (int i = 0; i < EnergyScale::kStops; ++i) {
        const QSize size = m_labels[i]->sizeHint();
        m_labels[i]->setGeometry(std::max(stopX(i) - size.width() / 2, from), kKnob + kBelow, size.width(),
                                 size.height());
        from = m_labels[i]->geometry().right() + 1 + kLabelGap;
    }
    int to = width();
    for (int i = EnergyScale::kStops - 1; i >= 0; --i) {
        const int x = std::max(0, std::min(m_labels[i]->x(), to - m_labels[i]->width()));
        m_labels[i]->move(x, m_labels[i]->y());
        to = x - kLabelGap;
    }
}

QSize EnergySlider::sizeHint() const {
    m_labels[0]->ensurePolished();
    if (m_stops == Stops::Tiles) return {220, kTileHeight + kTileGap + kKnob + 4};
    return {220, kKnob + kBelow + m_labels[0]->sizeHint().height()};
}

void EnergySlider::resizeEvent(QResizeEvent*) {
    m_stops == Stops::Tiles ? placeTiles() : placeLabels();
}

/// Draws the colours below the slider, in place of its groove.
void EnergySlider::paintColours(QPainter& painter) const {
    QLinearGradient colours(stopX(0), 0, stopX(EnergyScale::kStops - 1), 0);
    for (int i = 0; i < EnergyScale::kStops; ++i)
        colours.setColorAt(i / (EnergyScale::kStops - 1.0), QColor(energyColour(i)));
    if (!isEnabled()) painter.setOpacity(kFaint);
    painter.setBrush(colours);
    const double top = m_slider->geometry().center().y() + 0.5 - kColours / 2.0;
    painter.drawRoundedRect(QRectF(stopX(0) - kKnob / 2.0, top, width(), kColours), kColours / 2.0,
                            kColours / 2.0);
}

void EnergySlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    if (m_stops == Stops::Words) return paintColours(painter);
    painter.setBrush(palette().color(QPalette::Mid));
    for (int i = 0; i < EnergyScale::kStops; ++i)
        painter.drawRoundedRect(QRectF(stopX(i) - 1, m_slider->y() + kKnob / 2.0 - 5, 2, 14), 1, 1);
}

}  // namespace wend
