#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>
#include <burnish/base/parallel.h>
#include <burnish/input/color.h>
#include <burnish/input/plain_color_config.h>

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace burnish {
namespace ocio = OCIO_NAMESPACE;

struct ColorConfig::State {
    std::string name;
    ocio::ConstConfigRcPtr config;
};

namespace {

constexpr int kBuiltinConfigs = 0x02020000;  // the version that brought ocio:// and .ocioz
constexpr const char* kRemedy = "set --colorconfig or $OCIO to a config.ocio file, or unset $OCIO for plain Rec.709 and ACEScg";

[[noreturn]] void fail(const std::string& message) { throw Error(ErrorCode::color_space, message); }

void check_supported(const std::string& file, const std::string& where) {
    const bool builtin = file.starts_with("ocio://"), archive = file.ends_with(".ocioz");
    if ((!builtin && !archive) || ocio::GetVersionHex() >= kBuiltinConfigs) return;
    fail(where + ": OpenColorIO " + ocio::GetVersion() + (builtin ? " has no built-in configs" : " reads no .ocioz archives") +
         " (2.2 and newer do); " + kRemedy);
}

/// All names a user may give: colour spaces, their aliases, roles.
std::vector<std::string> known_names(const ocio::Config& config) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumColorSpaces(); ++i) {
        const auto space = config.getColorSpace(config.getColorSpaceNameByIndex(i));
        names.push_back(space->getName());
        for (size_t k = 0; k < space->getNumAliases(); ++k) names.push_back(space->getAlias(k));
    }
    for (int i = 0; i < config.getNumRoles(); ++i) names.push_back(config.getRoleName(i));
    return names;
}

/// Throws for a name that is not in the config: the one that may have been meant, and those there are.
[[noreturn]] void fail_unknown(const std::string& what, const std::string& name, const std::string& config,
                               const std::vector<std::string>& known, const std::vector<std::string>& listed) {
    constexpr size_t kLongestList = 16;  // studio configs have hundreds
    const std::vector<std::string_view> views(known.begin(), known.end());
    std::string message = what + " \"" + name + "\" is not in the config " + config + did_you_mean(name, views) + "; it has";
    for (size_t i = 0; i < std::min(listed.size(), kLongestList); ++i) message += (i ? ", " : " ") + listed[i];
    if (listed.size() > kLongestList) message += " and " + std::to_string(listed.size() - kLongestList) + " more";
    fail(message);
}

void check_space(const std::string& space, const ColorConfig& config) {
    const ocio::Config& c = *config.state().config;
    if (!c.getColorSpace(space.c_str())) fail_unknown("colour space", space, config.name(), known_names(c), config.spaces());
}

/// `name` if the config lists it, the config's default when it is empty.
std::string choose(const char* what, const std::string& name, const char* preset, const std::vector<std::string>& names,
                   const ColorConfig& config) {
    if (name.empty()) return preset;
    if (std::find(names.begin(), names.end(), name) == names.end()) fail_unknown(what, name, config.name(), names, names);
    return name;
}

/// Rows in parallel; without OpenColorIO's approximate powers, so that a value does not depend on the machine.
void process_rows(Image& image, const ocio::ConstProcessorRcPtr& processor) {
    if (processor->isNoOp()) return;
    const auto cpu = processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    for_each_index(image.height, [&](int y) {
        constexpr ptrdiff_t kFloat = sizeof(float);
        ocio::PackedImageDesc row(image.at(0, y), image.width, 1, ocio::CHANNEL_ORDERING_RGB, ocio::BIT_DEPTH_F32, kFloat,
                                  kFloat * image.channels, kFloat * image.channels * image.width);
        cpu->apply(row);
    });
}

void check_channels(const Image& image) {
    if (image.channels < 3)
        throw Error(ErrorCode::bad_argument,
                    "colour needs three channels, the image has " + std::to_string(image.channels) + "; give RGB");
}

/// Calls `make` and applies its processor; OpenColorIO's complaint becomes ours.
template <typename Make>
void apply_processor(Image& image, const ColorConfig& config, Make make) {
    check_channels(image);
    if (image.empty()) return;
    try {
        process_rows(image, make());
    } catch (const ocio::Exception& error) {
        fail(config.name() + ": " + error.what());
    }
}

}  // namespace

ColorConfig ColorConfig::load(const std::string& file) {
    const char* variable = std::getenv("OCIO");
    const bool from_environment = file.empty() && variable && *variable;
    const std::string path = from_environment ? variable : file;
    const std::string where = (from_environment ? "$OCIO = " : "colour config ") + path;
    try {
        auto state = std::make_shared<State>();
        if (path.empty()) {
            std::istringstream stream(kPlainColorConfig);
            state->config = ocio::Config::CreateFromStream(stream);
            state->name = "plain";
        } else {
            check_supported(path, where);
            state->config = ocio::Config::CreateFromFile(path.c_str());
            state->name = path;
        }
        state->config->validate();
        return ColorConfig(std::move(state));
    } catch (const ocio::Exception& error) {
        fail(where + ": not a usable OpenColorIO config (" + error.what() + "); " + kRemedy);
    }
}

const std::string& ColorConfig::name() const { return m_state->name; }

std::vector<std::string> ColorConfig::spaces() const {
    std::vector<std::string> names;
    for (int i = 0; i < m_state->config->getNumColorSpaces(); ++i)
        names.push_back(m_state->config->getColorSpaceNameByIndex(i));
    return names;
}

std::vector<std::string> ColorConfig::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < m_state->config->getNumDisplays(); ++i) names.push_back(m_state->config->getDisplay(i));
    return names;
}

std::vector<std::string> ColorConfig::views(const std::string& display) const {
    std::vector<std::string> names;
    for (int i = 0; i < m_state->config->getNumViews(display.c_str()); ++i)
        names.push_back(m_state->config->getView(display.c_str(), i));
    return names;
}

void convert(Image& image, const std::string& from, const std::string& to, const ColorConfig& config) {
    check_space(from, config);
    check_space(to, config);
    apply_processor(image, config, [&] { return config.state().config->getProcessor(from.c_str(), to.c_str()); });
}

void apply_view(Image& image, const std::string& from, const std::string& display, const std::string& view,
                const ColorConfig& config) {
    const ocio::Config& c = *config.state().config;
    check_space(from, config);
    const std::string d = choose("display", display, c.getDefaultDisplay(), config.displays(), config);
    const std::string v = choose("view", view, c.getDefaultView(d.c_str(), from.c_str()), config.views(d), config);
    apply_processor(image, config,
                    [&] { return c.getProcessor(from.c_str(), d.c_str(), v.c_str(), ocio::TRANSFORM_DIR_FORWARD); });
}

}  // namespace burnish
