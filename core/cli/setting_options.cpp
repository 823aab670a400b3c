#include "setting_options.h"

#include <burnish/job/settings.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace burnish::cli {
namespace {

using nlohmann::json;

constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {{"output", "-o"}, {"lights", "--light"}};

std::string short_number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", x);
    return text;
}

std::string joined(const auto& items, const std::string& separator, const auto& show) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "" : separator) + show(item);
    return text;
}

/// "NAME", "degrees", "1..4096" or "a|b|c": what stands for the value in the help.
std::string metavar(const Setting& setting) {
    if (!setting.unit.empty()) return std::string(setting.unit);
    if (!setting.choices.empty()) return joined(setting.choices, "|", [](std::string_view name) { return std::string(name); });
    const bool low = std::isfinite(setting.range.min), high = std::isfinite(setting.range.max);
    return (low ? short_number(setting.range.min) : "") + ".." + (high ? short_number(setting.range.max) : "");
}

std::string shown_default(const Setting& setting) {
    const json value = setting.default_value();
    const auto number = [](const json& x) { return short_number(x.get<double>()); };
    if (value.is_number()) return " [" + number(value) + "]";
    if (value.is_boolean()) return value.get<bool>() ? " [on]" : "";
    if (value.is_string()) return value == "" ? "" : " [" + value.get<std::string>() + "]";
    return value.empty() ? "" : " [" + joined(value, ",", number) + "]";
}

void collect(const Setting& setting, const std::string& text, json& values) {
    json value = setting_from_text(setting, text, option_name(setting.name));
    json& held = values[std::string(setting.name)];
    if (setting.repeatable() && !held.is_null())
        merge(held, value);
    else
        held = std::move(value);
}

void add_option(CLI::App& command, const Setting& setting, json& values) {
    std::string names = option_name(setting.name);
    for (const auto& [name, other] : kOtherNames)
        if (name == setting.name) names = std::string(other) + "," + names;
    const std::string group = setting.section.empty() ? "Frame and materials" : "Section " + std::string(setting.section);
    const std::string help = std::string(setting.help) + shown_default(setting);
    if (setting.kind == SettingKind::boolean) {
        const bool usual = setting.default_value().get<bool>();
        const std::string flag = usual ? names + ",!--no-" + names.substr(2) : names;
        const std::string name(setting.name);
        command
            .add_flag_function(
                flag, [&values, name](std::int64_t count) { values[name] = count > 0; }, help)
            ->group(group);
        return;
    }
    // Every value is one word, so that -1,0,0 and the like are never taken for options.
    CLI::Option* option = command.add_option_function<std::vector<std::string>>(
        names,
        [&setting, &values](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) collect(setting, text, values);
        },
        help);
    option->group(group)->type_name(metavar(setting))->type_size(1)->expected(1);
    if (setting.repeatable())
        option->expected(1)->take_all();
    else
        option->take_last();
}

}  // namespace

void merge(json& held, const json& more) {
    if (held.is_object())
        held.update(more);
    else
        held.insert(held.end(), more.begin(), more.end());
}

std::string option_name(std::string_view setting) {
    std::string name = "--" + std::string(setting);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

void add_setting_options(CLI::App& command, json& values, std::string_view section) {
    for (const Setting& setting : settings()) {
        if (section == "all" && setting.kind != SettingKind::materials && setting.name != "aovs")
            add_option(command, setting, values);
        if (section == setting.section && setting.name != "env") add_option(command, setting, values);
    }
}

void add_setting_option(CLI::App& command, json& values, std::string_view name) {
    add_option(command, *std::ranges::find(settings(), name, &Setting::name), values);
}

}  // namespace burnish::cli
