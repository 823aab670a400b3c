// The settings that are more than one value: layers per role, materials, the rules that assign them, lists of names.
#pragma once

#include <burnish/job/settings.h>

namespace burnish::setting {

Setting channels_setting();      // {"normal": "ViewLayer.Normal"}
Setting camera_setting();        // {"position": [...], ...}, or a file
Setting materials_setting();     // {"brass": {"lobes": [...]}, "body": "car-paint"}
Setting assign_setting();        // [{"material": "brass", "index": 3}, "varnish=crypto:table*"]
Setting per_pixel_setting();     // ["roughness", "tint"]
Setting tangent_axis_setting();  // [0, 0, 1]

}  // namespace burnish::setting
