// One progress for stages that run at the same time: it rises whoever reports, and a stop ends them all.
#pragma once

#include <burnish/base/progress.h>

#include <array>
#include <exception>
#include <mutex>

namespace burnish {

enum class FlowStage { read, shade, write };

class FlowProgress {
public:
    /// `whole` must outlive this.
    explicit FlowProgress(const Progress& whole) : m_whole(whole) {}

    /// Progress of one stage, 1 when it is through with every frame. Must not outlive this.
    Progress of(FlowStage stage);
    /// From here on every stage that reports ends with Error(cancelled). The first reason counts.
    void stop(std::exception_ptr reason);
    /// Throws the reason of a stop, if there was one.
    void rethrow() const;

private:
    void report(FlowStage stage, const std::string& name, float done);

    const Progress& m_whole;
    std::mutex m_mutex;
    std::array<float, 3> m_done{};
    std::exception_ptr m_reason;
};

}  // namespace burnish
