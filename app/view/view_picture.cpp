#include "app/view/view_picture.h"

#include <QFileInfo>
#include <QPainter>
#include <cstring>

#include "app/view/volume/solid_canvas.h"
#include "core/mesh/error.h"
#include "warp/image.h"

namespace wend {

namespace {

/// What lies over the view, as large against the solid as in the window: there the height decides.
void paintMarks(QImage& image, SolidCanvas& canvas, const PictureChoice& choice) {
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const double scale = choice.size.height() / static_cast<double>(canvas.height());
    painter.scale(scale, scale);
    if (choice.legend) canvas.paintLegend(painter);
    painter.translate((choice.size.width() / scale - canvas.width()) / 2, 0);
    if (choice.marks) canvas.paintMarks(painter);
}

Image imageOf(const QImage& picture) {
    const QImage straight = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image;
    image.width = straight.width();
    image.height = straight.height();
    image.channels = 4;
    image.alpha = image.unassociated = true;
    image.makePixels();
    for (int y = 0; y < image.height; ++y)
        std::memcpy(image.row(y), straight.constScanLine(y), image.rowBytes());
    return image;
}

}  // namespace

QImage viewPicture(SolidCanvas& canvas, const PictureChoice& choice) {
    QImage image = canvas.picture(choice.size, choice.transparent);
    if (!image.isNull() && (choice.marks || choice.legend)) paintMarks(image, canvas, choice);
    return image;
}

void writeViewPicture(const QString& path, SolidCanvas& canvas, PictureChoice choice) {
    const QString kind = QFileInfo(path).suffix().toLower();
    if (kind == QStringLiteral("jpg") || kind == QStringLiteral("jpeg")) choice.transparent = false;
    const QImage picture = viewPicture(canvas, choice);
    if (picture.isNull())
        throw InputError(path.toStdString(),
                         SolidCanvas::tr("the memory does not suffice for a picture of %1 x %2 pixels")
                             .arg(choice.size.width())
                             .arg(choice.size.height())
                             .toStdString());
    writeImage(path.toStdString(), imageOf(picture));
}

}  // namespace wend
