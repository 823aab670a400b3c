// Any light that a shot file can name.
#pragma once

#include <burnish/light/area/area_light.h>
#include <burnish/light/cube_map/cube_map_light.h>
#include <burnish/light/environment_light.h>
#include <burnish/light/mirror/mirror_light.h>
#include <burnish/light/traced/traced_light.h>

#include <variant>

namespace burnish {

using Light = std::variant<EnvironmentLight, CubeMapLight, MirrorLight, AreaLight, TracedLight>;

}  // namespace burnish
