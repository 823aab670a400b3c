// Wall time and progress of the stages of a run.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/output/report.h>

#include <chrono>
#include <string>
#include <utility>

namespace burnish {

/// Adds to the time of `stage`, which comes last when it is new.
inline void add_seconds(NamedValues<double>& seconds, const std::string& stage, double elapsed) {
    for (auto& [name, sum] : seconds)
        if (name == stage) {
            sum += elapsed;
            return;
        }
    seconds.emplace_back(stage, elapsed);
}

/// Runs `work`, adds its wall time in seconds under `stage` and hands its result on.
template <class Work>
auto timed(NamedValues<double>& seconds, const std::string& stage, Work&& work) {
    struct Stopwatch {
        NamedValues<double>& seconds;
        const std::string& stage;
        std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
        ~Stopwatch() {
            const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
            add_seconds(seconds, stage, elapsed.count());
        }
    } stopwatch{seconds, stage};
    return std::forward<Work>(work)();
}

}  // namespace burnish
