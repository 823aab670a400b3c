// A flag's text as JSON: the one grammar the command line adds to the settings.
#include <burnish/job/settings.h>

#include <charconv>

namespace burnish {
namespace {

using nlohmann::json;

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// A number, or the text itself so that the setting's own check can say what it expected.
json number_or_text(const std::string& text) {
    int64_t whole = 0;
    double number = 0;
    const char *begin = text.data() + (text.starts_with('+') ? 1 : 0), *end = text.data() + text.size();
    if (const auto read = std::from_chars(begin, end, whole); read.ec == std::errc() && read.ptr == end) return whole;
    if (const auto read = std::from_chars(begin, end, number); read.ec == std::errc() && read.ptr == end) return number;
    return text;
}

/// "0.2s" of seconds and "45dB" are numbers, too.
std::string without_unit(const Setting& setting, const std::string& text) {
    const size_t digits = text.find_last_of("0123456789.") + 1;
    const std::string_view unit = std::string_view(text).substr(digits);
    return !unit.empty() && setting.unit.starts_with(unit) ? text.substr(0, digits) : text;
}

json boolean_or_text(const std::string& text) {
    if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
    if (text == "false" || text == "off" || text == "no" || text == "0") return false;
    return text;
}

json numbers(const std::string& text) {
    json list = json::array();
    for (const std::string& part : split(text)) list.push_back(number_or_text(part));
    return list.size() == 1 ? list[0] : list;
}

json pair(const Setting& setting, const std::string& text, const std::string& where) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw Error(ErrorCode::bad_argument, where + ": expected " + std::string(setting.unit) + ", found '" + text + "'");
    return {{text.substr(0, equals), text.substr(equals + 1)}};
}

}  // namespace

json setting_from_text(const Setting& setting, const std::string& text, const std::string& where) {
    switch (setting.kind) {
        case SettingKind::boolean: return boolean_or_text(text);
        case SettingKind::integer:
        case SettingKind::number: return number_or_text(without_unit(setting, text));
        case SettingKind::names: return text.empty() ? json::array() : json(split(text));
        case SettingKind::color:
        case SettingKind::vector: return numbers(text);
        case SettingKind::pairs:
        case SettingKind::lights: return pair(setting, text, where);
        case SettingKind::rules: return json::array({text});
        case SettingKind::text:
        case SettingKind::path:
        case SettingKind::choice:
        case SettingKind::materials: return text;
    }
    return text;
}

}  // namespace burnish
