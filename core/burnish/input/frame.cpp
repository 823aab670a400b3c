#include <burnish/base/error.h>
#include <burnish/input/frame.h>
#include <burnish/input/metadata_spec.h>

namespace burnish {

const Image& AovFrame::layer(Role role) const {
    if (const auto found = layers.find(role); found != layers.end()) return found->second;
    const RoleInfo& info = role_info(role);
    const std::string name(info.name);
    std::string aliases;
    for (const std::string_view alias : info.aliases)
        if (!alias.empty()) aliases += (aliases.empty() ? "" : ", ") + std::string(alias);
    const bool camera_helps = role == Role::position && find(Role::depth);
    const std::string has = metadata ? metadata->layers : "";
    throw Error(ErrorCode::missing_channel,
                label() + ": no " + name + " layer (" + std::string(info.help) + "); looked for " + aliases +
                    "; the file has " + (has.empty() ? "none" : has) + "; name it with --channel " + name + "=NAME" +
                    (camera_helps ? ", or give a camera for the depth there is: --camera FILE" : ""));
}

}  // namespace burnish
