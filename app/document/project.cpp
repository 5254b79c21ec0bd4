#include "app/document/project.h"

#include <algorithm>

namespace wend {

int dimensionOf(const Project& project) {
    return project.dimension();
}

const Domain& domainOf(const Project& project) {
    return project.domain;
}

template <int Dim>
const Design<Dim>& designOf(const Project& project) {
    return std::get<Design<Dim>>(project.design);
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

void appendSettling(Project& project, double from, double length) {
    project.settle.push_back({from, from + length});
    project.end = std::max(project.end, from + length);
}

template const Design<2>& designOf<2>(const Project&);
template const Design<3>& designOf<3>(const Project&);

}  // namespace wend
