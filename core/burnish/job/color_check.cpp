#include <burnish/job/color_check.h>

#include <burnish/input/told_space.h>

namespace burnish {
namespace {

/// A picture and its colours as it tells them and as the job does.
struct Picture {
    std::string name, option;
    ToldSpace told;
    std::string given;  // by the job

    std::string space() const { return given.empty() ? told.space : common_space(given); }
    bool is_contradicted() const { return !told.space.empty() && !space().empty() && space() != told.space; }
    std::string contradiction() const {
        return name + " is " + told.space + " by " + told.evidence + ", but " + option + " says " + given +
               "; leave the option out, or make sure of it";
    }
};

/// Nothing is converted unless both spaces are named.
std::string mismatch(const Picture& frame, const Picture& light) {
    const std::string remedy = "; say " + frame.option + " " + frame.space() + " " + light.option + " ";
    if (light.space().empty())
        return light.name + " does not tell its colours, and the frame is " + frame.space() + remedy +
               "lin_rec709, as most HDRIs are";
    return light.name + " is " + light.space() + ", the frame is " + frame.space() + ", and none is converted" + remedy +
           light.space();
}

}  // namespace

std::vector<std::string> color_warnings(const Job& job, const AovFrame& frame) {
    const Picture own{frame.label(), "--beauty-space", frame.metadata ? told_space(*frame.metadata) : ToldSpace{},
                      job.color.beauty};
    const Picture light{job.environment, "--env-space", told_space(job.environment), job.color.environment};
    std::vector<std::string> warnings;
    for (const Picture* picture : {&own, &light})
        if (picture->is_contradicted()) warnings.push_back("colour: " + picture->contradiction());
    const bool is_usual = own.space() == "lin_rec709" && light.space().empty();
    const bool is_silent = own.space().empty() || job.environment.empty() || !job.color.environment.empty();
    if (!is_silent && !is_usual && own.space() != light.space()) warnings.push_back("colour: " + mismatch(own, light));
    return warnings;
}

}  // namespace burnish
