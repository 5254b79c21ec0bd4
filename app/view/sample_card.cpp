#include "app/view/sample_card.h"

#include <QFileInfo>
#include <QPainter>
#include <QtConcurrent>

#include "app/panels/theme.h"
#include "app/session/opening.h"
#include "app/session/picture_file.h"

namespace wend {

namespace {

constexpr int kPictureHeight = 122;
constexpr int kPadding = 14;

/// The part of the picture that is not transparent.
QRect opaquePart(const QImage& image) {
    QRect part;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) > 8) part |= QRect(x, y, 1, 1);
    return part;
}

QImage thumbnail(const QString& project) {
    const QImage image = pictureOfFile(picturePathOf(project).toStdString());
    if (image.isNull()) return {};
    const QImage small = image.scaled(720, 720, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    const QImage part = small.copy(opaquePart(small));
    return part.scaled(QSize(344, 260), Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

QString titleOf(const QString& path) {
    QString name = QFileInfo(path).completeBaseName().replace('-', ' ').replace('_', ' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

}  // namespace

SampleCard::SampleCard(const QString& projectPath, QWidget* parent)
    : QAbstractButton(parent), m_path(projectPath) {
    setText(titleOf(projectPath));
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(sizeHint());
    setAccessibleName(tr("Sample: %1").arg(text()));
    setToolTip(tr("Open the sample “%1”").arg(text()));
    setStatusTip(toolTip());
    load();
}

void SampleCard::load() {
    QtConcurrent::run([path = m_path] { return thumbnail(path); }).then(this, [this](const QImage& image) {
        m_picture = image;
        update();
    });
}

void SampleCard::enterEvent(QEnterEvent*) {
    update();
}
void SampleCard::leaveEvent(QEvent*) {
    update();
}

void SampleCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const Theme theme = Theme::of(palette());
    const bool lively = underMouse() || hasFocus();
    painter.setPen(QPen(lively ? theme.accent : theme.line, lively ? 2 : 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 10, 10);
    if (!m_picture.isNull()) {
        const QRectF space(kPadding, kPadding, width() - 2 * kPadding, kPictureHeight - 2 * kPadding + 6);
        const QSizeF size = QSizeF(m_picture.size()).scaled(space.size(), Qt::KeepAspectRatio);
        painter.drawImage(QRectF(space.center() - QPointF(size.width(), size.height()) / 2, size), m_picture);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(0, kPictureHeight, width(), height() - kPictureHeight - 6), Qt::AlignCenter,
                     text());
}

}  // namespace wend
