#pragma once

#include <variant>
#include <vector>

namespace wend {

struct DepthRegion;
struct Domain;
struct IntegrationOptions;
struct Project;
struct SettleWindow;
template <int Dim>
struct Design;
template <int Dim>
struct MaterialRegion;
template <int Dim>
struct MaterialSpec;

using AnyDesign = std::variant<Design<2>, Design<3>>;
using DepthRegions = std::vector<DepthRegion>;

// The parts of a project: who needs one of them includes its header alone.
int dimensionOf(const Project& project);
const Domain& domainOf(const Project& project);
template <int Dim>
const Design<Dim>& designOf(const Project& project);
const std::vector<SettleWindow>& settlingOf(const Project& project);
/// How the project is integrated, with its end: for every deformer of it.
IntegrationOptions integrationOf(const Project& project);

}  // namespace wend
