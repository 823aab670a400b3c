// Manifests of cryptomattes: the JSON that lists the object names of a file with their ids.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Object name -> id bits from manifest text, {"name": "8 hex digits", ...}. Whatever is not of that form is left out, and
/// `warnings` gets one line that starts with `where`.
std::map<std::string, uint32_t> parse_manifest(const std::string& text, const std::string& where,
                                               std::vector<std::string>& warnings);

/// Text of the manifest file `name` in the folder of `exr`; empty, with a warning, when it is absent, too large to be one, or
/// would lie outside that folder.
std::string read_manifest_file(const std::string& exr, const std::string& name, std::vector<std::string>& warnings);

}  // namespace burnish
