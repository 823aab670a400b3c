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
Color3f peak_of(const Parametrization& parametrization, const FactorTerm& term) {
    Color3f product(1, 1, 1);
    for (const Factor& factor : parametrization.factors) product *= peak_of(term[factor.map]);
    return product;
}

/// The share of a map's texels, as they count, that is below zero.
double share_below_zero(const FactorMap& map) {
    double below = 0, all = 0;
    for (const Color3f& texel : map.texels)
        for (int c = 0; c < 3; ++c) below += std::max(-texel[c], 0.0f), all += std::fabs(texel[c]);
    return all > 0 ? below / all : 0;
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

[[noreturn]] void refuse(const std::string& why) { throw Error(ErrorCode::bad_argument, "8-bit maps: " + why); }

void check(const Factors& factors) {
    constexpr double kMostBelow = 0.05;  // of a map: cutting off more would show
    for (const FactorTerm& term : factors.terms)
        for (const FactorMap& map : term)
            if (share_below_zero(map) > kMostBelow)
                refuse("the maps of several terms of parametrisation " + factors.parametrization->name +
                       " live by texels below zero; write EXR, make one term, or take parametrisation nre");
}

void check(const QuantiseSettings& settings, size_t maps) {
    if (!settings.weights.empty() && settings.weights.size() != maps + 1)
        refuse("expected " + std::to_string(maps + 1) + " prescale weights, of the colour and of each map, found " +
               std::to_string(settings.weights.size()));
    for (const float weight : settings.weights)
        if (!(weight >= 1e-15f && weight <= 1e15f))
            refuse("expected prescale weights above 0, found " + std::to_string(weight));
    if (!(settings.white >= 0 && settings.white <= 1e12f))
        refuse("expected a white above 0, found " + std::to_string(settings.white));
    if (settings.scale != std::exp2(std::round(std::log2(settings.scale))) || settings.scale < 1 || settings.scale > kMostScale)
        refuse("expected a scale of 1, 2, 4, 8 or 16, found " + std::to_string(settings.scale));
}

QuantisedTerm quantised_term(const Parametrization& parametrization, const FactorTerm& term, const QuantiseSettings& settings) {
    check(settings, term.size());
    const std::vector<float> ones(term.size() + 1, 1.0f);
    QuantisedTerm result;
    result.prescale = prescale_of_weights(parametrization, settings.weights.empty() ? ones : settings.weights);
    const Color3f whole = peak_of(parametrization, term) * result.prescale[0];
    result.white = settings.white > 0 ? settings.white : largest(whole) / settings.scale;
    const Color3f color = whole / result.white;
    constexpr float kRounding = 1e-5f;
    while (result.scale < largest(color) * (1 - kRounding) && result.scale < kMostScale) result.scale *= 2;
    result.color = clamped(color / result.scale);
    const float lift = std::max(largest(color), 1.0f);
    for (size_t map = 0; map < term.size(); ++map)
        result.maps.push_back(quantised_map(term[map], result.prescale[map + 1], lift, settings.alpha));
    return result;
}

}  // namespace

Color3f QuantisedFactors::operator()(const DirectionPair& pair) const {
    Color3f all(0, 0, 0);
    for (const QuantisedTerm& term : terms) {
        float product[4] = {term.color.x * term.scale, term.color.y * term.scale, term.color.z * term.scale, term.white};
        for (const Factor& factor : parametrization->factors) {
            const QuantisedMap& map = term.maps[factor.map];
            const BlendedTexels blend = map.layout.lookup(factor.direction->project(pair, guide));
            for (int c = 0; c < 4; ++c) {
                float sum = 0;
                for (size_t i = 0; i < blend.texel.size(); ++i) sum += blend.weight[i] * map.texels[blend.texel[i]][c];
                product[c] *= sum / 255;
            }
        }
        all += clamped(Color3f(product[0], product[1], product[2])) * product[3];
    }
    return all;
}

QuantisedFactors quantise(const Factors& factors, std::span<const QuantiseSettings> settings) {
    check(factors);
    QuantisedFactors result;
    result.parametrization = factors.parametrization, result.guide = factors.guide;
    for (size_t term = 0; term < factors.terms.size(); ++term)
        result.terms.push_back(quantised_term(*factors.parametrization, factors.terms[term], settings[term % settings.size()]));
    return result;
}

Factors one_term(const Factors& factors, size_t term) {
    Factors one = factors;
    one.terms = {factors.terms[term]};
    return one;
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
