#pragma once

#include <QRgb>
#include <QString>

#include "app/document/material_edits.h"
#include "app/session/brush.h"
#include "app/session/frame.h"

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
/// How the user knows the document: "giraffe".
QString shortName(const QString& fileName);

}  // namespace wend
