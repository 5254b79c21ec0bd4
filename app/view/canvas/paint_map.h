#pragma once

#include <QAction>
#include <optional>

#include "app/panels/distortion_panel.h"

namespace wend {

/// As long as a brush is chosen the map of what it paints is shown, afterwards what was shown before,
/// unless the user has chosen another map meanwhile. One that the user has switched off stays off.
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
