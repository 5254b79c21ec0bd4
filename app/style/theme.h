#pragma once

#include <QColor>
#include <QIcon>
#include <QImage>
#include <QPalette>
#include <QString>

namespace wend {

/// Colours of the window beyond those of a palette, for the light and the dark palette.
struct Theme {
    bool dark = false;
    QColor workspace;  // around the picture
    QColor checkerA, checkerB;
    QColor accent;      // under white
    QColor accentText;  // as text, and for focus rings
    QColor secondText;
    QColor line;                      // hairlines between areas
    QColor danger, warning, success;  // never without a sign

    static Theme of(const QPalette& palette);
    /// Returns the theme with checks from which a picture of this mean lightness (0 to 1) stands out: light
    /// ones behind dark ink in the dark theme, grey ones behind white in the light theme.
    Theme behind(double lightness) const;
};

/// Returns the mean lightness from 0 (black) to 1 (white) of what is not transparent: the luma (BT.709) of
/// its colours, weighted with alpha. 1 for an empty image.
double lightnessOf(const QImage& image);

enum class Appearance { System, Light, Dark };

/// Returns the palette of the window: of the system's lightness at the start, or of the chosen one.
QPalette wendPalette(Appearance appearance, const QPalette& system);
/// Returns a style sheet for the shapes of controls, in the colours of the palette.
QString wendStyleSheet(const QPalette& palette);

/// Returns the palette for icons on accent-coloured buttons.
QPalette primaryPalette(const QPalette& palette);

/// Returns an icon of resources/icons, drawn in the palette's colours for normal, disabled and checked state,
/// sharp at every scale.
QIcon wendIcon(const QString& name, const QPalette& palette);
/// Returns the same icon in one colour.
QIcon wendIcon(const QString& name, const QColor& colour);

}  // namespace wend
