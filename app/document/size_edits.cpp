#include "app/document/size_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/document/free_name.h"
#include "app/document/project.h"

namespace wend {

namespace {

constexpr double kSame = 1e-9;  // a stroke over the very same places

std::string strokeName() {
    return QCoreApplication::translate("Names", "Stroke").toStdString();
}

std::vector<int> entriesOf(const Project& project, int group) {
    const auto groups = sizeGroups(project.domain);
    return group >= 0 && group < static_cast<int>(groups.size()) ? groups[group].entries : std::vector<int>();
}

}  // namespace

std::vector<SizeGroup> sizeGroups(const Domain& domain) {
    std::vector<SizeGroup> groups;
    for (const std::vector<int>& entries : placesByName(domain.sizes)) {
        const SizeRegion& first = domain.sizes[entries.front()];
        groups.push_back({first.name, entries, first});
    }
    return groups;
}

Project withSizeStroke(const Project& project, const std::vector<Ball<3>>& balls, double factor) {
    Project next = project;
    const std::string name = freeName(namesOf(project.domain.sizes), strokeName());
    for (const Ball<3>& ball : balls) next.domain.sizes.push_back({name, ball, 0.5 * ball.radius, factor});
    return next;
}

Project withFlatSizeStroke(const Project& project, const std::vector<Ball<2>>& balls, double feather,
                           double factor) {
    Project next = project;
    auto& sizes = next.domain.flatSizes;
    const auto isHidden = [&](const SizeRegionIn<2>& region) {
        const auto* own = std::get_if<Ball<2>>(&region.shape);
        return own && std::ranges::any_of(balls, [&](const Ball<2>& ball) {
                   return (ball.centre - own->centre).norm() + own->radius + region.feather / 2 <=
                          (1 + kSame) * ball.radius - feather / 2;
               });
    };
    std::erase_if(sizes, isHidden);
    if (sizes.empty() && factor == 1) return next;
    const std::string name = freeName(namesOf(sizes), strokeName());
    for (const Ball<2>& ball : balls) sizes.push_back({name, ball, feather, factor});
    return next;
}

Project withSizeRegion(const Project& project, const Region<3>& shape, double factor) {
    Project next = project;
    next.domain.sizes.push_back({freeName(namesOf(project.domain.sizes),
                                          QCoreApplication::translate("Names", "Region").toStdString()),
                                 shape, 0, factor});
    return next;
}

Project withSizeFactor(const Project& project, int group, double factor) {
    Project next = project;
    for (const int i : entriesOf(project, group)) next.domain.sizes[i].factor = factor;
    return next;
}

Project withSizeShape(const Project& project, int group, const Region<3>& shape, double feather) {
    Project next = project;
    const auto entries = entriesOf(project, group);
    if (entries.empty()) return next;
    next.domain.sizes[entries.front()].shape = shape;
    next.domain.sizes[entries.front()].feather = feather;
    return next;
}

Project withoutSizes(const Project& project, int group) {
    Project next = project;
    auto entries = entriesOf(project, group);
    std::reverse(entries.begin(), entries.end());
    for (const int i : entries) next.domain.sizes.erase(next.domain.sizes.begin() + i);
    return next;
}

}  // namespace wend
