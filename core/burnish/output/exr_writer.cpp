#include <burnish/base/error.h>
#include <burnish/output/atomic_file.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/output_spec.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr int kRowsAtOnce = 64;  // four ZIP blocks; keeps the interleaved copy small

void check_sizes(const std::string& file, const Window& window, const std::vector<OutputLayer>& layers) {
    for (const OutputLayer& layer : layers) {
        const Image& image = *layer.image;
        if (image.width == window.width && image.height == window.height &&
            image.channels == static_cast<int>(layer.channels.size()))
            continue;
        throw Error(ErrorCode::size_mismatch,
                    file + ": layer " + (layer.channels.empty() ? "(unnamed)" : layer.channels.front()) + " is " +
                        std::to_string(image.width) + "x" + std::to_string(image.height) + "x" +
                        std::to_string(image.channels) + ", the frame is " + std::to_string(window.width) + "x" +
                        std::to_string(window.height) + " with " + std::to_string(layer.channels.size()) + " channel names");
    }
}

/// Rows [begin, end) of all layers, channels interleaved, values within what `type` can hold.
void interleave(const std::vector<OutputLayer>& layers, int begin, int end, PixelType type, int stride,
                std::vector<float>& rows) {
    int first = 0;
    for (const OutputLayer& layer : layers) {
        const Image& image = *layer.image;
        float* to = rows.data() + first;
        const float* from = image.at(0, begin);
        const size_t pixels = static_cast<size_t>(end - begin) * image.width;
        for (size_t i = 0; i < pixels; ++i, to += stride, from += image.channels) std::copy_n(from, image.channels, to);
        first += image.channels;
    }
    if (type == PixelType::half)
        for (float& value : rows) value = std::clamp(value, -kLargestHalf, kLargestHalf);
}

void write_pixels(OIIO::ImageOutput& output, const AtomicFile& target, const std::vector<OutputLayer>& layers, PixelType type) {
    const OIIO::ImageSpec& spec = output.spec();
    std::vector<float> rows;
    for (int begin = 0; begin < spec.height; begin += kRowsAtOnce) {
        const int end = std::min(begin + kRowsAtOnce, spec.height);
        rows.resize(static_cast<size_t>(end - begin) * spec.width * spec.nchannels);
        interleave(layers, begin, end, type, spec.nchannels, rows);
        if (!output.write_scanlines(spec.y + begin, spec.y + end, 0, OIIO::TypeFloat, rows.data()))
            target.fail(output.geterror());
    }
}

}  // namespace

void write_exr(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type) {
    check_sizes(file, frame.data_window, layers);
    const OIIO::ImageSpec spec = output_spec(file, frame, layers, type);
    AtomicFile target(file);
    OIIO::Filesystem::IOFile stream(target.handle(), OIIO::Filesystem::IOProxy::Write);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr", &stream);
    if (!output || !output->open(file, spec)) target.fail(output ? output->geterror() : OIIO::geterror());
    write_pixels(*output, target, layers, type);
    if (!output->close()) target.fail(output->geterror());
    target.commit();
}

void write_text(const std::string& file, const std::string& text) {
    AtomicFile target(file);
    if (std::fwrite(text.data(), 1, text.size(), target.handle()) != text.size()) target.fail("the disk did not take all data");
    target.commit();
}

}  // namespace burnish
