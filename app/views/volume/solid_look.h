#pragma once

#include <QPointer>
#include <utility>

#include "app/engine/motion/frame.h"
#include "app/engine/shape/pose_faults.h"
#include "app/views/shape/viewport.h"
#include "app/views/volume/drawn_solid.h"

namespace wend {

class ShapeMotion;
class SolidCanvas;
class VolumeView;

/// Makes the colours, map, paint and glyphs of a solid's frames, as the looks of a view ask for.
class SolidLook {
  public:
    explicit SolidLook(const Viewport& viewport) : m_viewport(viewport) {}

    /// Returns whether a frame has a detailed surface, or one with materials.
    bool hasDetail(const PosedFrame<3>& frame) const;
    /// Returns the same of the session's frame.
    bool hasDetail() const {
        const auto frame = motion().frame<3>();
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
    const ShapeMotion& motion() const;
    bool isOnDark() const { return ground().lightnessF() < 0.5; }
    void addMap(VolumePicture& picture, const PosedFrame<3>& frame) const;
    void addPaint(VolumePicture& picture, const PosedFrame<3>& frame) const;

    const Viewport& m_viewport;
    std::shared_ptr<const PoseFaults<3>> m_faults;
};

/// Draws a whole solid from a canvas's viewpoint without map, cut, edges and marks, in a hidden widget.
class PlainView {
  public:
    /// `size`: in pixels. Null where OpenGL gives none.
    QImage draw(const SolidCanvas& like, const PosedFrame<3>& frame, const QSize& size);

  private:
    QPointer<VolumeView> m_view;
};

}  // namespace wend
