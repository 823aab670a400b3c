#include <burnish/light/clean_picture.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

struct Scrubbed {
    size_t not_a_number = 0, infinite = 0, negative = 0;
};

/// Makes all values finite and >= 0: NaN and negative values become 0, infinite ones the largest finite value of the
/// picture (a sun that overflowed half floats is at least that bright). Counts channel values.
Scrubbed scrub(Image& picture) {
    float largest = 0.0f;
    for (const float value : picture.data) {
        if (std::isfinite(value)) largest = std::max(largest, value);
    }
    Scrubbed count;
    for (float& value : picture.data) {
        if (value >= 0.0f && value <= largest) continue;
        if (std::isnan(value))
            ++count.not_a_number;
        else if (std::isinf(value) && value > 0.0f)
            ++count.infinite;
        else
            ++count.negative;
        value = std::isinf(value) && value > 0.0f ? largest : 0.0f;
    }
    return count;
}

void warn(const Scrubbed& count, const std::string& name, std::vector<std::string>& warnings) {
    const auto add = [&](size_t n, const char* what) {
        if (n > 0) warnings.push_back(name + ": " + std::to_string(n) + " " + what);
    };
    add(count.not_a_number, "NaN values set to 0");
    add(count.infinite, "infinite values set to the largest finite value of the picture");
    add(count.negative, "negative values set to 0");
}

}  // namespace

void clean_picture(Image& picture, const std::function<void(Image&)>& convert, const std::string& name,
                   std::vector<std::string>& warnings) {
    warn(scrub(picture), name, warnings);
    if (!convert) return;
    convert(picture);
    for (float& value : picture.data) value = std::max(value, 0.0f);
}

}  // namespace burnish
