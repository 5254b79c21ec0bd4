#pragma once

#include <QRgb>
#include <QString>

#include "app/project/edits/material_edits.h"
#include "app/session/brush.h"
#include "app/session/shape_session.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// Returns the paint of an area that is filled with the brush; `along` gives its direction.
template <int Dim>
MaterialPaint paintOf(const BrushSettings& brush, const Vec<Dim>& along = Vec<Dim>::Zero());
/// Copies the material of a place to the brush.
template <int Dim>
void pickMaterial(const PosedFrame<Dim>& frame, int cell, Brush& brush);
/// Returns the name of the paint: "Rigid", "Stiff", "Combed"; "Keep" if the amount is below 1.
QString brushKind(const BrushSettings& brush, int dimension);
/// Returns the colour of the paint.
QRgb brushColour(const BrushSettings& brush, int dimension);
/// Returns an identifier of the paint, to compare it with the last one.
std::string brushAim(const BrushSettings& brush);
/// Returns the layer for the paint: the selected one if it holds this kind, else the topmost that does, else
/// a new one named after the kind.
template <int Dim>
std::string layerFor(const Design& design, const BrushSettings& brush, const ChosenLayer& chosen,
                     const std::string& aim, const std::string& kind);
/// Returns a name for a place at rest: that of its layer or of the nearest pin; empty far from both.
template <int Dim>
QString placeName(const ShapeSession& session, const Vec<Dim>& place, const std::string& layer);
/// Returns the map that is shown while painting: the property that the brush changes.
std::optional<Measure> paintedMap(const Workbench& on, int dimension);
/// Returns whether the brush's stiffness equals that of the whole shape, and what the user can do then.
bool paintsNothing(const BrushSettings& brush);
QString nothingToPaint();

}  // namespace wend
