#include <burnish/job/setting_kinds.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace burnish::setting {
namespace {

using nlohmann::json;

std::string plain(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string described(NumberRange range, bool whole, std::string_view unit) {
    std::string text = whole ? "a whole number" : "a number";
    const bool low = std::isfinite(range.min), high = std::isfinite(range.max);
    if (low && high) text += " in [" + plain(range.min) + ", " + plain(range.max) + "]";
    if (low && !high) text += " of at least " + plain(range.min);
    if (!low && high) text += " of at most " + plain(range.max);
    return unit.empty() ? text : text + " (" + std::string(unit) + ")";
}

}  // namespace

bool checked_boolean(const json& value, const std::string& where) {
    if (!value.is_boolean()) fail_expected(where, "true or false", value);
    return value.get<bool>();
}

double checked_number(const json& value, NumberRange range, bool whole, std::string_view unit, const std::string& where) {
    const double x = value.is_number() ? value.get<double>() : std::nan("");
    const bool in_range = std::isfinite(x) && x >= range.min && x <= range.max;
    if (!in_range || (whole && x != std::floor(x))) fail_expected(where, described(range, whole, unit), value);
    return x;
}

std::string checked_text(const json& value, const std::string& where) {
    if (!value.is_string()) fail_expected(where, "text", value);
    const auto text = value.get<std::string>();
    if (text.find('\0') != std::string::npos) fail_expected(where, "text without a zero character", value);
    return text;
}

size_t checked_choice(const json& value, const std::vector<std::string_view>& choices, const std::string& where) {
    return static_cast<size_t>(std::ranges::find(choices, name_from_json(value, where, choices)) - choices.begin());
}

Vec3f checked_triple(const json& value, NumberRange range, bool gray, const std::string& where) {
    if (gray && value.is_number()) return Vec3f(static_cast<float>(checked_number(value, range, false, "", where)));
    if (!value.is_array() || value.size() != 3) fail_expected(where, gray ? "[r, g, b] or one number" : "[x, y, z]", value);
    Vec3f triple;
    for (int i = 0; i < 3; ++i) {
        const std::string element = where + "[" + std::to_string(i) + "]";
        triple[i] = static_cast<float>(checked_number(value[static_cast<size_t>(i)], range, false, "", element));
    }
    return triple;
}

std::map<std::string, std::string> checked_pairs(const json& value, const std::string& where) {
    if (!value.is_object()) fail_expected(where, "an object of names", value);
    std::map<std::string, std::string> pairs;
    for (const auto& [key, element] : value.items()) pairs[key] = checked_text(element, where + "." + key);
    return pairs;
}

}  // namespace burnish::setting
