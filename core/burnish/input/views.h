// Views of a stereo frame: in one file, or a file each, whose names hold %V (left, right) or %v (l, r).
#pragma once

#include <string>
#include <vector>

namespace burnish {

/// What a job calls all views of its frames.
inline constexpr const char* kAllViews = "all";

struct FileViews {
    std::vector<std::string> names;  // none: a mono file
    bool in_one_part = false;        // the older way: channels with the view in their names
};

/// By the header alone. Throws Error(read_failed).
FileViews views_of_file(const std::string& file);

bool has_view_token(const std::string& pattern);
/// The file of a view: every %V is its name, every %v its first letter.
std::string view_file(std::string pattern, const std::string& view);

}  // namespace burnish
