// A cryptomatte of a scene's objects: which ones a pixel sees, and how much of it each covers.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/scene/trace.h>

namespace burnish {

/// Coverage counted over antialias x antialias rays a pixel; of more than `ranks` objects in one pixel those that cover least
/// are dropped. `name` is the layer's prefix, as "CryptoObject". Same bits for any thread count.
Cryptomatte trace_object_matte(const Tracer& tracer, const Camera& camera, int width, int height, int antialias, int ranks,
                               const std::string& name, const Progress& progress);

}  // namespace burnish
