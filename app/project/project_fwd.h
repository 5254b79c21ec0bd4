#pragma once

#include <memory>
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

// The parts of a project. Include only the header of the part that you use.
int dimensionOf(const Project& project);
const Domain& domainOf(const Project& project);
Domain& domainOf(Project& project);
const AnyDesign& designOf(const Project& project);
AnyDesign& designOf(Project& project);
template <int Dim>
const Design<Dim>& designOf(const Project& project);
template <int Dim>
Design<Dim>& designOf(Project& project);
const DepthRegions& depthOf(const Project& project);
DepthRegions& depthOf(Project& project);
double endOf(const Project& project);
double& endOf(Project& project);
const std::vector<SettleWindow>& settlingOf(const Project& project);
/// Returns the integration options of every deformer of the project, including the end time.
IntegrationOptions integrationOf(const Project& project);

/// A project to be changed: an empty one, or one as `project` is.
std::shared_ptr<Project> newProject();
std::shared_ptr<Project> copyOf(const Project& project);

}  // namespace wend
