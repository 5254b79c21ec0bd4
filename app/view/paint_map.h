#pragma once

#include <QAction>
#include <optional>

#include "app/panels/distortion_panel.h"

namespace wend {

/// As long as a brush is chosen the map of what it paints is shown, afterwards what was shown before,
/// unless the user has chosen something else meanwhile.
class PaintMap {
  public:
    PaintMap(DistortionPanel& panel, QAction& showMap) : m_panel(panel), m_showMap(showMap) {}
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
};

}  // namespace wend
