#include <burnish/job/flow_progress.h>

#include <algorithm>

namespace burnish {

Progress FlowProgress::of(FlowStage stage) {
    return Progress([this, stage](const std::string& name, float done) {
        report(stage, name, done);
        return true;
    });
}

void FlowProgress::stop(std::exception_ptr reason) {
    const std::lock_guard lock(m_mutex);
    if (!m_reason) m_reason = std::move(reason);
}

void FlowProgress::rethrow() const {
    if (m_reason) std::rethrow_exception(m_reason);
}

void FlowProgress::report(FlowStage stage, const std::string& name, float done) {
    constexpr std::array<float, 3> kShare = {0.1f, 0.8f, 0.1f};
    const std::lock_guard lock(m_mutex);
    if (m_reason) throw Error(ErrorCode::cancelled, "stopped during " + name);
    float& own = m_done[static_cast<size_t>(stage)];
    own = std::max(own, done);
    const float sum = kShare[0] * m_done[0] + kShare[1] * m_done[1] + kShare[2] * m_done[2];
    try {
        m_whole.report(name, std::min(sum, 1.0f));
    } catch (...) {
        m_reason = std::current_exception();
        throw;
    }
}

}  // namespace burnish
