// From a file or an image to an Environment: layout, orientation, scrubbing, pyramid, sampling table.
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/light/clean_picture.h>
#include <burnish/light/cube_resample.h>
#include <burnish/light/environment_layouts.h>
#include <burnish/light/environment_orientation.h>
#include <burnish/light/environment_source.h>
#include <burnish/light/picture_reader.h>

#include <bit>
#include <filesystem>
#include <optional>

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

using Conversion = std::function<void(Image&)>;

/// First three channels, or the first one three times.
Image as_rgb(const Image& image, const std::string& name) {
    if (image.empty() || image.channels < 1)
        throw Error(ErrorCode::bad_argument, name + ": the environment is empty, expected RGB pixels.");
    Image rgb(image.width, image.height, 3);
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        for (int k = 0; k < 3; ++k) rgb.at(i)[k] = image.at(i)[image.channels >= 3 ? k : 0];
    }
    return rgb;
}

/// The six files' names for face names in any of the usual spellings, the first spelling of which all six exist.
std::array<std::string, 6> face_files(const std::string& pattern, size_t at, size_t length) {
    constexpr std::array<std::array<const char*, 6>, 4> spellings = {{{"px", "nx", "py", "ny", "pz", "nz"},
                                                                      {"posx", "negx", "posy", "negy", "posz", "negz"},
                                                                      {"+X", "-X", "+Y", "-Y", "+Z", "-Z"},
                                                                      {"+x", "-x", "+y", "-y", "+z", "-z"}}};
    const auto names = [&](const auto& spelling) {
        std::array<std::string, 6> files;
        for (int face = 0; face < 6; ++face) files[face] = std::string(pattern).replace(at, length, spelling[face]);
        return files;
    };
    for (const auto& spelling : spellings) {
        const auto files = names(spelling);
        if (std::filesystem::exists(files[0])) return files;
    }
    return names(spellings[0]);
}

/// A picture of light on its way into an Environment, RGB: one lat-long or six faces.
struct Given {
    Image latlong;
    std::optional<std::array<Image, 6>> faces;
    bool named_faces = false;  // the faces' names follow the world's axes, see environment_layouts.h
    EnvmapTag tag = EnvmapTag::none;
    std::string description;  // layout and size, for the notes
    std::vector<std::string> warnings;
};

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

Given laid_out(Image picture, EnvmapTag tag, const std::string& name, const Conversion& convert) {
    Given given;
    given.tag = tag;
    clean_picture(picture, convert, name, given.warnings);
    const std::string size = size_text(picture.width, picture.height);
    const EnvironmentLayout layout =
        tag == EnvmapTag::latlong ? EnvironmentLayout::latlong : layout_of(picture.width, picture.height);
    given.description = std::string(layout_name(layout)) + ", " + size;
    if (layout != EnvironmentLayout::latlong) {
        given.faces = cut_faces(picture, layout);
        given.named_faces = faces_are_named(layout);
        return given;
    }
    if (tag == EnvmapTag::cube) {
        throw Error(ErrorCode::read_failed,
                    name + ": the envmap attribute says cube faces, but " + size +
                        " pixels are no six faces. Expected 1 : 6; correct the attribute or the picture.");
    }
    if (picture.width != 2 * picture.height)
        given.warnings.push_back(name + ": " + size + " pixels are not 2 : 1, taken as a lat-long all the same");
    given.latlong = std::move(picture);
    return given;
}

Given six_files(const std::string& pattern, size_t at, size_t length, const Conversion& convert) {
    Given given;
    std::array<Image, 6> faces;
    const std::array<std::string, 6> files = face_files(pattern, at, length);
    for (int face = 0; face < 6; ++face) {
        faces[face] = read_picture(files[face]).rgb;
        clean_picture(faces[face], convert, files[face], given.warnings);
        const int size = faces[0].width;
        if (faces[face].width == size && faces[face].height == size) continue;
        throw Error(ErrorCode::read_failed, files[face] + ": expected a cube face of " + size_text(size, size) +
                                                " pixels like " + files[0] + ", found " +
                                                size_text(faces[face].width, faces[face].height) + ".");
    }
    given.description = "six cube faces, " + size_text(faces[0].width, faces[0].height);
    given.faces = std::move(faces);
    given.named_faces = true;
    return given;
}

