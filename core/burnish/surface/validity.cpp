#include <burnish/surface/validity.h>

namespace burnish {

std::string_view validity_name(Validity validity) {
    static constexpr std::array<std::string_view, kValidityCount> names{
        "valid", "background", "not_finite", "zero_normal", "averaged_normal", "back_facing", "unassigned"};
    return names[static_cast<size_t>(validity)];
}

}  // namespace burnish
