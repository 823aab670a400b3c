#include <burnish/input/role_checks.h>
#include <burnish/input/verify_layer.h>

#include <cstdio>

namespace burnish {
namespace {

std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

Verdict verify_vectors(Image& image) {
    const VectorCheck check = check_vectors(image);
    switch (check.kind) {
        case VectorKind::unit: return {true, "unit length (median " + number("%.3f", check.median_length) + ")", ""};
        case VectorKind::encoded: decode_vectors(image); return {true, "stored as 0..1, decoded as 2n - 1", ""};
        case VectorKind::empty: return {false, "zero everywhere", ""};
        case VectorKind::neither: break;
    }
    return {false, "not unit vectors (median length " + number("%.3g", check.median_length) + ")", ""};
}

Verdict verify_position(const Candidate& candidate, const Image& image) {
    const PositionCheck check = check_positions(image);
    if (check.pixels == 0) return {false, "zero or not finite everywhere", ""};
    Verdict verdict{true, "about " + number("%.3g", check.median_size) + " units from the origin", ""};
    if (candidate.channels.front().type == ChannelType::half)
        verdict.warning = "position: " + candidate.layer + " is stored as half floats, in steps of " +
                          number("%.2g", half_step(check.median_size)) +
                          " units here; reflections near the camera may show bands. Render it as 32-bit float";
    if (candidate.meaning.is_camera_space)
        verdict.warning =
            "position: " + candidate.layer +
            " is in camera space by the renderer's habit, so that the environment turns with the camera; render a "
            "world-space position, or name it with --channel position=NAME";
    return verdict;
}

}  // namespace

Verdict verify_layer(Role role, const Candidate& candidate, Image& image) {
    switch (role) {
        case Role::normal:
        case Role::geometric_normal:
        case Role::tangent: return verify_vectors(image);
        case Role::position: return verify_position(candidate, image);
        default: break;
    }
    Verdict verdict;
    if (candidate.is_inverted) {
        for (float& value : image.data) value = 1.0f - value;
        verdict.finding = "glossiness, turned into roughness 1 - g";
    }
    const size_t scrubbed = role_info(role).is_color ? scrub(image) : 0;
    if (scrubbed > 0)
        verdict.warning = std::string(role_info(role).name) + ": " + std::to_string(scrubbed) +
                          " pixels are not finite numbers and were set to 0";
    return verdict;
}

}  // namespace burnish
