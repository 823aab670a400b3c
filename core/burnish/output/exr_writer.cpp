#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/output/exr_pixels.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/output_spec.h>

namespace burnish {
namespace {

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

}  // namespace

struct ExrWriter::State {
    std::string file;
    LayerFile output;
};

ExrWriter::ExrWriter(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type,
                     const HeaderTexts& attributes)
    : m_state(new State{file, {file, output_spec(file, frame, layers, type, attributes)}}) {}

ExrWriter::~ExrWriter() = default;

void ExrWriter::append(const std::vector<OutputLayer>& layers, int above, int below) {
    const Image& first = *layers.front().image;
    check_sizes(m_state->file, {0, 0, first.width, first.height}, layers);
    m_state->output.append(layers, above, first.height - below);
}

void ExrWriter::finish() { m_state->output.finish(); }

void write_exr(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type) {
    check_sizes(file, frame.data_window, layers);
    ExrWriter writer(file, frame, layers, type);
    writer.append(layers, 0, 0);
    writer.finish();
}

void write_exr_parts(const std::string& file, const AovFrame& frame, const std::vector<OutputPart>& parts, PixelType type,
                     const HeaderTexts& attributes) {
    std::vector<OIIO::ImageSpec> specs;
    AovFrame header;
    header.file = frame.file, header.metadata = frame.metadata;
    header.data_window = frame.data_window, header.display_window = frame.display_window;
    for (const OutputPart& part : parts) {
        header.data_window.width = part.layers.front().image->width;
        header.data_window.height = part.layers.front().image->height;
        check_sizes(file, header.data_window, part.layers);
        specs.push_back(output_spec(file, header, part.layers, type, attributes));
        specs.back().attribute("oiio:subimagename", part.name);
    }
    LayerFile output(file, specs);
    for (size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) output.next_part();
        output.append(parts[i].layers, 0, specs[i].height);
    }
    output.finish();
}

void write_text(const std::string& file, const std::string& text) {
    AtomicFile target(file);
    if (std::fwrite(text.data(), 1, text.size(), target.handle()) != text.size()) target.fail("the disk did not take all data");
    target.commit();
}

}  // namespace burnish
