#include "app/document/pin_edits.h"
#include "app/document/project.h"

#include <algorithm>

namespace wend {

namespace {

HandleTraits& traitsIn(Project& project, int handle) {
    return std::visit([handle](auto& design) -> HandleTraits& { return design.handles.at(handle).traits; },
                      project.design);
}

int countOf(const Project& project) {
    return static_cast<int>(
        std::visit([](const auto& design) { return design.handles.size(); }, project.design));
}

template <class Test>
std::vector<int> handlesWhere(const Project& project, Test test) {
    std::vector<int> found;
    for (int h = 0; h < countOf(project); ++h)
        if (test(h, traitsOf(project, h))) found.push_back(h);
    return found;
}

bool contains(const std::vector<int>& handles, int handle) {
    return std::find(handles.begin(), handles.end(), handle) != handles.end();
}

}  // namespace

const HandleTraits& traitsOf(const Project& project, int handle) {
    return std::visit(
        [handle](const auto& design) -> const HandleTraits& { return design.handles.at(handle).traits; },
        project.design);
}

Project withTraits(const Project& project, const std::vector<int>& handles,
                   const std::function<void(HandleTraits&)>& change) {
    Project next = project;
    for (const int h : handles) change(traitsIn(next, h));
    return next;
}

std::vector<int> withLinked(const Project& project, std::vector<int> handles) {
    const auto moves = [&](int h, const HandleTraits& traits) {
        return contains(handles, h) ||
               (traits.link > 0 && std::any_of(handles.begin(), handles.end(), [&](int other) {
                    return traitsOf(project, other).link == traits.link;
                }));
    };
    return handlesWhere(project, moves);
}

bool isLinked(const Project& project, int handle) {
    return withLinked(project, {handle}).size() > 1;
}

Project withLink(const Project& project, const std::vector<int>& handles) {
    int maximum = 0;
    for (int h = 0; h < countOf(project); ++h) maximum = std::max(maximum, traitsOf(project, h).link);
    return withTraits(project, withLinked(project, handles),
                      [link = maximum + 1](HandleTraits& traits) { traits.link = link; });
}

Project withoutLink(const Project& project, const std::vector<int>& handles) {
    const auto unlink = [](HandleTraits& traits) { traits.link = 0; };
    const Project next = withTraits(project, handles, unlink);
    return withTraits(next, handlesWhere(next, [&](int h, const auto&) { return !isLinked(next, h); }),
                      unlink);
}

std::vector<std::string> groupNames(const Project& project) {
    std::vector<std::string> names;
    for (int h = 0; h < countOf(project); ++h) {
        const std::string& group = traitsOf(project, h).group;
        if (!group.empty() && std::find(names.begin(), names.end(), group) == names.end())
            names.push_back(group);
    }
    return names;
}

std::vector<int> handlesOfGroup(const Project& project, const std::string& group) {
    return handlesWhere(project, [&](int, const HandleTraits& traits) { return traits.group == group; });
}

}  // namespace wend
