#include <burnish/material/import/gltf_file.h>

#include <burnish/base/error.h>
#include <burnish/base/json_text.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace burnish {

using nlohmann::json;

namespace {

constexpr uint64_t kLargestFile = 1 << 30;  // bytes

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
    throw Error(ErrorCode::read_failed, file + ": " + problem);
}

uint64_t size_of(const std::string& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error) refuse(file, "cannot be read (" + error.message() + "); check its path and permissions");
    if (size > kLargestFile) refuse(file, "is larger than the 1 GiB burnish reads; leave pictures out of it");
    return size;
}

/// All of a .gltf, the first chunk of a .glb.
std::string json_text(const std::string& file) {
    const uint64_t size = size_of(file);
    std::ifstream stream(file, std::ios::binary);
    uint32_t head[5] = {};  // "glTF", version, length, length of the first chunk, "JSON"
    stream.read(reinterpret_cast<char*>(head), sizeof head);
    if (std::memcmp(head, "glTF", 4) != 0) {
        stream.clear(), stream.seekg(0);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    if (head[1] != 2)
        refuse(file, "expected glTF 2, found version " + std::to_string(head[1]) + "; export it again as glTF 2.0");
    if (size < sizeof head || head[3] > size - sizeof head || std::memcmp(head + 4, "JSON", 4) != 0)
        refuse(file, "the file is cut short or damaged; export it again");
    std::string text(head[3], '\0');
    stream.seekg(sizeof head), stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
}

json parsed(const std::string& file) {
    const std::string text = json_text(file);
    try {
        return parse_json(text, file);
    } catch (const Error& error) {
        refuse(error.what(), "is it glTF? Export it again");
    }
}

}  // namespace

json read_gltf(const std::string& file) {
    json document = parsed(file);
    const json asset = document.is_object() ? document.value("asset", json()) : json();
    const json version = asset.is_object() ? asset.value("version", json()) : json();
    if (!version.is_string() || !version.get<std::string>().starts_with("2."))
        refuse(file, "expected glTF 2.0 with its asset.version; export it again as glTF 2.0");
    return document;
}

}  // namespace burnish
