#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/project.h"
#include "app/session/cage_facts.h"
#include "app/session/mesh_verdict.h"
#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"
#include "core/meshing/surface.h"

namespace wend {

struct MeshFile;

/// What a solid's domain becomes.
struct Solid {
    std::shared_ptr<const SimplicialMesh<3>> rest;
    std::shared_ptr<const MeshFile> source;  // what came in or was made: cells, fields, labelled border
    std::shared_ptr<const Skin> skin;        // the surface that is seen and exported
    std::shared_ptr<const Embedding<3>> embedding;  // takes the skin's points along
    std::vector<std::string> notices;               // what the user should hear
    std::optional<MeshVerdict> verdict;             // on cells that were made
    std::optional<CageFacts> cage;                  // if a cage carries the surface
    bool refineHelps = false;                       // splitting the surface's triangles would help
};

/// Whether messages name the project's keys and the commands that help: the window has words of its own.
enum class Advice { Keys, None };

/// Reads and meshes the domain of a project in space (paths relative to `folder`). A surface that bounds no
/// volume throws SurfaceError (also where the repairs did not help), everything else InputError, with the
/// file's name; Cancelled when stopped.
Solid loadSolid(const Project& project, const std::string& folder, std::stop_token stop = {},
                Advice advice = Advice::Keys);

/// The surface of a skin, with its labels.
Surface surfaceOf(const Skin& skin);

/// True if both make the same solid.
bool sameSolid(const Project& a, const Project& b);

}  // namespace wend
