#include "app/project/edits/pin_edits.h"
#include "app/project/design.h"

#include <algorithm>

namespace wend {

namespace {

int countOf(const Design& design) {
    return static_cast<int>(design.handles.size());
}

template <class Test>
std::vector<int> handlesWhere(const Design& design, Test test) {
    std::vector<int> found;
    for (int h = 0; h < countOf(design); ++h)
        if (test(h, traitsOf(design, h))) found.push_back(h);
    return found;
}

bool contains(const std::vector<int>& handles, int handle) {
    return std::find(handles.begin(), handles.end(), handle) != handles.end();
}

}  // namespace

const PinTraits& traitsOf(const Design& design, int handle) {
    return design.handles.at(static_cast<std::size_t>(handle)).traits;
}

Design withTraits(const Design& design, const std::vector<int>& handles,
                  const std::function<void(PinTraits&)>& change) {
    Design next = design;
    for (const int h : handles) change(next.handles.at(static_cast<std::size_t>(h)).traits);
    return next;
}

std::vector<int> withLinked(const Design& design, std::vector<int> handles) {
    const auto moves = [&](int h, const PinTraits& traits) {
        return contains(handles, h) ||
               (traits.link > 0 && std::any_of(handles.begin(), handles.end(), [&](int other) {
                    return traitsOf(design, other).link == traits.link;
                }));
    };
    return handlesWhere(design, moves);
}

bool isLinked(const Design& design, int handle) {
    return withLinked(design, {handle}).size() > 1;
}

Design withLink(const Design& design, const std::vector<int>& handles) {
    int maximum = 0;
    for (int h = 0; h < countOf(design); ++h) maximum = std::max(maximum, traitsOf(design, h).link);
    return withTraits(design, withLinked(design, handles),
                      [link = maximum + 1](PinTraits& traits) { traits.link = link; });
}

Design withoutLink(const Design& design, const std::vector<int>& handles) {
    const auto unlink = [](PinTraits& traits) { traits.link = 0; };
    const Design next = withTraits(design, handles, unlink);
    return withTraits(next, handlesWhere(next, [&](int h, const auto&) { return !isLinked(next, h); }),
                      unlink);
}

std::vector<std::string> groupNames(const Design& design) {
    std::vector<std::string> names;
    for (int h = 0; h < countOf(design); ++h) {
        const std::string& group = traitsOf(design, h).group;
        if (!group.empty() && std::find(names.begin(), names.end(), group) == names.end())
            names.push_back(group);
    }
    return names;
}

std::vector<int> handlesOfGroup(const Design& design, const std::string& group) {
    return handlesWhere(design, [&](int, const PinTraits& traits) { return traits.group == group; });
}

}  // namespace wend
