// What a fit compares: transfer probabilities p = f |cos theta_o| of measured pairs, each with its share of the error.
//
//     L1 = sum weight |p_measured - p_model| / sum weight,   weight = sin(theta_o) |cos(theta_i)|
//
// over what was recorded, p > 0. The sine is a sample's solid angle on a grid of angles; the cosine stands for even incident
// light; p instead of f keeps grazing angles, where measurements are poor, from ruling the fit.
// Source: Walkthrough, eq. 2.4, 2.6-2.8 and 3.7; printed without the bars of the absolute value.
#pragma once

#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/parameters.h>

#include <span>
#include <vector>

namespace burnish {

/// One side of the surface. "Incident" is the direction a table has few of, "outgoing" the one it has many of, whichever of wo
/// and wi they are.
struct TransferSamples {
    std::vector<Vec3f> wo, wi;
    std::vector<float> cosine;  // |cos theta_o|
    std::vector<float> weight;  // sum 1
    std::vector<Color3f> p;
    std::vector<int> incident;  // which incident direction
    std::vector<Vec3f> incident_directions;
    bool wi_is_incident = true;
    double share = 0;  // sum of the weights as printed, to put two sides together

    size_t size() const { return wo.size(); }
    const Vec3f& outgoing(size_t j) const { return wi_is_incident ? wo[j] : wi[j]; }
};

/// The recorded samples of one side, in their order.
TransferSamples transfer_samples(std::span<const BrdfSample> samples, Side side);

/// About `count` of them that stand for all: drawn evenly in the order of the table, as densely as they carry energy and weight, and
/// weighted up in turn. The same ones every time.
TransferSamples thinned(const TransferSamples& samples, size_t count);

/// Mean of the channels.
std::vector<float> grey(std::span<const Color3f> p);

/// p of a material on one side, by the lobes of that side; the diffuse part belongs to reflection.
std::vector<Color3f> model_transfer(const Material& material, const TransferSamples& samples, Side side);

/// The error above per channel.
Color3f l1_error(std::span<const Color3f> model, const TransferSamples& samples);

/// What one incident direction sends to one side.
struct IncidentAlbedo {
    Vec3f incident;
    Color3f albedo;  // integral of f |cos theta_o| over the side
};

/// By the samples' own grid, which must cover the side evenly in angle, half of it by symmetry if need be. What was not recorded counts
/// as dark, so shadowed tables come out darker than their material.
std::vector<IncidentAlbedo> measured_albedo(std::span<const BrdfSample> samples, Side side);

}  // namespace burnish
