// What travels through a run: rows of one frame, first read, then shaded, then written.
#pragma once

#include <burnish/base/error.h>
#include <burnish/job/run_frame.h>

#include <cstddef>
#include <exception>
#include <optional>

namespace burnish {

struct Band {
    size_t task = 0;  // index of its frame among the tasks
    bool is_last = false;
    bool is_skipped = false;       // its frame's output is there already
    Window whole;                  // data window of its frame
    AovFrame frame;                // the rows
    std::optional<AovFrame> fine;  // their samples, where the job has finer AOVs
    FrameResult result;
    NamedValues<double> seconds;
    std::exception_ptr failure;  // what went wrong on the way; to be told when its turn to be written comes
    bool is_run_over = false;    // ... and it was no fault of the frame's
};

/// Whether a run goes on past a frame that ended with this error.
inline bool is_passed_over(const Job& job, const Error& error) {
    const ErrorCode code = error.code();
    const bool is_frames_fault =
        code == ErrorCode::read_failed || code == ErrorCode::missing_channel || code == ErrorCode::size_mismatch;
    return job.bad_frames == BadFrames::skip && is_frames_fault;
}

}  // namespace burnish
