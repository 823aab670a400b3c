#include <burnish/factor/quantise.h>

#include <burnish/base/error.h>

#include <algorithm>
#include <string>

namespace burnish {
namespace {

constexpr float kMostScale = 16;  // beyond it, 8 bits are too few even with alpha (Factor 4.3.2)

float largest(const Color3f& c) { return std::max({c.x, c.y, c.z}); }

Color3f clamped(const Color3f& c) {
    return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

float uses(const Parametrization& parametrization, size_t map) {
    return static_cast<float>(parametrization.uses(static_cast<int>(map)));
}

/// The largest of each channel; 1 for one that is black.
Color3f peak_of(const FactorMap& map) {
    Color3f peak(0, 0, 0);
    for (const Color3f& texel : map.texels)
        for (int c = 0; c < 3; ++c) peak[c] = std::max(peak[c], texel[c]);
    for (int c = 0; c < 3; ++c) peak[c] = peak[c] > 0 ? peak[c] : 1;
    return peak;
}

/// What all maps make together where they are largest.
Color3f peak_of(const Factors& factors) {
    Color3f product(1, 1, 1);
    for (const Factor& factor : factors.parametrization->factors) product *= peak_of(factors.terms[0][factor.map]);
    return product;
}

/// Colour and alpha whose product is `value`, the colour at most 1 / `lift`.
std::array<uint8_t, 4> texel_with_alpha(const Color3f& value, float lift) {
    const float alpha = std::clamp(std::ceil(255 * largest(value) * lift), 1.0f, 255.0f);
    const auto byte = [&](float x) { return static_cast<uint8_t>(std::lround(std::min(255 * x * 255 / alpha, 255.0f))); };
    return {byte(value.x), byte(value.y), byte(value.z), static_cast<uint8_t>(alpha)};
}

std::array<uint8_t, 4> opaque_texel(const Color3f& value) {
    const auto byte = [](float x) { return static_cast<uint8_t>(std::lround(255 * x)); };
    return {byte(value.x), byte(value.y), byte(value.z), 255};
}

QuantisedMap quantised_map(const FactorMap& map, float prescale, float lift, bool alpha) {
    QuantisedMap result{map.layout, {}};
    const Color3f peak = peak_of(map);
    for (const Color3f& texel : map.texels) {
        const Color3f value = clamped(texel / peak * prescale);
        result.texels.push_back(alpha ? texel_with_alpha(value, lift) : opaque_texel(value));
    }
    return result;
}

void check(const Factors& factors, const QuantiseSettings& settings) {
    const auto refuse = [](const std::string& why) { throw Error(ErrorCode::bad_argument, "8-bit maps: " + why); };
    if (factors.terms.size() != 1)
        refuse("there are " + std::to_string(factors.terms.size()) +
               " terms, and the maps of those after the first have texels below zero; write EXR, or make one term");
    const size_t expected = factors.terms[0].size() + 1;
    if (!settings.weights.empty() && settings.weights.size() != expected)
        refuse("expected " + std::to_string(expected) + " prescale weights, of the colour and of each map, found " +
               std::to_string(settings.weights.size()));
    for (const float weight : settings.weights)
        if (!(weight >= 1e-15f && weight <= 1e15f))
            refuse("expected prescale weights above 0, found " + std::to_string(weight));
    if (!(settings.white >= 0 && settings.white <= 1e12f))
        refuse("expected a white above 0, found " + std::to_string(settings.white));
    if (settings.scale != std::exp2(std::round(std::log2(settings.scale))) || settings.scale < 1 || settings.scale > kMostScale)
        refuse("expected a scale of 1, 2, 4, 8 or 16, found " + std::to_string(settings.scale));
}

}  // namespace

Color3f QuantisedFactors::operator()(const DirectionPair& pair) const {
    float product[4] = {color.x * scale, color.y * scale, color.z * scale, white};
    for (const Factor& factor : parametrization->factors) {
        const QuantisedMap& map = maps[factor.map];
        const BlendedTexels blend = map.layout.lookup(factor.direction->project(pair, guide));
        for (int c = 0; c < 4; ++c) {
            float sum = 0;
            for (size_t i = 0; i < blend.texel.size(); ++i) sum += blend.weight[i] * map.texels[blend.texel[i]][c];
            product[c] *= sum / 255;
        }
    }
    return clamped(Color3f(product[0], product[1], product[2])) * product[3];
}

QuantisedFactors quantise(const Factors& factors, const QuantiseSettings& settings) {
    check(factors, settings);
    const Parametrization& parametrization = *factors.parametrization;
    const std::vector<float> ones(factors.terms[0].size() + 1, 1.0f);
    QuantisedFactors result;
    result.parametrization = &parametrization, result.guide = factors.guide;
    result.prescale = prescale_of_weights(parametrization, settings.weights.empty() ? ones : settings.weights);
    const Color3f whole = peak_of(factors) * result.prescale[0];
    result.white = settings.white > 0 ? settings.white : largest(whole) / settings.scale;
    const Color3f color = whole / result.white;
    constexpr float kRounding = 1e-5f;
    while (result.scale < largest(color) * (1 - kRounding) && result.scale < kMostScale) result.scale *= 2;
    result.color = clamped(color / result.scale);
    const float lift = std::max(largest(color), 1.0f);
    for (size_t map = 0; map < factors.terms[0].size(); ++map)
        result.maps.push_back(quantised_map(factors.terms[0][map], result.prescale[map + 1], lift, settings.alpha));
    return result;
}

std::vector<float> prescale_of_weights(const Parametrization& parametrization, const std::vector<float>& weights) {
    const auto count = static_cast<float>(weights.size());
    float logarithm = std::log(weights[0]);  // of the product
    for (size_t map = 0; map + 1 < weights.size(); ++map) logarithm += uses(parametrization, map) * std::log(weights[map + 1]);
    std::vector<float> prescale = {weights[0] / std::exp(logarithm / count)};
    for (size_t map = 0; map + 1 < weights.size(); ++map)
        prescale.push_back(weights[map + 1] / std::exp(logarithm / (count * uses(parametrization, map))));
    return prescale;
}

}  // namespace burnish
