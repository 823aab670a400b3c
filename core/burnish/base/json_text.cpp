#include <burnish/base/error.h>
#include <burnish/base/json_text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace burnish {

using nlohmann::json;

json parse_json(const std::string& text, const std::string& where) {
    constexpr int kDeepest = 64;
    try {
        return json::parse(text, [&](int depth, json::parse_event_t, json&) {
            if (depth > kDeepest) throw Error(ErrorCode::bad_argument, where + ": nested deeper than 64 levels");
            return true;
        });
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const auto line = 1 + std::count(text.begin(), end, '\n');
        throw Error(ErrorCode::bad_argument, where + ": not valid JSON near line " + std::to_string(line) +
                                                 "; look for a missing comma, quote or brace");
    } catch (const json::exception&) {
        throw Error(ErrorCode::bad_argument, where + ": holds a number that no 64-bit float can hold");
    }
}

json read_json(const std::string& file, const std::string& what, std::uintmax_t largest) {
    const auto fail = [&](const std::string& why) {
        throw Error(ErrorCode::read_failed, file + ": cannot read the " + what + ": " + why);
    };
    std::error_code status;
    const std::uintmax_t size = std::filesystem::file_size(file, status);
    if (status) fail(status.message());
    if (size > largest) fail("expected at most " + std::to_string(largest) + " bytes, found " + std::to_string(size));
    std::ifstream stream(file, std::ios::binary);
    if (!stream) fail("check its permissions");
    return parse_json({std::istreambuf_iterator<char>(stream), {}}, file);
}

}  // namespace burnish
