// A picture of distant light, lat-long or six cube faces, as cells of constant radiance on the sphere that can be searched
// and changed in place.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <array>
#include <functional>
#include <vector>

namespace burnish {

struct PictureCell {
    float* rgb;
    Imath::V3d direction;      // of its centre, light axes
    double solid_angle;        // steradian
    double bilinear_variance;  // rad^2 per axis: what bilinear interpolation adds to the spread of a picture's detail
};

class PictureCells {
public:
    using Visit = std::function<void(const PictureCell&)>;

    /// The pictures must outlive the cells.
    explicit PictureCells(Image& latlong) : m_pictures{&latlong} {}
    explicit PictureCells(std::array<Image, 6>& faces) {
        for (Image& face : faces) m_pictures.push_back(&face);
    }

    /// Luminance averaged over the sphere.
    double mean_luminance() const;
    /// The cells brighter than `least`, brightest first, else in the picture's order.
    std::vector<PictureCell> brighter_than(double least) const;
    /// Visits the cells whose centres are within `angle` radians of the unit direction d, in the picture's order.
    void visit_within(const Imath::V3d& d, double angle, const Visit& visit) const;

private:
    /// A block of a cube face's texels, [x0, x1) x [y0, y1).
    struct Block {
        int face, x0, x1, y0, y1;
    };

    bool is_cube() const { return m_pictures.size() == 6; }
    PictureCell cell(int picture, int x, int y) const;
    double row_luminance(int picture, int y) const;
    void visit_rows(const Imath::V3d& d, double angle, const Visit& visit) const;
    void visit_block(const Block& block, const Imath::V3d& d, double angle, const Visit& visit) const;

    std::vector<Image*> m_pictures;
};

}  // namespace burnish
