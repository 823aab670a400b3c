#include <burnish/light/picture_reader.h>

#include <burnish/base/error.h>
#include <burnish/input/channel_names.h>
#include <burnish/input/layers.h>
#include <burnish/input/roles.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace burnish {
namespace {

constexpr int64_t kMaxPixels = int64_t{1} << 28;      // 16384 x 16384
constexpr int64_t kSmallPicture = int64_t{64} << 20;  // bytes; below this any compression is believed
constexpr int64_t kMaxCompression = 4096;             // zip reaches about 1000
constexpr int64_t kHdrPixelsPerByte = 16;             // run lengths of 127 in each of four planes: 8 bytes for 127 pixels

/// Messages are one line, OpenImageIO's may be several.
[[noreturn]] void refuse(const std::string& file, std::string problem) {
    std::replace(problem.begin(), problem.end(), '\n', ' ');
    throw Error(ErrorCode::read_failed, file + ": " + problem);
}

int64_t bytes_on_disk(const std::string& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) refuse(file, "no such file. Check the path of the environment.");
    const auto size = std::filesystem::file_size(file, failed);
    if (failed || size == 0) refuse(file, "the file is empty or cannot be read.");
    return static_cast<int64_t>(size);
}

/// Radiance files say their size in a line of text, "-Y height +X width"; OpenImageIO 2.4 trusts it blindly.
void check_radiance_header(const std::string& file, int64_t bytes) {
    std::ifstream in(file, std::ios::binary);
    std::string head(static_cast<size_t>(std::min<int64_t>(bytes, 65536)), '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    const std::string extension = std::filesystem::path(file).extension().string();
    const bool named = extension == ".hdr" || extension == ".rgbe" || extension == ".HDR";
    if (!named && head.compare(0, 2, "#?") != 0) return;
    if (head.compare(0, 2, "#?") != 0)
        refuse(file, "not a Radiance picture: expected it to start with #?. Save it again as .hdr or .exr.");

    const size_t blank = head.find("\n\n");
    const size_t end = blank == std::string::npos ? blank : head.find('\n', blank + 2);
    if (end == std::string::npos) refuse(file, "the Radiance header has no line with the picture's size. The file is damaged.");
    const std::string line = head.substr(blank + 2, end - blank - 2);
    std::istringstream words(line);
    std::string first, second, rest;
    int64_t rows = 0, columns = 0;
    const bool parsed = static_cast<bool>(words >> first >> rows >> second >> columns) && !(words >> rest) &&
                        first.size() == 2 && second.size() == 2 && rows > 0 && columns > 0;
    if (!parsed)
        refuse(file, "the Radiance header says \"" + line.substr(0, 60) +
                         "\" where \"-Y height +X width\" was expected. The file is damaged.");
    if (rows > kMaxPixels / columns || rows * columns > kHdrPixelsPerByte * bytes) {
        refuse(file, "the header promises " + std::to_string(columns) + " x " + std::to_string(rows) +
                         " pixels, more than the file's " + std::to_string(bytes) + " bytes can hold. The file is damaged.");
    }
}

void check_size(const std::string& file, const OIIO::ImageSpec& spec, int64_t bytes) {
    const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
    if (spec.deep) refuse(file, "deep images hold no environment. Flatten it first.");
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1)
        refuse(file, "a picture of " + size + " pixels is no environment.");
    if (spec.height > kMaxPixels / spec.width)
        refuse(file, size + " pixels are more than burnish reads. Make the environment smaller.");
    const int64_t needed = static_cast<int64_t>(spec.width) * spec.height * static_cast<int64_t>(spec.pixel_bytes(true));
    if (needed > kSmallPicture && needed / kMaxCompression > bytes) {
        refuse(file, "the header promises " + size + " pixels, more than the file's " + std::to_string(bytes) +
                         " bytes can hold. The file is damaged.");
    }
}

/// The first layer of `role`, by its aliases best first, that `fits`; null when there is none.
template <class Fits>
const Layer* layer_of_role(const std::vector<Layer>& layers, Role role, const Fits& fits) {
    for (const std::string_view alias : role_info(role).aliases)
        for (const Layer& layer : layers)
            if (normal_form(layer.name) == alias && fits(layer)) return &layer;
    return nullptr;
}

