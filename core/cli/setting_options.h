// The settings table as command-line options.
#pragma once

#include <burnish/job/job.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace burnish::cli {

/// Adds one option per setting that has a text form, of all sections or of one; not for what a command takes by position
/// (`aovs`; of the section lights also `env`). What the user gives is collected in `values` by setting name; `values` must
/// outlive the parsing.
void add_setting_options(CLI::App& command, nlohmann::json& values, std::string_view section = "all");

/// The same for one setting, by its name.
void add_setting_option(CLI::App& command, nlohmann::json& values, std::string_view name);

/// Repeated flags add to what is there: objects gain keys, lists grow.
void merge(nlohmann::json& held, const nlohmann::json& more);

/// "--env-rotate" for "env_rotate".
std::string option_name(std::string_view setting);

}  // namespace burnish::cli
