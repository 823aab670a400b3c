#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>
#include <burnish/material/sgd/sgd_data.h>

#include <algorithm>
#include <numbers>

namespace burnish {
namespace {

SgdChannel channel(const std::vector<float>& extra, size_t k) {
    const float lambda = extra[6 + k], c = extra[9 + k], exponent = extra[12 + k];
    const ShiftedGamma slopes(extra[k], extra[3 + k]);
    SgdChannel channel{};
    channel.set_slopes(slopes);
    if (lambda > 0)
        channel.fitted.emplace(lambda, c, exponent);
    else
        channel.smith.emplace(slopes);
    return channel;
}

}  // namespace

void SgdChannel::set_slopes(const ShiftedGamma& slopes) {
    shift = static_cast<float>(slopes.shift()), inv_decay = static_cast<float>(1 / slopes.decay());
    p = static_cast<float>(slopes.p()), log_scale = static_cast<float>(slopes.log_scale());
}

SgdData::SgdData(const std::vector<float>& numbers) : extra(numbers) {
    for (size_t k = 0; k < 3; ++k) channels.push_back(channel(extra, k));
    tabulate_slopes();
}

SgdData::SgdData(const SgdData& sharp, float variance) : extra(sharp.extra), channels(sharp.channels) {
    for (size_t k = 0; k < 3; ++k) channels[k].set_slopes(ShiftedGamma(extra[k], extra[3 + k]).blurred(variance));
    tabulate_slopes();
}

void SgdData::tabulate_slopes() {
    constexpr double kEnd = 30;  // decays, where exp(-x / decay) is nothing
    double shift = channels[0].shift, decay = 0;
    for (const SgdChannel& channel : channels)
        shift = std::min<double>(shift, channel.shift), decay = std::max(decay, 1.0 / channel.inv_decay);
    slopes.emplace([&](double x) { return density(static_cast<float>(x)); }, shift, kEnd * decay);
    own_width = std::clamp(std::sqrt(slopes->beyond(0.5) / std::numbers::ln2_v<float>), kMinWidth, 1.0f);
}

std::shared_ptr<const SgdData> sgd_data(const LobeParameters& lobe) {
    const std::vector<float> numbers = lobe.extra.empty() ? default_parameters(model_info(ModelId::sgd)) : lobe.extra;
    const auto made = std::dynamic_pointer_cast<const SgdData>(lobe.data);
    if (made && made->extra == numbers) return made;
    return std::make_shared<SgdData>(numbers);
}

}  // namespace burnish
