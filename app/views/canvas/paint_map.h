#pragma once

#include <QAction>
#include <optional>

#include "app/panels/distortion_panel.h"

namespace wend {

/// Shows the map of the painted property while a brush is active, and restores the earlier map afterwards,
/// unless the user has chosen another one. A map that the user switched off stays off.
class PaintMap {
  public:
    PaintMap(DistortionPanel& panel, QAction& showMap);
    void show(Measure wanted);
    void end();

  private:
    struct Before {
        Measure measure;
        bool shown;
    };
    DistortionPanel& m_panel;
    QAction& m_showMap;
    std::optional<Before> m_before;  // while painting
    Measure m_painted = Measure::Phi;
    bool m_isChosen = false;  // the map that is shown, by the user
    QObject m_listener;
};

}  // namespace wend
