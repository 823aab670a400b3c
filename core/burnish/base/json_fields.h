// Reading one JSON object strictly: every field is asked for by name, type and range, and every message tells the path to the
// field, what was expected and what was found.
#pragma once

#include <burnish/base/types.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// [x, y, z], coordinates of at most 1e12; `where` is the path to `value`. Throws Error(bad_argument).
Vec3f vector_from_json(const nlohmann::json& value, const std::string& where);

/// Numbers a field may hold, ends included.
struct NumberRange {
    double min, max;
};

/// All methods throw Error(bad_argument). The JSON value must outlive the reader.
class JsonFields {
public:
    /// `where`: the path to `value` for messages, e.g. "shot.json: materials.brass". Throws unless `value` is an object.
    JsonFields(const nlohmann::json& value, std::string where);

    bool has(std::string_view key) const;
    /// Throws for the first key that is not in `known`, naming the nearest one that is.
    void expect_only(std::span<const std::string_view> known) const;
    /// Throws when two of `rivals` are present.
    void expect_at_most_one(std::span<const std::string_view> rivals) const;

    /// The field as it is; throws when it is absent.
    const nlohmann::json& at(std::string_view key) const;
    float number(std::string_view key, NumberRange range) const;
    float number(std::string_view key, NumberRange range, float fallback) const {
        return has(key) ? number(key, range) : fallback;
    }
    int whole_number(std::string_view key, NumberRange range, int fallback) const;
    /// A list of three numbers, or one number for all three.
    Color3f color(std::string_view key, NumberRange range) const;
    Color3f color(std::string_view key, NumberRange range, const Color3f& fallback) const {
        return has(key) ? color(key, range) : fallback;
    }
    /// A list of three numbers.
    Vec3f vector(std::string_view key) const { return vector_from_json(at(key), path(key)); }
    Vec3f vector(std::string_view key, const Vec3f& fallback) const { return has(key) ? vector(key) : fallback; }
    bool boolean(std::string_view key, bool fallback) const;
    /// Any text, or "" where the field is absent.
    std::string text(std::string_view key) const;
    /// A text out of `known`.
    std::string name(std::string_view key, std::span<const std::string_view> known) const;

    /// "where.key", for messages and nested readers.
    std::string path(std::string_view key) const;

private:
    const nlohmann::json& m_value;
    std::string m_where;
};

/// A text out of `known`; `where` is the path to `value`.
std::string name_from_json(const nlohmann::json& value, const std::string& where, std::span<const std::string_view> known);

/// Throws Error(bad_argument) "where: expected ..., found ...".
[[noreturn]] void fail_expected(const std::string& where, const std::string& expected, const nlohmann::json& found);
/// Throws Error(bad_argument) "where: unknown <what> "word" (did you mean ...); known: ...".
[[noreturn]] void fail_unknown(const std::string& where, std::string_view what, std::string_view word,
                               std::span<const std::string_view> known);

/// A float as the shortest decimal number that reads back as the same float: 0.1f becomes 0.1, not 0.10000000149.
nlohmann::json to_json_number(float value);
nlohmann::json to_json_vector(const Vec3f& value);
/// One number when all channels agree, else a list of three.
nlohmann::json to_json_color(const Color3f& color);

}  // namespace burnish
