#include <burnish/factor/factors_file.h>

#include <burnish/base/error.h>
#include <burnish/base/json_text.h>
#include <burnish/input/exr_file.h>
#include <burnish/input/metadata.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace burnish {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
    throw Error(ErrorCode::read_failed, file + ": " + problem + "; write it again with burnish factor");
}

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// R, G and B of a map's part. The first part's layer may have no name (input/layers.h).
std::vector<ChannelRead> channels_of(const ExrFile& exr, const std::string& map, bool is_first, Image& image) {
    const Layer* layer = exr.find_layer(map);
    if (!layer && is_first) layer = exr.find_layer("");
    std::vector<ChannelRead> reads;
    for (const char* component : {"r", "g", "b"}) {
        const Channel* channel = layer ? layer->find(component) : nullptr;
        if (!channel) refuse(exr.name(), "expected the map " + map + " with R, G and B, found no such part");
        reads.push_back({*channel, &image, static_cast<int>(reads.size())});
    }
    return reads;
}

void read_map(const ExrFile& exr, const std::string& name, bool is_first, FactorMap& map) {
    Image image(map.layout.width(), map.layout.height(), 3);
    const std::vector<ChannelRead> reads = channels_of(exr, name, is_first, image);
    const Window window = exr.data_window(reads[0].channel.part);
    if (window.width != image.width || window.height != image.height)
        refuse(exr.name(), "expected the map " + name + " of " + size_text(image.width, image.height) + " texels, found " +
                               size_text(window.width, window.height));
    exr.read(reads, window);
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        map.texels.emplace_back(image.at(i)[0], image.at(i)[1], image.at(i)[2]);
        if (!is_finite(map.texels.back())) refuse(exr.name(), "the map " + name + " has texels that are no numbers");
    }
}

}  // namespace

StoredFactors read_factors(const std::string& file) {
    const ExrFile exr(file, "");
    const std::optional<std::string> text = string_attribute(*exr.metadata(0), kFactorsAttribute);
    if (!text) refuse(file, std::string("expected factors, found no attribute ") + kFactorsAttribute);
    const std::string where = file + ": " + kFactorsAttribute;
    StoredFactors stored = factors_from_json(parse_json(*text, where), where);
    for (size_t term = 0; term < stored.factors.terms.size(); ++term)
        for (int map = 0; map < stored.factors.parametrization->map_count(); ++map)
            read_map(exr, map_name(*stored.factors.parametrization, map, term), term == 0 && map == 0,
                     stored.factors.terms[term][map]);
    return stored;
}

}  // namespace burnish
