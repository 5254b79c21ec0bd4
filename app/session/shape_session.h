#pragma once

#include <optional>

#include "app/engine/motion/playback.h"
#include "app/session/pins.h"
#include "app/session/selection.h"
#include "app/session/shape_gesture.h"
#include "app/session/shape_motion.h"

namespace wend {

/// A document with its moving shape: what the window shows and what gestures change. It owns and connects
/// ShapeMotion, which computes and chooses the shown frame, ShownPins, which places the handles in it, and
/// ShapeGesture, which moves them. Lives in the window's thread; the compute thread does all computing.
class ShapeSession : public QObject {
    Q_OBJECT

  public:
    explicit ShapeSession(QObject* parent = nullptr);

    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    Selection& selection() { return m_selection; }
    const Selection& selection() const { return m_selection; }
    Playback& playback() { return m_playback; }
    const Playback& playback() const { return m_playback; }
    ShapeMotion& motion() { return m_motion; }
    const ShapeMotion& motion() const { return m_motion; }
    const ShownPins& pins() const { return m_pins; }
    /// Returns the gestures that move the selected handles.
    ShapeGesture& gestures() { return m_gesture; }
    const ShapeGesture& gestures() const { return m_gesture; }

    /// Adds a pin at a point of the shown shape. Returns −1 and shows a notice if the point is outside.
    int addPin(const Vec3& p);
    /// Does the same at a place of it.
    int addPin(const std::optional<Place>& place);
    /// Adds a handle of any kind, in terms of the rest shape, named "<kind> 1", "<kind> 2" …
    int addHandle(Placement<3> at, const std::string& kind, const std::string& part = {});
    void changeHandle(int handle, Placement<3> at);
    void removeSelected();

  private:
    void reset();
    void takeProject();

    Document m_document;
    Selection m_selection{m_document};
    Playback m_playback;
    ShapeMotion m_motion{m_document, m_selection, m_playback};
    ShownPins m_pins{m_document, m_motion};
    ShapeGesture m_gesture{m_document, m_selection, m_playback, m_motion, m_pins};
};

}  // namespace wend
