// Untrusted text to JSON: bounded in size and depth, with messages that say where it breaks.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace burnish {

/// Parses JSON of at most 64 levels; `where` names it in messages. Throws Error(bad_argument) with the line that is wrong.
nlohmann::json parse_json(const std::string& text, const std::string& where);

/// Reads and parses a JSON file of at most `largest` bytes; `what` says what it should hold, e.g. "material". Throws
/// Error(read_failed) when it cannot be read and Error(bad_argument) when it is not JSON.
nlohmann::json read_json(const std::string& file, const std::string& what, std::uintmax_t largest = 1 << 20);

}  // namespace burnish
