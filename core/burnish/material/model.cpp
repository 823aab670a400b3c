#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>
#include <burnish/material/model.h>
#include <burnish/material/models/all.h>

#include <algorithm>

namespace burnish {

#define BURNISH_MODEL(id, type) static_assert(LobeModel<type>);
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL

std::span<const ModelInfo> models() {
    static const std::vector<ModelInfo> all{
#define BURNISH_MODEL(id, type) type::info(),
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL
    };
    return all;
}

std::vector<float> default_parameters(const ModelInfo& model) {
    std::vector<float> values;
    for (const ModelParameter& parameter : model.parameters)
        values.insert(values.end(), parameter.per_channel ? 3 : 1, parameter.value);
    return values;
}

const ModelInfo& model_info(ModelId id) { return models()[static_cast<size_t>(id)]; }

ModelId model_by_name(std::string_view name) {
    const std::span<const ModelInfo> all = models();
    const auto found = std::ranges::find(all, name, &ModelInfo::name);
    if (found != all.end()) return static_cast<ModelId>(found - all.begin());
    std::vector<std::string_view> known;
    std::string list;
    for (const ModelInfo& info : all) {
        known.push_back(info.name);
        list += (list.empty() ? "" : ", ") + std::string(info.name);
    }
    throw Error(ErrorCode::bad_argument,
                "unknown model \"" + std::string(name) + "\"" + did_you_mean(name, known) + "; known: " + list);
}

}  // namespace burnish
