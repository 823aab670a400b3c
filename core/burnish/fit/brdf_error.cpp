#include <burnish/fit/brdf_error.h>

#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/half_difference.h>

#include <algorithm>
#include <cmath>

namespace burnish {

double BrdfError::worst_channel() const { return std::max({channel(0), channel(1), channel(2)}); }

double BrdfError::overall() const {
    const double greatest = *std::max_element(albedo.begin(), albedo.end());
    const double mean = (absolute[0] * absolute[0] + absolute[1] * absolute[1] + absolute[2] * absolute[2]) / 3;
    return greatest > 0 ? std::sqrt(mean) / greatest : 0;
}

BrdfError brdf_error(const BrdfGrid& grid, const Channels& absolute) {
    return {absolute, {grid.max_albedo(0), grid.max_albedo(1), grid.max_albedo(2)}};
}

BrdfError brdf_error(const BrdfGrid& grid, const Material& material) {
    const MaterialBrdf model(material);
    Channels squares{};
    for (size_t j = 0; j < grid.cells().size(); ++j) {
        const auto [theta_h, theta_d, phi_d] = grid.angles(grid.cells()[j]);
        const auto [wo, wi] =
            directions(HalfDifference{static_cast<float>(theta_h), 0, static_cast<float>(theta_d), static_cast<float>(phi_d)});
        const Color3f f = model(wo, wi);
        for (int c = 0; c < 3; ++c) {
            const double off = grid.f(c)[j] - f[c];
            squares[c] += grid.cells()[j].weight * off * off;
        }
    }
    return brdf_error(grid, Channels{std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2])});
}

}  // namespace burnish
