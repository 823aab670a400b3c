// The names a user may have meant.
#pragma once

#include <string>
#include <vector>

namespace burnish {

/// The `count` names that differ least from `wanted` (edits of letters, whatever their case; a name that contains it counts
/// as near), quoted and comma-separated.
std::string near_names(const std::string& wanted, const std::vector<std::string>& names, size_t count = 5);

}  // namespace burnish
