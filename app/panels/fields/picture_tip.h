#pragma once

#include <QList>
#include <QPalette>
#include <QString>
#include <functional>

class QWidget;

namespace wend {

/// A drawing of resources/tips with its caption.
struct TipPicture {
    QString name;
    QString caption;
};

/// Shows the pictures below the text of the widget's tooltip, in the colours of the window, light or dark.
void showInTip(QWidget* widget, std::function<QList<TipPicture>()> pictures);
/// Returns the tooltip as rich text with the drawings.
QString tipWithPictures(const QString& words, const QList<TipPicture>& pictures, const QPalette& palette);

/// Pictures of a stretched square for the four energies, or for one of them.
QList<TipPicture> energyPictures(int dimension);
TipPicture energyPicture(int stop);
/// Returns a pull that does not reach far, and one that does.
QList<TipPicture> reachPictures();
/// Returns a bar that is pulled, soft all over, and with a stiff part.
QList<TipPicture> stiffnessPictures();
/// Returns a strip whose end was moved in a circle.
QList<TipPicture> memoryPictures();
/// Returns a shape after its pins were moved, and after it has relaxed.
QList<TipPicture> relaxPictures();

}  // namespace wend
