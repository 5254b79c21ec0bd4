#pragma once

#include <QRgb>
#include <QString>

#include "app/document/edits/material_edits.h"
#include "app/session/brush.h"
#include "app/session/shape_session.h"
#include "app/tools/tool_kind.h"

namespace wend {

/// What lies under an area that is filled with the brush, `along` being where its direction may come from.
template <int Dim>
MaterialPaint<Dim> paintOf(const BrushSettings& brush, const Vec<Dim>& along = Vec<Dim>::Zero());
/// What is there becomes what the brush paints.
template <int Dim>
void pickMaterial(const PosedFrame<Dim>& frame, int cell, Brush& brush);
/// What that is called: "Rigid", "Stiff", "Combed"; where nothing is painted wholly, "Keep".
QString brushKind(const BrushSettings& brush, int dimension);
/// The colour of what it paints.
QRgb brushColour(const BrushSettings& brush, int dimension);
/// What the brush is about to paint, as it is compared with what it painted last.
std::string brushAim(const BrushSettings& brush);
/// The layer that takes what is painted: the chosen one if it has what the brush paints, else the topmost if
/// it has, else a new one, named after its kind.
template <int Dim>
std::string layerFor(const Design<Dim>& design, const BrushSettings& brush, const ChosenLayer& chosen,
                     const std::string& aim, const std::string& kind);
/// How the user knows a place at rest: by the name that the layer was given, or by that of the nearest pin;
/// empty far from all of them.
template <int Dim>
QString placeName(const ShapeSession& session, const Vec<Dim>& place, const std::string& layer);
/// What is coloured while one paints: what the brush changes.
std::optional<Measure> paintedMap(const Workbench& on, int dimension);
/// The brush would make something as stiff as it is everywhere: what the user can do about it.
bool paintsNothing(const BrushSettings& brush);
QString nothingToPaint();

}  // namespace wend
