#pragma once

#include "app/engine/motion/frame.h"
#include "app/engine/shape/pose_faults.h"
#include "app/views/shape/viewport.h"
#include "app/views/volume/drawn_solid.h"

namespace wend {

/// How the frames of a solid look in a view, by its looks: their colours, those of a map or paint, and
/// glyphs.
class SolidLook {
  public:
    SolidLook(const Viewport& viewport, const ShapeMotion& motion, const Document& document)
        : m_viewport(viewport), m_motion(motion), m_document(document) {}

    /// Returns whether a frame has a detailed surface, or one with materials.
    bool hasDetail(const PosedFrame<3>& frame) const;
    /// Returns the same of the session's frame.
    bool hasDetail() const {
        const auto frame = m_motion.frame<3>();
        return frame && hasDetail(*frame);
    }
    VolumePicture picture(const PosedFrame<3>& frame) const;
    SurfaceStyle style() const;
    /// Returns the picture without a map, and its style: for another view.
    VolumePicture plainPicture(const PosedFrame<3>& frame) const;
    SurfaceStyle plainStyle() const;
    QRgb plainColour() const;
    /// Returns the colour of the background.
    QColor ground() const;
    /// Returns the triangles of arrows, ellipsoids and faults on the drawn solid; the second ones are faintly
    /// visible where they are covered.
    std::pair<std::vector<DrawVertex>, std::vector<DrawVertex>> glyphs(const PosedFrame<3>& frame,
                                                                       const DrawnSolid& solid) const;
    /// Sets the faults that a map marks; null for none. Returns false if they were set before.
    bool setFaults(const std::shared_ptr<const PoseFaults<3>>& faults) {
        return std::exchange(m_faults, faults) != faults;
    }

  private:
    bool isOnDark() const { return ground().lightnessF() < 0.5; }
    void addMap(VolumePicture& picture, const PosedFrame<3>& frame) const;
    void addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const;

    const Viewport& m_viewport;
    const ShapeMotion& m_motion;
    const Document& m_document;
    std::shared_ptr<const PoseFaults<3>> m_faults;
};

}  // namespace wend
