#include <burnish/base/error.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/input/cryptomatte_manifest.h>
#include <burnish/input/name_pattern.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <optional>

namespace burnish {
namespace {

// Letters, long names, and both in either case: Arnold R, Blender r, Clarisse red.
constexpr std::array<std::array<std::string_view, 2>, 4> kComponents{
    {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}}};
constexpr int kMostLayers = 100;  // two digits

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

bool ends_with_layer(std::string_view path, std::string_view layer) {
    return path == layer ||
           (path.size() > layer.size() && path.ends_with(layer) && path[path.size() - layer.size() - 1] == '.');
}

/// The four channels of a layer; fewer than four when the file has not all of them.
std::vector<CryptomatteSource::Channel> layer_channels(const CryptomatteSource& source, const std::string& layer) {
    std::vector<CryptomatteSource::Channel> found;
    for (const auto& [letter, word] : kComponents)
        for (const CryptomatteSource::Channel& channel : source.channels) {
            const size_t dot = channel.name.rfind('.');
            if (dot == std::string::npos || !ends_with_layer(std::string_view(channel.name).substr(0, dot), layer)) continue;
            const std::string component = lower(std::string_view(channel.name).substr(dot + 1));
            if (component != letter && component != word) continue;
            found.push_back(channel);
            break;
        }
    return found;
}

/// The channels of all layers; none when the cryptomatte cannot be used.
std::vector<std::string> rank_channels(const CryptomatteSource& source, const std::string& name,
                                       std::vector<std::string>& warnings) {
    std::vector<std::string> names;
    for (int number = 0; number < kMostLayers; ++number) {
        const std::string layer = name + (number < 10 ? "0" : "") + std::to_string(number);
        const auto channels = layer_channels(source, layer);
        if (channels.size() != 4) break;
        for (const CryptomatteSource::Channel& channel : channels) {
            names.push_back(channel.name);
            if (channel.is_float) continue;
            warnings.push_back(source.file + ": cryptomatte " + name + " is not used: channel " + channel.name +
                               " must be 32-bit float to hold ids; write cryptomattes as float");
            return {};
        }
    }
    if (names.empty())
        warnings.push_back(source.file + ": cryptomatte " + name + " is not used: no layer " + name + "00 with four channels");
    return names;
}

/// The attributes of one cryptomatte, by key.
struct Header {
    std::string name, manifest, manif_file, hash, conversion;
};

std::map<std::string, Header> headers(const std::vector<CryptomatteSource::Attribute>& attributes) {
    constexpr std::string_view kPrefix = "cryptomatte/";
    std::map<std::string, Header> result;
    for (const auto& [name, value] : attributes) {
        const size_t begin = name.starts_with("exr/") ? 4 : 0;  // Nuke's prefix
        if (name.compare(begin, kPrefix.size(), kPrefix) != 0) continue;
        const size_t key = begin + kPrefix.size(), slash = name.find('/', key);
        if (slash == std::string::npos) continue;
        Header& header = result[name.substr(key, slash - key)];
        const std::string field = name.substr(slash + 1);
        if (field == "name") header.name = value;
        if (field == "manifest") header.manifest = value;
        if (field == "manif_file") header.manif_file = value;
        if (field == "hash") header.hash = value;
        if (field == "conversion") header.conversion = value;
    }
    return result;
}

/// Patterns mean object names unless they say otherwise, so object cryptomattes come first.
int order_of(const Cryptomatte& cryptomatte) {
    const std::string name = lower(cryptomatte.name);
    if (name.find("object") != std::string::npos) return 0;
    if (name.find("material") != std::string::npos) return 1;
    return name.find("asset") != std::string::npos ? 2 : 0;
}

std::map<std::string, uint32_t> manifest_of(const CryptomatteSource& source, const Header& header,
                                            std::vector<std::string>& warnings) {
    std::string text = header.manifest;
    if (text.empty() && !header.manif_file.empty()) text = read_manifest_file(source.file, header.manif_file, warnings);
    if (text.empty()) return {};
    return parse_manifest(text, source.file + ": cryptomatte " + header.name, warnings);
}

}  // namespace

