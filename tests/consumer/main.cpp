// Uses an installed burnish as a stranger would: one umbrella header, a job, an error to catch.
#include <burnish/burnish.h>

#include <cstdio>

int main() {
    burnish::Job job;
    job.aovs = "absent.exr", job.environment = "absent.hdr", job.material = "chrome", job.output.file = "out.exr";
    try {
        burnish::run(job, burnish::Progress());
    } catch (const burnish::Error& error) {
        std::printf("burnish %s: %s\n", std::string(burnish::version()).c_str(), error.what());
        return error.code() == burnish::ErrorCode::read_failed ? 0 : 1;
    }
    return 1;
}
