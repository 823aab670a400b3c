// Layers of images into the scanlines of one EXR file. Internal to the writers: headers elsewhere stay free of OpenImageIO.
#pragma once

#include <burnish/output/exr_writer.h>

#include <OpenImageIO/imageio.h>

namespace burnish {

/// Writes the layers, whose channels are those of `spec` in its order and whose sizes are its size: the whole file or none.
/// Values of half channels are clamped to +-65504. Throws Error(write_failed).
void write_layers(const std::string& file, const OIIO::ImageSpec& spec, const std::vector<OutputLayer>& layers);

}  // namespace burnish
