#include "job_options.h"

#include "progress_display.h"
#include "setting_options.h"

#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>

namespace burnish::cli {

void add_job_options(CLI::App& command, JobOptions& options) {
    command.add_option("AOVS", options.input, "an EXR, an EXR pattern (shot.####.exr) or a shot file (.json)")->required();
    add_setting_options(command, options.values);
    command.add_option("--progress", options.progress, "auto|none|text|alf|json|openjd, on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command.add_flag("-q,--quiet", options.quiet, "print errors only");
    command.add_flag("--json", options.as_json, "print the report as JSON");
}

Job make_job(const JobOptions& options) {
    Job job;
    if (options.input.ends_with(".json"))
        job = read_shot_file(options.input);
    else
        job.aovs = options.input;
    nlohmann::json values = options.values;
    for (const Setting& setting : settings()) {
        const std::string name(setting.name);
        if (!setting.repeatable() || !values.contains(name)) continue;
        nlohmann::json held = setting.get(job);
        merge(held, values[name]);
        values[name] = std::move(held);
    }
    set_settings(job, values, "");
    return job;
}

}  // namespace burnish::cli
