#include <burnish/job/savings.h>

#include <burnish/input/metadata.h>
#include <burnish/light/filter/gaussian_stack.h>

namespace burnish {
namespace {

std::string share(size_t done, size_t all) { return std::to_string(done) + " of " + std::to_string(all); }

/// Of the environment's stack, whose finest levels cost most; "" where all were filtered.
std::string saved_levels(const std::string& name, const GaussianStack& stack) {
    size_t filtered = 0;
    int finest = 0;
    for (int k = 0; k < stack.level_count(); ++k) {
        if (!stack.is_filtered(k)) continue;
        ++filtered, finest = std::max(finest, stack.size(k));
    }
    if (filtered == static_cast<size_t>(stack.level_count())) return "";
    return name + ": " + share(filtered, static_cast<size_t>(stack.level_count())) + " levels filtered" +
           (filtered > 0
                ? ", faces of up to " + share(static_cast<size_t>(finest), static_cast<size_t>(stack.size(0))) + " texels"
                : "");
}

}  // namespace

std::vector<std::string> saved_reading(const AovFrame& frame) {
    if (!frame.metadata) return {};
    const ChannelCounts counts = channel_counts(*frame.metadata);
    if (counts.decoded >= counts.all) return {};
    return {share(counts.decoded, counts.all) + " channels decoded"};
}

std::vector<std::string> saved_light(const Rig& rig) {
    std::vector<std::string> saved;
    if (rig.loaded_count() < rig.lights.size())
        saved.push_back(share(rig.loaded_count(), rig.lights.size()) + " lights loaded");
    if (const Environment* environment = rig.environment())
        if (const std::string line = saved_levels(rig.lights.back().name, environment->gaussian_stack()); !line.empty())
            saved.push_back(line);
    return saved;
}

void tell_of_lights(const Look& look, Report& report) {
    LightNotes told = look.rig.told();
    report.notes = std::move(told.notes);
    report.warnings = look.wardrobe.warnings;
    report.warnings.insert(report.warnings.end(), told.warnings.begin(), told.warnings.end());
    report.saved = saved_light(look.rig);
}

}  // namespace burnish
