#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>
#include <burnish/material/library.h>
#include <burnish/material/measured_library.h>
#include <burnish/merl_sgd_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::string_view kPrefix = "merl:";

const json& merl() {
    static const json materials = json::parse(kMerlSgdJson).at("materials");
    return materials;
}

/// " (did you mean "merl:brass"?)", else those that hold the word.
std::string suggestion(const std::string& name) {
    const std::vector<std::string_view> known(library_names().begin(), library_names().end());
    if (const std::string nearest = did_you_mean(name, known); !nearest.empty()) return nearest;
    const std::string_view word = std::string_view(name).substr(kPrefix.size());
    std::string similar;
    for (const std::string_view other : known)
        if (!word.empty() && other.substr(kPrefix.size()).find(word) != std::string_view::npos)
            similar += (similar.empty() ? "" : ", ") + std::string(other);
    return similar.empty() ? "" : " (similar: " + similar + ")";
}

}  // namespace

std::span<const std::string> library_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& item : merl().items()) all.push_back(std::string(kPrefix) + item.key());
        return all;
    }();
    return names;
}

bool is_library_name(std::string_view name) { return name.starts_with(kPrefix); }

const json& library_json(const std::string& name) {
    const auto found = is_library_name(name) ? merl().find(name.substr(kPrefix.size())) : merl().end();
    if (found == merl().end())
        throw Error(ErrorCode::bad_argument,
                    "material: unknown name \"" + name + "\"" + suggestion(name) + "; \"burnish models\" lists the library");
    return *found;
}

Material library_material(const std::string& name) { return material_from_json(library_json(name), name, name); }

}  // namespace burnish
