// `burnish word` for words burnish does not know: runs burnish-word, the one beside burnish (`burnish chart` of the Python
// package) or else one from the PATH, so that other packages add commands.
#pragma once

#include "command.h"

#include <map>

namespace burnish::cli {

/// Replaces this process by burnish-<argv[0]> with the remaining arguments. Throws Error(bad_argument), naming the nearest
/// command, when there is no such program.
int run_external(char** argv, const std::map<std::string, Run>& commands);

}  // namespace burnish::cli
