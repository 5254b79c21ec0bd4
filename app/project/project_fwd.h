#pragma once

#include <memory>
#include <vector>

namespace wend {

struct Domain;
struct IntegrationOptions;
struct Project;
struct SettleWindow;
struct ValueLayer;
struct Design;
struct MaterialSpec;

using ValueLayers = std::vector<ValueLayer>;

// The parts of a project. Include only the header of the part that you use.
int dimensionOf(const Project& project);
const Domain& domainOf(const Project& project);
Domain& domainOf(Project& project);
const Design& designOf(const Project& project);
Design& designOf(Project& project);
const ValueLayers& depthOf(const Project& project);
ValueLayers& depthOf(Project& project);
double endOf(const Project& project);
double& endOf(Project& project);
const std::vector<SettleWindow>& settlingOf(const Project& project);
/// Returns the integration options of every deformer of the project, including the end time.
IntegrationOptions integrationOf(const Project& project);

/// Return a project to be changed: an empty one, and a copy.
std::shared_ptr<Project> newProject();
std::shared_ptr<Project> copyOf(const Project& project);

}  // namespace wend
