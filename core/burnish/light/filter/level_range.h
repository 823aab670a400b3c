// Levels of a stack that lookups ask for.
#pragma once

namespace burnish {

struct LevelRange {
    float finest, coarsest;
};

}  // namespace burnish
