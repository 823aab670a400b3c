// Layers of images into the scanlines of one EXR file. Internal to the writers: headers elsewhere stay free of OpenImageIO.
#pragma once

#include <burnish/base/atomic_file.h>
#include <burnish/output/exr_writer.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>

namespace burnish {

/// A file of which rows are appended from the top: there when finished, else never.
class LayerFile {
public:
    /// One part a spec; several have names ("oiio:subimagename") and one display window. Throws Error(write_failed).
    LayerFile(const std::string& file, const std::vector<OIIO::ImageSpec>& parts);
    LayerFile(const std::string& file, const OIIO::ImageSpec& spec) : LayerFile(file, std::vector{spec}) {}

    /// Appends rows [begin, end) of the layers, whose channels are those of the spec in its order and whose width is its
    /// width. Values of half channels are clamped to +-65504. Throws Error(write_failed).
    void append(const std::vector<OutputLayer>& layers, int begin, int end);
    /// The rows of a part are complete: what is appended now belongs to the next. Throws Error(write_failed).
    void next_part();
    /// The file is complete. Throws Error(write_failed).
    void finish();

private:
    std::vector<OIIO::ImageSpec> m_parts;
    AtomicFile m_target;
    OIIO::Filesystem::IOFile m_stream;
    std::unique_ptr<OIIO::ImageOutput> m_output;  // goes before its stream
    size_t m_part = 0;
    int m_rows = 0;  // of the part, appended
};

/// Writes whole layers: the whole file or none. Throws Error(write_failed).
void write_layers(const std::string& file, const OIIO::ImageSpec& spec, const std::vector<OutputLayer>& layers);

}  // namespace burnish
