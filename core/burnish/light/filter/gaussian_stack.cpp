#include <burnish/light/filter/gaussian_stack.h>

#include <burnish/base/error.h>
#include <burnish/light/filter/gaussian_blur.h>
#include <burnish/light/filter/light_curvature.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace burnish {
namespace {

constexpr double kTexelPerSigma[] = {0.75, 0.5};                      // at a face's centre, of fine and of dense levels
constexpr double kStep[] = {std::numbers::sqrt2, 1.189207115002721};  // from one width to the next: 2^(1/2) and 2^(1/4)
constexpr double kDenseSigma =
    0.028;                         // from here on levels are small, so they can be dense: blends of two are then true Gaussians
constexpr double kTapRatio = 1.5;  // a level comes by taps from one that is at most so much narrower, and at least kStep[1]
constexpr double kWidestSigma = 0.99;  // the last level is the first beyond this
constexpr double kSumSigma = 0.35;     // from here on, a Gaussian of a Gaussian is no Gaussian: sums over a much finer level
constexpr double kTooWideSigma = 1.5;
constexpr double kSumRatio = 2.8;  // by sums, from one that is at least so much narrower
constexpr int kSmallestSize = 16;

void check_faces(const std::array<Image, 6>& faces) {
    const int size = faces[0].width;
    for (const Image& face : faces) {
        if (size > 0 && face.width == size && face.height == size && face.channels >= 3) continue;
        throw Error(ErrorCode::bad_argument, "cube map: expected six square RGB faces of one size, found one of " +
                                                 std::to_string(face.width) + " x " + std::to_string(face.height) + " x " +
                                                 std::to_string(face.channels) + ". Resample the faces first.");
    }
}

double texel_width(int size) { return 2.0 / size; }

/// A level to be made.
struct Planned {
    int size;
    double sigma, versine;  // of its lookups
};

/// Level 0 is the map: texel areas and the tent, over the whole sphere.
Planned planned_map(int size) {
    const double versine = 0.25 * texel_width(size) * texel_width(size) * kMeanTexelMetric;
    return {size, sigma_of_versine(versine), versine};
}

std::vector<Planned> planned_levels(int map_size) {
    std::vector<Planned> levels = {planned_map(map_size)};
    double sigma = texel_width(map_size);
    while (levels.back().sigma < kWidestSigma && sigma < kTooWideSigma) {
        const bool dense = sigma >= kDenseSigma;
        const int fitting =
            levels.size() == 1 ? map_size : 2 * static_cast<int>(std::ceil(1.0 / (kTexelPerSigma[dense] * sigma)));
        levels.push_back({std::max(kSmallestSize, fitting), sigma, versine_of_sigma(sigma)});
        sigma *= kStep[dense];
    }
    return levels;
}

/// The last level at least `ratio` narrower than level k; the map if there is none.
int narrower(const std::vector<Planned>& levels, int k, double ratio) {
    int from = k - 1;
    while (from > 0 && levels[from].sigma * ratio > levels[k].sigma) --from;
    return from;
}

void make_level(const std::vector<Planned>& levels, int k, CubeStack& stack) {
    const double target = levels[k].versine;
    if (k > 2 && levels[k].sigma < kSumSigma) {
        const int from = levels[k].sigma <= kTapRatio * levels[k - 2].sigma ? k - 2 : k - 1;
        return blur_by_taps(stack[from], {target, levels[from].versine, 0.0}, stack[k]);
    }
    const int from = k == 2 ? 1 : narrower(levels, k, kSumRatio);
    const double width2 = texel_width(levels[from].size) * texel_width(levels[from].size);
    if (from == 0) return blur_by_sum(stack[0], {target, 0.0, width2 / 12.0}, stack[k]);
    const double tent = width2 / 6.0 * kMeanTexelMetric;  // part of lookups, not of texel values
    blur_by_sum(stack[from], {target, 1.0 - (1.0 - levels[from].versine) / (1.0 - tent), 0.0}, stack[k]);
}

}  // namespace

GaussianStack::GaussianStack(const std::array<Image, 6>& faces) {
    check_faces(faces);
    const std::vector<Planned> levels = planned_levels(faces[0].width);
    std::vector<int> sizes;
    for (const Planned& level : levels) {
        sizes.push_back(level.size);
        m_versines.push_back(static_cast<float>(level.versine));
    }
    m_stack = CubeStack(sizes);
    m_stack[0].fill(faces);
    for (int k = 1; k < m_stack.level_count(); ++k) make_level(levels, k, m_stack);
    for (int k = 0; k < m_stack.level_count(); ++k) set_curvature(static_cast<float>(levels[k].sigma), m_stack[k]);
    set_level_steps();
}

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
    const int last = m_stack.level_count() - 1, k = std::clamp(static_cast<int>(level), 0, std::max(0, last - 1));
    const float blend = std::clamp(level - static_cast<float>(k), 0.0f, 1.0f), next = m_versines[std::min(k + 1, last)];
    return static_cast<float>(sigma_of_versine(m_versines[k] + blend * (next - m_versines[k])));
}

}  // namespace burnish
