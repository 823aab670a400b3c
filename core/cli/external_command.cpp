#include "external_command.h"

#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>

#include <unistd.h>
#include <filesystem>

namespace burnish::cli {
namespace {

/// The folder of this program's own file, or "" where the system does not tell.
std::filesystem::path own_folder() {
    std::error_code unknown;
    return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
}

}  // namespace

int run_external(char** argv, const std::map<std::string, Run>& commands) {
    const std::string word = argv[0], program = "burnish-" + word;
    if (word.find('/') == std::string::npos) {
        const std::filesystem::path beside = own_folder() / program;
        argv[0] = const_cast<char*>(program.c_str());
        if (beside.is_absolute()) execv(beside.c_str(), argv);
        execvp(program.c_str(), argv);
    }
    std::vector<std::string_view> names;
    for (const auto& command : commands) names.push_back(command.first);
    throw Error(ErrorCode::bad_argument, "no command '" + word + "' and no program " + program +
                                             " beside burnish or on the PATH" + did_you_mean(word, names) +
                                             "; see burnish --help");
}

}  // namespace burnish::cli
