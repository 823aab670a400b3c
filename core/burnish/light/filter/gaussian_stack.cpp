#include <burnish/light/filter/gaussian_stack.h>

#include <burnish/base/error.h>
#include <burnish/light/filter/cube_resample.h>
#include <burnish/light/filter/gaussian_blur.h>
#include <burnish/light/filter/light_curvature.h>

#include <atomic>
#include <mutex>
#include <string>

namespace burnish {
namespace {

using Faces = std::shared_ptr<const std::array<Image, 6>>;

const Faces& checked(const Faces& faces) {
    const int size = (*faces)[0].width;
    for (const Image& face : *faces) {
        if (size > 0 && face.width == size && face.height == size && face.channels >= 3) continue;
        throw Error(ErrorCode::bad_argument, "cube map: expected six square RGB faces of one size, found one of " +
                                                 std::to_string(face.width) + " x " + std::to_string(face.height) + " x " +
                                                 std::to_string(face.channels) + ". Resample the faces first.");
    }
    return faces;
}

double texel_square(int size) { return 4.0 / (static_cast<double>(size) * size); }

std::vector<int> sizes_of(const std::vector<GaussianLevel>& levels) {
    std::vector<int> sizes;
    for (const GaussianLevel& level : levels) sizes.push_back(level.size);
    return sizes;
}

}  // namespace

/// Filters levels, each with what it comes from, when they are first asked for. Who was given a level reads it without a lock:
/// it is never written again.
class GaussianStack::Maker {
public:
    Maker(Faces faces, const std::vector<GaussianLevel>& levels)
        : m_faces(std::move(faces)), m_levels(levels), m_has_light(levels.size()), m_is_done(levels.size()) {}

    const CubeStack& make(std::span<const LevelRange> ranges) {
        if (is_whole()) return m_stack;
        const std::lock_guard lock(m_making);
        if (m_stack.level_count() == 0) m_stack = CubeStack(sizes_of(m_levels));
        for (const LevelRange& range : ranges)
            for (int k = first_read(range.finest); k <= last_read(range.coarsest); ++k) finish(k);
        if (std::ranges::all_of(m_is_done, std::identity())) {
            m_shrunk.clear();
            m_is_whole.store(true, std::memory_order_release);
        }
        return m_stack;
    }

    bool is_whole() const { return m_is_whole.load(std::memory_order_acquire); }

    bool is_filtered(int k) {
        const std::lock_guard lock(m_making);
        return m_has_light[k];
    }

private:
    // At a whole level kernels also read one of its neighbours, with no weight.
    static constexpr float kRounding = 0.01f;
    int first_read(float level) const { return clamped(std::ceil(level - kRounding) - 1); }
    int last_read(float level) const { return clamped(std::floor(level + kRounding) + 1); }
    int clamped(float level) const {
        return static_cast<int>(std::clamp(level, 0.0f, static_cast<float>(m_levels.size() - 1)));
    }

    void finish(int k) {
        if (m_is_done[k]) return;
        add_light(k);
        set_curvature(static_cast<float>(m_levels[k].sigma), m_stack[k]);
        m_is_done[k] = true;
    }

    void add_light(int k) {
        if (m_has_light[k]) return;
        const GaussianLevel& level = m_levels[k];
        if (k == 0)
            m_stack[0].fill(*m_faces);
        else if (level.source == GaussianLevel::Source::map)
            sum_over_map(level, m_stack[k]);
        else
            blur_level(level, m_stack[k]);
        m_has_light[k] = true;
    }

    void sum_over_map(const GaussianLevel& level, CubeLevel& target) {
        const int size = m_levels[0].size >> level.halvings;
        const GaussianBlur blur{level.versine, 0.0, texel_square(size) / 12.0};
        if (level.halvings > 0) return blur_by_sum(CubeLevel(shrunk(level.halvings)), blur, target);
        add_light(0);
        blur_by_sum(m_stack[0], blur, target);
    }

    /// The map's faces, halved so many times, >= 1.
    const std::array<Image, 6>& shrunk(int halvings) {
        while (static_cast<int>(m_shrunk.size()) < halvings)
            m_shrunk.push_back(halved_cube(m_shrunk.empty() ? *m_faces : m_shrunk.back()));
        return m_shrunk[static_cast<size_t>(halvings) - 1];
    }

    void blur_level(const GaussianLevel& level, CubeLevel& target) {
        const GaussianLevel& from = m_levels[level.from];
        add_light(level.from);
        if (level.source == GaussianLevel::Source::taps)
            return blur_by_taps(m_stack[level.from], {level.versine, from.versine, 0.0}, target);
        const double tent = texel_square(from.size) / 6.0 * kMeanTexelMetric;  // part of lookups, not of texel values
        blur_by_sum(m_stack[level.from], {level.versine, 1.0 - (1.0 - from.versine) / (1.0 - tent), 0.0}, target);
    }

    const Faces m_faces;
    const std::vector<GaussianLevel> m_levels;
    std::mutex m_making;
    std::vector<std::array<Image, 6>> m_shrunk;  // while levels are missing
    std::vector<bool> m_has_light, m_is_done;    // without and with the fourth channel
    std::atomic<bool> m_is_whole = false;
    CubeStack m_stack;
};

GaussianStack::GaussianStack(Faces faces)
    : m_levels(gaussian_levels((*checked(faces))[0].width)), m_maker(std::make_shared<Maker>(faces, m_levels)) {
    for (const GaussianLevel& level : m_levels) m_versines.push_back(static_cast<float>(level.versine));
    set_level_steps();
}

GaussianStack::GaussianStack(std::array<Image, 6> faces)
    : GaussianStack(std::make_shared<const std::array<Image, 6>>(std::move(faces))) {}

const CubeStack& GaussianStack::stack() const { return stack(std::array{LevelRange{0, last_level()}}); }

const CubeStack& GaussianStack::stack(std::span<const LevelRange> ranges) const { return m_maker->make(ranges); }

bool GaussianStack::is_filtered(int level) const { return m_maker->is_filtered(level); }

bool GaussianStack::is_whole() const { return m_maker->is_whole(); }

float GaussianStack::level(float sigma) const {
    if (!(sigma > 0.0f) || m_versines.size() < 2) return 0.0f;
    const auto versine = static_cast<float>(versine_of_sigma(std::min(sigma, 10.0f)));
    const auto wider = std::upper_bound(m_versines.begin() + 1, m_versines.end() - 1, versine);
    const float near = *(wider - 1), far = *wider;
    return static_cast<float>(wider - 1 - m_versines.begin()) + std::clamp((versine - near) / (far - near), 0.0f, 1.0f);
}

void GaussianStack::set_level_steps() {
    const auto square_at = [](uint32_t step) {
        return std::bit_cast<float>(std::bit_cast<uint32_t>(kLeastSquare) + (step << kStepBits));
    };
    for (uint32_t step = 0; square_at(step) <= kLargestSquare; ++step) {
        const float from = square_at(step), to = square_at(step + 1), own = level(std::sqrt(from));
        m_level_steps.push_back({own, (level(std::sqrt(to)) - own) / (to - from)});
    }
}

float GaussianStack::sigma(float level) const {
    const int last = level_count() - 1, k = std::clamp(static_cast<int>(level), 0, std::max(0, last - 1));
    const float blend = std::clamp(level - static_cast<float>(k), 0.0f, 1.0f), next = m_versines[std::min(k + 1, last)];
    return static_cast<float>(sigma_of_versine(m_versines[k] + blend * (next - m_versines[k])));
}

}  // namespace burnish
