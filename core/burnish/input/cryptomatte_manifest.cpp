#include <burnish/input/cryptomatte.h>
#include <burnish/input/cryptomatte_manifest.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

namespace burnish {
namespace fs = std::filesystem;
namespace {

constexpr uintmax_t kLargestManifest = 256u << 20;  // bytes; two million long names

std::optional<uint32_t> id_of(const nlohmann::json& value) {
    if (!value.is_string()) return std::nullopt;
    const auto& text = value.get_ref<const std::string&>();
    uint32_t id = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id, 16);
    if (text.size() != 8 || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return cryptomatte_id_of_hash(id);
}

/// True for a plain path below the folder it is relative to.
bool stays_inside(const fs::path& path) {
    if (path.empty() || path.is_absolute() || path.has_root_name()) return false;
    for (const fs::path& part : path)
        if (part == "..") return false;
    return true;
}

}  // namespace

std::map<std::string, uint32_t> parse_manifest(const std::string& text, const std::string& where,
                                               std::vector<std::string>& warnings) {
    constexpr bool kThrow = false;
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, kThrow);
    if (!json.is_object()) {
        warnings.push_back(where + ": the manifest is not a JSON object and is not used; objects are found by exact name");
        return {};
    }
    std::map<std::string, uint32_t> manifest;
    size_t damaged = 0;
    for (const auto& [name, value] : json.items()) {
        if (const auto id = id_of(value))
            manifest.emplace(name, *id);
        else
            ++damaged;
    }
    if (damaged != 0)
        warnings.push_back(where + ": " + std::to_string(damaged) + " manifest entries have no id of 8 hex digits; left out");
    return manifest;
}

std::string read_manifest_file(const std::string& exr, const std::string& name, std::vector<std::string>& warnings) {
    const auto refuse = [&](const std::string& reason) {
        warnings.push_back(exr + ": manifest file " + name + " " + reason + "; objects are found by exact name");
        return std::string();
    };
    if (!stays_inside(name)) return refuse("lies outside the folder of the EXR and is not opened");
    const fs::path path = fs::path(exr).parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return refuse("is not there");
    if (fs::file_size(path, error) > kLargestManifest || error) return refuse("is too large");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return refuse("cannot be read");
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace burnish
