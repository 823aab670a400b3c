#include "external_command.h"

#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>

#include <unistd.h>

namespace burnish::cli {

int run_external(char** argv, const std::map<std::string, Run>& commands) {
    const std::string word = argv[0], program = "burnish-" + word;
    if (word.find('/') == std::string::npos) {
        argv[0] = const_cast<char*>(program.c_str());
        execvp(argv[0], argv);
    }
    std::vector<std::string_view> names;
    for (const auto& command : commands) names.push_back(command.first);
    throw Error(ErrorCode::bad_argument, "no command '" + word + "' and no program " + program + " on the PATH" +
                                             did_you_mean(word, names) + "; see burnish --help");
}

}  // namespace burnish::cli