uint32_t cryptomatte_id(std::string_view name) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(name.data());
    const size_t blocks = name.size() / 4;
    const auto scramble = [](uint32_t k) { return std::rotl(k * 0xcc9e2d51u, 15) * 0x1b873593u; };
    uint32_t h = 0;
    for (size_t i = 0; i < blocks; ++i) {
        const unsigned char* b = bytes + 4 * i;
        const uint32_t k = b[0] | uint32_t{b[1]} << 8 | uint32_t{b[2]} << 16 | uint32_t{b[3]} << 24;
        h = std::rotl(h ^ scramble(k), 13) * 5 + 0xe6546b64u;
    }
    uint32_t tail = 0;
    for (size_t i = name.size(); i > 4 * blocks; --i) tail = tail << 8 | bytes[i - 1];
    h ^= scramble(tail) ^ static_cast<uint32_t>(name.size());
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return cryptomatte_id_of_hash(h ^ h >> 16);
}

std::vector<Cryptomatte> decode_cryptomattes(const CryptomatteSource& source, std::vector<std::string>& warnings) {
    std::vector<Cryptomatte> result;
    for (const auto& [key, header] : headers(source.attributes)) {
        const std::string where = source.file + ": cryptomatte " + (header.name.empty() ? key : header.name);
        if (header.name.empty()) {
            warnings.push_back(where + " is not used: its header has no name");
            continue;
        }
        const auto same_name = [&](const Cryptomatte& other) { return other.name == header.name; };
        if (std::any_of(result.begin(), result.end(), same_name)) continue;
        if ((!header.hash.empty() && header.hash != "MurmurHash3_32") ||
            (!header.conversion.empty() && header.conversion != "uint32_to_float32")) {
            warnings.push_back(where + " is not used: hash " + header.hash + " with conversion " + header.conversion +
                               "; expected MurmurHash3_32 with uint32_to_float32");
            continue;
        }
        Cryptomatte cryptomatte;
        cryptomatte.name = header.name;
        cryptomatte.channels = rank_channels(source, header.name, warnings);
        if (cryptomatte.channels.empty()) continue;
        cryptomatte.manifest = manifest_of(source, header, warnings);
        result.push_back(std::move(cryptomatte));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Cryptomatte& a, const Cryptomatte& b) { return order_of(a) < order_of(b); });
    return result;
}

std::vector<uint32_t> matching_ids(const Cryptomatte& cryptomatte, const std::string& patterns) {
    if (const auto exact = cryptomatte.manifest.find(patterns); exact != cryptomatte.manifest.end()) return {exact->second};
    std::vector<uint32_t> ids;
    for (const NamePattern& pattern : name_patterns(patterns)) {
        if (!pattern.has_wildcards()) {
            const auto listed = cryptomatte.manifest.find(pattern.literal());
            ids.push_back(listed != cryptomatte.manifest.end() ? listed->second : cryptomatte_id(pattern.literal()));
            continue;
        }
        if (cryptomatte.manifest.empty())
            throw Error(ErrorCode::bad_argument,
                        "cryptomatte " + cryptomatte.name + " has no manifest to look up \"" + patterns +
                            "\" in; give full object names without * and ?, or render with a manifest");
        for (const auto& [name, id] : cryptomatte.manifest)
            if (pattern.matches(name)) ids.push_back(id);
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

float cryptomatte_coverage(const Cryptomatte& cryptomatte, const std::vector<uint32_t>& ids, size_t pixel) {
    float sum = 0;
    for (const Image& rank : cryptomatte.ranks) {
        const float* entry = rank.at(pixel);
        if (!(entry[1] > 0)) break;  // largest coverage first
        if (std::binary_search(ids.begin(), ids.end(), std::bit_cast<uint32_t>(entry[0]))) sum += entry[1];
    }
    return std::min(sum, 1.0f);
}

Image cryptomatte_coverage(const Cryptomatte& cryptomatte, const std::vector<uint32_t>& ids) {
    const Image& first = cryptomatte.ranks.front();
    Image coverage(first.width, first.height, 1);
    for (size_t i = 0; i < coverage.pixel_count(); ++i) coverage.data[i] = cryptomatte_coverage(cryptomatte, ids, i);
    return coverage;
}

}  // namespace burnish
