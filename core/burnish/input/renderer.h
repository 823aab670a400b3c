// The renderers burnish knows by their files.
#pragma once

#include <string_view>

namespace burnish {

enum class Renderer { unknown, cycles, arnold, renderman, vray, karma, mitsuba, redshift, octane, luxcore };

/// "Cycles", "V-Ray", ...; "an unknown renderer".
std::string_view renderer_name(Renderer renderer);

}  // namespace burnish
