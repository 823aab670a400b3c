#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/fit/search/lobe_space.h>
#include <burnish/material/any_model.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {
namespace {

constexpr NumberRange kWidths{0.002, 1}, kAnyWidth{kMinWidth, 1};
constexpr NumberRange kStrengths{0, 10}, kAnyStrength{0, 1000};
constexpr NumberRange kReflectivities{0, 1};
constexpr NumberRange kTurn{-360, 360};
constexpr double kLogarithmicRatio = 50;  // wider ranges of positive numbers are searched in ratios
/// Behind a sheet 1 - F = (1 - r0) (1 - (1 - c)^5), which only its product with kt tells: r0 is any, the one of glass.
constexpr double kSheetReflectivity = 0.04;

/// The user's bounds within what the parameter allows.
NumberRange bounded(const ParameterBounds& bounds, int number, const std::string& name, NumberRange usual,
                    NumberRange allowed) {
    const NumberRange* wanted = find_bounds(bounds, number, name);
    if (!wanted) return usual;
    if (!(wanted->min <= wanted->max) || wanted->min < allowed.min || wanted->max > allowed.max)
        throw Error(ErrorCode::bad_argument, "bounds of \"" + name + "\": expected min <= max within " +
                                                 std::to_string(allowed.min) + " to " + std::to_string(allowed.max) +
                                                 ", found " + std::to_string(wanted->min) + " to " +
                                                 std::to_string(wanted->max));
    return *wanted;
}

bool is_logarithmic(const NumberRange& range) { return range.min > 0 && range.max > kLogarithmicRatio * range.min; }

ShapeParameter width(const std::string& name, NumberRange range, bool x, bool y) {
    return {name, range, true,
            [x, y](LobeParameters& lobe, float m) {
                if (x) lobe.mx = m;
                if (y) lobe.my = m;
            },
            [x](const LobeParameters& lobe) { return x ? lobe.mx : lobe.my; }};
}

ShapeParameter rotation(NumberRange range) {
    constexpr float kDegree = kPi / 180;
    return {"rotation_deg", range, false, [](LobeParameters& lobe, float angle) { lobe.rotation = angle * kDegree; },
            [](const LobeParameters& lobe) { return lobe.rotation / kDegree; }};
}

/// A model's own number; of a colour all channels, which shape is the same in.
ShapeParameter own(const ModelParameter& parameter, size_t index, NumberRange range) {
    const size_t count = parameter.per_channel ? 3 : 1;
    return {std::string(parameter.name), range, is_logarithmic(range),
            [index, count](LobeParameters& lobe, float value) { std::fill_n(&lobe.extra[index], count, value); },
            [index](const LobeParameters& lobe) { return lobe.extra[index]; }};
}

std::vector<ShapeParameter> all_widths(const ModelInfo& info, int number, bool round, const ParameterBounds& bounds) {
    if (info.own_width) return {};
    const bool split = info.anisotropic && (!round || find_bounds(bounds, number, "mx") || find_bounds(bounds, number, "my"));
    const NumberRange usual = bounded(bounds, number, "m", kWidths, kAnyWidth);
    if (!split) return {width("m", usual, true, true)};
    return {width("mx", bounded(bounds, number, "mx", usual, kAnyWidth), true, false),
            width("my", bounded(bounds, number, "my", usual, kAnyWidth), false, true)};
}

std::vector<ShapeParameter> all_shape(const ModelInfo& info, int number, bool round, const ParameterBounds& bounds) {
    std::vector<ShapeParameter> shape = all_widths(info, number, round, bounds);
    size_t index = 0;
    for (const ModelParameter& parameter : info.parameters) {
        const NumberRange allowed{parameter.min, parameter.max};
        shape.push_back(own(parameter, index, bounded(bounds, number, std::string(parameter.name), allowed, allowed)));
        index += parameter.per_channel ? 3 : 1;
    }
    if (find_bounds(bounds, number, "rotation_deg"))
        shape.push_back(rotation(bounded(bounds, number, "rotation_deg", {}, kTurn)));
    return shape;
}

/// Whether the lobe follows a change of r0 at all; models of plastics' or of none do not.
bool follows_fresnel(const LobeParameters& lobe) {
    LobeParameters probe = lobe;
    probe.fresnel = {FresnelKind::schlick, Color3f(0, 1, 0)};
    probe.mx = probe.my = 0.5f;
    const Color3f f = AnyModel(probe).eval(Vec3f(0.6f, 0, 0.8f), Vec3f(-0.6f, 0, 0.8f));
    return f.x != f.y;
}

void expect_known_bounds(const ModelInfo& info, const ParameterBounds& bounds) {
    std::vector<std::string_view> known{"kd", "ks", "kt", "m", "mx", "my", "r0", "rotation_deg"};
    for (const ModelParameter& parameter : info.parameters) known.push_back(parameter.name);
    for (const auto& [key, range] : bounds) {
        const std::string_view name = std::string_view(key).substr(key.find('.') + 1);
        if (std::ranges::find(known, name) == known.end()) fail_unknown("bounds", "parameter", name, known);
    }
}

}  // namespace

float ShapeParameter::at(double unit) const {
    const double x = std::clamp(unit, 0.0, 1.0);
    if (!logarithmic) return static_cast<float>(range.min + x * (range.max - range.min));
    return static_cast<float>(range.min * std::pow(range.max / range.min, x));
}

double ShapeParameter::unit(float value) const {
    if (range.max == range.min) return 0;
    const double x = logarithmic ? std::log(value / range.min) / std::log(range.max / range.min)
                                 : (value - range.min) / (range.max - range.min);
    return std::clamp(x, 0.0, 1.0);
}

int LobeSpace::parameters() const {
    const auto free = [](const NumberRange& range) { return range.max > range.min ? 1 : 0; };
    int count = free(strength) + (has_fresnel ? free(r0) : 0);
    for (const ShapeParameter& parameter : shape) count += free(parameter.range);
    return count;
}

LobeParameters LobeSpace::at(const std::vector<double>& units) const {
    LobeParameters lobe = base;
    for (size_t i = 0; i < shape.size(); ++i) shape[i].set(lobe, shape[i].at(units[i]));
    settle_width(lobe);
    return lobe;
}

void settle_width(LobeParameters& lobe) {
    if (const float own_width = prepare(lobe); own_width > 0) lobe.mx = lobe.my = own_width;
}

const NumberRange* find_bounds(const ParameterBounds& bounds, int number, const std::string& name) {
    for (const std::string& key : {std::to_string(number) + "." + name, name})
        if (const auto found = bounds.find(key); found != bounds.end()) return &found->second;
    return nullptr;
}

LobeSpace lobe_space(ModelId model, Side side, int number, bool round, const ParameterBounds& bounds) {
    const ModelInfo& info = model_info(model);
    expect_known_bounds(info, bounds);
    LobeSpace space;
    space.base.model = model;
    space.base.side = side;
    space.base.extra = default_parameters(info);
    space.shape = all_shape(info, number, round, bounds);
    space.strength = bounded(bounds, number, side == Side::reflection ? "ks" : "kt", kStrengths, kAnyStrength);
    space.has_fresnel = follows_fresnel(space.base);
    const NumberRange usual = side == Side::reflection ? kReflectivities : NumberRange{kSheetReflectivity, kSheetReflectivity};
    space.r0 = bounded(bounds, number, "r0", usual, kReflectivities);
    if (!space.has_fresnel) return space;
    space.base.fresnel = {FresnelKind::schlick, Color3f(static_cast<float>(space.r0.min))};
    space.base.fresnel.complement = side == Side::transmission;
    return space;
}

}  // namespace burnish
