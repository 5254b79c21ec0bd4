#include "app/panels/fields/picture_tip.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QHelpEvent>
#include <QPainter>
#include <QSvgRenderer>
#include <QToolTip>
#include <QWidget>

#include "app/style/energy_scale.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kPictureHeight = 72;  // pixels of the screen
constexpr double kSharp = 2;        // pixels of the drawing to one of these

constexpr std::array<const char*, EnergyScale::kStops> kEnergies = {"energy-area", "energy-length",
                                                                    "energy-rigid", "energy-angle"};

/// Replaces the three tones of a drawing by the palette's colours for text, secondary text and accents.
QByteArray inColours(QByteArray svg, const QPalette& palette) {
    const Theme theme = Theme::of(palette);
    svg.replace("#000000", palette.color(QPalette::WindowText).name().toLatin1());
    svg.replace("#808080", theme.secondText.name().toLatin1());
    svg.replace("#4a5bd4", theme.accentText.name().toLatin1());
    return svg;
}

/// Returns the drawing as an inline image; empty if there is none.
QString imageText(const QString& name, const QPalette& palette) {
    QFile file(QStringLiteral(":/wend/tips/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QSvgRenderer drawing(inColours(file.readAll(), palette));
    const QSizeF size = QSizeF(drawing.defaultSize()) * kPictureHeight / drawing.defaultSize().height();
    QImage image((kSharp * size).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    drawing.render(&painter);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return QStringLiteral("<img width='%1' height='%2' src='data:image/png;base64,%3'>")
        .arg(size.toSize().width())
        .arg(size.toSize().height())
        .arg(QString::fromLatin1(bytes.toBase64()));
}

/// Shows the pictures with the words that the widget has at the time.
class PictureTip : public QObject {
  public:
    PictureTip(QWidget* widget, std::function<QList<TipPicture>()> pictures)
        : QObject(widget), m_pictures(std::move(pictures)) {
        widget->installEventFilter(this);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ToolTip) return false;
        auto* widget = static_cast<QWidget*>(watched);
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           tipWithPictures(widget->toolTip(), m_pictures(), widget->palette()), widget);
        return true;
    }

  private:
    std::function<QList<TipPicture>()> m_pictures;
};

}  // namespace

void showInTip(QWidget* widget, std::function<QList<TipPicture>()> pictures) {
    new PictureTip(widget, std::move(pictures));
}

QString tipWithPictures(const QString& words, const QList<TipPicture>& pictures, const QPalette& palette) {
    QString cells;
    for (const TipPicture& picture : pictures)
        cells += QStringLiteral("<td align='center'>%1<br>%2</td>")
                     .arg(imageText(picture.name, palette), picture.caption.toHtmlEscaped());
    return words + QStringLiteral("<table cellspacing='8'><tr>%1</tr></table>").arg(cells);
}

TipPicture energyPicture(int stop) {
    return {QLatin1String(kEnergies.at(static_cast<std::size_t>(stop))), {}};
}

QList<TipPicture> energyPictures(int dimension) {
    const EnergyScale scale(dimension);
    QList<TipPicture> pictures;
    for (int stop = 0; stop < EnergyScale::kStops; ++stop)
        pictures << TipPicture{energyPicture(stop).name, scale.stops()[stop].name};
    return pictures;
}

QList<TipPicture> reachPictures() {
    return {{QStringLiteral("reach-near"), QCoreApplication::translate("PictureTip", "near")},
            {QStringLiteral("reach-far"), QCoreApplication::translate("PictureTip", "far")}};
}

QList<TipPicture> stiffnessPictures() {
    return {{QStringLiteral("stiffness-even"), QCoreApplication::translate("PictureTip", "×1 everywhere")},
            {QStringLiteral("stiffness-part"),
             QCoreApplication::translate("PictureTip", "×50 along the left half")}};
}

QList<TipPicture> memoryPictures() {
    return {{QStringLiteral("memory-none"), QCoreApplication::translate("PictureTip", "not at all")},
            {QStringLiteral("memory-full"), QCoreApplication::translate("PictureTip", "fully")}};
}

QList<TipPicture> relaxPictures() {
    return {{QStringLiteral("relax-before"), QCoreApplication::translate("PictureTip", "as it was pulled")},
            {QStringLiteral("relax-after"), QCoreApplication::translate("PictureTip", "relaxed")}};
}

}  // namespace wend
