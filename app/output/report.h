#pragma once

#include "app/engine/shape/cage_facts.h"
#include "app/engine/shape/mesh_verdict.h"
#include "app/engine/shape/pose_faults.h"
#include "app/output/run.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "warp/sampling.h"

namespace wend {

/// The share of its motions that a handle has done, see reachOf().
struct HandleReach {
    std::string name;
    double share = 1;
};
std::vector<HandleReach> reachedAt(const Design& design, double time);
/// Returns "handle "hand" reaches only 60 % of its motion …" for a project that ends before its motions do;
/// else empty.
std::string fallsShort(const Project& project);

/// The content of a report (contract of the command line).
struct RunFigures {
    int vertices = 0, cells = 0, dimension = 0;
    double time = 0, total = 0;  // reached; seconds
    std::string backEnd, device, solver;
    Distortion distortion;
    Statistics statistics;
    double restEnergy = 0, restForce = 0;     // W, and how far the shape is from settled
    std::string faults;                       // faultsJson()
    std::string quality;                      // qualityJson()
    std::optional<MeshVerdict> verdict = {};  // on cells that were made
    std::optional<CageFacts> cage = {};       // if one carries the surface
    std::optional<View> canvas = {};          // of pictures that were written
    std::vector<HandleReach> reached = {};
    std::vector<std::string> notices = {};
};
std::string reportJson(const RunFigures& figures);
/// Returns {"asked", "got", "worstCell", "cellsAbove", "facets"} of a verdict, as text.
std::string verdictJson(const MeshVerdict& verdict);
/// Returns {"edge", "bodies", "parts", "apart", "gaps", "why"}, as text.
std::string cageJson(const CageFacts& cage);
/// Returns {"selfCrossings": {"places", "pairs", "first"}, "blownUp": {"factor", "cells", "places", "worst"}}
/// as text.
template <int Dim>
std::string faultsJson(const PoseFaults<Dim>& faults);
/// Returns, as text, {"before", "after"}, each {"scaledJacobian", "aspectRatio", "minAngle", "maxAngle"} with
/// the worst value, its cell and the mean (see CellShape; degrees).
template <int Dim>
std::string qualityJson(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);
/// Returns for example "the canvas of 400 x 300 pixels begins at x -12, y 0 of the picture".
std::string canvasText(const View& canvas);
/// Returns "20 steps; …": how near the end is to the truth.
std::string summaryText(const Statistics& statistics, const IntegrationOptions& integration);

}  // namespace wend
