// A job on the command line: the frame or shot file, and one option per setting. For every command that runs jobs.
#pragma once

#include <burnish/job/job.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace burnish::cli {

struct JobOptions {
    std::string input;  // EXR, EXR pattern or shot file
    nlohmann::json values = nlohmann::json::object();
    std::string progress = "auto";
    bool quiet = false, as_json = false;
};

/// Adds AOVS, the settings' options, --progress, --quiet and --json; `options` must outlive the parsing.
void add_job_options(CLI::App& command, JobOptions& options);

/// The shot file's job with the flags over it; repeatable flags add to what the shot file has. Throws Error.
Job make_job(const JobOptions& options);

}  // namespace burnish::cli
