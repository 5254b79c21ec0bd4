#pragma once

#include "app/project/design.h"
#include "app/project/file/json_reader.h"
#include "app/project/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

/// Reads the material, whose coordinates have the dimension of the design.
void readMaterial(const JsonValue& value, Project& project);
/// Reads a handle; a motion without a time window takes [0, end].
Pin readHandle(const JsonValue& value, double end);
/// Reads a region: {"polygon": …}, {"circle": …} …
Region<3> readRegion(const JsonValue& value);
/// Reads the loops of an outline.
Outline readPolygons(const JsonValue& value);
/// Reads a region of `domain.sizes` or `depth` into the last layer, or into a new one.
void readSize(const JsonValue& value, ValueLayers& sizes);
void readDepth(const JsonValue& value, ValueLayers& depth);
/// Reads the keys of material.cells.
void readCellValues(JsonObject& object, MaterialSpec& spec);

}  // namespace wend
