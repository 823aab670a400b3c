// The command line: one command a file, all errors on one line, documented exit codes.
#include "command.h"
#include "external_command.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/job/run.h>

#include <cstdio>
#include <map>
#include <new>

namespace {

using namespace burnish;

constexpr int kFailure = 1, kUsage = 2;
constexpr const char* kFooter =
    "Written in Python: burnish sequence runs frames over processes or a farm, burnish chart and burnish fit-plots draw pictures.\n"
    "Any other word runs burnish-<word>, found beside burnish or on the PATH.\n"
    "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 some frames were skipped or failed, 130 stopped by Ctrl-C.";

/// The last line of every run that fails; farms look for it.
int fail(std::string_view name, const std::string& message, int code) {
    std::string line = message;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(stderr, "burnish: error: %s %s\n", std::string(name).c_str(), line.c_str());
    return code;
}

int run_guarded(const cli::Run& command) {
    try {
        return command();
    } catch (const Error& error) {
        const bool stopped = error.code() == ErrorCode::cancelled && cli::caught_signal() != 0;
        return fail(error_name(error.code()), error.what(),
                    stopped ? cli::kSignalBase + cli::caught_signal() : exit_code(error.code()));
    } catch (const std::bad_alloc&) {
        return fail("E_OUT_OF_MEMORY", "not enough memory for this frame", kFailure);
    } catch (const std::exception& error) {
        return fail("E_INTERNAL", error.what(), kFailure);
    }
}

int usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App* command = &app;
    for (const CLI::App* chosen : app.get_subcommands()) command = chosen;
    const std::string name = command == &app ? "burnish" : "burnish " + command->get_name();
    return fail("E_USAGE", std::string(error.what()) + "; see " + name + " --help", kUsage);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("View-dependent specular overlays for rendered frames", "burnish");
    app.set_version_flag("--version", "burnish " + std::string(version()));
    app.require_subcommand(1);
    app.footer(kFooter);
    std::map<std::string, cli::Run> commands;
    commands["composite"] = cli::add_composite(app);
    commands["bandwidth"] = cli::add_bandwidth(app);
    commands["info"] = cli::add_info(app);
    commands["envmap"] = cli::add_envmap(app);
    commands["compare"] = cli::add_compare(app);
    commands["models"] = cli::add_models(app);
    commands["demo"] = cli::add_demo(app);
    commands["bake"] = cli::add_bake(app);
    commands["fit"] = cli::add_fit(app);
    commands["factor"] = cli::add_factor(app);
    commands["tabulate"] = cli::add_tabulate(app);
    commands["preview"] = cli::add_preview(app);
    commands["calibrate"] = cli::add_calibrate(app);

    if (argc > 1 && argv[1][0] != '-' && commands.count(argv[1]) == 0)
        return run_guarded([&] { return cli::run_external(argv + 1, commands); });
    int code = 0;
    // A setting's text is checked while parsing, so an Error may leave the parser too.
    code = run_guarded([&] {
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return error.get_exit_code() == 0 ? app.exit(error) : usage_error(app, error);
        }
        cli::catch_signals();
        return commands.at(app.get_subcommands().front()->get_name())();
    });
    return code;
}
