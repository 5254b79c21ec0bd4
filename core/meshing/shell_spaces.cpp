#include "core/meshing/shell_spaces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "core/base/disjoint_sets.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

/// Returns for every space whether it is reached from the outside through walls of other shells only.
std::vector<bool> reachedWithout(int shell, int count, const std::vector<SpaceWall>& walls) {
    DisjointSets sets(count + 1);  // the last is the outside
    const auto place = [count](int space) { return space < 0 ? count : space; };
    for (const SpaceWall& wall : walls)
        if (wall.shell != shell) sets.join(place(wall.spaces[0]), place(wall.spaces[1]));
    std::vector<bool> reached;
    for (int space = 0; space < count; ++space) reached.push_back(sets.root(space) == sets.root(count));
    return reached;
}

/// Returns a wall of each kind of neighbourhood: the same spaces and the same shell.
std::vector<SpaceWall> kindsOf(const std::vector<SpaceWall>& walls) {
    std::set<std::array<int, 3>> known;
    std::vector<SpaceWall> kinds;
    for (const SpaceWall& wall : walls) {
        const auto [low, high] = std::minmax(wall.spaces[0], wall.spaces[1]);
        if (known.insert({low, high, wall.shell}).second) kinds.push_back(wall);
    }
    return kinds;
}

/// Counts the shells around each space: those whose walls every path from outside to it crosses. If every
/// wall has the outside on one side, no shell is in another and nothing needs to be searched.
void findDepths(const std::vector<SpaceWall>& allWalls, std::vector<ShellSpace>& spaces) {
    const std::vector<SpaceWall> walls = kindsOf(allWalls);
    const bool areApart = std::ranges::all_of(
        walls, [](const SpaceWall& wall) { return std::ranges::count(wall.spaces, -1) > 0; });
    if (areApart) {
        for (const SpaceWall& wall : walls)
            if (const int space = std::ranges::max(wall.spaces); space >= 0)
                spaces[static_cast<std::size_t>(space)] = {wall.shell, 1, false, 0};
        return;
    }
    std::set<int> shells;
    for (const SpaceWall& wall : walls) shells.insert(wall.shell);
    const int count = static_cast<int>(spaces.size());
    std::map<int, std::vector<bool>> reached;
    for (const int shell : shells) reached[shell] = reachedWithout(shell, count, walls);
    for (int space = 0; space < count; ++space)
        for (const auto& [shell, from] : reached)
            spaces[static_cast<std::size_t>(space)].depth += !from[static_cast<std::size_t>(space)];
    // The innermost shell is around the fewest spaces; it has a wall at the space itself.
    for (int space = 0; space < count; ++space) {
        auto fewest = std::numeric_limits<std::ptrdiff_t>::max();
        for (const auto& [shell, from] : reached) {
            if (from[static_cast<std::size_t>(space)]) continue;
            const auto around = std::ranges::count(from, false);
            if (around < fewest) spaces[static_cast<std::size_t>(space)].shell = shell;
            fewest = std::min(fewest, around);
        }
    }
}

/// Returns the spaces that are filled, by their shells and the vertices of their walls.
std::vector<int> inOrder(const std::vector<SpaceWall>& walls, const std::vector<ShellSpace>& spaces) {
    std::vector<std::array<int, 3>> keys;
    for (const ShellSpace& space : spaces) keys.push_back({space.shell, std::numeric_limits<int>::max(), -1});
    for (const SpaceWall& wall : walls)
        for (const int space : wall.spaces) {
            if (space < 0 || spaces[static_cast<std::size_t>(space)].shell != wall.shell) continue;
            auto& key = keys[static_cast<std::size_t>(space)];
            key[1] = std::min(key[1], *std::ranges::min_element(wall.vertices));
            key[2] = std::max(key[2], *std::ranges::max_element(wall.vertices));
        }
    std::vector<int> order(spaces.size());
    std::iota(order.begin(), order.end(), 0);
    std::erase_if(order, [&](int space) { return !spaces[static_cast<std::size_t>(space)].kept; });
    std::ranges::stable_sort(order, {}, [&](int space) { return keys[static_cast<std::size_t>(space)]; });
    return order;
}

