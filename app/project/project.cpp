#include "app/project/project.h"

#include <algorithm>

#include "core/motion/reach.h"

namespace wend {

int dimensionOf(const Project& project) {
    return project.dimension();
}

const Domain& domainOf(const Project& project) {
    return project.domain;
}

Domain& domainOf(Project& project) {
    return project.domain;
}

const Design& designOf(const Project& project) {
    return project.design;
}

Design& designOf(Project& project) {
    return project.design;
}

const ValueLayers& depthOf(const Project& project) {
    return project.depth;
}

ValueLayers& depthOf(Project& project) {
    return project.depth;
}

double endOf(const Project& project) {
    return project.end;
}

double& endOf(Project& project) {
    return project.end;
}

const std::vector<SettleWindow>& settlingOf(const Project& project) {
    return project.settle;
}

IntegrationOptions integrationOf(const Project& project) {
    IntegrationOptions options = project.integration;
    options.end = project.end;
    options.settle = project.settle;
    return options;
}

std::shared_ptr<Project> newProject() {
    return std::make_shared<Project>();
}

std::shared_ptr<Project> copyOf(const Project& project) {
    return std::make_shared<Project>(project);
}

double endOfMotions(const Project& project) {
    double end = lastMotionEnd(handlesIn<3>(project.design.handles), 1.0);
    for (const SettleWindow& window : project.settle) end = std::max(end, window.end);
    return end;
}

void appendSettling(Project& project, double from, double length) {
    project.settle.push_back({from, from + length});
    project.end = std::max(project.end, from + length);
}

}  // namespace wend
