#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/project/extras.h"
#include "app/project/file/json_reader.h"
#include "app/project/project_fwd.h"

namespace wend {

// A handle's place may be named: {"group": NAME}, a group of the mesh's or surface's file, or {"vertices":
// FILE}, a list of vertex ids. Names are resolved when the project is read. The name is kept with the
// handle's extras under "/at", together with the place that it meant, and is written again as long as the
// handle is still there.

// Directions of a handle may also be named: "normal of GROUP" for an axis of rotation or a direction that is
// held. Their names are kept under "/hold/normal", and with the motion's extras under "/axis".

/// Reads a direction; one that is named stays zero until findNamedPlaces() resolves it.
Vec3 readNamedDirection(const JsonValue& value);

/// Returns the group that a direction "normal of GROUP" names; nothing if it is no text. Other texts fail,
/// with an example of that dimension.
std::optional<std::string> readWall(const JsonValue& value, int dimension);
/// Returns "normal of GROUP".
std::string wallText(const std::string& group);

/// Takes the name from the object "at", if it is one; the vertices follow with findNamedPlaces.
bool readNamedPlace(JsonObject& at, Extras& extras);

/// Finds the vertices of all handles whose place is named, directions that are, and walls of the material. A
/// mesh that cannot be
/// read is left to who needs it. Throws InputError "handles[2].at: …".
void findNamedPlaces(Project& project, const std::string& folder);

/// Writes the name of a direction to its place in `json` if it still means that value.
void putNamedDirection(nlohmann::ordered_json& json, const Extras& extras, const std::string& pointer);
/// Places a handle on a group by its name, which means these vertices. `dimension`: of the group's cells.
void placeOnGroup(Pin& handle, const std::string& group, int dimension, const std::vector<int>& vertices);
/// Returns the extras without names.
Extras withoutNames(Extras extras);

/// Returns the name of a handle's place if it still means `place`, both as JSON.
std::optional<nlohmann::ordered_json> nameOfPlace(const Extras& extras, const nlohmann::ordered_json& place);

/// Names the files of such places from another folder.
void rebaseNamedPlaces(Extras& extras, const std::function<std::string(const std::string&)>& rebased);

}  // namespace wend