/// Keeps of `common` what is in `labels`, too.
void intersect(std::vector<int>& common, bool& isFirst, const std::vector<int>& labels) {
    if (isFirst) common = labels;
    isFirst = false;
    std::erase_if(common, [&](int label) { return std::ranges::count(labels, label) == 0; });
}

/// Returns the label that all walls of a space have: those to the outside of its shell if there are any. 0 if
/// there is none, or more than one.
int commonLabel(int space, const std::vector<SpaceWall>& walls, const std::vector<ShellSpace>& spaces) {
    const int shell = spaces[static_cast<std::size_t>(space)].shell;
    std::vector<int> outer, all;
    bool isFirstOuter = true, isFirst = true;
    for (const SpaceWall& wall : walls) {
        if (wall.shell != shell || std::ranges::count(wall.spaces, space) == 0) continue;
        const int other = wall.spaces[0] == space ? wall.spaces[1] : wall.spaces[0];
        const bool isInner = other >= 0 && spaces[static_cast<std::size_t>(other)].shell == shell;
        if (!isInner) intersect(outer, isFirstOuter, wall.labels);
        intersect(all, isFirst, wall.labels);
    }
    const std::vector<int>& common = !all.empty() || isFirstOuter ? all : outer;
    return common.size() == 1 ? common.front() : 0;
}

void label(const std::vector<SpaceWall>& walls, const std::vector<std::string>& labelNames,
           ShellSpaces& result) {
    std::map<std::string, int> uses;
    for (const int space : inOrder(walls, result.spaces)) {
        const int own = commonLabel(space, walls, result.spaces);
        const bool hasName = own > 0 && own <= static_cast<int>(labelNames.size());
        result.names.push_back(hasName ? labelNames[static_cast<std::size_t>(own) - 1] : "");
        ++uses[result.names.back()];
        result.spaces[static_cast<std::size_t>(space)].label = static_cast<int>(result.names.size());
    }
    for (std::string& name : result.names)
        if (uses[name] > 1) name.clear();
}

}  // namespace

std::vector<int> shellsOf(const std::vector<std::array<int, 3>>& triangles, int vertices) {
    const Surface surface{Points3::Zero(3, vertices), triangles, {}};
    DisjointSets sets(surface.triangleCount());
    for (const SurfaceEdge& edge : edgesOf(surface))
        for (const int t : edge.triangles) sets.join(t, edge.triangles.front());
    std::map<int, int> numbers;
    std::vector<int> shells;
    for (int t = 0; t < surface.triangleCount(); ++t)
        shells.push_back(numbers.try_emplace(sets.root(t), static_cast<int>(numbers.size())).first->second);
    return shells;
}

int ShellSpaces::filled() const {
    return static_cast<int>(std::ranges::count_if(spaces, &ShellSpace::kept));
}

int ShellSpaces::deepest() const {
    int depth = 0;
    for (const ShellSpace& space : spaces) depth = std::max(depth, space.depth);
    return depth;
}

bool ShellSpaces::shareWalls() const {
    std::set<int> shells;
    return std::ranges::any_of(spaces,
                               [&](const ShellSpace& space) { return !shells.insert(space.shell).second; });
}

Message ShellSpaces::summary() const {
    const int hollow = static_cast<int>(spaces.size()) - filled();
    if (deepest() <= 1) {
        if (!shareWalls()) return {};
        return {sentence("Core", "bodies touch along shared walls; spaces filled: %1, hollow: %2"), filled(),
                hollow};
    }
    return {
        shareWalls()
            ? sentence("Core",
                       "shells lie one in the other, up to %1 deep, and bodies touch along shared walls; "
                       "spaces filled: %2, hollow: %3")
            : sentence("Core", "shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3"),
        deepest(), filled(), hollow};
}

ShellSpaces shellSpaces(int count, const std::vector<SpaceWall>& walls, Shells choice,
                        const std::vector<std::string>& labelNames) {
    ShellSpaces result;
    result.spaces.resize(static_cast<std::size_t>(count));
    findDepths(walls, result.spaces);
    for (ShellSpace& space : result.spaces)
        space.kept = choice == Shells::Regions ? space.depth > 0 : space.depth % 2 == 1;
    label(walls, labelNames, result);
    return result;
}

}  // namespace wend
