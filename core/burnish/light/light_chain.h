// The lights of some pixels, one behind the other: what the first leaves of a ray, the next ones see.
//
//     L = sum over k of  L_k * product over i < k, i blocking, of (1 - cover_i)
//
// Lights that do not block add. So a floor has its mirror buffer first, for what that cannot see a cube map of the room, and the
// sky behind the windows; a lamp that no picture holds simply adds its light.
#pragma once

#include <burnish/light/light.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

class LightChain {
public:
    struct Link {
        std::shared_ptr<const Light> light;
        bool blocks;  // whether it hides what comes behind it, as far as it covers
    };

    LightChain() = default;
    explicit LightChain(std::vector<Link> links) : m_links(std::move(links)) {}

    const std::vector<Link>& links() const { return m_links; }

    /// Whether what arrives depends on the place: not where all lights are environments.
    bool is_near() const;

    /// out[i] of rays[i], as light_ray.h says; nearness is the mean by nearness_weight. kept: of each link, one after the other, what
    /// to take of each ray; empty = all.
    void lookup(std::span<const LightRay> rays, std::span<Incident> out, std::span<const float> kept = {}) const;
    /// Share of a ray that the links before `link` leave, [0, 1].
    float left_for(size_t link, const LightRay& ray) const;

    ExactLight exact(const LightRay& ray) const;
    bool can_sample() const;
    /// From each light that can be sampled as often as from any other; `exact` knows the density of that.
    LightDraw sample(const Vec3f& p, const Vec2f& u) const;

private:
    std::vector<Link> m_links;
};

}  // namespace burnish
