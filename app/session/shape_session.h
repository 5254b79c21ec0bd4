#pragma once

#include <QObject>
#include <optional>

#include "app/document/document.h"
#include "app/session/compute_thread.h"
#include "app/session/drag_gesture.h"
#include "app/session/frame_track.h"
#include "app/session/pins.h"
#include "app/session/playback.h"
#include "app/session/selection.h"

namespace wend {

/// A document with its shape in motion: what the window shows and what its gestures do. Lives in the thread
/// of the window; all computing is done by the compute thread.
class ShapeSession : public QObject {
    Q_OBJECT

  public:
    explicit ShapeSession(QObject* parent = nullptr);

    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    Selection& selection() { return m_selection; }
    Playback& playback() { return m_playback; }
    const FrameTrack& track() const { return m_track; }

    /// The frame to show now: of the drag, or of the time that is shown; null before the first mesh.
    const FramePtr& frame() const { return m_frame; }
    /// True while the frame does not yet show what the document says.
    bool isStale() const { return m_stale; }
    /// True while something is being computed.
    bool isBusy() const { return m_busy; }
    /// The handles at the time that is shown; dragged ones are where the pointer has them.
    std::vector<PinView> pins() const;
    /// Where a handle's points are when it begins to hold: the starts of its paths.
    std::vector<Vec<2>> pathStarts(int handle) const;
    /// The length in domain units that a tolerance of the stroke is measured in: one pixel of a picture.
    double pixel() const;

    // gestures
    /// A pin at a point of the shape as it is shown; −1 if there is no shape.
    int addPin(const Vec<2>& p);
    void removeSelected();
    void nudgeSelected(const Vec<2>& by);
    bool isDragging() const { return m_drag.has_value(); }
    void beginDrag();
    void dragTo(const Vec<2>& offset);
    void endDrag(double tolerance);
    void cancelDrag();

  signals:
    void frameChanged();
    void pinsChanged();
    void busyChanged(bool busy);
    void progress(double time, double end);
    /// A line for the status bar: what could not be done, and where.
    void notice(QString text);
    /// The project cannot be computed as it is; an empty text takes it back.
    void problem(QString text);

  private:
    void postShape();
    void takeShape(int revision, const std::shared_ptr<const SimplicialMesh<2>>& rest, double keptUpTo);
    void takeFrame(const FramePtr& frame);
    void takeLive(const FramePtr& frame);
    void takeFinished(double time, const QString& problem);
    void takeFailure(const QString& reason);
    void showTime();
    void show(const FramePtr& frame, bool stale);
    void setBusy(bool busy);
    const std::vector<PinPlace>& places() const;
    void goToEnd();
    void pushStroke(const std::vector<int>& handles, const std::vector<Vec<2>>& starts,
                    const std::vector<Vec<2>>& offsets, const QString& mergeKey);
    std::vector<Vec<2>> centresOf(const std::vector<int>& handles) const;
    QString nameOf(const std::vector<int>& handles) const;

    Document m_document;
    Selection m_selection;
    Playback m_playback;
    FrameTrack m_track;
    FramePtr m_frame;    // shown
    FramePtr m_preview;  // the last frame of a drag, until the exact motion is there
    bool m_stale = false, m_busy = false, m_failed = false;
    int m_revision = 0;  // of the newest request for a shape
    bool m_trackIsCurrent = false;
    std::shared_ptr<const SimplicialMesh<2>> m_rest;  // the newest
    struct Placed {  // the handles in the rest mesh of the frame that is shown
        std::shared_ptr<const SimplicialMesh<2>> rest;
        std::shared_ptr<const Project> project;
        std::vector<PinPlace> places;
    };
    mutable Placed m_placed;
    std::optional<DragGesture> m_drag;
    ComputeThread m_compute;  // the last member: it stops before the others go
};

}  // namespace wend
