// Colours known at scattered points of the plane, and something sensible in between.
//
// Around the point asked for, a plane is fitted to the nearest points, each weighing the more the nearer it is (without bound, so
// that the points themselves keep their colours) and nothing where it would leave the set of the nearest; the result stays within
// their range. Sources: Shepard 1968; the weights of Franke & Little (Barnhill 1977).
#pragma once

#include <burnish/base/types.h>

#include <memory>
#include <vector>

namespace burnish {

class ScatteredColors {
public:
    /// At least one point; points and colours of one length, all finite. Points that fall together are averaged.
    ScatteredColors(const std::vector<Vec2f>& points, const std::vector<Color3f>& colors);

    Color3f at(const Vec2f& point) const;

    /// A point by its place in the constructor's list, and its weight.
    struct Neighbour {
        size_t index;
        Vec2f offset;  // from the point asked for
        float weight;
    };
    /// The points that count at `point`, weights summing to 1.
    std::vector<Neighbour> neighbours(const Vec2f& point) const;

private:
    struct Tree;
    std::shared_ptr<const Tree> m_tree;
    std::vector<Color3f> m_colors;
};

}  // namespace burnish
