// Every instruction set that this processor has, one after the other.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace burnish_test {

/// Calls `check` with the kernels of each instruction set alone.
template <class Check>
void for_each_target(const Check& check) {
    for (int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
        const int64_t target = rest & -rest;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        SCOPED_TRACE(hwy::TargetName(target));
        check();
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
}

}  // namespace burnish_test
