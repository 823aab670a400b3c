#include <burnish/job/write_frame.h>

#include <burnish/output/exr_writer.h>

namespace burnish {

void write_frame(const Job& job, const ColorFlow& color, const FrameTask& task, const AovFrame& frame, FrameResult& result) {
    color.to_output(result.composite);
    std::vector<OutputLayer> layers{{{"R", "G", "B", "A"}, &result.composite.beauty},
                                    {{"burnish_spec.R", "burnish_spec.G", "burnish_spec.B"}, &result.composite.overlay}};
    const auto add = [&](const char* name, std::vector<std::string> components, const Image& image) {
        if (image.empty()) return;
        for (std::string& component : components) component = std::string(name) + "." + component;
        layers.push_back({components, &image});
    };
    add("burnish_diffuse", {"R", "G", "B"}, result.composite.diffuse);
    if (job.output.diagnostics) {
        add("burnish_validity", {"X"}, result.validity);
        add("burnish_samples", {"X"}, result.shaded.samples);
        add("burnish_error", {"X"}, result.shaded.standard_error);
    }
    write_exr(task.output, frame, layers, job.output.pixel_type);
    if (!task.preview.empty()) write_preview(task.preview, result.composite.beauty, color.preview());
}

}  // namespace burnish
