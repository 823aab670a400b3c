#include <burnish/output/factors_writer.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/factor/factors_file.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/preview.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <list>

namespace burnish {
namespace {

constexpr float kLargestHalf = 65504;

Image picture_of(const FactorMap& map) {
    Image picture(map.layout.width(), map.layout.height(), 3);
    for (size_t i = 0; i < picture.pixel_count(); ++i) std::copy_n(&map.texels[i].x, 3, picture.at(i));
    return picture;
}

Image picture_of(const QuantisedMap& map) {
    Image picture(map.layout.width(), map.layout.height(), 4);
    for (size_t i = 0; i < picture.pixel_count(); ++i)
        std::ranges::transform(map.texels[i], picture.at(i), [](uint8_t byte) { return static_cast<float>(byte) / 255; });
    return picture;
}

bool fits_half(const Image& picture) {
    return std::ranges::all_of(picture.data, [](float value) { return std::fabs(value) <= kLargestHalf; });
}

}  // namespace

void write_factors(const std::string& file, const StoredFactors& stored) {
    if (std::filesystem::path(file).extension() != ".exr")
        throw Error(ErrorCode::bad_argument, file + ": factors are written as EXR; end the name in .exr");
    std::list<Image> pictures;  // parts point to them
    std::vector<OutputPart> parts;
    AovFrame frame;
    for (size_t term = 0; term < stored.factors.terms.size(); ++term)
        for (int map = 0; map < stored.factors.parametrization->map_count(); ++map) {
            const Image& picture = pictures.emplace_back(picture_of(stored.factors.terms[term][map]));
            parts.push_back({map_name(*stored.factors.parametrization, map, term), {{{"R", "G", "B"}, &picture}}});
            frame.display_window.width = std::max(frame.display_window.width, picture.width);
            frame.display_window.height = std::max(frame.display_window.height, picture.height);
        }
    const PixelType type = std::ranges::all_of(pictures, fits_half) ? PixelType::half : PixelType::float32;
    write_exr_parts(file, frame, parts, type, {{kFactorsAttribute, factors_to_json(stored).dump()}});
}

nlohmann::json eight_bit_to_json(const QuantisedFactors& eight_bit) {
    nlohmann::json terms = nlohmann::json::array();
    for (const QuantisedTerm& term : eight_bit.terms) {
        nlohmann::json prescale = nlohmann::json::array();
        for (const float s : term.prescale) prescale.push_back(to_json_number(s));
        terms.push_back({{"white", to_json_number(term.white)},
                         {"color", to_json_color(term.color)},
                         {"scale", to_json_number(term.scale)},
                         {"prescale", prescale}});
    }
    return {{"formula", "sum over terms of white * min(color * product of rgb * scale, 1) * product of alpha"},
            {"terms", terms}};
}

std::vector<std::string> write_quantised(const std::string& folder, const std::string& name, const StoredFactors& stored,
                                         const QuantisedFactors& eight_bit) {
    const std::string stem = (std::filesystem::path(folder) / name).string();
    std::vector<std::string> files;
    for (size_t term = 0; term < eight_bit.terms.size(); ++term)
        for (size_t map = 0; map < eight_bit.terms[term].maps.size(); ++map) {
            files.push_back(stem + '_' + map_name(*eight_bit.parametrization, static_cast<int>(map), term) + ".png");
            write_code_values(files.back(), picture_of(eight_bit.terms[term].maps[map]));
        }
    nlohmann::json beside = factors_to_json(stored);
    beside["eight_bit"] = eight_bit_to_json(eight_bit);
    files.push_back(stem + ".json");
    write_text(files.back(), beside.dump(2) + "\n");
    return files;
}

}  // namespace burnish
