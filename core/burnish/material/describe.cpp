#include <burnish/material/describe.h>
#include <burnish/material/library.h>
#include <burnish/material/measured_library.h>
#include <burnish/material/model.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace burnish {

namespace {

constexpr const char* kSharedFields = R"(fields of every lobe
  ks | kt                    strength of reflection | of transmission through a thin sheet; 1
  tint                       colour; 1
  m | mx my | roughness      slope widths (along t, along b) in [0.0001, 1] | artist's roughness r, m = r^2; m = 0.1
  anisotropy                 in [-1, 1], with m or roughness: mx = m (1 - a), my = m / (1 - a) for a >= 0
  rotation_deg               turns the tangent about the normal, right-hand rule; 0
  r0 | ior | eta k | metal   Fresnel: Schlick's | dielectric | conductor | conductor by name; none of them: F = 1
  f1 | dip dip_power         with r0, bend Schlick's curve: F - f1 c | F - dip c (1 - c)^dip_power, c = cos of wo to h
  per_pixel                  list of what the frame's layers replace: roughness anisotropy rotation tint weight
)";

size_t longest_name(const auto& named) {
    size_t longest = 0;
    for (const auto& one : named) longest = std::max(longest, one.name.size());
    return longest;
}

/// What sets a model apart from one with widths mx, my and f(wo, wi) = f(wi, wo).
std::string marks(const ModelInfo& model) {
    return std::string(model.reciprocal ? "" : "; not reciprocal") + (model.anisotropic ? "" : "; round only") +
           (model.own_width ? "; has a width of its own, stretched to m" : "");
}

void describe(const ModelInfo& model, size_t name_width, std::ostream& text) {
    const std::string indent(name_width + 4, ' ');
    text << "  " << std::left << std::setw(static_cast<int>(name_width) + 2) << model.name << model.summary << "\n"
         << indent << model.source << marks(model) << "\n";
    for (const ModelParameter& parameter : model.parameters)
        text << indent << parameter.name << " = " << parameter.value << (parameter.per_channel ? " per channel" : "") << " in ["
             << parameter.min << ", " << parameter.max << "]: " << parameter.help << "\n";
}

void describe(const LobeParameters& lobe, std::ostream& text) {
    text << model_info(lobe.model).name << " " << lobe.mx;
    if (lobe.mx != lobe.my) text << " x " << lobe.my;
    if (lobe.side == Side::transmission) text << " through";
}

void describe(const Material& preset, size_t name_width, std::ostream& text) {
    text << "  " << std::left << std::setw(static_cast<int>(name_width) + 2) << preset.name;
    for (size_t i = 0; i < preset.lobes.size(); ++i) {
        text << (i ? " + " : "");
        describe(preset.lobes[i], text);
    }
    text << "\n";
}

/// Names without their common prefix, filled to lines.
void describe_library(std::ostream& text) {
    constexpr size_t kLine = 110;
    const std::string prefix = "merl:";
    text << "\nlibrary: " << library_names().size() << " measured materials (MERL) as sgd lobes, used as " << prefix
         << "NAME\n";
    std::string line = " ";
    for (const std::string& name : library_names()) {
        const std::string word = " " + name.substr(prefix.size());
        if (line.size() + word.size() > kLine) text << line << "\n", line = " ";
        line += word;
    }
    text << line << "\n";
}

}  // namespace

std::string describe_models() {
    std::ostringstream text;
    text << "models\n";
    for (const ModelInfo& model : models()) describe(model, longest_name(models()), text);
    text << "\n" << kSharedFields << "\npresets (model, slope widths)\n";
    for (const Material& preset : presets()) describe(preset, longest_name(presets()), text);
    describe_library(text);
    return text.str();
}

}  // namespace burnish
