#include <burnish/shading/reference_run.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kBatch = 64;  // pixels: reports of progress, and so chances to cancel, come often

}  // namespace

ReferenceRun::ReferenceRun(const Surfaces& surfaces, const Assignment& assignment, std::vector<MaterialShader> shaders,
                           const EstimatorSettings& settings)
    : m_surfaces(surfaces),
      m_width(assignment.width),
      m_height(assignment.height),
      m_shaders(std::move(shaders)),
      m_settings(settings),
      m_parts(m_shaders.size()) {
    for (size_t rule = 0; rule < m_parts.size(); ++rule) {
        Part& part = m_parts[rule];
        for (int y = 0; y < m_height; y += kTileSize)
            for (int x = 0; x < m_width; x += kTileSize)
                surfaces.list({x, y, std::min(kTileSize, m_width - x), std::min(kTileSize, m_height - y)},
                              static_cast<int>(rule), part.pixels);
        part.running.resize(part.pixels.size());
    }
}

int ReferenceRun::most_points(int lookups) const {
    const int passes = std::min(lookups, m_settings.max_samples) / kPassLookups;
    return std::max(passes, 1) * kPassPoints;
}

bool ReferenceRun::is_finished(const RunningReference& pixel, int points) const {
    return pixel.points >= points || pixel.is_within(m_settings.tolerance);
}

bool ReferenceRun::is_done() const {
    const int points = most_points(m_settings.max_samples);
    return std::ranges::all_of(m_parts, [&](const Part& part) {
        return std::ranges::all_of(part.running, [&](const RunningReference& pixel) { return is_finished(pixel, points); });
    });
}

void ReferenceRun::carry_on(int lookups, const Progress& progress) {
    const int points = most_points(lookups);
    size_t all = 0, done = 0;
    for (const Part& part : m_parts) all += part.pixels.size();
    for (size_t rule = 0; rule < m_parts.size(); ++rule) {
        const size_t own = m_parts[rule].pixels.size();
        if (own == 0) continue;
        const auto share = [&](size_t pixels) { return static_cast<float>(pixels) / static_cast<float>(all); };
        const auto work = [&](const Window& row) {
            carry_on(rule, static_cast<size_t>(row.x), static_cast<size_t>(row.x + row.width), points);
        };
        // The list as an image of one row.
        for_each_tile(static_cast<int>(own), 1, part_of(progress, share(done), share(done + own)), "shading", work, kBatch);
        done += own;
    }
}

/// A few pixels side by side, pass after pass; those that are finished leave.
void ReferenceRun::carry_on(size_t rule, size_t begin, size_t end, int points) {
    Part& part = m_parts[rule];
    SurfaceBatch batch;
    std::vector<size_t> places;
    for (size_t i = begin; i < end; ++i) places.push_back(i);
    std::vector<RunningReference> running;
    for (size_t filled = 0;;) {
        std::erase_if(places, [&](size_t i) { return is_finished(part.running[i], points); });
        if (places.empty()) return;
        if (places.size() != filled) {
            batch.clear();
            for (const size_t i : places) batch.pixel.push_back(part.pixels[i]);
            m_surfaces.fill(batch, m_shaders[rule].needs());
            filled = places.size();
        }
        running.clear();
        for (const size_t i : places) running.push_back(part.running[i]);
        m_shaders[rule].add_pass(batch, running);
        for (size_t k = 0; k < places.size(); ++k) part.running[places[k]] = running[k];
    }
}

ShadedFrame ReferenceRun::frame() const {
    ShadedFrame frame{Image(m_width, m_height, 3), Image(m_width, m_height, 1), Image(m_width, m_height, 1), 0};
    for (size_t rule = 0; rule < m_parts.size(); ++rule) {
        const Part& part = m_parts[rule];
        for (size_t i = 0; i < part.pixels.size(); ++i) {
            const RunningReference& pixel = part.running[i];
            const Color3f mean = pixel.mean();
            std::copy_n(&mean.x, 3, frame.overlay.at(size_t{part.pixels[i]}));
            *frame.standard_error.at(size_t{part.pixels[i]}) = pixel.standard_error();
            const float lookups = static_cast<float>(pixel.lookups_per_lobe() * m_shaders[rule].lobe_count());
            *frame.samples.at(size_t{part.pixels[i]}) = lookups;
            frame.lookups += lookups;
        }
    }
    return frame;
}

}  // namespace burnish
