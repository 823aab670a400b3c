// What a file claims to be, checked before anything is allocated for it: the gate untrusted files pass first.
#pragma once

#include <string>

namespace burnish {

inline constexpr int kLargestSide = 65536;           // pixels
inline constexpr long long kMostPixels = 1LL << 28;  // 16384 x 16384
inline constexpr int kMostChannels = 1024;           // per part, OpenImageIO's own limit

/// Reads the header only. Throws Error(read_failed) when the file is absent or no OpenEXR file, when its header is damaged,
/// when it is deep, subsampled or of unknown compression, and when it claims more pixels than a file of its bytes can hold.
void check_exr_header(const std::string& file);

}  // namespace burnish
