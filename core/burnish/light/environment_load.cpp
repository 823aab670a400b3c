// From a file or an image to an Environment: suns, cube faces, notes.
#include <burnish/base/error.h>
#include <burnish/light/environment_orientation.h>
#include <burnish/light/environment_picture.h>
#include <burnish/light/environment_source.h>
#include <burnish/light/filter/cube_resample.h>

#include <bit>
#include <tuple>

namespace burnish {
namespace {

void check_settings(const EnvironmentSettings& s, const std::string& name) {
    const auto refuse = [&](const std::string& problem) { throw Error(ErrorCode::bad_argument, name + ": " + problem); };
    if (!std::isfinite(s.rotate_deg)) refuse("the rotation of the environment must be a finite number of degrees.");
    if (!std::isfinite(s.scale) || !is_finite(s.tint)) refuse("scale and tint of the environment must be finite.");
    const bool power_of_two =
        s.face_size >= 2 && s.face_size <= 8192 && std::has_single_bit(static_cast<unsigned>(s.face_size));
    if (s.face_size != 0 && !power_of_two) {
        refuse("the face size is " + std::to_string(s.face_size) +
               ", expected 0 (from the file) or a power of two in [2, 8192].");
    }
}

int own_face_size(const EnvironmentPicture& given) {
    return given.faces ? cube_size_for_cube((*given.faces)[0].width) : cube_size_for_latlong(given.latlong.width);
}

using Faces = std::shared_ptr<const std::array<Image, 6>>;

Faces pyramid_faces(const EnvironmentPicture& given, int face_size) {
    return std::make_shared<const std::array<Image, 6>>(given.faces ? resized_cube(*given.faces, face_size)
                                                                    : latlong_to_cube(given.latlong, face_size));
}

DiscCut cut_suns(EnvironmentPicture& given) {
    return DiscCut(given.faces ? PictureCells(*given.faces) : PictureCells(given.latlong));
}

}  // namespace

Environment Environment::from_picture(EnvironmentPicture given, const EnvironmentSettings& settings, const std::string& name) {
    check_settings(settings, name);
    const Orientation orientation = orient(given, settings);
    Environment light;
    light.m_suggested_face_size = own_face_size(given);
    const int face = settings.face_size > 0 ? settings.face_size : light.m_suggested_face_size;
    DiscCut suns = settings.suns == Suns::automatic ? cut_suns(given) : DiscCut();
    light.m_discs = suns.discs();
    Faces filtered = pyramid_faces(given, face);
    const bool as_given = given.faces && suns.discs().empty() && (*given.faces)[0].width == face;
    suns.put_back();
    Faces whole = as_given || !given.faces ? nullptr : std::make_shared<const std::array<Image, 6>>(std::move(*given.faces));
    light.m_source = std::make_shared<Source>(std::move(given.latlong), as_given ? filtered : std::move(whole));
    light.m_filtered = std::make_shared<Filtered>(std::move(filtered), settings.kernel);
    light.m_settings = settings, light.m_is_cube = given.faces.has_value();
    light.m_settings.convention = orientation.convention, light.m_settings.up = orientation.up;
    light.m_world_to_light = orientation.world_to_light;
    light.m_gain = settings.tint * settings.scale;
    light.m_notes.push_back(name + ": " + given.description + ", " +
                            (orientation.convention == EnvironmentConvention::blender ? "blender" : "openexr") +
                            " convention, " + (orientation.up == UpAxis::z ? "Z" : "Y") + " up, filtered on a cube of " +
                            size_text(face, face));
    for (const std::string& sun : suns.notes()) light.m_notes.push_back(name + ": " + sun);
    light.m_warnings = std::move(given.warnings);
    return light;
}

Environment Environment::relit(const EnvironmentSettings& settings) const {
    check_settings(settings, "light");
    const auto fixed = [](const EnvironmentSettings& s) { return std::tie(s.convention, s.up, s.face_size, s.kernel, s.suns); };
    if (fixed(settings) != fixed(m_settings))
        throw Error(ErrorCode::bad_argument,
                    "light: is made already; rotation, flip, scale and tint can change, for anything else read its file again");
    Environment light = *this;
    light.m_settings = settings;
    light.m_world_to_light =
        world_to_light_matrix(settings.convention, settings.up, settings.rotate_deg, settings.flip, m_is_cube);
    light.m_gain = settings.tint * settings.scale;
    return light;
}

Environment Environment::load(const std::string& file, const EnvironmentSettings& settings,
                              const std::function<void(Image&)>& convert) {
    check_settings(settings, file);
    return from_picture(read_environment_picture(file, PictureLayer::color, convert), settings, file);
}

Environment Environment::from_image(const Image& image, const EnvironmentSettings& settings, const std::string& name) {
    check_settings(settings, name);
    return from_picture(environment_picture(image, name), settings, name);
}

}  // namespace burnish
