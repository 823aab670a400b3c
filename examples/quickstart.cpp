// The quickstart in C++. Argument: the folder `burnish demo` wrote (default: demo).
#include <burnish/burnish.h>

#include <cstdio>

int main(int argc, char** argv) {
    const std::string demo = argc > 1 ? argv[1] : "demo";

    burnish::Job job;
    job.aovs = demo + "/shot.exr";
    job.environment = demo + "/sky.exr";
    job.light.up = burnish::UpAxis::z;
    burnish::AssignRule& rule = job.assign.emplace_back();
    rule.material = "gold", rule.cryptomatte = "ball_*";
    job.output.file = demo + "/quickstart_cpp.exr";

    try {
        const burnish::Report report = burnish::run(job, burnish::Progress());
        std::printf("%s\n", burnish::summary(report.frames.front()).c_str());
    } catch (const burnish::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return burnish::exit_code(error.code());
    }
}
