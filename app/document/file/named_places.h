#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/document/file/json_reader.h"
#include "app/document/project_fwd.h"

namespace wend {

// A handle's place may be named: {"group": NAME}, a group of the mesh's or surface's file, or {"vertices":
// FILE}, a list of vertex ids. What it names is looked up when the project is read; the name is kept with the
// handle's extras under "/at", with what it stood for, and is written again while the handle is still there.

/// Takes the name from the object "at", if it is one; the vertices follow with findNamedPlaces.
bool readNamedPlace(JsonObject& at, Extras& extras);

/// Finds the vertices of all handles whose place is named. A mesh that cannot be read is left to who needs
/// it. Throws InputError "handles[2].at: …".
void findNamedPlaces(Project& project, const std::string& folder);

/// The name of a handle's place if it stands for `place` still, both as JSON.
std::optional<nlohmann::ordered_json> nameOfPlace(const Extras& extras, const nlohmann::ordered_json& place);

/// Names the files of such places from another folder.
void rebaseNamedPlaces(Extras& extras, const std::function<std::string(const std::string&)>& rebased);

}  // namespace wend
