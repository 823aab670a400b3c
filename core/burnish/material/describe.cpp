#include <burnish/material/describe.h>
#include <burnish/material/library.h>
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

void describe(const ModelInfo& model, std::ostream& text) {
    text << "  " << std::left << std::setw(12) << model.name << model.summary << "\n"
         << std::setw(14) << "" << model.source << (model.reciprocal ? "" : "; not reciprocal") << "\n";
    for (const ModelParameter& parameter : model.parameters)
        text << std::setw(14) << "" << parameter.name << " = " << parameter.value << " in [" << parameter.min << ", "
             << parameter.max << "]: " << parameter.help << "\n";
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

}  // namespace

std::string describe_models() {
    std::ostringstream text;
    text << "models\n";
    for (const ModelInfo& model : models()) describe(model, text);
    text << "\n" << kSharedFields << "\npresets (model, slope widths)\n";
    size_t name_width = 0;
    for (const Material& preset : presets()) name_width = std::max(name_width, preset.name.size());
    for (const Material& preset : presets()) describe(preset, name_width, text);
    return text.str();
}

}  // namespace burnish
