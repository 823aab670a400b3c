#include <burnish/job/job_hash.h>

#include <burnish/base/sha256.h>
#include <burnish/job/settings.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

namespace burnish {
namespace {

constexpr std::array<std::string_view, 7> kNoPixels{"frames", "bad_frames",    "output", "preview",
                                                    "report", "skip_existing", "threads"};

bool names_space(const ColorSpaces& spaces) {
    return !spaces.beauty.empty() || !spaces.environment.empty() || !spaces.output.empty();
}

}  // namespace

std::string job_hash(const Job& job, const std::string& kind) {
    nlohmann::json document = {{"burnish", BURNISH_VERSION}, {"kind", kind}};
    for (const Setting& setting : settings())
        if (std::ranges::find(kNoPixels, setting.name) == kNoPixels.end())
            document["job"][std::string(setting.name)] = setting.get(job);
    const char* studio = std::getenv("OCIO");
    if (studio && job.color.config.empty() && names_space(job.color)) document["ocio"] = studio;
    std::istringstream text(document.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
    return sha256(text);
}

}  // namespace burnish
