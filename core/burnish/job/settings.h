// The one table of settings. The command line makes its options from it, Python its keywords and documentation, the shot
// file its schema; no face has a name, default, range or help text of its own.
#pragma once

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/job/job.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

inline constexpr NumberRange kAnyNumber{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// What a setting holds; decides which JSON it takes and how a flag's text becomes that JSON (`setting_from_text`).
enum class SettingKind {
    boolean,    // true, false
    integer,    // whole number in range
    number,     // number in range
    text,       // string
    path,       // string; in a shot file relative to the shot file
    choice,     // one of `choices`
    names,      // list of `choices`; text "a,b"
    color,      // [r, g, b] or one number; text "r,g,b"
    vector,     // [x, y, z]; text "x,y,z"
    pairs,      // object of strings; text "key=value", repeatable
    rules,      // list of assign rules; text "material=selector:value", repeatable
    materials,  // object: name -> material as JSON, preset or file; no text form
    lights,     // object: name -> light as JSON or file; text "name=JSON or file", repeatable
};

struct Setting {
    std::string_view name;          // Python keyword; the command line spells it with dashes
    std::string_view section, key;  // place in the shot file; section "" is the document itself
    SettingKind kind;
    std::string_view unit;  // or what the value is ("FILE", "degrees"); "" where the kind says it
    std::string_view help;
    std::function<nlohmann::json(const Job&)> get;
    /// Checks and stores; `where` names the field in messages. Throws Error(bad_argument).
    std::function<void(Job&, const nlohmann::json&, const std::string& where)> set;
    NumberRange range = kAnyNumber;
    std::vector<std::string_view> choices = {};

    nlohmann::json default_value() const { return get(Job{}); }
    bool repeatable() const { return kind == SettingKind::pairs || kind == SettingKind::rules || kind == SettingKind::lights; }
};

/// All settings, in the order they are shown.
std::span<const Setting> settings();

/// A flag's text as the JSON the setting takes; of a repeatable one, one element. Throws Error(bad_argument).
nlohmann::json setting_from_text(const Setting& setting, const std::string& text, const std::string& where);

/// Sets by keyword from an object {name: value}. Throws Error(bad_argument) naming the nearest keyword.
void set_settings(Job& job, const nlohmann::json& values, const std::string& where);

}  // namespace burnish
