#include <burnish/job/frame_tasks.h>

#include <burnish/base/error.h>
#include <burnish/input/frames.h>
#include <burnish/input/views.h>

#include <filesystem>

namespace burnish {
namespace {

constexpr const char* kFileViews[] = {"left", "right"};  // of frames whose names hold %V

bool is_of_files(const std::string& view) { return !view.empty() && view != kAllViews; }

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

using FrameNumber = std::optional<int>;  // nothing: the job has no frame pattern

std::vector<FrameNumber> frame_numbers(const Job& job) {
    if (!has_frame_token(job.aovs)) {
        if (!job.frames.empty()) refuse("frames: '" + job.aovs + "' names one file; put #### where the frame number goes");
        return {FrameNumber{}};
    }
    const std::string pattern = view_file(job.aovs, is_of_files(job.view) ? job.view : kFileViews[0]);
    const std::vector<int> numbers = job.frames.empty() ? frames_on_disk(pattern) : parse_frames(job.frames);
    if (numbers.empty()) throw Error(ErrorCode::read_failed, job.aovs + ": no file fits this pattern");
    return {numbers.begin(), numbers.end()};
}

/// The file of a frame, where each has its own: a camera may be the same for all, and so may what it sees.
std::string source(const std::string& pattern, FrameNumber frame) {
    return frame && has_frame_token(pattern) && !pattern.starts_with('{') ? frame_file(pattern, *frame) : pattern;
}

/// A target must tell frames apart when there are several.
std::string target(const std::string& setting, const std::string& pattern, FrameNumber frame, size_t count) {
    if (count > 1 && !pattern.empty() && !has_frame_token(pattern))
        refuse(setting + ": " + std::to_string(count) + " frames would all be written to '" + pattern +
               "'; put #### where the number goes");
    return source(pattern, frame);
}

/// Those of the first frame that can be read; {""}: there is one only.
std::vector<std::string> all_views(const Job& job, const std::vector<FrameNumber>& frames) {
    for (const FrameNumber frame : frames) {
        try {
            const std::vector<std::string> views = views_of_file(source(job.aovs, frame)).names;
            return views.empty() ? std::vector<std::string>{""} : views;
        } catch (const Error& error) {
            if (error.code() != ErrorCode::read_failed) throw;  // its own turn tells
        }
    }
    return {""};
}

std::vector<std::string> views_of_job(const Job& job, const std::vector<FrameNumber>& frames) {
    const bool all = job.view == kAllViews;
    if (has_view_token(job.aovs)) {
        if (all) return {std::begin(kFileViews), std::end(kFileViews)};
        return {job.view.empty() ? kFileViews[0] : job.view};
    }
    return all ? all_views(job, frames) : std::vector{job.view};
}

void check_views(const Job& job, const std::vector<std::string>& views) {
    if (views.size() > 1 && !job.camera.empty() && !has_view_token(job.camera))
        refuse("camera: " + std::to_string(views.size()) +
               " views would all be seen by one camera; put %V where the view's name goes, or leave it to the frame");
    for (const std::string* file : {&job.output.file, &job.output.preview})
        if (views.front().empty() && has_view_token(*file))
            refuse("output: '" + *file + "' names a view, and none is chosen; add --view NAME or --view all");
}

/// Preview: one picture will do, that of the first view, where the name tells none.
FrameTask task_of(const Job& job, FrameNumber frame, size_t frames, const std::vector<std::string>& views, size_t i) {
    const std::string& view = views[i];
    const auto of_view = [&](const std::string& file) { return file.starts_with('{') ? file : view_file(file, view); };
    FrameTask task{frame,
                   of_view(source(job.aovs, frame)),
                   of_view(source(job.fine_aovs, frame)),
                   of_view(source(job.camera, frame)),
                   of_view(target("output", job.output.file, frame, frames)),
                   of_view(target("preview", job.output.preview, frame, frames)),
                   view};
    if (!has_view_token(job.aovs)) task.view_in_file = view;
    if (i > 0 && !has_view_token(job.output.preview)) task.preview.clear();
    if (!has_view_token(job.output.file)) task.views = views.size(), task.is_last_view = i + 1 == views.size();
    return task;
}

}  // namespace

std::vector<FrameTask> frame_tasks(const Job& job) {
    check_files(job);
    const std::vector<FrameNumber> frames = frame_numbers(job);
    const std::vector<std::string> views = views_of_job(job, frames);
    check_views(job, views);
    std::vector<FrameTask> tasks;
    for (const FrameNumber frame : frames)
        for (size_t i = 0; i < views.size(); ++i) tasks.push_back(task_of(job, frame, frames.size(), views, i));
    return tasks;
}

}  // namespace burnish
