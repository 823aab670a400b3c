#include <burnish/light/light_chain.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kNothingLeft = 1e-4f;  // of a ray: what lies behind is not looked up

bool can_sample(const LightChain::Link& link) {
    return std::visit([](const auto& light) { return light.can_sample(); }, *link.light);
}

void ask(const Light& light, std::span<const LightRay> rays, std::span<Incident> out) {
    std::visit([&](const auto& own) { own.lookup(rays, out); }, light);
}

void add(const Incident& one, float share, Incident& sum) {
    sum.radiance += one.radiance * share;
    sum.bend += one.bend * share;
    sum.nearness += one.nearness * nearness_weight(luminance(one.radiance), one.bend) * share;
    sum.cover = std::max(sum.cover, 1 - share * (1 - one.cover));
}

/// The rays of which something is left, one after the other, and which they are.
struct RaysLeft {
    std::vector<LightRay> rays;
    std::vector<uint32_t> places;

    /// needed: whether those of which nothing is kept are asked, too.
    void take(std::span<const LightRay> all, std::span<const float> left, std::span<const float> kept, bool needed) {
        rays.clear(), places.clear();
        for (uint32_t i = 0; i < all.size(); ++i)
            if (left[i] > kNothingLeft && (needed || kept.empty() || kept[i] > 0)) rays.push_back(all[i]), places.push_back(i);
    }
};

}  // namespace

bool LightChain::is_near() const {
    const auto is_distant = [](const Link& link) { return std::holds_alternative<EnvironmentLight>(*link.light); };
    return !std::all_of(m_links.begin(), m_links.end(), is_distant);
}

void LightChain::lookup(std::span<const LightRay> rays, std::span<Incident> out, std::span<const float> kept) const {
    if (m_links.empty() || !kept.empty()) std::fill(out.begin(), out.end(), Incident());
    if (m_links.empty()) return;
    std::vector<float> left(m_links.size() == 1 && kept.empty() ? 0 : rays.size(), 1.0f);
    size_t next = 0;
    if (kept.empty()) {
        ask(*m_links[next++].light, rays, out);
        if (m_links.size() == 1) return;
        for (size_t i = 0; i < out.size(); ++i) {
            out[i].nearness *= nearness_weight(luminance(out[i].radiance), out[i].bend);
            if (m_links[0].blocks) left[i] = 1 - out[i].cover;
        }
    }
    std::vector<Incident> found;
    RaysLeft asked;
    for (; next < m_links.size(); ++next) {
        const Link& link = m_links[next];
        const std::span<const float> own = kept.empty() ? kept : kept.subspan(next * rays.size(), rays.size());
        asked.take(rays, left, own, link.blocks);
        found.resize(asked.rays.size());
        ask(*link.light, asked.rays, found);
        for (size_t k = 0; k < found.size(); ++k) {
            const uint32_t i = asked.places[k];
            add(found[k], own.empty() ? left[i] : left[i] * own[i], out[i]);
            if (link.blocks) left[i] *= 1 - found[k].cover;
        }
    }
    for (Incident& sum : out) sum.nearness /= std::max(nearness_weight(luminance(sum.radiance), sum.bend), 1e-20f);
}

float LightChain::left_for(size_t link, const LightRay& ray) const {
    float left = 1;
    for (size_t i = 0; i < link && left > kNothingLeft; ++i) {
        Incident one;
        if (!m_links[i].blocks) continue;
        ask(*m_links[i].light, {&ray, 1}, {&one, 1});
        left *= 1 - one.cover;
    }
    return left;
}

ExactLight LightChain::exact(const LightRay& ray) const {
    ExactLight sum;
    float left = 1;
    int sampled = 0;
    for (const Link& link : m_links) {
        const bool draws = burnish::can_sample(link);
        sampled += draws;
        if (left <= kNothingLeft && !draws) continue;
        const ExactLight one = std::visit([&](const auto& light) { return light.exact(ray); }, *link.light);
        sum.radiance += one.radiance * left, sum.pdf += one.pdf;
        sum.cover = std::max(sum.cover, 1 - left * (1 - one.cover));
        if (link.blocks) left *= 1 - one.cover;
    }
    sum.pdf /= static_cast<float>(std::max(sampled, 1));
    return sum;
}

bool LightChain::can_sample() const {
    return std::any_of(m_links.begin(), m_links.end(), [](const Link& link) { return burnish::can_sample(link); });
}

LightDraw LightChain::sample(const Vec3f& p, const Vec2f& u) const {
    std::vector<const Light*> sampled;
    for (const Link& link : m_links)
        if (burnish::can_sample(link)) sampled.push_back(link.light.get());
    if (sampled.empty()) return {};
    const float place = u.x * static_cast<float>(sampled.size());
    const size_t chosen = std::min(static_cast<size_t>(place), sampled.size() - 1);
    const Vec2f rest(std::min(place - static_cast<float>(chosen), 0.99999994f), u.y);
    return std::visit([&](const auto& light) { return light.sample(p, rest); }, *sampled[chosen]);
}

}  // namespace burnish
