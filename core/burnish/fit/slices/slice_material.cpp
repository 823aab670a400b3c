#include <burnish/fit/slices/slice_material.h>

#include <burnish/fit/search/lobe_space.h>
#include <burnish/material/any_model.h>

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

/// The lobe of a shape at strength 1, its own numbers the same in every channel.
LobeParameters lobe_of(const ShapeFamily& family, Shape shape) {
    LobeParameters lobe;
    lobe.model = model_by_name(family.model);
    const auto number = [&](size_t i) { return static_cast<float>(shape[i]); };
    if (lobe.model == ModelId::sgd) {
        lobe.extra = default_parameters(model_info(lobe.model));
        for (size_t c = 0; c < 3; ++c) {
            lobe.extra[c] = number(0), lobe.extra[3 + c] = number(1);
            if (shape.size() < 5) continue;
            lobe.extra[6 + c] = number(2), lobe.extra[12 + c] = number(4);
            lobe.extra[9 + c] = static_cast<float>(std::log1p(1 / shape[2]) / std::pow(shape[3], shape[4]));
        }
    } else if (lobe.model == ModelId::abc) {
        lobe.extra = {number(0), number(1)};
    } else {
        lobe.mx = lobe.my = number(0);
    }
    settle_width(lobe);
    return lobe;
}

/// Strength, f0 and f1 of one channel into that channel of a lobe.
void set_reflectance(const LobeFit& fit, double unit, int channel, Color3f& strength, Fresnel& fresnel) {
    fresnel.kind = FresnelKind::generalised_schlick;
    const double ks = std::max(0.0, fit.ks());
    strength[channel] = static_cast<float>(ks / unit);
    fresnel.eta[channel] = ks > 0 ? static_cast<float>(fit.a / ks) : 0;
    fresnel.k[channel] = ks > 0 ? static_cast<float>(-fit.b / ks) : 0;
}

void set_strength(const Color3f& strength, LobeParameters& lobe) {
    lobe.strength = std::max({strength.x, strength.y, strength.z});
    if (lobe.strength > 0) lobe.tint = strength / lobe.strength;
}

/// One lobe of sgd out of the `index`-th of each channel.
LobeParameters joint_lobe(const std::array<FittedChannel, 3>& channels, size_t index) {
    LobeParameters lobe = lobe_of(*channels[0].family, channels[0].fit.lobes[index].shape);
    Color3f strength(0);
    for (int c = 0; c < 3; ++c) {
        const auto& [family, fit] = channels[static_cast<size_t>(c)];
        const LobeFit& found = fit.lobes[index];
        const LobeParameters own = lobe_of(*family, found.shape);
        for (size_t k = static_cast<size_t>(c); k < lobe.extra.size(); k += 3) lobe.extra[k] = own.extra[k];
        set_reflectance(found, ks_unit(*family, found.shape), c, strength, lobe.fresnel);
    }
    set_strength(strength, lobe);
    lobe.data.reset();
    settle_width(lobe);
    return lobe;
}

LobeParameters channel_lobe(const FittedChannel& channel, int c, size_t index) {
    const LobeFit& found = channel.fit.lobes[index];
    LobeParameters lobe = lobe_of(*channel.family, found.shape);
    Color3f strength(0);
    set_reflectance(found, ks_unit(*channel.family, found.shape), c, strength, lobe.fresnel);
    lobe.fresnel.eta = Color3f(lobe.fresnel.eta[c]);
    lobe.fresnel.k = Color3f(lobe.fresnel.k[c]);
    set_strength(strength, lobe);
    return lobe;
}

/// Narrow lobes first; of abc, whose first number grows as lobes narrow, the other way round.
void sort_lobes(FittedChannel& channel) {
    const double sign = channel.family->model == "abc" ? -1 : 1;
    std::stable_sort(channel.fit.lobes.begin(), channel.fit.lobes.end(),
                     [&](const LobeFit& a, const LobeFit& b) { return sign * a.shape[0] < sign * b.shape[0]; });
}

}  // namespace

double ks_unit(const ShapeFamily& family, Shape shape) {
    const Vec3f n(0, 0, 1);
    const double S = 0.25;  // of a shape seen and lit from above, D being 1 there
    return AnyModel(lobe_of(family, shape)).eval(n, n).x / S;
}

Material slice_material(const std::array<FittedChannel, 3>& channels) {
    Material material;
    std::array<FittedChannel, 3> sorted = channels;
    for (int c = 0; c < 3; ++c) {
        material.kd[c] = static_cast<float>(channels[static_cast<size_t>(c)].fit.kd);
        sort_lobes(sorted[static_cast<size_t>(c)]);
    }
    const auto add = [&](LobeParameters lobe) {
        if (lobe.strength > 0) material.lobes.push_back(std::move(lobe));
    };
    for (size_t index = 0; index < channels[0].fit.lobes.size(); ++index) {
        if (channels[0].family->model == "sgd") {
            add(joint_lobe(sorted, index));
        } else {
            for (int c = 0; c < 3; ++c) add(channel_lobe(sorted[static_cast<size_t>(c)], c, index));
        }
    }
    return material;
}

}  // namespace burnish
