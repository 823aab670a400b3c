#include <burnish/output/atomic_file.h>
#include <burnish/output/exr_pixels.h>

#include <OpenImageIO/filesystem.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr int kRowsAtOnce = 64;  // four ZIP blocks; keeps the interleaved copy small

/// Rows [begin, end) of all layers, channels interleaved, values within what the channel's type can hold.
void interleave(const std::vector<OutputLayer>& layers, const OIIO::ImageSpec& spec, int begin, int end,
                std::vector<float>& rows) {
    const size_t stride = static_cast<size_t>(spec.nchannels);
    size_t first = 0;
    for (const OutputLayer& layer : layers) {
        const Image& image = *layer.image;
        float* to = rows.data() + first;
        const float* from = image.at(0, begin);
        const size_t pixels = static_cast<size_t>(end - begin) * image.width;
        for (size_t i = 0; i < pixels; ++i, to += stride, from += image.channels) std::copy_n(from, image.channels, to);
        first += layer.channels.size();
    }
    for (size_t c = 0; c < stride; ++c)
        if (spec.channelformat(static_cast<int>(c)) == OIIO::TypeHalf)
            for (size_t i = c; i < rows.size(); i += stride) rows[i] = std::clamp(rows[i], -kLargestHalf, kLargestHalf);
}

void write_pixels(OIIO::ImageOutput& output, const AtomicFile& target, const std::vector<OutputLayer>& layers) {
    const OIIO::ImageSpec& spec = output.spec();
    std::vector<float> rows;
    for (int begin = 0; begin < spec.height; begin += kRowsAtOnce) {
        const int end = std::min(begin + kRowsAtOnce, spec.height);
        rows.resize(static_cast<size_t>(end - begin) * spec.width * spec.nchannels);
        interleave(layers, spec, begin, end, rows);
        if (!output.write_scanlines(spec.y + begin, spec.y + end, 0, OIIO::TypeFloat, rows.data()))
            target.fail(output.geterror());
    }
}

}  // namespace

void write_layers(const std::string& file, const OIIO::ImageSpec& spec, const std::vector<OutputLayer>& layers) {
    AtomicFile target(file);
    OIIO::Filesystem::IOFile stream(target.handle(), OIIO::Filesystem::IOProxy::Write);
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr", &stream);
    if (!output || !output->open(file, spec)) target.fail(output ? output->geterror() : OIIO::geterror());
    write_pixels(*output, target, layers);
    if (!output->close()) target.fail(output->geterror());
    output.reset();  // textures stay open after close(); the writer must be gone before its stream is
    target.commit();
}

}  // namespace burnish
