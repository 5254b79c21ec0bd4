#include "app/panels/theme.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "app/session/accent.h"

namespace wend {

namespace {

QPalette lightPalette() {
    QPalette p;
    p.setColor(QPalette::Window, QColor(0xf5f5f7));
    p.setColor(QPalette::WindowText, QColor(0x1f2126));
    p.setColor(QPalette::Base, QColor(0xffffff));
    p.setColor(QPalette::AlternateBase, QColor(0xf0f0f3));
    p.setColor(QPalette::Text, QColor(0x1f2126));
    p.setColor(QPalette::Button, QColor(0xfbfbfc));
    p.setColor(QPalette::ButtonText, QColor(0x1f2126));
    p.setColor(QPalette::Mid, QColor(0xc9cad1));
    p.setColor(QPalette::Midlight, QColor(0xe3e4e8));
    p.setColor(QPalette::Dark, QColor(0xa4a6af));
    p.setColor(QPalette::Shadow, QColor(0x6b6e78));
    p.setColor(QPalette::Highlight, QColor(kAccent));
    p.setColor(QPalette::HighlightedText, QColor(0xffffff));
    p.setColor(QPalette::Link, QColor(0x3f4fc4));
    p.setColor(QPalette::PlaceholderText, QColor(0x80838d));
    p.setColor(QPalette::ToolTipBase, QColor(0x2a2c33));
    p.setColor(QPalette::ToolTipText, QColor(0xf2f2f5));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor(0xa5a7af));
    return p;
}

QPalette darkPalette() {
    QPalette p;
    p.setColor(QPalette::Window, QColor(0x26272c));
    p.setColor(QPalette::WindowText, QColor(0xe7e8ec));
    p.setColor(QPalette::Base, QColor(0x1c1d21));
    p.setColor(QPalette::AlternateBase, QColor(0x212227));
    p.setColor(QPalette::Text, QColor(0xe7e8ec));
    p.setColor(QPalette::Button, QColor(0x303138));
    p.setColor(QPalette::ButtonText, QColor(0xe7e8ec));
    p.setColor(QPalette::Mid, QColor(0x484a53));
    p.setColor(QPalette::Midlight, QColor(0x3a3b43));
    p.setColor(QPalette::Dark, QColor(0x121316));
    p.setColor(QPalette::Shadow, QColor(0x9b9da8));
    p.setColor(QPalette::Highlight, QColor(0x7482f0));
    p.setColor(QPalette::HighlightedText, QColor(0xffffff));
    p.setColor(QPalette::Link, QColor(0x98a4ff));
    p.setColor(QPalette::PlaceholderText, QColor(0x878a95));
    p.setColor(QPalette::ToolTipBase, QColor(0x3b3d46));
    p.setColor(QPalette::ToolTipText, QColor(0xf2f2f5));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor(0x6a6c76));
    return p;
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightnessF() < palette.color(QPalette::WindowText).lightnessF();
}

QByteArray recoloured(const QByteArray& svg, const QColor& colour) {
    QByteArray result = svg;
    result.replace("#000000", colour.name().toLatin1());  // the icons' only tone
    return result;
}

void addPixmaps(QIcon& icon, const QByteArray& svg, const QColor& colour, QIcon::Mode mode,
                QIcon::State state) {
    QSvgRenderer renderer(recoloured(svg, colour));
    for (const int size : {16, 20, 24, 32, 40, 48, 64, 72, 96}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        renderer.render(&painter);
        icon.addPixmap(pixmap, mode, state);
    }
}

}  // namespace

Theme Theme::of(const QPalette& palette) {
    Theme theme;
    theme.dark = isDark(palette);
    theme.workspace = theme.dark ? QColor(0x16171a) : QColor(0xdcdde3);
    theme.checkerA = theme.dark ? QColor(0x3a3b40) : QColor(0xffffff);
    theme.checkerB = theme.dark ? QColor(0x323338) : QColor(0xf0f0f3);
    theme.accent = palette.color(QPalette::Highlight);
    theme.secondText = theme.dark ? QColor(0xa0a2ad) : QColor(0x63666f);
    theme.line = theme.dark ? QColor(0x17181b) : QColor(0xd5d6dc);
    theme.warning = theme.dark ? QColor(0xe8a33d) : QColor(0xb06a00);
    return theme;
}

QPalette wendPalette(Appearance appearance, const QPalette& system) {
    const bool dark = appearance == Appearance::Dark || (appearance == Appearance::System && isDark(system));
    return dark ? darkPalette() : lightPalette();
}

QString wendStyleSheet(const QPalette& palette) {
    const Theme theme = Theme::of(palette);
    QFile file(QStringLiteral(":/wend/window.qss"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const auto set = [&sheet](const char* name, const QColor& colour) {
        sheet.replace(QLatin1String(name), colour.name(QColor::HexArgb));
    };
    QColor hover = palette.color(QPalette::WindowText);
    hover.setAlpha(22);
    QColor pressed = palette.color(QPalette::WindowText);
    pressed.setAlpha(40);
    QColor tint = theme.accent;
    tint.setAlpha(theme.dark ? 90 : 46);
    set("@accent", theme.accent);
    set("@tint", tint);
    set("@hover", hover);
    set("@pressed", pressed);
    set("@line", theme.line);
    set("@second", theme.secondText);
    set("@warning", theme.warning);
    set("@window", palette.color(QPalette::Window));
    set("@handle", theme.dark ? QColor(0xd5d7e0) : QColor(0xffffff));
    set("@base", palette.color(QPalette::Base));
    set("@button", palette.color(QPalette::Button));
    set("@text", palette.color(QPalette::WindowText));
    set("@disabled", palette.color(QPalette::Disabled, QPalette::ButtonText));
    set("@mid", palette.color(QPalette::Mid));
    set("@groove", palette.color(QPalette::Midlight));
    return sheet;
}

QIcon wendIcon(const QString& name, const QPalette& palette) {
    QFile file(QStringLiteral(":/wend/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray svg = file.readAll();
    QIcon icon;
    const QColor on = isDark(palette) ? palette.color(QPalette::Link) : palette.color(QPalette::Highlight);
    addPixmaps(icon, svg, palette.color(QPalette::WindowText), QIcon::Normal, QIcon::Off);
    addPixmaps(icon, svg, on, QIcon::Normal, QIcon::On);
    for (const auto state : {QIcon::Off, QIcon::On})
        addPixmaps(icon, svg, palette.color(QPalette::Disabled, QPalette::WindowText), QIcon::Disabled,
                   state);
    return icon;
}

}  // namespace wend
