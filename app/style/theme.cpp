#include "app/style/theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>
#include <map>
#include <tuple>

#include "app/style/colours.h"

namespace wend {

namespace {

/// The roles of both palettes in one order: surface, raised, field, line between, border of controls, text,
/// muted, disabled, accent under white, accent as text.
struct Tones {
    QRgb surface, raised, field, line, border, text, muted, disabled, accent, accentText;
};

constexpr Tones kLight = {0xf5f5f7, 0xffffff, 0xffffff, 0xd5d6dc, 0x8a8d98,
                          0x1f2126, 0x5c5f69, 0x8b8e98, kAccent,  0x4a5bd4};
constexpr Tones kDark = {0x26272c, 0x303138, 0x1c1d21, 0x3c3e47, 0x7e818c,
                         0xe7e8ec, 0xa8aab5, 0x7e818c, 0x5a6ae6, 0x98a4ff};

QPalette paletteOf(const Tones& tones) {
    QPalette p;
    const auto set = [&p](std::initializer_list<QPalette::ColorRole> roles, QRgb tone) {
        for (const auto role : roles) p.setColor(role, QColor(tone));
    };
    set({QPalette::Window, QPalette::AlternateBase}, tones.surface);
    set({QPalette::WindowText, QPalette::Text, QPalette::ButtonText}, tones.text);
    set({QPalette::Base}, tones.field);
    set({QPalette::Button, QPalette::ToolTipBase}, tones.raised);
    set({QPalette::ToolTipText}, tones.text);
    set({QPalette::Mid}, tones.border);
    set({QPalette::Light}, tones.raised);  // menus etch disabled entries with it
    set({QPalette::Midlight}, tones.line);
    set({QPalette::Dark}, tones.border);
    set({QPalette::Shadow, QPalette::PlaceholderText}, tones.muted);
    set({QPalette::Highlight}, tones.accent);
    set({QPalette::HighlightedText}, 0xffffff);
    set({QPalette::Link}, tones.accentText);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor(tones.disabled));
    return p;
}

QPalette lightPalette() {
    return paletteOf(kLight);
}

QPalette darkPalette() {
    return paletteOf(kDark);
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightnessF() < palette.color(QPalette::WindowText).lightnessF();
}

QByteArray recoloured(const QByteArray& svg, const QColor& colour) {
    QByteArray result = svg;
    result.replace("#000000", colour.name().toLatin1());  // the icons' only tone
    return result;
}

/// An icon of one tone that depends on its state; each size is drawn when it is first needed.
class ToneIcon : public QIconEngine {
  public:
    ToneIcon(QByteArray svg, const QPalette& palette) : m_svg(std::move(svg)), m_palette(palette) {}

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QColor tone = toneOf(mode, state);
        QPixmap& pixmap = m_drawn[{size.width(), size.height(), tone.rgba()}];
        if (pixmap.isNull()) pixmap = drawn(size, tone);
        return pixmap;
    }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal scale = painter->device()->devicePixelRatioF();
        painter->drawPixmap(rect, pixmap(QSizeF(QSizeF(rect.size()) * scale).toSize(), mode, state));
    }
    QIconEngine* clone() const override { return new ToneIcon(*this); }

  private:
    QColor toneOf(QIcon::Mode mode, QIcon::State state) const {
        if (mode == QIcon::Disabled) return m_palette.color(QPalette::Disabled, QPalette::WindowText);
        return m_palette.color(state == QIcon::On ? QPalette::Link : QPalette::WindowText);
    }
    QPixmap drawn(const QSize& size, const QColor& tone) const {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        QSvgRenderer(recoloured(m_svg, tone)).render(&painter);
        return pixmap;
    }

    QByteArray m_svg;
    QPalette m_palette;
    std::map<std::tuple<int, int, QRgb>, QPixmap> m_drawn;
};

}  // namespace

Theme Theme::of(const QPalette& palette) {
    Theme theme;
    theme.dark = isDark(palette);
    theme.workspace = theme.dark ? QColor(0x16171a) : QColor(0xdcdde3);
    theme.checkerA = theme.dark ? QColor(0x3a3b40) : QColor(0xffffff);
    theme.checkerB = theme.dark ? QColor(0x323338) : QColor(0xf0f0f3);
    theme.accent = palette.color(QPalette::Highlight);
    theme.accentText = palette.color(QPalette::Link);
    theme.secondText = palette.color(QPalette::PlaceholderText);
    theme.line = palette.color(QPalette::Midlight);
    theme.danger = theme.dark ? QColor(0xff8a80) : QColor(0xb3261e);
    theme.warning = theme.dark ? QColor(0xe8a33d) : QColor(0x8a5a00);
    theme.success = theme.dark ? QColor(0x5fd0a4) : QColor(0x0b7a5b);
    return theme;
}

double lightnessOf(const QImage& image) {
    const QImage pixels = image.convertToFormat(QImage::Format_ARGB32);
    double sum = 0, weight = 0;
    for (int y = 0; y < pixels.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(pixels.constScanLine(y));
        for (int x = 0; x < pixels.width(); ++x) {
            const QRgb pixel = row[x];
            sum +=
                qAlpha(pixel) * (0.2126 * qRed(pixel) + 0.7152 * qGreen(pixel) + 0.0722 * qBlue(pixel)) / 255;
            weight += qAlpha(pixel);
        }
    }
    return weight > 0 ? sum / weight : 1;
}

Theme Theme::behind(double lightness) const {
    constexpr double kDark = 0.35, kLight = 0.93;
    Theme theme = *this;
    if (dark && lightness < kDark) {
        theme.checkerA = QColor(0xe4e5ea);
        theme.checkerB = QColor(0xd6d7de);
    } else if (!dark && lightness > kLight) {
        theme.checkerA = QColor(0xc4c6d0);
        theme.checkerB = QColor(0xb6b8c3);
    }
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
    hover.setAlphaF(0.09F);
    QColor pressed = palette.color(QPalette::WindowText);
    pressed.setAlphaF(0.16F);
    QColor tint = theme.accent;
    tint.setAlphaF(theme.dark ? 0.3F : 0.18F);
    set("@accentText", theme.accentText);
    set("@accentDeep", theme.accent.darker(115));
    set("@accent", theme.accent);
    set("@danger", theme.danger);
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

QPalette primaryPalette(const QPalette& palette) {
    QPalette primary = palette;
    for (const auto role : {QPalette::WindowText, QPalette::Link})
        primary.setColor(role, palette.color(QPalette::HighlightedText));
    return primary;
}

QIcon wendIcon(const QString& name, const QPalette& palette) {
    QFile file(QStringLiteral(":/wend/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QIcon(new ToneIcon(file.readAll(), palette));
}

QIcon wendIcon(const QString& name, const QColor& colour) {
    QPalette palette;
    for (const auto role : {QPalette::WindowText, QPalette::Link}) palette.setColor(role, colour);
    return wendIcon(name, palette);
}

}  // namespace wend
