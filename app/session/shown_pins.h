#pragma once

#include "app/project/edits/document.h"
#include "app/session/pins.h"

namespace wend {

class ShapeMotion;

/// The document's handles in the shown frame. Their places in the rest mesh are cached per project and mesh.
/// Lives in the window's thread.
class ShownPins {
  public:
    ShownPins(const Document& document, const ShapeMotion& motion) : m_document(document), m_motion(motion) {}

    int count() const;
    /// Returns whether a handle may not be changed: it is locked, or the part that it is in.
    bool isLocked(int handle) const;
    /// The name of one, or how many they are.
    QString nameOf(const std::vector<int>& handles) const;
    /// Returns the pins that act at a time, or those that do not; hidden ones only if `all`.
    std::vector<PinView> at(double time, bool holding, bool all) const;
    std::vector<Vec3> pathStarts(int handle) const;
    /// The vertices that a handle of a solid holds, increasing.
    std::vector<int> verticesOf(int handle) const;
    Placement<3> placementOf(const std::vector<int>& vertices) const;
    /// Resets the cache for another file.
    void drop() { m_places = {}; }

  private:
    FramePtr shape() const;
    const std::vector<PinPlace>& places() const;

    const Document& m_document;
    const ShapeMotion& m_motion;
    struct Cache {
        std::shared_ptr<const void> rest;
        std::shared_ptr<const Project> project;
        std::vector<PinPlace> of;
    };
    mutable Cache m_places;
};

}  // namespace wend
