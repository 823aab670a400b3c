// The models and presets as text: what `burnish models` prints.
#pragma once

#include <string>

namespace burnish {

/// Name, summary, source and own parameters of every model, the fields all lobes share, and one line a preset.
std::string describe_models();

}  // namespace burnish
