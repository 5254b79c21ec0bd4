#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

namespace wend {

/// Colours of the window beyond what a palette holds; light and dark follow the desktop's palette.
struct Theme {
    bool dark = false;
    QColor workspace;  // around the picture
    QColor checkerA, checkerB;
    QColor accent;      // under white
    QColor accentText;  // as text, and for rings around what has the keyboard
    QColor secondText;
    QColor line;                      // hairlines between areas
    QColor danger, warning, success;  // never without a sign

    static Theme of(const QPalette& palette);
};

enum class Appearance { System, Light, Dark };

/// The palette of the window: the system's lightness (as it was at the start) or the one asked for.
QPalette wendPalette(Appearance appearance, const QPalette& system);
/// Shapes of controls, in the colours of the palette.
QString wendStyleSheet(const QPalette& palette);

/// For icons on a button that is filled with the accent.
QPalette primaryPalette(const QPalette& palette);

/// An icon of resources/icons, drawn in the palette's colours for normal, disabled and checked state, sharp
/// at every scale.
QIcon wendIcon(const QString& name, const QPalette& palette);
/// The same in one colour.
QIcon wendIcon(const QString& name, const QColor& colour);

}  // namespace wend
