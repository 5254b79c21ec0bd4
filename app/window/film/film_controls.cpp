#include "app/window/film/film_controls.h"

#include <QApplication>
#include <QSlider>
#include <QToolButton>
#include <utility>

#include "app/project/edits/film_edits.h"
#include "app/session/settle_step.h"
#include "app/style/theme.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/film/key_pose_strip.h"
#include "app/window/film/pose_drawing.h"
#include "app/window/film/sound_track.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"

namespace wend {

FilmControls::FilmControls(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    Actions& a = m_parts.actions;
    Playback& playback = m_parts.session.playback();
    m_parts.strip.playButton()->setDefaultAction(a.play);
    m_parts.strip.loopButton()->setDefaultAction(a.loop);
    connectTime();
    connect(&m_parts.strip, &TimeStrip::wayChanged, &m_parts.tracks,
            [strip = &m_parts.strip, tracks = &m_parts.tracks] { tracks->setWay(strip->way()); });
    m_parts.tracks.poses().setDrawing(new PoseDrawing(m_parts.picture, m_parts.solid, this));
    connect(m_parts.strip.slider(), &QSlider::valueChanged, this, [this, &playback] {
        if (m_parts.strip.slider()->isSliderDown()) m_parts.tracks.sound().scrub(playback.time());
    });
    connect(a.loop, &QAction::toggled, &playback, &Playback::setLoops);
    connect(&m_parts.session.document(), &Document::projectChanged, this, &FilmControls::takeCycle);
    connect(&m_parts.session.document(), &Document::opened, this, &FilmControls::takeCycle);
    connect(a.record, &QAction::toggled, &m_parts.session.gestures(), &ShapeGesture::setRecording);
    const auto pose = [this, &a] {
        m_parts.session.gestures().setPosing(a.poseHere->isChecked() &&
                                             m_parts.tools.mode() == Mode::Animate);
    };
    connect(a.poseHere, &QAction::toggled, this, pose);
    connect(&m_parts.tools, &Toolbox::changed, this, pose);
    connect(a.keepWay, &QAction::toggled, &m_parts.session.gestures(), &ShapeGesture::setKeepsWay);
    connect(a.speed.get(), &QMenu::triggered, this, [&a, &playback](const QAction* chosen) {
        playback.setSpeed(chosen->data().toDouble());
        a.setSpeed(playback.speed());
    });
    connect(a.settle, &QAction::triggered, this,
            [this] { settleAtEnd(m_parts.session.document(), m_parts.session.playback()); });
    connect(&playback, &Playback::playingChanged, this, &FilmControls::showPlaying);
    connect(&m_parts.tools, &Toolbox::changed, this, &FilmControls::showTracks);
    connect(&m_parts.session.document(), &Document::opened, this, &FilmControls::showTracks);
    showTracks();
}

/// A cycle that is marked or opened loops.
void FilmControls::takeCycle() {
    const auto cycle = filmMarksOf(m_parts.session.document()).cycle;
    m_parts.session.playback().setCycle(cycle ? cycle->at(0) : 0, cycle ? cycle->at(1) : 0);
    if (!std::exchange(m_hasCycle, cycle.has_value()) && cycle) m_parts.actions.loop->setChecked(true);
}

void FilmControls::connectTime() {
    const Actions& a = m_parts.actions;
    Playback& playback = m_parts.session.playback();
    connect(a.play, &QAction::triggered, &playback,
            [&playback] { playback.setPlaying(!playback.isPlaying()); });
    connect(a.toStart, &QAction::triggered, &playback, [&playback] { playback.setTime(0); });
    connect(a.toEnd, &QAction::triggered, &playback, [&playback] { playback.setTime(playback.end()); });
}

void FilmControls::showPlaying(bool playing) {
    QAction& play = *m_parts.actions.play;
    play.setIcon(
        wendIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"), QApplication::palette()));
    play.setText(playing ? tr("&Pause") : tr("&Play"));
}

/// Shows the tracks in the step Animate.
void FilmControls::showTracks() {
    m_parts.tracks.setVisible(!m_parts.session.document().isEmpty() && m_parts.tools.mode() == Mode::Animate);
}

}  // namespace wend
