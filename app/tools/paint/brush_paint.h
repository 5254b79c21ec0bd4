#pragma once

#include <QRgb>
#include <QString>

#include "app/engine/motion/edited_material.h"
#include "app/project/edits/material_edits.h"
#include "app/session/brush.h"
#include "app/session/pins.h"
#include "app/session/shape_motion.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Returns the paint of an area that is filled with the brush; `along` gives its direction.
MaterialPaint paintOf(const BrushSettings& brush, int dimension, const Vec3& along = Vec3::Zero());
/// Returns the axis of the brush's stiffness, which has no z in pictures.
Vec3 axisOf(const BrushSettings& brush, int dimension);
/// Copies the material of a place to the brush.
void pickMaterial(const EditedMaterial& material, int cell, Brush& brush);
/// Returns the name of the paint: "Rigid", "Stiff", "Combed"; "Keep" if the amount is below 1.
QString brushKind(const BrushSettings& brush, int dimension);
/// Returns the colour of the paint.
QRgb brushColour(const BrushSettings& brush, int dimension);
/// Returns an identifier of the paint, to compare it with the last one.
std::string brushAim(const BrushSettings& brush);
/// Returns the layer for the paint: the selected one if it holds this kind, else the topmost that does, else
/// a new one named after the kind.
PaintedLayer layerFor(const Design& design, const BrushSettings& brush, const ChosenLayer& chosen,
                      const std::string& aim, const std::string& kind);
/// Returns a name for a place at rest: that of its layer or of the nearest pin; empty far from both.
QString placeName(const ShapeMotion& motion, const ShownPins& pins, const Vec3& place,
                  const std::string& layer);
/// Returns the map that is shown while painting: the property that the brush changes.
std::optional<Measure> paintedMap(const Workbench& on, int dimension);
/// Returns whether the brush's stiffness equals that of the whole shape, and what the user can do then.
bool paintsNothing(const BrushSettings& brush);
QString nothingToPaint();

}  // namespace wend
