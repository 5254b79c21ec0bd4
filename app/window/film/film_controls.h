#pragma once

#include <QObject>
#include <functional>

namespace wend {

class Actions;
class ShapeCanvas;
class ShapeSession;
class SolidCanvas;
class TimeStrip;
class Toolbox;
class TrackView;

/// Playback, recording and time: the film's actions, the strip below the canvas and the tracks.
class FilmControls : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        ShapeSession& session;
        Actions& actions;
        const Toolbox& tools;
        TimeStrip& strip;
        TrackView& tracks;
        const ShapeCanvas& picture;
        std::function<SolidCanvas*()> solid;  // the view of solids, null before the first one
    };
    FilmControls(const Parts& parts, QObject* parent);

  private:
    void connectTime();
    void takeCycle();
    void showPlaying(bool playing);
    void showTracks();

    Parts m_parts;
    bool m_hasCycle = false;
};

}  // namespace wend
