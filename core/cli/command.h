// What every command of the command line has: a name, its options, and work that ends in an exit code.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace burnish::cli {

/// A command adds itself to the app and returns what to run when it was chosen; that returns the exit code and throws Error.
using Run = std::function<int()>;

Run add_composite(CLI::App& app);
Run add_bandwidth(CLI::App& app);
Run add_info(CLI::App& app);
Run add_envmap(CLI::App& app);
Run add_compare(CLI::App& app);
Run add_models(CLI::App& app);
Run add_demo(CLI::App& app);
Run add_bake(CLI::App& app);
Run add_fit(CLI::App& app);
Run add_factor(CLI::App& app);
Run add_tabulate(CLI::App& app);
Run add_preview(CLI::App& app);
Run add_calibrate(CLI::App& app);

}  // namespace burnish::cli
