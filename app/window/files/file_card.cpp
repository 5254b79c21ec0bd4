#include "app/window/files/file_card.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPainter>

#include "app/base/in_background.h"
#include "app/style/theme.h"
#include "app/window/files/thumbnail.h"

namespace wend {

namespace {

constexpr int kPictureHeight = 118, kPadding = 12, kTitleHeight = 20, kLineHeight = 18;

QString titleOf(const QString& path) {
    QString name = QFileInfo(path).completeBaseName().replace('-', ' ').replace('_', ' ');
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

struct Sample {
    const char *name = nullptr, *lesson = nullptr;  // what it demonstrates
};

/// Returns empty strings for an unknown sample.
Sample sampleOf(const QString& path) {
    static const QMap<QString, Sample> samples = {
        {"frog", {QT_TRANSLATE_NOOP("FileCard", "Frog"), QT_TRANSLATE_NOOP("FileCard", "Eyes stay round")}},
        {"giraffe",
         {QT_TRANSLATE_NOOP("FileCard", "Giraffe"), QT_TRANSLATE_NOOP("FileCard", "Pins and paths")}},
        {"octopus",
         {QT_TRANSLATE_NOOP("FileCard", "Octopus"), QT_TRANSLATE_NOOP("FileCard", "Many pins at once")}},
        {"strip",
         {QT_TRANSLATE_NOOP("FileCard", "Strip"), QT_TRANSLATE_NOOP("FileCard", "Choose what to keep")}},
        {"walker",
         {QT_TRANSLATE_NOOP("FileCard", "Walker"), QT_TRANSLATE_NOOP("FileCard", "A walk that loops")}},
        {"eagle",
         {QT_TRANSLATE_NOOP("FileCard", "Eagle"), QT_TRANSLATE_NOOP("FileCard", "Flight, with a skin")}},
        {"bar", {QT_TRANSLATE_NOOP("FileCard", "Bar"), QT_TRANSLATE_NOOP("FileCard", "A stiff middle")}},
    };
    return samples.value(QFileInfo(path).completeBaseName());
}

QString translated(const char* text) {
    return text ? QCoreApplication::translate("FileCard", text) : QString();
}

}  // namespace

FileCard::FileCard(const QString& path, Kind kind, QWidget* parent, const QString& line)
    : QAbstractButton(parent), m_path(path), m_line(line) {
    const bool sample = kind == Kind::Sample;
    const Sample known = sample ? sampleOf(path) : Sample();
    if (line.isEmpty())
        m_line = sample ? translated(known.lesson) : QDir::toNativeSeparators(QFileInfo(path).absolutePath());
    setText(!sample ? QFileInfo(path).fileName() : known.name ? translated(known.name) : titleOf(path));
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(sizeHint());
    setAccessibleDescription(m_line);
    switch (kind) {
        case Kind::Sample:
            setAccessibleName(tr("Sample: %1").arg(text()));
            setToolTip(tr("Open the sample “%1”").arg(text()));
            break;
        case Kind::Recent:
            setAccessibleName(tr("Open %1").arg(text()));
            setToolTip(QDir::toNativeSeparators(path));
            break;
        case Kind::Lost:
            setAccessibleName(tr("Recover %1").arg(text()));
            setToolTip(tr("Open the unsaved changes to “%1”").arg(text()));
            break;
    }
    setStatusTip(toolTip());
    setAttribute(Qt::WA_Hover);
}

void FileCard::load() {
    m_isAsked = true;
    const auto look = [path = m_path] { return thumbnailOf(path); };
    inBackground(this, look, [this](const Thumbnail& shown) {
        m_picture = shown.picture;
        m_isSolid = shown.isSolid;
        if (m_isSolid) setAccessibleName(tr("%1, solid").arg(accessibleName()));
        update();
    });
}

void FileCard::paintPicture(QPainter& painter) const {
    const QRectF space(kPadding, kPadding, width() - 2 * kPadding, kPictureHeight - 2 * kPadding + 4);
    if (m_picture.isNull()) {
        const QRectF icon(space.center() - QPointF(20, 20), QSizeF(40, 40));
        wendIcon(QStringLiteral("picture"), palette())
            .paint(&painter, icon.toRect(), Qt::AlignCenter, QIcon::Disabled);
        return;
    }
    const QSizeF size = QSizeF(m_picture.size()).scaled(space.size(), Qt::KeepAspectRatio);
    painter.drawImage(QRectF(space.center() - QPointF(size.width(), size.height()) / 2, size), m_picture);
}

/// Draws the badge at the top right.
void FileCard::paintBadge(QPainter& painter) const {
    const QString text = tr("Solid");
    const int wide = painter.fontMetrics().horizontalAdvance(text) + 14;
    const QRectF badge(width() - wide - 8, 8, wide, 20);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::of(palette()).accent);
    painter.drawRoundedRect(badge, 10, 10);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(badge, Qt::AlignCenter, text);
}

void FileCard::paintEvent(QPaintEvent*) {
    if (!m_isAsked) load();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const Theme theme = Theme::of(palette());
    const bool lively = underMouse() || hasFocus();
    painter.setPen(QPen(lively ? theme.accentText : theme.line, lively ? 2 : 1));
    painter.setBrush(palette().color(QPalette::Button));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
    paintPicture(painter);
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QFontMetrics bold(font);
    const int room = this->room();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(8, kPictureHeight, room, kTitleHeight), Qt::AlignCenter,
                     bold.elidedText(text(), Qt::ElideMiddle, room));
    font = this->font();
    font.setPixelSize(12);
    painter.setFont(font);
    painter.setPen(theme.secondText);
    painter.drawText(QRectF(8, kPictureHeight + kTitleHeight, room, kLineHeight), Qt::AlignCenter,
                     QFontMetrics(font).elidedText(m_line, Qt::ElideMiddle, room));
    if (m_isSolid) paintBadge(painter);
}

}  // namespace wend
