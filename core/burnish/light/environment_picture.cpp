#include <burnish/light/environment_picture.h>

#include <burnish/base/error.h>
#include <burnish/light/clean_picture.h>
#include <burnish/light/environment_layouts.h>
#include <burnish/light/environment_orientation.h>

#include <algorithm>
#include <filesystem>

namespace burnish {
namespace {

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

/// One layer of a file in the values that EnvironmentPicture promises.
Picture clean_layer(const std::string& file, PictureLayer layer, const Conversion& convert,
                    std::vector<std::string>& warnings) {
    Picture picture = read_picture(file, layer);
    if (layer == PictureLayer::color) clean_picture(picture.pixels, convert, file, warnings);
    if (layer != PictureLayer::alpha) return picture;
    clean_picture(picture.pixels, {}, file, warnings);
    for (float& value : picture.pixels.data) value = std::min(value, 1.0f);
    picture.pixels = as_rgb(picture.pixels, file);
    return picture;
}

EnvironmentPicture laid_out(Picture picture, const std::string& name, EnvironmentPicture given) {
    given.tag = picture.tag;
    const int width = picture.pixels.width, height = picture.pixels.height;
    const std::string size = size_text(width, height);
    const EnvironmentLayout layout = picture.tag == EnvmapTag::latlong ? EnvironmentLayout::latlong : layout_of(width, height);
    given.description = std::string(layout_name(layout)) + ", " + size;
    if (layout != EnvironmentLayout::latlong) {
        given.faces = cut_faces(picture.pixels, layout);
        given.named_faces = faces_are_named(layout);
        return given;
    }
    if (picture.tag == EnvmapTag::cube) {
        throw Error(ErrorCode::read_failed,
                    name + ": the envmap attribute says cube faces, but " + size +
                        " pixels are no six faces. Expected 1 : 6; correct the attribute or the picture.");
    }
    if (width != 2 * height)
        given.warnings.push_back(name + ": " + size + " pixels are not 2 : 1, taken as a lat-long all the same");
    given.latlong = std::move(picture.pixels);
    return given;
}

/// The six files that a name stands for, or nothing where it is one file's.
std::optional<std::array<std::string, 6>> six_files(const std::string& name) {
    for (const std::string token : {"{face}", "%s"}) {
        const size_t at = name.find(token);
        if (at != std::string::npos) return face_files(name, at, token.size());
    }
    return std::nullopt;
}

EnvironmentPicture read_six(const std::array<std::string, 6>& files, PictureLayer layer, const Conversion& convert) {
    EnvironmentPicture given;
    std::array<Image, 6> faces;
    for (int face = 0; face < 6; ++face) {
        faces[face] = clean_layer(files[face], layer, convert, given.warnings).pixels;
        const int size = faces[0].width;
        if (faces[face].width == size && faces[face].height == size) continue;
        throw Error(ErrorCode::read_failed, files[face] + ": expected a cube face of " + size_text(size, size) +
                                                " pixels like " + files[0] + ", found " +
                                                size_text(faces[face].width, faces[face].height) + ".");
    }
    given.description = "six cube faces, " + size_text(faces[0].width, faces[0].height);
    given.faces = std::move(faces);
    given.named_faces = given.six_files = true;
    return given;
}

/// `automatic` resolved: a file that carries an envmap attribute, and a world with Y up, mean OpenEXR's layout.
EnvironmentConvention resolved(EnvironmentConvention convention, UpAxis up, EnvmapTag tag) {
    if (convention != EnvironmentConvention::automatic) return convention;
    return tag != EnvmapTag::none || up == UpAxis::y ? EnvironmentConvention::openexr : EnvironmentConvention::blender;
}

}  // namespace

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

std::vector<std::string> picture_files(const std::string& name) {
    const auto six = six_files(name);
    return six ? std::vector<std::string>(six->begin(), six->end()) : std::vector{name};
}

EnvironmentPicture read_environment_picture(const std::string& file, PictureLayer layer, const Conversion& convert) {
    if (const auto files = six_files(file)) return read_six(*files, layer, convert);
    EnvironmentPicture given;
    Picture picture = clean_layer(file, layer, convert, given.warnings);
    return laid_out(std::move(picture), file, std::move(given));
}

bool environment_has_layer(const std::string& file, PictureLayer layer) {
    const auto files = six_files(file);
    return has_layer(files ? (*files)[0] : file, layer);
}

EnvironmentPicture environment_picture(const Image& image, const std::string& name) {
    EnvironmentPicture given;
    Image rgb = as_rgb(image, name);
    clean_picture(rgb, {}, name, given.warnings);
    return laid_out({std::move(rgb), EnvmapTag::none}, name, std::move(given));
}

Orientation orient(EnvironmentPicture& picture, const EnvironmentSettings& settings) {
    const UpAxis up = settings.up == UpAxis::automatic ? UpAxis::y : settings.up;
    const EnvironmentConvention convention = resolved(settings.convention, up, picture.tag);
    if (picture.named_faces && convention == EnvironmentConvention::blender)
        picture.faces = from_z_up_names(std::move(*picture.faces));
    return {convention, up,
            world_to_light_matrix(convention, up, settings.rotate_deg, settings.flip, picture.faces.has_value())};
}

}  // namespace burnish
