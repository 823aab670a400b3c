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

Verdict verify_vectors(const Image& image) {
    const VectorCheck check = check_vectors(image);
    switch (check.kind) {
        case VectorKind::unit: return {true, false, "unit length (median " + number("%.3f", check.median_length) + ")", ""};
        case VectorKind::encoded: return {true, true, "stored as 0..1, decoded as 2n - 1", ""};
        case VectorKind::empty: return {false, false, "zero everywhere", ""};
        case VectorKind::neither: break;
    }
    return {false, false, "not unit vectors (median length " + number("%.3g", check.median_length) + ")", ""};
}

Verdict verify_position(const Candidate& candidate, const Image& image) {
    const PositionCheck check = check_positions(image);
    if (check.pixels == 0) return {false, false, "zero or not finite everywhere", ""};
    Verdict verdict{true, false, "about " + number("%.3g", check.median_size) + " units from the origin", ""};
    if (candidate.meaning.is_camera_space)
        verdict.warning =
            "position: " + candidate.layer +
            " is in camera space by the renderer's habit, so that the environment turns with the camera; render a "
            "world-space position, or name it with --channel position=NAME";
    return verdict;
}

}  // namespace

bool is_judged(Role role) {
    return role == Role::position || role == Role::normal || role == Role::geometric_normal || role == Role::tangent;
}

Verdict verify_layer(Role role, const Candidate& candidate, const Image& image) {
    if (role == Role::position) return verify_position(candidate, image);
    return is_judged(role) ? verify_vectors(image) : Verdict{};
}

size_t decode_layer(Role role, const Candidate& candidate, bool is_encoded, Image& image, int above, int below) {
    if (is_encoded) decode_vectors(image);
    if (candidate.is_inverted)
        for (float& value : image.data) value = 1.0f - value;
    return role_info(role).is_color ? scrub(image, above, below) : 0;
}

}  // namespace burnish
