#include <burnish/base/parallel.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/object_matte.h>

#include <algorithm>
#include <bit>

namespace burnish {
namespace {

struct Share {
    int object, rays;
};

/// Objects seen through a pixel, those with most rays first; equal ones in the scene's order.
void count_objects(const Tracer& tracer, const Camera& camera, const Window& frame, int x, int y, int n,
                   std::vector<Share>& shares) {
    shares.clear();
    for (int i = 0; i < n * n; ++i) {
        const auto hit = closest_at(tracer, camera, subpixel(x, y, i, n), frame.width, frame.height);
        if (!hit) continue;
        const auto known = std::ranges::find(shares, hit->object, &Share::object);
        if (known != shares.end())
            ++known->rays;
        else
            shares.push_back({hit->object, 1});
    }
    std::ranges::sort(shares, [](Share a, Share b) { return a.rays != b.rays ? a.rays > b.rays : a.object < b.object; });
}

}  // namespace

Cryptomatte trace_object_matte(const Tracer& tracer, const Camera& camera, int width, int height, int antialias, int ranks,
                               const std::string& name, const Progress& progress) {
    Cryptomatte matte;
    matte.name = name;
    matte.ranks.assign(static_cast<size_t>(ranks), Image(width, height, 2));
    std::vector<float> ids;
    for (const Object& object : tracer.scene().objects) {
        matte.manifest[object.name] = cryptomatte_id(object.name);
        ids.push_back(std::bit_cast<float>(matte.manifest[object.name]));
    }
    const Window frame{0, 0, width, height};
    for_each_tile(width, height, progress, "matting", [&](const Window& tile) {
        std::vector<Share> shares;
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                count_objects(tracer, camera, frame, x, y, antialias, shares);
                for (size_t rank = 0; rank < std::min(shares.size(), matte.ranks.size()); ++rank) {
                    float* pair = matte.ranks[rank].at(x, y);
                    pair[0] = ids[static_cast<size_t>(shares[rank].object)];
                    pair[1] = static_cast<float>(shares[rank].rays) / static_cast<float>(antialias * antialias);
                }
            }
    });
    return matte;
}

}  // namespace burnish
