// "Did you mean": the known name nearest to one that was mistyped.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// The name of `known` with the fewest edits (insert, drop, replace, swap neighbours; case counts for nothing) to `word`,
/// empty when even that one needs more than a third of the word, and at least two, changed.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known);

/// " (did you mean "x"?)" or "", ready to append to a message.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace burnish
