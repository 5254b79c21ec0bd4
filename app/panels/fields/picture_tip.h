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

/// The tooltip of the widget shows these below its words, in the colours of the window, light or dark.
void showInTip(QWidget* widget, std::function<QList<TipPicture>()> pictures);
/// Returns the tooltip as rich text with the drawings.
QString tipWithPictures(const QString& words, const QList<TipPicture>& pictures, const QPalette& palette);

/// Pictures of a stretched square for the four energies, or for one of them.
QList<TipPicture> energyPictures(int dimension);
TipPicture energyPicture(int stop);
/// A pull that reaches not far, and one that does.
QList<TipPicture> reachPictures();
/// A bar that is pulled, soft all over, and with a part that is stiff.
QList<TipPicture> stiffnessPictures();
/// A strip whose end was moved in a circle.
QList<TipPicture> memoryPictures();
/// A shape after its pins were moved, and after it has relaxed.
QList<TipPicture> relaxPictures();

}  // namespace wend
