// Views of a frame in one part, as older stereo files have them: attribute `multiView`, and channels with their view in the name.
#pragma once

#include <burnish/output/join_parts.h>

namespace burnish {

/// `views`: a scanline file each, of one part, all with the same channels and windows; the first is the one without a mark. Whole or
/// not at all. Throws Error(write_failed).
void join_views(const std::string& target, const std::vector<StoredParts>& views);

}  // namespace burnish
