// Distant light: an environment map, exact for the reference and as a pyramid for the filtered estimators.
#pragma once

#include <burnish/base/up_axis.h>
#include <burnish/light/bright_discs.h>
#include <burnish/light/filter/cube_pyramid.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burnish {

class GaussianStack;
struct EnvironmentPicture;

/// How the picture is laid over directions. `blender`: lat-long, +X in the middle, Z up. `openexr`: lat-long, +Z in the
/// middle, Y up (USD, Mitsuba). With the other up axis each keeps its look: see environment_orientation.h. For cubes the
/// convention says whose axes the faces are named after: `blender` a Z-up world's, `openexr` a Y-up world's.
enum class EnvironmentConvention { automatic, blender, openexr };
/// Small, very bright discs of the picture: `automatic` takes them out of the pyramid, see bright_discs.h; `keep` leaves them in.
enum class Suns { automatic, keep };

struct EnvironmentSettings {
    EnvironmentConvention convention =
        EnvironmentConvention::automatic;  // openexr for Y up or an envmap attribute, else blender
    UpAxis up = UpAxis::automatic;         // up axis of the render's world; automatic counts as y
    float rotate_deg = 0.0f;               // turns the lookup direction about the up axis, as Blender's mapping node does
    bool flip = false;                     // mirrors left and right
    float scale = 1.0f;                    // multiplies radiance
    Color3f tint{1, 1, 1};
    int face_size = 0;  // texels per cube face edge; 0 = from the file
    PyramidKernel kernel = PyramidKernel::binomial6;
    Suns suns = Suns::automatic;
};

class Environment {
public:
    /// Reads a lat-long (.hdr, .exr, .tx), a cube in one picture (envmap attribute, strip, two rows or cross, see
    /// environment_layouts.h) or, when `file` has a `%s` or `{face}` in its name, six files px nx py ny pz nz (also posx,
    /// +X, +x ...). Throws Error(read_failed | bad_argument).
    /// `convert` takes each picture (RGB, scrubbed) into the colour space of the work; empty = it is there.
    static Environment load(const std::string& file, const EnvironmentSettings& settings,
                            const std::function<void(Image&)>& convert = {});
    /// From pixels in memory: lat-long (W = 2H) or one of the cube layouts, RGB or grey.
    static Environment from_image(const Image& image, const EnvironmentSettings& settings, const std::string& name);
    /// From a picture that was read, see environment_picture.h.
    static Environment from_picture(EnvironmentPicture picture, const EnvironmentSettings& settings, const std::string& name);

    /// The same light turned, flipped, scaled or tinted otherwise, at no cost: everything made from the picture is shared. Throws
    /// Error(bad_argument) where `settings` differ from this light's in anything else.
    Environment relit(const EnvironmentSettings& settings) const;
    /// As it was made, nothing left automatic but face size and suns.
    const EnvironmentSettings& settings() const { return m_settings; }

    /// Unfiltered radiance from unit direction d in light axes: bilinear in the picture as given; scale and tint apart.
    Color3f radiance(const Vec3f& d) const;

    /// Draws a direction in light axes with density ~ luminance, u in [0, 1)^2; `pdf` is per steradian.
    Vec3f sample(const Vec2f& u, float& pdf) const;
    float pdf(const Vec3f& d) const;

    /// The picture without its discs, filtered, on cube faces of `face_size` texels: each made when first asked for, by any
    /// thread. Either one and the discs make the whole picture that `radiance` gives.
    const CubePyramid& pyramid() const;
    const GaussianStack& gaussian_stack() const;
    int face_size() const;
    /// What both are made from: +X -X +Y -Y +Z -Z, RGB.
    const std::array<Image, 6>& faces() const;
    const std::vector<BrightDisc>& discs() const { return m_discs; }
    /// World direction -> light axes, as row vector times matrix: convention, up axis, rotation and flip in one (a flip makes
    /// its determinant negative).
    const Matrix33f& world_to_light() const { return m_world_to_light; }
    /// scale * tint, to be multiplied into the overlay once.
    const Color3f& gain() const { return m_gain; }
    /// Texels per cube face edge that keep the picture's own resolution: the default of EnvironmentSettings::face_size.
    int suggested_face_size() const { return m_suggested_face_size; }
    /// What was found and what was scrubbed (NaN, infinite and negative texels), one line each.
    const std::vector<std::string>& notes() const { return m_notes; }
    const std::vector<std::string>& warnings() const { return m_warnings; }

private:
    class Source;     // the picture as given and its sampling tables
    struct Filtered;  // its cube faces and what was made from them
    std::shared_ptr<const Source> m_source;
    std::shared_ptr<Filtered> m_filtered;
    std::vector<BrightDisc> m_discs;
    EnvironmentSettings m_settings;
    bool m_is_cube = false;  // the picture
    Matrix33f m_world_to_light;
    Color3f m_gain{1, 1, 1};
    int m_suggested_face_size = 0;
    std::vector<std::string> m_notes, m_warnings;
};

}  // namespace burnish
