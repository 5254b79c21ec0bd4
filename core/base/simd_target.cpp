#include "core/base/simd_target.h"

#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace wend {
namespace {

struct Row {
    SimdTarget target;
    std::string_view name;
    std::int64_t bit;
};

// Highway 1.0 has no target of its own for SSE2: its emulation of 128-bit vectors compiles to it.
#if HWY_ARCH_X86
constexpr std::array kRows{Row{SimdTarget::Sse2, "sse2", HWY_EMU128},
                           Row{SimdTarget::Ssse3, "ssse3", HWY_SSSE3},
                           Row{SimdTarget::Sse4, "sse4", HWY_SSE4}, Row{SimdTarget::Avx2, "avx2", HWY_AVX2},
                           Row{SimdTarget::Avx512, "avx512", HWY_AVX3}};
#else
#error "kernels have been tried on x86 only"
#endif

const Row& rowOf(SimdTarget target) {
    return kRows[static_cast<std::size_t>(target)];
}

std::vector<SimdTarget> findTargets() {
    const std::int64_t supported = hwy::SupportedTargets();
    std::vector<SimdTarget> targets{SimdTarget::Sse2};
    for (const Row& row : kRows)
        if (row.target != SimdTarget::Sse2 && (supported & row.bit) != 0) targets.push_back(row.target);
    return targets;
}

const std::vector<SimdTarget>& targets() {
    static const std::vector<SimdTarget> found = findTargets();
    return found;
}

std::string listOf(std::span<const Row> rows) {
    std::string names;
    for (const Row& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

std::string supportedNames() {
    std::vector<Row> rows;
    for (const SimdTarget target : targets()) rows.push_back(rowOf(target));
    return listOf(rows);
}

}  // namespace

std::string_view nameOf(SimdTarget target) {
    return rowOf(target).name;
}

std::optional<SimdTarget> simdTargetNamed(std::string_view name) {
    const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.name == name; });
    if (row == kRows.end()) return std::nullopt;
    return row->target;
}

std::span<const SimdTarget> supportedSimdTargets() {
    return targets();
}

SimdTarget simdTarget() {
    const std::int64_t enabled = hwy::SupportedTargets();
    const auto& supported = targets();
    const auto best = std::find_if(supported.rbegin(), supported.rend(),
                                   [&](SimdTarget target) { return (enabled & rowOf(target).bit) != 0; });
    return best == supported.rend() ? SimdTarget::Sse2 : *best;
}

void setSimdTarget(SimdTarget target) {
    const auto& supported = targets();
    if (std::find(supported.begin(), supported.end(), target) == supported.end())
        throw std::invalid_argument("this processor has no " + std::string(nameOf(target)) + " (it has " +
                                    supportedNames() + ")");
    hwy::SetSupportedTargetsForTest(rowOf(target).bit);
    hwy::GetChosenTarget().Update(rowOf(target).bit);
}

void useSimdOfEnvironment() {
    const char* name = std::getenv("WEND_SIMD");
    if (name == nullptr || *name == '\0') return;
    const std::optional<SimdTarget> target = simdTargetNamed(name);
    if (!target)
        throw std::invalid_argument("WEND_SIMD: '" + std::string(name) + "' is not an instruction set (" +
                                    listOf(kRows) + ")");
    try {
        setSimdTarget(*target);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string("WEND_SIMD: ") + error.what());
    }
}

}  // namespace wend
