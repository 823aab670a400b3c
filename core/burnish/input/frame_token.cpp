#include <burnish/input/frame_token.h>

#include <cctype>
#include <string_view>

namespace burnish {
namespace {

constexpr int kMostDigits = 18;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// "%04d", "$F4" and "<f4>" are one form: an opening, digits (may be none), a closing.
std::optional<FrameToken> numbered(const std::string& text, size_t begin, std::string_view opening, std::string_view closing) {
    if (text.compare(begin, opening.size(), opening) != 0) return std::nullopt;
    size_t i = begin + opening.size();
    int digits = 0;
    for (; i < text.size() && is_digit(text[i]); ++i)
        if (digits = 10 * digits + (text[i] - '0'); digits > kMostDigits) return std::nullopt;
    if (text.compare(i, closing.size(), closing) != 0) return std::nullopt;
    if (closing.empty() && i < text.size() && continues_name(text[i])) return std::nullopt;  // $FOO is another variable
    return FrameToken{begin, i + closing.size(), digits == 0 ? 1 : digits};
}

/// A run of the same sign, one digit each; a lone # is four, as OpenImageIO and Nuke's users have it.
std::optional<FrameToken> run(const std::string& text, size_t begin, char sign) {
    size_t end = begin;
    while (end < text.size() && text[end] == sign) ++end;
    const int digits = static_cast<int>(end - begin);
    if (digits == 0 || digits > kMostDigits) return std::nullopt;
    return FrameToken{begin, end, sign == '#' && digits == 1 ? 4 : digits};
}

}  // namespace

std::optional<FrameToken> find_frame_token(const std::string& pattern, size_t from) {
    const size_t slash = pattern.find_last_of('/');
    const size_t name = slash == std::string::npos ? 0 : slash + 1;  // folders with @ are people and versions
    for (size_t i = from; i < pattern.size(); ++i) {
        std::optional<FrameToken> token;
        switch (pattern[i]) {
            case '#': token = run(pattern, i, '#'); break;
            case '@': token = i >= name ? run(pattern, i, '@') : std::nullopt; break;
            case '%': token = numbered(pattern, i, "%", "d"); break;
            case '$': token = numbered(pattern, i, "$F", ""); break;
            case '<': token = numbered(pattern, i, "<f", ">"); break;
            default: break;
        }
        if (token) return token;
    }
    return std::nullopt;
}

}  // namespace burnish
