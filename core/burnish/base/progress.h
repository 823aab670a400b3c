// Progress and cancellation of long work, one path for every face: Ctrl-C, Esc and a callback that returns false all end
// as Error(cancelled), thrown by the thread that called the long function.
#pragma once

#include <burnish/base/error.h>

#include <functional>
#include <string>

namespace burnish {

class Progress {
public:
    /// Called with (stage, done in [0, 1]); returning false cancels. Calls come one at a time, from any thread.
    using Callback = std::function<bool(const std::string& stage, float done)>;

    Progress() = default;
    explicit Progress(Callback callback) : m_callback(std::move(callback)) {}

    /// Reports; throws Error(cancelled) when the callback asks to stop.
    void report(const std::string& stage, float done) const {
        if (m_callback && !m_callback(stage, done)) throw Error(ErrorCode::cancelled, "cancelled during " + stage);
    }

private:
    Callback m_callback;
};

/// Progress of a part of something larger: [0, 1] of the part is [begin, end] of the whole.
inline Progress part_of(const Progress& whole, float begin, float end) {
    return Progress([whole, begin, end](const std::string& stage, float done) {
        whole.report(stage, begin + (end - begin) * done);
        return true;
    });
}

}  // namespace burnish
