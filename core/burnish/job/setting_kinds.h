// Builders of the settings table: one per kind, each binding a member of Job to its JSON form and its check.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/job/settings.h>

#include <utility>

namespace burnish::setting {

struct Place {
    std::string_view name, section, key;
};

bool checked_boolean(const nlohmann::json& value, const std::string& where);
double checked_number(const nlohmann::json& value, NumberRange range, bool whole, std::string_view unit,
                      const std::string& where);
std::string checked_text(const nlohmann::json& value, const std::string& where);
/// Index of a string into the choices.
size_t checked_choice(const nlohmann::json& value, const std::vector<std::string_view>& choices, const std::string& where);
/// Three numbers in range; with `gray` also one number for all three.
Vec3f checked_triple(const nlohmann::json& value, NumberRange range, bool gray, const std::string& where);
std::map<std::string, std::string> checked_pairs(const nlohmann::json& value, const std::string& where);

template <class At>
Setting boolean(Place at, At member, std::string_view help) {
    auto get = [member](const Job& job) { return nlohmann::json(member(job)); };
    auto set = [member](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = checked_boolean(value, where);
    };
    return {at.name, at.section, at.key, SettingKind::boolean, "", help, get, set};
}

template <class At>
Setting integer(Place at, At member, NumberRange range, std::string_view unit, std::string_view help) {
    auto get = [member](const Job& job) { return nlohmann::json(member(job)); };
    auto set = [=](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = static_cast<int>(checked_number(value, range, true, unit, where));
    };
    return {at.name, at.section, at.key, SettingKind::integer, unit, help, get, set, range};
}

template <class At>
Setting number(Place at, At member, NumberRange range, std::string_view unit, std::string_view help) {
    auto get = [member](const Job& job) { return to_json_number(member(job)); };
    auto set = [=](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = static_cast<float>(checked_number(value, range, false, unit, where));
    };
    return {at.name, at.section, at.key, SettingKind::number, unit, help, get, set, range};
}

template <class At>
Setting text(Place at, At member, SettingKind kind, std::string_view unit, std::string_view help) {
    auto get = [member](const Job& job) { return nlohmann::json(member(job)); };
    auto set = [member](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = checked_text(value, where);
    };
    return {at.name, at.section, at.key, kind, unit, help, get, set};
}

template <class At>
Setting color(Place at, At member, NumberRange range, std::string_view help) {
    auto get = [member](const Job& job) { return to_json_vector(member(job)); };
    auto set = [=](Job& job, const nlohmann::json& value, const std::string& where) {
        const Vec3f c = checked_triple(value, range, true, where);
        member(job) = Color3f(c.x, c.y, c.z);
    };
    return {at.name, at.section, at.key, SettingKind::color, "R,G,B", help, get, set, range};
}

template <class At>
Setting pairs(Place at, At member, std::string_view unit, std::string_view help) {
    auto get = [member](const Job& job) { return nlohmann::json(member(job)); };
    auto set = [member](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = checked_pairs(value, where);
    };
    return {at.name, at.section, at.key, SettingKind::pairs, unit, help, get, set};
}

/// An enumeration by the names of its values.
template <class E, class At>
Setting choice(Place at, At member, std::vector<std::pair<std::string_view, E>> values, std::string_view help) {
    std::vector<std::string_view> names;
    for (const auto& value : values) names.push_back(value.first);
    auto get = [=](const Job& job) {
        for (const auto& [name, value] : values)
            if (value == member(job)) return nlohmann::json(name);
        return nlohmann::json();
    };
    auto set = [=](Job& job, const nlohmann::json& value, const std::string& where) {
        member(job) = values[checked_choice(value, names, where)].second;
    };
    return {at.name, at.section, at.key, SettingKind::choice, "", help, get, set, kAnyNumber, names};
}

}  // namespace burnish::setting
