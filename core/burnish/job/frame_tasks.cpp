#include <burnish/job/frame_tasks.h>

#include <burnish/base/error.h>
#include <burnish/input/frames.h>

#include <filesystem>

namespace burnish {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::bad_argument, message); }

void expect_extension(const std::string& setting, const std::string& file, const std::string& extension) {
    if (!file.empty() && std::filesystem::path(file).extension() != extension)
        refuse(setting + ": expected a file that ends in " + extension + ", found '" + file + "'");
}

void check_files(const Job& job) {
    if (job.aovs.empty()) refuse("no frame: name the EXR with the AOVs");
    if (job.output.file.empty()) refuse("no output: name the EXR to write with -o FILE (shot file: output.file)");
    expect_extension("output", job.output.file, ".exr");
    expect_extension("preview", job.output.preview, ".png");
    std::error_code none;
    if (job.output.file == job.fine_aovs)
        refuse("output: '" + job.output.file + "' holds the fine AOVs; write to another file");
    if (job.output.file == job.aovs || std::filesystem::equivalent(job.output.file, job.aovs, none))
        refuse("output: '" + job.output.file + "' is the frame itself; write to another file");
}

std::vector<int> frame_numbers(const Job& job) {
    if (!job.frames.empty()) return parse_frames(job.frames);
    const std::vector<int> found = frames_on_disk(job.aovs);
    if (found.empty()) throw Error(ErrorCode::read_failed, job.aovs + ": no file fits this pattern");
    return found;
}

/// A target must tell frames apart when there are several.
std::string target(const std::string& setting, const std::string& pattern, int frame, size_t count) {
    if (has_frame_token(pattern)) return frame_file(pattern, frame);
    if (count > 1 && !pattern.empty())
        refuse(setting + ": " + std::to_string(count) + " frames would all be written to '" + pattern +
               "'; put #### where the number goes");
    return pattern;
}

/// A camera may be the same for all frames, and so may what it sees.
std::string source(const std::string& pattern, int frame) {
    return has_frame_token(pattern) && !pattern.starts_with('{') ? frame_file(pattern, frame) : pattern;
}

}  // namespace

bool is_up_to_date(const FrameTask& task) {
    std::error_code none;
    const auto written = std::filesystem::last_write_time(task.output, none);
    const auto is_older = [&](const std::string& input) {
        return !none && written > std::filesystem::last_write_time(input, none) && !none;
    };
    return is_older(task.aovs) && (task.fine_aovs.empty() || is_older(task.fine_aovs));
}

std::vector<FrameTask> frame_tasks(const Job& job) {
    check_files(job);
    if (!has_frame_token(job.aovs)) {
        if (!job.frames.empty()) refuse("frames: '" + job.aovs + "' names one file; put #### where the frame number goes");
        return {{{}, job.aovs, job.fine_aovs, job.camera, job.output.file, job.output.preview}};
    }
    const std::vector<int> numbers = frame_numbers(job);
    std::vector<FrameTask> tasks;
    for (const int n : numbers)
        tasks.push_back({n, frame_file(job.aovs, n), source(job.fine_aovs, n), source(job.camera, n),
                         target("output", job.output.file, n, numbers.size()),
                         target("preview", job.output.preview, n, numbers.size())});
    return tasks;
}

}  // namespace burnish
