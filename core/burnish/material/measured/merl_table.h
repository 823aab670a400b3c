// The MERL format: an isotropic BRDF as a table of 90 x 90 x 180 cells of theta_h, theta_d and phi_d.
//
//     file      int32 90, 90, 180; then doubles, all red, all green, all blue, phi_d fastest, theta_h slowest; little endian
//     f         number x (1, 1.15, 1.66) / 1500, in 1/sr; a negative number: not measured
//     cells     [h, h+1) x [d, d+1) x [p, p+1) of theta_h = (h/90)^2 90 deg, theta_d = d deg, phi_d = p deg, each with its
//               value in its middle (h + 1/2, ...); phi_d and phi_d + 180 deg are the same cell by reciprocity
//
// Between the middles values are interpolated linearly in these coordinates, round the circle in phi_d, and kept beyond the
// first and the last middle. Source: Matusik, Pfister, Brand & McMillan 2003, "A data-driven reflectance model", and the code
// that comes with its data.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/measured/measured_brdf.h>

#include <functional>
#include <memory>
#include <optional>

namespace burnish {

class MerlTable final : public MeasuredBrdf {
public:
    static constexpr int kThetaH = 90, kThetaD = 90, kPhiD = 180, kCells = kThetaH * kThetaD * kPhiD;
    static constexpr std::uintmax_t kFileSize = 3 * sizeof(int32_t) + 3 * sizeof(double) * kCells;

    struct Cell {
        int h, d, p;
    };

    /// Tabulates f(wo, wi), RGB in 1/sr, called by several threads. Cells with a direction below the surface stay unmeasured.
    explicit MerlTable(const std::function<Color3f(const Vec3f& wo, const Vec3f& wi)>& f,
                       const Progress& progress = Progress());
    /// Throws Error(read_failed) for a file that is not such a table, naming what is wrong.
    static std::shared_ptr<const MerlTable> read(const std::string& file);
    /// Writes the numbers as they were read, bit by bit; the file appears whole or not at all.
    void write(const std::string& file) const;

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const override;
    bool is_isotropic() const override { return true; }
    bool transmits() const override { return false; }
    bool is_dense() const override { return true; }
    /// Every second theta_d and every fourth phi_d of what is measured above the surface, some 140,000.
    std::vector<BrdfSample> samples() const override;

    /// f of a cell, nothing where it was not measured: a number that is negative, not finite, or beyond any reflectance.
    std::optional<Color3f> at(const Cell& cell) const;
    /// The middle of a cell, with phi_h = 0.
    static DirectionPair directions(const Cell& cell);
    /// How many cells were measured.
    int measured_cells() const;

private:
    explicit MerlTable(std::vector<double> numbers);
    void fill_from_numbers();
    std::optional<Color3f> at_index(size_t index) const;

    std::vector<double> m_numbers;  // as in the file: three planes
    std::vector<Color3f> m_filled;  // f of all cells, with sensible values where nothing was measured
};

}  // namespace burnish
