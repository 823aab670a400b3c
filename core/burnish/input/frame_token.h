// The place of the frame number in a file pattern.
#pragma once

#include <optional>
#include <string>

namespace burnish {

struct FrameToken {
    size_t begin = 0, end = 0;  // in the pattern
    int digits = 1;             // at least this many, zero padded
};

/// The first token at or after `from`; see frames.h for the forms.
std::optional<FrameToken> find_frame_token(const std::string& pattern, size_t from);

}  // namespace burnish
