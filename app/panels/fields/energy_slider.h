#pragma once

#include <QIcon>
#include <QPixmap>
#include <QSlider>
#include <QTimer>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/style/energy_scale.h"

class QMimeData;
class QPainter;
class QToolButton;

namespace wend {

/// A slider between the four named stops, to which the handle snaps nearby. The stops are tiles above it,
/// with a picture of their effect, or words below it, with the colours that mark painted places.
class EnergySlider : public QWidget {
    Q_OBJECT

  public:
    enum class Stops { Words, Tiles };
    explicit EnergySlider(QWidget* parent = nullptr, Stops stops = Stops::Words);

    double phi() const { return m_phi; }
    void setPhi(double phi);
    /// Sets the accessible name; the default is "Keep".
    void setName(const QString& name);
    const EnergyScale& scale() const { return m_scale; }
    /// Sets the dimension, on which the names and the range of φ depend.
    void setDimension(int dimension);
    QSlider* slider() const { return m_slider; }
    QSize sizeHint() const override;
    /// Sets the pictures of the tiles; an empty list restores the samples. Stale pictures are faint.
    void setPictures(const std::vector<QPixmap>& pictures);
    void setPicturesStale(bool stale);
    static QSize pictureSize();
    /// Returns the φ of a dragged tile; nothing for other data.
    static std::optional<double> phiIn(const QMimeData* data);

  signals:
    /// Emitted when the pointer rests on a tile; NaN when it leaves.
    void hovered(double phi);
    /// Emitted when the user chooses another φ; the number is the same for all values of one gesture.
    void phiChosen(double phi, int gesture);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void choose(int value);
    void makeStop(int stop);
    void placeLabels();
    void placeTiles();
    void showPictures();
    QPixmap drawn(const QPixmap& picture) const;
    void dragTile(int stop);
    int stopX(int stop) const;
    int tileWidth() const;
    QString helpText() const;
    QIcon swatch(int stop) const;
    void paintColours(QPainter& painter) const;

    Stops m_stops;
    QString m_name;
    int m_dimension = 2;
    EnergyScale m_scale;
    QSlider* m_slider;
    std::array<QToolButton*, EnergyScale::kStops> m_labels;
    std::array<QIcon, EnergyScale::kStops> m_samples;
    double m_phi;
    int m_gesture = 0;
    std::vector<QPixmap> m_pictures;  // of the shape itself; empty: of a sample
    bool m_stale = false;
    QTimer m_rest;  // the pointer on a tile
    int m_under = -1;
    QPoint m_pressed;
};

}  // namespace wend
