// The colours of shading levels, the same in every picture: hot where every pixel is shaded, cold where few are.
#pragma once

#include <burnish/base/types.h>

#include <algorithm>
#include <array>

namespace burnish {

struct LevelColor {
    const char* name;
    Color3f rgb;  // display code values
};

/// Entry k: level k, the last also beyond.
inline const std::array<LevelColor, 8> kLevelColors{{{"white", {1.0f, 1.0f, 1.0f}},
                                                     {"yellow", {1.0f, 0.9f, 0.2f}},
                                                     {"orange", {1.0f, 0.55f, 0.1f}},
                                                     {"red", {0.85f, 0.15f, 0.1f}},
                                                     {"magenta", {0.75f, 0.15f, 0.6f}},
                                                     {"purple", {0.45f, 0.15f, 0.7f}},
                                                     {"blue", {0.15f, 0.25f, 0.8f}},
                                                     {"dark blue", {0.08f, 0.1f, 0.4f}}}};

inline const Color3f& level_color(float level) {
    const float last = static_cast<float>(kLevelColors.size() - 1);
    return kLevelColors[static_cast<size_t>(std::clamp(level, 0.0f, last))].rgb;
}

}  // namespace burnish
