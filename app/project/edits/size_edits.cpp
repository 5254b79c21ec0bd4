#include "app/project/edits/size_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/project/edits/free_name.h"

namespace wend {

namespace {

constexpr double kSamePlaces = 1e-9;  // a stroke over the very same places

std::string strokeName() {
    return QCoreApplication::translate("Names", "Stroke").toStdString();
}

std::vector<int> entriesOf(const Domain& domain, int group) {
    const auto groups = sizeGroups(domain);
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

Domain withSizeStroke(const Domain& domain, const std::vector<Ball<3>>& balls, double factor) {
    Domain next = domain;
    const std::string name = freeName(namesOf(domain.sizes), strokeName());
    for (const Ball<3>& ball : balls) next.sizes.push_back({name, ball, 0.5 * ball.radius, factor});
    return next;
}

Domain withFlatSizeStroke(const Domain& domain, const std::vector<Ball<3>>& balls, double feather,
                          double factor, const std::string& part) {
    Domain next = domain;
    auto& sizes = next.sizes;
    const auto isHidden = [&](const SizeRegion& region) {
        const auto* own = std::get_if<Ball<3>>(&region.shape);
        const bool isReached = part.empty() || part == region.part;
        return own && isReached && std::ranges::any_of(balls, [&](const Ball<3>& ball) {
                   return (ball.centre - own->centre).norm() + own->radius + region.feather / 2 <=
                          (1 + kSamePlaces) * ball.radius - feather / 2;
               });
    };
    std::erase_if(sizes, isHidden);
    if (sizes.empty() && factor == 1) return next;
    const std::string name = freeName(namesOf(sizes), strokeName());
    for (const Ball<3>& ball : balls) sizes.push_back({name, ball, feather, factor, {}, part});
    return next;
}

Domain withSizeRegion(const Domain& domain, const Region<3>& shape, double factor) {
    Domain next = domain;
    next.sizes.push_back(
        {freeName(namesOf(domain.sizes), QCoreApplication::translate("Names", "Region").toStdString()), shape,
         0, factor});
    return next;
}

Domain withSizeFactor(const Domain& domain, int group, double factor) {
    Domain next = domain;
    for (const int i : entriesOf(domain, group)) next.sizes[i].factor = factor;
    return next;
}

Domain withSizeShape(const Domain& domain, int group, const Region<3>& shape, double feather) {
    Domain next = domain;
    const auto entries = entriesOf(domain, group);
    if (entries.empty()) return next;
    next.sizes[entries.front()].shape = shape;
    next.sizes[entries.front()].feather = feather;
    return next;
}

Domain withoutSizes(const Domain& domain, int group) {
    Domain next = domain;
    auto entries = entriesOf(domain, group);
    std::reverse(entries.begin(), entries.end());
    for (const int i : entries) next.sizes.erase(next.sizes.begin() + i);
    return next;
}

}  // namespace wend
