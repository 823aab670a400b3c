#include <burnish/fit/search/retro_reflection.h>

namespace burnish {
namespace {

constexpr float kDegree = kPi / 180;
constexpr float kRingFrom_deg = 12, kRingTo_deg = 25, kFarFromMirror_deg = 30;

struct WeightedMean {
    double sum = 0, weight = 0;
    void add(float value, float w) { sum += static_cast<double>(value) * w, weight += w; }
    float value() const { return weight > 0 ? static_cast<float>(sum / weight) : 0; }
};

}  // namespace

RetroReflection retro_reflection(const TransferSamples& samples) {
    const std::vector<float> p = grey(samples.p);
    const float cone = std::cos(RetroReflection::kCone_deg * kDegree), far = std::cos(kFarFromMirror_deg * kDegree);
    const float ring_from = std::cos(kRingFrom_deg * kDegree), ring_to = std::cos(kRingTo_deg * kDegree);
    WeightedMean back, around, mirror;
    for (size_t j = 0; j < samples.size(); ++j) {
        const Vec3f &in = samples.incident_directions[static_cast<size_t>(samples.incident[j])], &out = samples.outgoing(j);
        const float to_light = in.dot(out), to_mirror = Vec3f(-in.x, -in.y, in.z).dot(out);
        const float f = p[j] / samples.cosine[j];
        if (to_mirror > cone && to_light < far) mirror.add(f, samples.weight[j]);
        if (to_mirror > far) continue;
        if (to_light > cone) back.add(f, samples.weight[j]);
        if (to_light < ring_from && to_light > ring_to) around.add(f, samples.weight[j]);
    }
    return {back.value(), around.value(), mirror.value()};
}

}  // namespace burnish
