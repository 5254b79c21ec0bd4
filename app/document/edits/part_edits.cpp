#include "app/document/edits/part_edits.h"

#include <algorithm>

#include "app/document/design.h"
#include "app/document/domain.h"

namespace wend {

std::vector<PicturePart> withPartMoved(std::vector<PicturePart> parts, int from, int to) {
    const auto begin = parts.begin();
    if (from < to)
        std::rotate(begin + from, begin + from + 1, begin + to + 1);
    else
        std::rotate(begin + to, begin + from, begin + from + 1);
    return parts;
}

std::shared_ptr<const Project> withPartName(const Project& project, int part, const std::string& name) {
    auto next = copyOf(project);
    std::vector<PicturePart>& parts = domainOf(*next).parts;
    const std::string before = parts.at(static_cast<std::size_t>(part)).name;
    const auto rename = [&](std::string& reference) {
        if (reference == before) reference = name;
    };
    for (PicturePart& one : parts) {
        rename(one.name);
        rename(one.cutFrom);
        rename(one.ridesOn);
        for (Joint& joint : one.joints) rename(joint.to);
    }
    for (Handle<2>& handle : designOf<2>(*next).handles) rename(handle.part);
    return next;
}

std::shared_ptr<const Project> withoutParts(const Project& project, const std::string& path) {
    auto next = copyOf(project);
    domainOf(*next).parts.clear();
    domainOf(*next).path = path;
    for (Handle<2>& handle : designOf<2>(*next).handles) handle.part.clear();
    return next;
}

bool mayRide(const std::vector<PicturePart>& parts, int part, int on) {
    const PicturePart& rider = parts.at(static_cast<std::size_t>(part));
    const auto isJoined = [&](const PicturePart& other) {
        return std::ranges::any_of(other.joints, [&](const Joint& joint) { return joint.to == rider.name; });
    };
    if (!rider.joints.empty() || std::ranges::any_of(parts, isJoined)) return false;
    const PicturePart* host = &parts.at(static_cast<std::size_t>(on));
    while (host != &rider && !host->ridesOn.empty())
        host = &*std::ranges::find(parts, host->ridesOn, &PicturePart::name);
    return host != &rider;
}

}  // namespace wend
