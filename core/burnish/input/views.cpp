#include <burnish/input/views.h>

#include <burnish/input/exr_file.h>

namespace burnish {
namespace {

constexpr const char *kName = "%V", *kLetter = "%v";

void replace_all(std::string& text, const std::string& token, const std::string& by) {
    for (size_t at = text.find(token); at != std::string::npos; at = text.find(token, at + by.size()))
        text.replace(at, token.size(), by);
}

}  // namespace

FileViews views_of_file(const std::string& file) {
    const ExrFile opened(file, "");
    return {opened.views(), opened.has_views_in_one_part()};
}

bool has_view_token(const std::string& pattern) {
    return pattern.find(kName) != std::string::npos || pattern.find(kLetter) != std::string::npos;
}

std::string view_file(std::string pattern, const std::string& view) {
    replace_all(pattern, kName, view);
    replace_all(pattern, kLetter, view.substr(0, 1));
    return pattern;
}

}  // namespace burnish
