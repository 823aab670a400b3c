// The settings as fields of the shot file's sections, with paths as a shot file means them: relative to its folder.
#pragma once

#include <burnish/job/settings.h>

#include <filesystem>

namespace burnish {

bool is_section(std::string_view key);

/// `where` names the section in messages. Throw Error(bad_argument).
void set_field(Job& job, std::string_view section, const std::string& key, const nlohmann::json& value,
               const std::string& where, const std::filesystem::path& folder);
void set_section(Job& job, std::string_view section, const nlohmann::json& fields, const std::string& where,
                 const std::filesystem::path& folder);

/// A relative path as from `folder`; absolute ones, "" and JSON in a path's place stay.
std::string in_folder(const std::string& path, const std::filesystem::path& folder);

}  // namespace burnish
