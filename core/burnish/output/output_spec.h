// The header of an output file: windows and channels of the job, attributes of the input that still hold, and a trace of
// what burnish did. Internal to the writer.
#pragma once

#include <burnish/output/exr_writer.h>

#include <OpenImageIO/imageio.h>

namespace burnish {

/// Throws Error(bad_argument) for channel names that compositing packages would change ("one dot at most, letters first")
/// and for names given twice.
OIIO::ImageSpec output_spec(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers,
                            PixelType type, const HeaderTexts& attributes = {});

}  // namespace burnish
