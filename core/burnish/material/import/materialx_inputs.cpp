#include <burnish/material/import/materialx_inputs.h>

#include <burnish/base/error.h>

#include <charconv>
#include <cstring>

namespace burnish {
namespace {

/// Colours written as a display shows them are turned into light.
float linear_of_srgb(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

bool is_srgb(pugi::xml_node input) {
    for (pugi::xml_node node = input; node; node = node.parent())
        if (const auto space = node.attribute("colorspace")) return std::strcmp(space.value(), "srgb_texture") == 0;
    return false;
}

[[noreturn]] void fail(const std::string& where, size_t count, NumberRange range, const std::string& text) {
    char numbers[80];
    std::snprintf(numbers, sizeof numbers, "expected %zu number%s between %g and %g, found ", count, count > 1 ? "s" : "",
                  range.min, range.max);
    throw Error(ErrorCode::bad_argument, where + ": " + numbers + "\"" + text.substr(0, 60) + "\"");
}

}  // namespace

std::vector<float> MaterialxInputs::values(const char* name, size_t count, NumberRange range, float preset) {
    m_asked.insert(name);
    const pugi::xml_node input = m_node.find_child_by_attribute("input", "name", name);
    const std::string where = m_where + "." + name, text = input.attribute("value").value();
    if (text.empty()) {
        if (input) m_notes.push_back(where + " comes from a texture or graph, which is left out: the default holds everywhere");
        return std::vector(count, preset);
    }
    std::vector<float> values;
    const char *at = text.data(), *end = at + text.size();
    while (at < end && values.size() < count) {
        while (at < end && (*at == ' ' || *at == ',')) ++at;
        float value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !(value >= range.min && value <= range.max)) fail(where, count, range, text);
        values.push_back(value), at = next;
    }
    if (values.size() != count || text.find_first_not_of(" ", static_cast<size_t>(at - text.data())) != std::string::npos)
        fail(where, count, range, text);
    return values;
}

float MaterialxInputs::number(const char* name, NumberRange range, float preset) { return values(name, 1, range, preset)[0]; }

Color3f MaterialxInputs::color(const char* name, NumberRange range, const Color3f& preset) {
    const pugi::xml_node input = m_node.find_child_by_attribute("input", "name", name);
    std::vector<float> rgb = values(name, 3, range, 0);
    if (!input.attribute("value")) return preset;
    for (float& value : rgb) value = is_srgb(input) ? linear_of_srgb(value) : value;
    return {rgb[0], rgb[1], rgb[2]};
}

std::vector<std::string> MaterialxInputs::notes() const {
    std::vector<std::string> notes = m_notes;
    for (const pugi::xml_node input : m_node.children("input"))
        if (!m_asked.contains(input.attribute("name").value()))
            notes.push_back(m_where + "." + input.attribute("name").value() + " is left out");
    return notes;
}

}  // namespace burnish
