#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/layer.h"
#include "app/project/project_fwd.h"
#include "app/project/solid_view.h"
#include "core/integration/integration_options.h"

namespace wend {

/// A named time of the film; the motion does not depend on it.
struct TimeMarker {
    double at = 0;
    std::string name;
    Extras extras = {};
};

/// The project as the file describes it (docs/project-file.md): values only, no meshes or pictures.
struct Project {
    Domain domain;
    Design design;
    ValueLayers depth;  // in the plane: the order, 0 elsewhere
    double end = 1;
    bool endIsGiven = true;  // false: the file leaves `end` to the motions, see endOfMotions()
    double frameRate = 24;   // of films, per unit of time
    std::optional<std::array<double, 2>> cycle;  // the part of time that a loop shows
    std::vector<TimeMarker> markers;             // in the order of time
    std::string audio;                 // a file that sounds from time 0 on, in films, too; empty: none
    std::vector<SettleWindow> settle;  // in the order of time; none ends after `end`
    SolidView view;                    // in space
    IntegrationOptions integration;    // end and settle are not looked at: see integrationOf()
    Extras extras = {};                // of everything but regions, handles and motions, which keep their own

    int dimension() const { return design.dimension; }
};

/// Returns the end of a project that gives none: that of the last motion, 1 if nothing moves, and at least
/// the end of the last window of settling.
double endOfMotions(const Project& project);

/// Adds a window of settling, which `end` covers then.
void appendSettling(Project& project, double from, double length = 1);

}  // namespace wend
