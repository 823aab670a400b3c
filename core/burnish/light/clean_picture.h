// Pictures of light as they come from files hold NaN, infinite and negative values now and then: none may reach the shading.
#pragma once

#include <burnish/base/image.h>

#include <functional>
#include <string>
#include <vector>

namespace burnish {

/// Finite values >= 0 in the colour space of the work; colours outside its gamut lose their negative part. `convert` takes the
/// picture into that space; empty = it is there. Adds a line to `warnings` for each kind of value that was scrubbed.
void clean_picture(Image& picture, const std::function<void(Image&)>& convert, const std::string& name,
                   std::vector<std::string>& warnings);

}  // namespace burnish
