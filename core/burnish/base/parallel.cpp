#include <burnish/base/parallel.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>

namespace burnish {
namespace {

/// Loops keep to themselves. Exceptions of work around one do not cancel it half way, and whoever called it would take what it
/// leaves for whole; and a thread that waits for its end takes up none of that work, which could take long.
template <class Work>
void loop(int count, const Work& work) {
    tbb::task_group_context alone(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, count, work, alone); });
}

}  // namespace

void for_each_tile(int width, int height, const Progress& progress, const std::string& stage,
                   const std::function<void(const Window& tile)>& work, int size) {
    const int columns = (width + size - 1) / size, rows = (height + size - 1) / size;
    const int count = columns * rows;
    std::mutex reporting;
    int done = 0;
    progress.report(stage, 0.0f);
    loop(count, [&](int index) {
        const int x = index % columns * size, y = index / columns * size;
        work({x, y, std::min(size, width - x), std::min(size, height - y)});
        const std::lock_guard lock(reporting);
        progress.report(stage, static_cast<float>(++done) / static_cast<float>(count));
    });
}

void for_each_index(int count, const std::function<void(int)>& work) { loop(count, work); }

ThreadLimit::ThreadLimit(int threads) {
    using Control = tbb::global_control;
    if (threads > 0) m_control = std::make_shared<Control>(Control::max_allowed_parallelism, static_cast<size_t>(threads));
}

}  // namespace burnish
