#pragma once

#include <limits>
#include <type_traits>

#include "app/project/options/options.h"
#include "app/project/project.h"

/// The parts from which the records of the option table are built.
namespace wend::option_parts {

// --- Accessors ---

/// Accesses what `At` finds in a project.
template <class At>
constexpr Accessor at(At) {
    return {[](const Project& project) { return static_cast<double>(At{}(project)); },
            [](Project& project, double value) {
                auto& found = At{}(project);
                found = static_cast<std::remove_cvref_t<decltype(found)>>(value);
            }};
}

/// Accesses what `At` finds in the material of the whole shape.
template <class At>
constexpr Accessor inMaterial(At) {
    return at([](auto& project) -> auto& { return At{}(project.design.material); });
}

#define AT(member) at([](auto& project) -> auto& { return project.member; })
#define IN_MATERIAL(member) inMaterial([](auto& material) -> auto& { return material.member; })

/// A cut-out whose holes are filled is a choice of its own in the window.
constexpr Accessor kOutline{
    [](const Project& project) {
        const Domain& domain = project.domain;
        const bool isFilled =
            domain.outline == OutlineKind::Alpha && domain.alpha.holes == OutlineHoles::Filled;
        return isFilled ? double(kFilledCutOut) : static_cast<double>(domain.outline);
    },
    [](Project& project, double value) {
        const bool isFilled = value == kFilledCutOut;
        project.domain.outline = isFilled ? OutlineKind::Alpha : static_cast<OutlineKind>(value);
        project.domain.alpha.holes = isFilled ? OutlineHoles::Filled : OutlineHoles::Kept;
    }};

/// Accesses the aimed number of vertices. Setting it clears the edge length.
constexpr Accessor kAim{[](const Project& project) { return static_cast<double>(project.domain.vertices); },
                        [](Project& project, double value) {
                            project.domain.vertices = static_cast<int>(value);
                            project.domain.edge = project.domain.maxVolume = 0;
                        }};

/// A length of 0 is no smoothing.
constexpr Accessor kSmoothing{[](const Project& project) {
                                  const Smoothing& smoothing = project.design.material.smoothing;
                                  return smoothing.kind == SmoothingKind::None ? 0 : smoothing.length;
                              },
                              [](Project& project, double value) {
                                  Smoothing& smoothing = project.design.material.smoothing;
                                  smoothing.kind = value > 0 ? SmoothingKind::Invariant : SmoothingKind::None;
                                  if (value > 0) smoothing.length = value;
                              }};

// --- Which projects have them ---

template <DomainKind... Kinds>
constexpr bool hasDomain(const Project& project) {
    return ((project.domain.kind == Kinds) || ...);
}

template <SmoothingKind Kind>
bool smooths(const Project& project) {
    return project.design.material.smoothing.kind == Kind;
}

constexpr Scope kPicture{hasDomain<DomainKind::Image>, "pictures"};
constexpr Scope kFlat{hasDomain<DomainKind::Image>, "pictures and outlines"};
constexpr Scope kSurface{hasDomain<DomainKind::Surface>, "closed surfaces"};
constexpr Scope kAnySurface{hasDomain<DomainKind::Surface>, "surfaces"};
constexpr Scope kMeshed{hasDomain<DomainKind::Image, DomainKind::Surface>,
                        "pictures, outlines and closed surfaces"};
constexpr Scope kCutOut{[](const Project& project) {
                            return hasDomain<DomainKind::Image>(project) &&
                                   project.domain.outline == OutlineKind::Alpha;
                        },
                        "pictures with --outline alpha"};
constexpr Scope kSolid{[](const Project& project) { return project.dimension() == 3; }, "solids"};
constexpr Scope kInvariant{smooths<SmoothingKind::Invariant>, "smoothing of the invariant kind"};
constexpr Scope kPaper{smooths<SmoothingKind::Paper>, "smoothing as in the paper"};

// --- What they may be ---

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kAny{}, kPart{0, 1}, kOrder{-1000, 1000}, kLink{1, 1e6}, kPositive{0, kInfinity, true, true},
    kNotNegative{0, kInfinity, false, true}, kVertices{3, 1e7}, kHundred{0, 100}, kQuality{1.2, 10},
    kRatio{1, 1e6}, kTolerance{1e-12, 0.1}, kSteps{0, 1e6}, kSmallestStep{0, 0.1, true, false},
    kFrames{2, 1e6}, kThreads{0, 1024}, kRepeats{1, 1000}, kHole{0, 1e6}, kFactor{0.01, 100},
    kPercent{1, 1000}, kWidth{1, 1e5}, kDetail{0.05, 1000}, kOffset{0, 10}, kOpenUnit{0, 1, true, true},
    kUnitAboveZero{0, 1, true, false};

}  // namespace wend::option_parts
