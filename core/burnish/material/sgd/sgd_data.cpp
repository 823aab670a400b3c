#include <burnish/material/microfacet.h>
#include <burnish/material/model.h>
#include <burnish/material/sgd/sgd_data.h>

#include <algorithm>
#include <numbers>

namespace burnish {
namespace {

constexpr double kEnd = 30;  // alphas, where exp(-x / alpha) is nothing

SgdChannel channel(const std::vector<float>& extra, size_t k) {
    const float lambda = extra[6 + k], c = extra[9 + k], exponent = extra[12 + k];
    const ShiftedGamma slopes(extra[k], extra[3 + k]);
    SgdChannel channel{extra[k], extra[3 + k], static_cast<float>(slopes.log_scale()), {}, {}};
    if (lambda > 0)
        channel.fitted.emplace(lambda, c, exponent);
    else
        channel.smith.emplace(slopes);
    return channel;
}

}  // namespace

SgdData::SgdData(const std::vector<float>& numbers) : extra(numbers) {
    for (size_t k = 0; k < 3; ++k) channels.push_back(channel(extra, k));
    const auto [lowest, highest] = std::minmax({extra[0], extra[1], extra[2]});
    slopes.emplace([&](double x) { return density(static_cast<float>(x)); }, static_cast<double>(lowest) * lowest,
                   kEnd * highest);
    own_width = std::clamp(std::sqrt(slopes->beyond(0.5) / std::numbers::ln2_v<float>), kMinWidth, 1.0f);
}

std::shared_ptr<const SgdData> sgd_data(const LobeParameters& lobe) {
    const std::vector<float> numbers = lobe.extra.empty() ? default_parameters(model_info(ModelId::sgd)) : lobe.extra;
    const auto made = std::dynamic_pointer_cast<const SgdData>(lobe.data);
    if (made && made->extra == numbers) return made;
    return std::make_shared<SgdData>(numbers);
}

}  // namespace burnish
