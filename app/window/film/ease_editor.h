#pragma once

#include <QDialog>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/project/edits/progress.h"

class QLabel;
class QToolButton;

namespace wend {

class ExactBox;
class TrackChoice;

/// The progress of a move over its time, with two handles that are dragged up and down.
class EasePlot : public QWidget {
    Q_OBJECT

  public:
    explicit EasePlot(QWidget* parent = nullptr);

    static constexpr double kLow = -0.5, kHigh = 1.5;  // of the way, at the lower and upper edge
    void setProgress(const std::optional<ShownProgress>& shown);
    const Progress& curve() const { return m_curve; }
    /// Returns where a handle (0 or 1) is drawn.
    QPointF handleSpot(int handle) const;
    QSize sizeHint() const override { return {240, 240}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

  signals:
    /// Emitted during a drag.
    void moved(const wend::Progress& curve);
    /// Emitted at the end of a drag, or after a key.
    void changed(const wend::Progress& curve, bool byKey);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QRectF area() const;
    QPointF spot(double time, double way) const;
    double& wayOf(int handle) { return handle == 0 ? m_curve.first : m_curve.second; }
    double limited(double way) const;
    void paintGrid(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintHandles(QPainter& painter) const;

    std::optional<ShownProgress> m_shown;
    Progress m_curve, m_before;  // m_before: of the drag
    int m_active = 0;            // the handle that keys move
    bool m_drags = false;
};

/// A small window beside the tracks with the easing of what is chosen there: a curve with two handles,
/// presets, and the speeds at both ends as numbers. It follows the choice; every drag is one undo step.
class EaseEditor : public QDialog {
    Q_OBJECT

  public:
    EaseEditor(TrackChoice& choice, QWidget* parent);

    EasePlot& plot() const { return *m_plot; }

  private:
    ExactBox* speedBox(const QString& name);
    QWidget* makePresets();
    QIcon curveIcon(const Progress& curve) const;
    void takeChoice();
    void showSpeeds(const Progress& curve);
    void typeSpeeds();

    TrackChoice& m_choice;
    QLabel* m_what;
    EasePlot* m_plot;
    ExactBox *m_start, *m_end;
    std::vector<QToolButton*> m_presets;
};

}  // namespace wend
