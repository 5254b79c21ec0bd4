#pragma once

#include <QTest>

#include "core/base/simd_target.h"

namespace wend::test {

/// Runs `check` on every SIMD target of this processor, least first, until a check fails; then restores the
/// best target.
template <class Check>
void onEveryTarget(Check check) {
    for (const SimdTarget target : supportedSimdTargets()) {
        setSimdTarget(target);
        check(target);
        if (!QTest::currentTestFailed()) continue;
        qWarning("on the target %s", std::string(nameOf(target)).c_str());
        break;
    }
    setSimdTarget(supportedSimdTargets().back());
}

}  // namespace wend::test