/// Indices of the channels that a layer of the picture is made of; none where the file does not have it.
std::vector<int> channels_of(const OIIO::ImageSpec& spec, PictureLayer wanted) {
    const std::vector<ChannelType> types(spec.channelnames.size(), ChannelType::float32);
    const std::vector<Layer> layers = gather_layers({{"", "", spec.channelnames, types, {}}}, "");
    if (wanted == PictureLayer::distance) {
        const Layer* depth = layer_of_role(layers, Role::depth, [](const Layer&) { return true; });
        if (depth) return {depth->channels[0].index};
        return spec.nchannels == 1 ? std::vector<int>{0} : std::vector<int>{};
    }
    const Layer* color = layer_of_role(
        layers, Role::beauty, [](const Layer& layer) { return layer.find("r") && layer.find("g") && layer.find("b"); });
    if (wanted == PictureLayer::alpha) {
        const Layer* main = color ? color : layer_of_role(layers, Role::alpha, [](const Layer&) { return true; });
        const Channel* alpha = main ? main->find("a") : nullptr;
        return alpha ? std::vector<int>{alpha->index} : std::vector<int>{};
    }
    if (color) return {color->find("r")->index, color->find("g")->index, color->find("b")->index};
    return spec.nchannels <= 2 ? std::vector<int>{0, 0, 0} : std::vector<int>{};
}

[[noreturn]] void refuse_missing(const std::string& file, const OIIO::ImageSpec& spec, PictureLayer layer) {
    std::string found;
    for (const std::string& name : spec.channelnames) found += (found.empty() ? "" : ", ") + name;
    found = ", found " + found.substr(0, 200) + ".";
    if (layer == PictureLayer::color) refuse(file, "no colour: expected channels R, G, B or Combined.R, G, B" + found);
    const std::string expected =
        layer == PictureLayer::alpha ? "no alpha: expected a channel A" : "no distances: expected a channel Z or Depth.Z";
    throw Error(ErrorCode::missing_channel, file + ": " + expected + found);
}

EnvmapTag tag_of(const OIIO::ImageSpec& spec) {
    const std::string format = spec.get_string_attribute("textureformat");
    if (format == "LatLong Environment") return EnvmapTag::latlong;
    return format == "CubeFace Environment" ? EnvmapTag::cube : EnvmapTag::none;
}

/// The picture upright: Radiance files may store it mirrored or turned.
Image upright(Image picture, int orientation) {
    if (orientation == 1) return picture;
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeFloat);
    spec.attribute("Orientation", orientation);
    const OIIO::ImageBuf turned = OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(spec, picture.data.data()));
    Image out(turned.spec().width, turned.spec().height, picture.channels);
    turned.get_pixels(OIIO::ROI::All(), OIIO::TypeFloat, out.data.data());
    return out;
}

Image read_channels(const std::string& file, OIIO::ImageInput& in, const std::vector<int>& channels) {
    const OIIO::ImageSpec& spec = in.spec();
    const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
    const int begin = *first, count = *last - begin + 1;
    std::vector<float> pixels(static_cast<size_t>(spec.width) * spec.height * count);
    if (!in.read_image(0, 0, begin, begin + count, OIIO::TypeFloat, pixels.data()))
        refuse(file, "cannot be read: " + in.geterror());
    Image picture(spec.width, spec.height, static_cast<int>(channels.size()));
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        for (size_t k = 0; k < channels.size(); ++k) picture.at(i)[k] = pixels[i * count + channels[k] - begin];
    }
    return upright(std::move(picture), spec.get_int_attribute("Orientation", 1));
}

/// Calls `read(in)` on the open and checked file.
template <class Read>
auto with_open(const std::string& file, const Read& read) {
    const int64_t bytes = bytes_on_disk(file);
    check_radiance_header(file, bytes);
    try {
        const auto in = OIIO::ImageInput::open(file);
        if (!in) refuse(file, "not a picture burnish can read: " + OIIO::geterror());
        check_size(file, in->spec(), bytes);
        return read(*in);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        refuse(file, std::string("cannot be read: ") + problem.what());
    }
}

}  // namespace

Picture read_picture(const std::string& file, PictureLayer layer) {
    return with_open(file, [&](OIIO::ImageInput& in) -> Picture {
        const std::vector<int> channels = channels_of(in.spec(), layer);
        if (channels.empty()) refuse_missing(file, in.spec(), layer);
        return {read_channels(file, in, channels), tag_of(in.spec())};
    });
}

bool has_layer(const std::string& file, PictureLayer layer) {
    return with_open(file, [&](OIIO::ImageInput& in) { return !channels_of(in.spec(), layer).empty(); });
}

}  // namespace burnish
