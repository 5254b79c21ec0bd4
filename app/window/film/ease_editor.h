#pragma once

#include <QDialog>
#include <vector>

#include "app/project/edits/progress.h"

class QLabel;
class QToolButton;

namespace wend {

class EasePlot;
class ExactBox;
class TrackView;

/// A small window beside the tracks with the easing of what is chosen there: a curve with two handles,
/// presets, and the speeds at both ends as numbers. It follows the choice; every drag is one undo step.
class EaseEditor : public QDialog {
    Q_OBJECT

  public:
    explicit EaseEditor(TrackView& tracks);

    EasePlot& plot() const { return *m_plot; }

  private:
    void makeSpeeds();
    QWidget* makePresets();
    QIcon curveIcon(const Progress& curve) const;
    void takeChoice();
    void showSpeeds(const Progress& curve);
    void typeSpeeds();

    TrackView& m_tracks;
    QLabel* m_what;
    EasePlot* m_plot;
    ExactBox *m_start, *m_end;
    std::vector<QToolButton*> m_presets;
};

}  // namespace wend
