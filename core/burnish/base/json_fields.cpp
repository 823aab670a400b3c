#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/base/nearest_name.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace burnish {

namespace {

using nlohmann::json;

/// A value as a message shows it: short, whatever the file held.
std::string shown(const json& value) {
    constexpr size_t kLongest = 40;
    if (value.is_structured() && value.size() > 4)
        return std::string(value.is_array() ? "a list" : "an object") + " of " + std::to_string(value.size()) + " entries";
    const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string shown(NumberRange range) {
    std::ostringstream text;
    text << range.min << " to " << range.max;
    return text.str();
}

bool holds(NumberRange range, const json& value) {
    return value.is_number() && value.get<double>() >= range.min && value.get<double>() <= range.max;
}

std::string listed(std::span<const std::string_view> names) {
    std::string list;
    for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

/// Keys and words from a file, cut and made printable for a message.
std::string quoted(std::string_view word) { return shown(json(word)); }

}  // namespace

JsonFields::JsonFields(const json& value, std::string where) : m_value(value), m_where(std::move(where)) {
    if (!value.is_object()) throw Error(ErrorCode::bad_argument, m_where + ": expected an object {...}, found " + shown(value));
}

bool JsonFields::has(std::string_view key) const { return m_value.find(key) != m_value.end(); }

std::string JsonFields::path(std::string_view key) const { return m_where + "." + std::string(key); }

void JsonFields::expect_only(std::span<const std::string_view> known) const {
    for (const auto& item : m_value.items())
        if (std::ranges::find(known, item.key()) == known.end()) fail_unknown(m_where, "field", item.key(), known);
}

void JsonFields::expect_at_most_one(std::span<const std::string_view> rivals) const {
    std::string_view first;
    for (const std::string_view key : rivals) {
        if (!has(key)) continue;
        if (!first.empty())
            throw Error(ErrorCode::bad_argument, m_where + ": both \"" + std::string(first) + "\" and \"" + std::string(key) +
                                                     "\" are given; keep one of " + listed(rivals));
        first = key;
    }
}

const json& JsonFields::at(std::string_view key) const {
    const auto found = m_value.find(key);
    if (found == m_value.end())
        throw Error(ErrorCode::bad_argument, m_where + ": field \"" + std::string(key) + "\" is missing");
    return *found;
}

float JsonFields::number(std::string_view key, NumberRange range) const {
    const json& value = at(key);
    if (!holds(range, value)) fail_expected(path(key), "a number from " + shown(range), value);
    return value.get<float>();
}

int JsonFields::whole_number(std::string_view key, NumberRange range, int fallback) const {
    if (!has(key)) return fallback;
    const json& value = at(key);
    if (!holds(range, value) || value.get<double>() != std::floor(value.get<double>()))
        fail_expected(path(key), "a whole number from " + shown(range), value);
    return value.get<int>();
}

Color3f JsonFields::color(std::string_view key, NumberRange range) const {
    const json& value = at(key);
    if (holds(range, value)) return Color3f(value.get<float>());
    const bool three = value.is_array() && value.size() == 3;
    if (!three || !std::ranges::all_of(value, [&](const json& channel) { return holds(range, channel); }))
        fail_expected(path(key), "a number from " + shown(range) + " or a list of three", value);
    return {value[0].get<float>(), value[1].get<float>(), value[2].get<float>()};
}

bool JsonFields::boolean(std::string_view key, bool fallback) const {
    if (!has(key)) return fallback;
    if (!at(key).is_boolean()) fail_expected(path(key), "true or false", at(key));
    return at(key).get<bool>();
}

std::string JsonFields::text(std::string_view key) const {
    if (!has(key)) return "";
    if (!at(key).is_string()) fail_expected(path(key), "text in quotes", at(key));
    return at(key).get<std::string>();
}

std::string JsonFields::name(std::string_view key, std::span<const std::string_view> known) const {
    return name_from_json(at(key), path(key), known);
}

Vec3f vector_from_json(const json& value, const std::string& where) {
    constexpr NumberRange kCoordinates{-1e12, 1e12};
    const auto usable = [&](const json& x) { return holds(kCoordinates, x); };
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, usable)) fail_expected(where, "[x, y, z]", value);
    return {value[0].get<float>(), value[1].get<float>(), value[2].get<float>()};
}

std::string name_from_json(const json& value, const std::string& where, std::span<const std::string_view> known) {
    if (!value.is_string()) fail_expected(where, "a name in quotes", value);
    const std::string word = value.get<std::string>();
    if (std::ranges::find(known, word) == known.end()) fail_unknown(where, "name", word, known);
    return word;
}

void fail_expected(const std::string& where, const std::string& expected, const json& found) {
    throw Error(ErrorCode::bad_argument, where + ": expected " + expected + ", found " + shown(found));
}

void fail_unknown(const std::string& where, std::string_view what, std::string_view word,
                  std::span<const std::string_view> known) {
    throw Error(ErrorCode::bad_argument, where + ": unknown " + std::string(what) + " " + quoted(word) +
                                             did_you_mean(word, known) + "; known: " + listed(known));
}

json to_json_number(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double shortest = 0;
    std::from_chars(text, end, shortest);
    return shortest;
}

json to_json_vector(const Vec3f& value) {
    return json::array({to_json_number(value.x), to_json_number(value.y), to_json_number(value.z)});
}

json to_json_color(const Color3f& color) {
    if (color.x == color.y && color.y == color.z) return to_json_number(color.x);
    return {to_json_number(color.x), to_json_number(color.y), to_json_number(color.z)};
}

}  // namespace burnish