/// `automatic` resolved: a file that carries an envmap attribute, and a world with Y up, mean OpenEXR's layout.
EnvironmentConvention resolved(EnvironmentConvention convention, UpAxis up, EnvmapTag tag) {
    if (convention != EnvironmentConvention::automatic) return convention;
    return tag != EnvmapTag::none || up == UpAxis::y ? EnvironmentConvention::openexr : EnvironmentConvention::blender;
}

int own_face_size(const Given& given) {
    return given.faces ? cube_size_for_cube((*given.faces)[0].width) : cube_size_for_latlong(given.latlong.width);
}

std::array<Image, 6> pyramid_faces(const Given& given, int face_size) {
    return given.faces ? resized_cube(*given.faces, face_size) : latlong_to_cube(given.latlong, face_size);
}

DiscCut cut_suns(Given& given) { return DiscCut(given.faces ? PictureCells(*given.faces) : PictureCells(given.latlong)); }

}  // namespace

/// Puts an Environment together; nested, so that it may fill the private parts.
struct Environment::Builder {
    static Environment build(Given given, const EnvironmentSettings& settings, const std::string& name) {
        const UpAxis up = settings.up == UpAxis::automatic ? UpAxis::y : settings.up;
        const EnvironmentConvention convention = resolved(settings.convention, up, given.tag);
        if (given.named_faces && convention == EnvironmentConvention::blender)
            given.faces = from_z_up_names(std::move(*given.faces));

        Environment light;
        light.m_suggested_face_size = own_face_size(given);
        const int face = settings.face_size > 0 ? settings.face_size : light.m_suggested_face_size;
        DiscCut suns = settings.suns == Suns::automatic ? cut_suns(given) : DiscCut();
        light.m_discs = suns.discs();
        light.m_filtered = std::make_shared<Filtered>(pyramid_faces(given, face), settings.kernel);
        suns.put_back();
        light.m_world_to_light =
            world_to_light_matrix(convention, up, settings.rotate_deg, settings.flip, given.faces.has_value());
        light.m_gain = settings.tint * settings.scale;
        light.m_notes.push_back(name + ": " + given.description + ", " +
                                (convention == EnvironmentConvention::blender ? "blender" : "openexr") + " convention, " +
                                (up == UpAxis::z ? "Z" : "Y") + " up, filtered on a cube of " + size_text(face, face));
        for (const std::string& sun : suns.notes()) light.m_notes.push_back(name + ": " + sun);
        light.m_warnings = std::move(given.warnings);

        auto source = std::make_shared<Source>();
        if (given.faces) source->cube = CubeLevel(*given.faces);
        source->latlong = std::move(given.latlong);
        source->make_table();
        light.m_source = std::move(source);
        return light;
    }
};

Environment Environment::load(const std::string& file, const EnvironmentSettings& settings, const Conversion& convert) {
    check_settings(settings, file);
    for (const std::string token : {"{face}", "%s"}) {
        const size_t at = file.find(token);
        if (at != std::string::npos) return Builder::build(six_files(file, at, token.size(), convert), settings, file);
    }
    Picture picture = read_picture(file);
    return Builder::build(laid_out(std::move(picture.rgb), picture.tag, file, convert), settings, file);
}

Environment Environment::from_image(const Image& image, const EnvironmentSettings& settings, const std::string& name) {
    check_settings(settings, name);
    return Builder::build(laid_out(as_rgb(image, name), EnvmapTag::none, name, {}), settings, name);
}

}  // namespace burnish
