// Work over tiles on oneTBB. Each tile writes its own pixels only, so results are the same bits for any thread count.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/progress.h>

#include <functional>
#include <memory>
#include <string>

namespace burnish {

inline constexpr int kTileSize = 32;  // pixels; a tile's batches stay in the second-level cache

/// Calls `work(tile)` for every tile of `size` pixels a side of a width x height image, in parallel; reports progress under `stage`.
/// Throws what `work` throws, and Error(cancelled) when the progress callback asks to stop.
void for_each_tile(int width, int height, const Progress& progress, const std::string& stage,
                   const std::function<void(const Window& tile)>& work, int size = kTileSize);

/// Calls `work(i)` for i in [0, count) in parallel, without progress: for building tables and pyramids.
void for_each_index(int count, const std::function<void(int)>& work);

/// Limits burnish to this many threads while it lives; 0 means all cores.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);

private:
    std::shared_ptr<void> m_control;
};

}  // namespace burnish
