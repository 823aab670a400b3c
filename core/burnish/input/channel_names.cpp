#include <burnish/input/channel_names.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burnish {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

}  // namespace

ChannelName split_channel(std::string_view name) {
    const size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return {"", std::string(name)};
    return {std::string(name.substr(0, dot)), std::string(name.substr(dot + 1))};
}

std::string_view last_token(std::string_view layer) { return layer.substr(layer.rfind('.') + 1); }

std::string_view parent_path(std::string_view layer) {
    const size_t dot = layer.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : layer.substr(0, dot);
}

std::string normal_form(std::string_view layer) {
    std::string token = lower(last_token(layer));
    std::erase_if(token, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    for (const std::string_view prefix : {"vrayre", "blender", "beauty", "aov"})
        if (token.size() > prefix.size() && token.starts_with(prefix)) return token.substr(prefix.size());
    return token;
}

std::string normal_component(std::string_view component) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kLong = {
        {{"red", "r"}, {"green", "g"}, {"blue", "b"}, {"alpha", "a"}}};
    std::string text = lower(component);
    for (const auto& [name, letter] : kLong)
        if (text == name) return std::string(letter);
    return text;
}

std::string without_view(std::string_view name, std::string_view view) {
    if (!view.empty() && name.size() > view.size() + 1 && name.ends_with(view)) {
        const char separator = name[name.size() - view.size() - 1];
        if (separator == '.' || separator == '_') return std::string(name.substr(0, name.size() - view.size() - 1));
    }
    return std::string(name);
}

}  // namespace burnish
