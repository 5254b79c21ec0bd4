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

const AnyDesign& designOf(const Project& project) {
    return project.design;
}

AnyDesign& designOf(Project& project) {
    return project.design;
}

template <int Dim>
const Design<Dim>& designOf(const Project& project) {
    return std::get<Design<Dim>>(project.design);
}

template <int Dim>
Design<Dim>& designOf(Project& project) {
    return std::get<Design<Dim>>(project.design);
}

const DepthRegions& depthOf(const Project& project) {
    return project.depth;
}

DepthRegions& depthOf(Project& project) {
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
    double end =
        std::visit([](const auto& design) { return lastMotionEnd(design.handles, 1.0); }, project.design);
    for (const SettleWindow& window : project.settle) end = std::max(end, window.end);
    return end;
}

void appendSettling(Project& project, double from, double length) {
    project.settle.push_back({from, from + length});
    project.end = std::max(project.end, from + length);
}

template const Design<2>& designOf<2>(const Project&);
template const Design<3>& designOf<3>(const Project&);
template Design<2>& designOf<2>(Project&);
template Design<3>& designOf<3>(Project&);

}  // namespace wend
