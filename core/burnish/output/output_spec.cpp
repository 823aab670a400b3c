#include <burnish/base/error.h>
#include <burnish/input/metadata_spec.h>
#include <burnish/output/output_spec.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace burnish {
namespace {

const std::string kSoftware = "burnish " BURNISH_VERSION;
const std::string kHistory = "burnish/history";

/// Attributes that speak of the input's channels, storage or reader, and would lie about the output.
bool is_stale(const std::string& name) {
    static constexpr std::array kPrefixes = {"oiio:", "openexr:", "cryptomatte/", "arnold/aovs/", "Exif:"};
    static constexpr std::array kNames = {"name",
                                          "type",
                                          "version",
                                          "compression",
                                          "compressionName",
                                          "dwaCompressionLevel",
                                          "lineOrder",
                                          "tiles",
                                          "chunkCount",
                                          "textureformat",
                                          "multiView",
                                          "maxSamplesPerPixel",
                                          "planarconfig",
                                          "wrapmodes",
                                          "fovcot",
                                          "envmap",
                                          "Software",
                                          "tilewidth",
                                          "tileheight",
                                          "BlenderMultiChannel",
                                          "preview",
                                          "burnish:job",
                                          "thumbnail",
                                          "screenWindowWidthScale"};
    return std::any_of(kPrefixes.begin(), kPrefixes.end(), [&](const char* prefix) { return name.starts_with(prefix); }) ||
           std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

void keep_attributes(const AovFrame& frame, OIIO::ImageSpec& spec) {
    if (!frame.metadata) return;
    for (const OIIO::ParamValue& attribute : frame.metadata->spec.extra_attribs) {
        const std::string name = attribute.name().string();
        if (is_stale(name)) continue;
        spec.extra_attribs.push_back(attribute);
        // OpenImageIO would write V-Ray's camera-to-world matrix as the standard worldToCamera, its inverse.
        if (name == "worldtocamera") {
            spec.extra_attribs.back() = OIIO::ParamValue("cameraTransform", attribute.type(), 1, attribute.data());
        }
    }
}

void add_history(const AovFrame& frame, const std::vector<OutputLayer>& layers, OIIO::ImageSpec& spec) {
    std::string line = kSoftware + ": ";
    if (!frame.file.empty()) line += std::filesystem::path(frame.file).filename().string() + " -> ";
    std::string separator;
    for (const OutputLayer& layer : layers)
        for (const std::string& channel : layer.channels) line += std::exchange(separator, " ") + channel;
    const std::string before = spec.get_string_attribute(kHistory);
    spec.attribute(kHistory, before.empty() ? line : before + "\n" + line);
    spec.attribute("Software", kSoftware);
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_plain_token(std::string_view token) {
    const auto fits = [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !token.empty() && is_letter(token.front()) && std::all_of(token.begin(), token.end(), fits);
}

/// "R" or "burnish_spec.R".
bool is_plain_name(std::string_view channel) {
    const size_t dot = channel.find('.');
    return is_plain_token(channel.substr(0, dot)) && (dot == std::string_view::npos || is_plain_token(channel.substr(dot + 1)));
}

void name_channels(const std::string& file, const std::vector<OutputLayer>& layers, OIIO::ImageSpec& spec) {
    std::set<std::string> seen;
    spec.channelnames.clear();
    for (const OutputLayer& layer : layers) {
        for (const std::string& channel : layer.channels) {
            if (!is_plain_name(channel))
                throw Error(ErrorCode::bad_argument, file + ": channel name \"" + channel +
                                                         "\": use letters, digits and _, letters first, one dot at most, "
                                                         "as in burnish_spec.R");
            if (!seen.insert(channel).second)
                throw Error(ErrorCode::bad_argument, file + ": channel \"" + channel + "\" is given twice");
            spec.channelnames.push_back(channel);
        }
    }
}

}  // namespace

OIIO::ImageSpec output_spec(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers,
                            PixelType type, const HeaderTexts& attributes) {
    int channels = 0;
    for (const OutputLayer& layer : layers) channels += static_cast<int>(layer.channels.size());
    if (channels == 0) throw Error(ErrorCode::bad_argument, file + ": there are no channels to write");
    OIIO::ImageSpec spec(frame.data_window.width, frame.data_window.height, channels,
                         type == PixelType::half ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.x = frame.data_window.x, spec.y = frame.data_window.y;
    spec.full_x = frame.display_window.x, spec.full_y = frame.display_window.y;
    spec.full_width = frame.display_window.width, spec.full_height = frame.display_window.height;
    name_channels(file, layers, spec);
    keep_attributes(frame, spec);
    add_history(frame, layers, spec);
    for (const auto& [name, text] : attributes) spec.attribute(name, text);
    spec.attribute("compression", "zip");
    // OpenImageIO stamps the time of writing into files without a date; an empty one keeps same job, same bits.
    if (!spec.find_attribute("DateTime")) spec.attribute("DateTime", "");
    return spec;
}

}  // namespace burnish
