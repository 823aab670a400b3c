// Frames that are hard to shade sparsely: where few pixels cannot stand for many, or where a prediction might think they can.
#pragma once

#include "bench/sparse_case.h"

#include <span>
#include <string_view>

namespace burnish {

/// What a hard case is made with: the lobe wherever the case does not bring its own, the size of its frame.
struct HardSettings {
    ModelId model = ModelId::ggx;
    float m = 0.1f;
    int height = 1080;  // pixels; 16:9
};

std::span<const std::string_view> hard_case_names();
/// Throws std::out_of_range for an unknown name.
SparseCase hard_case(std::string_view name, const HardSettings& settings);

}  // namespace burnish
