#include <burnish/job/read_frame.h>

#include <burnish/base/error.h>
#include <burnish/input/camera_source.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/frame_geometry.h>
#include <burnish/job/run_frame.h>
#include <burnish/shading/shading_plan.h>

#include <algorithm>

namespace burnish {
namespace {

bool is_in_other_part(Role role, FramePart part) {
    return part != FramePart::whole && is_of_picture(role) != (part == FramePart::picture);
}

Role role_of(Role role) { return role; }
template <class Value>
Role role_of(const std::pair<const Role, Value>& entry) {
    return entry.first;
}

/// The channels a role takes out of an array that may have an alpha more.
void check_layer(const Image& image, const RoleInfo& role, const Image& first) {
    const std::string name(role.name);
    if (image.width != first.width || image.height != first.height)
        throw Error(ErrorCode::size_mismatch, name + ": expected " + std::to_string(first.width) + "x" +
                                                  std::to_string(first.height) + " pixels like the other layers, found " +
                                                  std::to_string(image.width) + "x" + std::to_string(image.height));
    if (image.channels != role.channels)
        throw Error(ErrorCode::size_mismatch, name + ": expected " + std::to_string(role.channels) + " channels, found " +
                                                  std::to_string(image.channels));
}

void split_alpha(std::map<Role, Image>& layers) {
    const auto beauty = layers.find(Role::beauty);
    if (beauty == layers.end() || beauty->second.channels != 4) return;
    const Image rgba = std::move(beauty->second);
    Image &rgb = beauty->second = Image(rgba.width, rgba.height, 3), alpha(rgba.width, rgba.height, 1);
    for (size_t i = 0; i < rgba.pixel_count(); ++i) std::copy_n(rgba.at(i), 3, rgb.at(i)), *alpha.at(i) = rgba.at(i)[3];
    layers.emplace(Role::alpha, std::move(alpha));
}

}  // namespace

ReadOptions read_options(const Job& job, const Wardrobe& wardrobe, const std::string& camera, FramePart part,
                         const std::string& view) {
    const auto is_elsewhere = [part](const auto& wanted) { return is_in_other_part(role_of(wanted), part); };
    ReadOptions options;
    options.roles = wanted_roles(job, wardrobe);
    options.substitutes = substitute_roles(job, wardrobe);
    options.channels = job.channels;
    std::erase_if(options.roles, is_elsewhere);
    std::erase_if(options.substitutes, is_elsewhere);
    std::erase_if(options.channels, is_elsewhere);
    options.view = view;
    if (part == FramePart::picture) return options;
    if (may_be_sparse(job.density.density, job.estimator.kind)) options.shaded_block = ShadingPlan::kBlock;
    options.camera = camera_source(camera);
    options.cryptomattes =
        std::any_of(wardrobe.rules.begin(), wardrobe.rules.end(), [](const AssignRule& r) { return !r.cryptomatte.empty(); });
    return options;
}

AovFrame read_job_frame(const Job& job, const Wardrobe& wardrobe, const std::string& file, const std::string& camera,
                        FramePart part, const std::string& view) {
    return read_frame(file, read_options(job, wardrobe, camera, part, view));
}

AovFrame frame_from_layers(std::map<Role, Image> layers, const std::string& camera) {
    if (layers.empty()) throw Error(ErrorCode::size_mismatch, "aovs: expected at least position and normal, found no layer");
    split_alpha(layers);
    const Image& first = layers.begin()->second;
    for (const auto& [role, image] : layers) check_layer(image, role_info(role), first);
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, first.width, first.height};
    frame.layers = std::move(layers);
    find_camera(frame, frame.data_window, camera_source(camera));
    judge_depth(frame, frame.data_window);
    complete_position(frame, frame.data_window, false);
    return frame;
}

}  // namespace burnish
