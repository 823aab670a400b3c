#include <burnish/job/write_frame.h>

#include <burnish/job/job_hash.h>

namespace burnish {
namespace {

std::vector<OutputLayer> layers_of(const FrameResult& result, bool diagnostics) {
    std::vector<OutputLayer> layers{{{"R", "G", "B", "A"}, &result.composite.beauty},
                                    {{"burnish_spec.R", "burnish_spec.G", "burnish_spec.B"}, &result.composite.overlay}};
    const auto add = [&](const char* name, std::vector<std::string> components, const Image& image) {
        if (image.empty()) return;
        for (std::string& component : components) component = std::string(name) + "." + component;
        layers.push_back({components, &image});
    };
    add("burnish_diffuse", {"R", "G", "B"}, result.composite.diffuse);
    if (!diagnostics) return layers;
    add("burnish_validity", {"X"}, result.validity);
    add("burnish_samples", {"X"}, result.shaded.samples);
    add("burnish_error", {"X"}, result.shaded.standard_error);
    return layers;
}

}  // namespace

void FrameWriter::append(const Window& whole, const AovFrame& band, FrameResult& result) {
    m_color.to_output(result.composite);
    const std::vector<OutputLayer> layers = layers_of(result, m_job.output.diagnostics);
    if (!m_exr) open(whole, band, layers);
    m_exr->append(layers, band.margin_above, band.margin_below);
    if (m_preview) m_preview->append(result.composite.beauty, band.margin_above, band.margin_below);
}

void FrameWriter::open(const Window& whole, const AovFrame& band, const std::vector<OutputLayer>& layers) {
    AovFrame header;
    header.file = band.file, header.metadata = band.metadata;
    header.data_window = whole, header.display_window = band.display_window;
    const HeaderTexts attributes = m_hash.empty() ? HeaderTexts{} : HeaderTexts{{kJobHashAttribute, m_hash}};
    m_exr.emplace(m_output.begin(m_task), header, layers, m_job.output.pixel_type, attributes);
    if (!m_task.preview.empty()) m_preview.emplace(m_task.preview, whole.width, whole.height, m_color.preview());
}

void FrameWriter::finish() {
    m_exr->finish();
    m_output.finish(m_task);
    if (m_preview) m_preview->finish();
}

}  // namespace burnish
