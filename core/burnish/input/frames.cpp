#include <burnish/base/error.h>
#include <burnish/input/frame_token.h>
#include <burnish/input/frames.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>
#include <unordered_set>

namespace burnish {
namespace fs = std::filesystem;
namespace {

constexpr int64_t kMostFrames = 1'000'000;

[[noreturn]] void fail(const std::string& text, const std::string& reason) {
    throw Error(ErrorCode::bad_argument, "frames \"" + text + "\": " + reason);
}

/// Takes an integer off the front of `rest`.
std::optional<int> take_number(std::string_view& rest) {
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc()) return std::nullopt;
    rest.remove_prefix(static_cast<size_t>(end - rest.data()));
    return number;
}

bool take(std::string_view& rest, char c) {
    if (rest.empty() || rest.front() != c) return false;
    rest.remove_prefix(1);
    return true;
}

struct Range {
    int first = 0, last = 0, step = 1;
};

/// "5", "1-24", "1-24x2" or "1-24:2".
Range parse_range(std::string_view item, const std::string& text) {
    const std::string expected = "expected ranges such as 1-24, 1-24x2 or 1,3,5-7, found \"" + std::string(item) + "\"";
    std::string_view rest = item;
    Range range;
    const auto first = take_number(rest);
    if (!first) fail(text, expected);
    range.first = range.last = *first;
    if (take(rest, '-')) {
        const auto last = take_number(rest);
        if (!last) fail(text, expected);
        range.last = *last;
        if (take(rest, 'x') || take(rest, ':')) range.step = take_number(rest).value_or(0);
    }
    if (!rest.empty()) fail(text, expected);
    if (range.step < 1) fail(text, "the step in \"" + std::string(item) + "\" must be 1 or more");
    if (range.last < range.first)
        fail(text, "the range \"" + std::string(item) + "\" runs backwards; give the smaller frame first");
    return range;
}

/// A frame number with at least `digits` characters, sign included.
std::string padded(int frame, int digits) {
    char text[32];
    std::snprintf(text, sizeof(text), "%0*d", digits, frame);
    return text;
}

/// The first folder or file name of the pattern with a token, as [begin, end).
std::pair<size_t, size_t> tokened_component(const std::string& pattern, const FrameToken& token) {
    const size_t slash = pattern.rfind('/', token.begin);
    const size_t begin = slash == std::string::npos ? 0 : slash + 1;
    return {begin, std::min(pattern.find('/', token.begin), pattern.size())};
}

}  // namespace

std::vector<int> parse_frames(const std::string& text) {
    std::vector<int> frames;
    std::unordered_set<int> seen;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find_first_of(", \t", begin), text.size());
        if (end > begin) {
            const Range range = parse_range(std::string_view(text).substr(begin, end - begin), text);
            const int64_t count = (static_cast<int64_t>(range.last) - range.first) / range.step + 1;
            if (count + static_cast<int64_t>(frames.size()) > kMostFrames)
                fail(text, "more than a million frames; check the range");
            for (int64_t k = 0; k < count; ++k)
                if (const int frame = static_cast<int>(range.first + k * range.step); seen.insert(frame).second)
                    frames.push_back(frame);
        }
        begin = end + 1;
    }
    if (frames.empty()) fail(text, "no frame; give ranges such as 1-24, 1-24x2 or 1,3,5-7");
    return frames;
}

bool has_frame_token(const std::string& pattern) { return find_frame_token(pattern, 0).has_value(); }

std::string frame_file(const std::string& pattern, int frame) {
    std::string file;
    size_t copied = 0;
    while (const auto token = find_frame_token(pattern, copied)) {
        file.append(pattern, copied, token->begin - copied);
        file += padded(frame, token->digits);
        copied = token->end;
    }
    return file.append(pattern, copied, std::string::npos);
}

std::vector<int> frames_on_disk(const std::string& pattern) {
    const auto token = find_frame_token(pattern, 0);
    if (!token) throw Error(ErrorCode::bad_argument, pattern + ": has no frame number; write it as ####, %04d, $F4 or <f4>");
    const auto [begin, end] = tokened_component(pattern, *token);
    const std::string component = pattern.substr(begin, end - begin), prefix = pattern.substr(begin, token->begin - begin);
    const fs::path folder = begin == 0 ? fs::path(".") : fs::path(pattern.substr(0, begin));

    std::vector<int> frames;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), last; !error && entry != last; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix)) continue;
        std::string_view rest = std::string_view(name).substr(prefix.size());
        const auto frame = take_number(rest);
        if (!frame || frame_file(component, *frame) != name) continue;
        if (std::error_code ignored; fs::is_regular_file(frame_file(pattern, *frame), ignored)) frames.push_back(*frame);
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

}  // namespace burnish
