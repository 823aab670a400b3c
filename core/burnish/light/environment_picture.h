// A picture over directions as files hold it, on its way into an Environment or a map of distances: layout and orientation.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/light/picture_reader.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// One lat-long or six faces: RGB, for distances one channel.
struct EnvironmentPicture {
    Image latlong;
    std::optional<std::array<Image, 6>> faces;
    bool named_faces = false;  // the faces' names follow the world's axes, see environment_layouts.h
    bool six_files = false;
    EnvmapTag tag = EnvmapTag::none;
    std::string description;  // layout and size, for the notes
    std::vector<std::string> warnings;
};

/// "512 x 512"
std::string size_text(int width, int height);

/// The files that a name stands for: itself, or those of six faces, see Environment::load.
std::vector<std::string> picture_files(const std::string& name);

/// Reads a file or six of them, see Environment::load. Colour is finite, >= 0 and converted; alpha is three times the same, in
/// [0, 1]; distances are as the file has them. Throws what read_picture does.
EnvironmentPicture read_environment_picture(const std::string& file, PictureLayer layer,
                                            const std::function<void(Image&)>& convert = {});

/// Whether that file, or the first of the six, has the layer.
bool environment_has_layer(const std::string& file, PictureLayer layer);

/// Colour from memory: RGB, or grey. Throws Error(bad_argument) where there are no pixels.
EnvironmentPicture environment_picture(const Image& image, const std::string& name);

/// What `automatic` comes to, and the way from world directions to the picture's.
struct Orientation {
    EnvironmentConvention convention;
    UpAxis up;
    Matrix33f world_to_light;
};

/// Gives the faces the light's own order; to be called once.
Orientation orient(EnvironmentPicture& picture, const EnvironmentSettings& settings);

}  // namespace burnish
