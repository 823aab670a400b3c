// Microfacet lobes as fits see them, in double: a distribution D of theta_h times masking, without strength and Fresnel.
//
//     S(theta_h, wo, wi) = D(theta_h) G(wo, wi) / (4 cos_o cos_i)
//
// D is written for theta_h itself: half vectors of float directions lose the peaks of polished metals. What a family says is what
// its model in material/models says, up to a constant factor (`model_scale`); masking of sgd is Smith's, integrated.
#pragma once

#include <burnish/fit/brdf_grid.h>

#include <span>
#include <string_view>
#include <vector>

namespace burnish {

/// A number that a lobe's shape depends on.
struct FamilyNumber {
    std::string_view name;  // in a material's JSON
    double min, max;
    bool logarithmic;
    int scan;  // how many values a scan of the whole range tries
};

using Shape = std::span<const double>;  // in the order of ShapeFamily::parameters

/// How masking goes: by a product of one-sided factors, or by the V-grooves of Torrance & Sparrow.
enum class Masking { smith, grooves };

struct ShapeFamily {
    std::string_view model;  // its name
    std::vector<FamilyNumber> parameters;
    Masking masking;
    double (*D)(Shape numbers, double theta_h);
    std::vector<double> (*G1)(Shape numbers, std::span<const double> theta);  // of Masking::smith
};

/// The family of a model, null for models that are not microfacets in half and difference angles or that nobody fits so.
const ShapeFamily* shape_family(std::string_view model);
/// sgd with the three numbers of its fitted G1 free: lambda, the angle "reach" over which it falls, and the power k (eq. V.3).
const ShapeFamily& sgd_with_free_masking();

/// S on the cells of a grid. Holds what does not change from shape to shape.
class ShapeGrid {
public:
    explicit ShapeGrid(const BrdfGrid& grid);

    /// S of every cell.
    void evaluate(const ShapeFamily& family, Shape numbers, std::vector<double>& S) const;

private:
    static constexpr int kAngles = 64;  // intervals of the table of G1 over 90 degrees, cubic in between

    struct Place {
        int node;
        float along;
    };
    struct CellGeometry {
        int h;
        Place i, o;
        double scale, grooves;
    };

    static Place place(double cosine);

    std::vector<double> m_theta_h, m_angles;  // m_angles: of the table of G1
    std::vector<CellGeometry> m_cells;
};

}  // namespace burnish
