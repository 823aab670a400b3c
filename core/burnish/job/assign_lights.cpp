#include <burnish/job/assign_lights.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/light/mirror/plane.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace burnish {
namespace {

/// What a pixel's place decides; -1: none.
struct Choice {
    int mirror = -1, pane = -1, cube = -1;

    auto operator<=>(const Choice&) const = default;
};

/// The lights that are chosen by place, sorted by what decides.
class Places {
public:
    explicit Places(const Rig& rig) {
        for (size_t i = 0; i < rig.lights.size(); ++i) {
            const RigLight& light = rig.lights[i];
            if (const auto* mirror = light.as<MirrorSettings>())
                (mirror->behind ? m_panes : m_mirrors).push_back({i, mirror->plane});
            else if (const auto* map = light.as<CubeMapSettings>())
                add_cube(i, map->centre);
            else
                (light.as<AreaSettings>() ? m_areas : light.settings ? m_traced : m_environment).push_back(i);
        }
        if (!m_traced.empty()) m_cubes.clear();
    }

    bool has_planes() const { return !m_mirrors.empty() || !m_panes.empty(); }

    Choice choose(const Vec3f& p, const Vec3f& n, std::vector<float>& scratch) const {
        return {first_under(m_mirrors, p, n), first_under(m_panes, p, n), nearest_cube(p, scratch)};
    }

    RigChain chain(const Choice& choice) const {
        RigChain chain;
        if (choice.mirror >= 0) chain.push_back(m_mirrors[static_cast<size_t>(choice.mirror)].light);
        if (choice.pane >= 0) chain.push_back(m_panes[static_cast<size_t>(choice.pane)].light);
        chain.insert(chain.end(), m_areas.begin(), m_areas.end());
        chain.insert(chain.end(), m_traced.begin(), m_traced.end());
        if (choice.cube >= 0) chain.push_back(m_cubes[static_cast<size_t>(choice.cube)]);
        chain.insert(chain.end(), m_environment.begin(), m_environment.end());
        return chain;
    }

private:
    struct Lying {
        size_t light;
        Plane plane;
    };

    void add_cube(size_t light, const Vec3f& centre) {
        m_cubes.push_back(light);
        m_x.push_back(centre.x), m_y.push_back(centre.y), m_z.push_back(centre.z);
    }

    static int first_under(const std::vector<Lying>& planes, const Vec3f& p, const Vec3f& n) {
        const auto found = std::find_if(planes.begin(), planes.end(), [&](const Lying& l) { return lies_on(l.plane, p, n); });
        return found == planes.end() ? -1 : static_cast<int>(found - planes.begin());
    }

    int nearest_cube(const Vec3f& p, std::vector<float>& squares) const {
        if (m_cubes.empty()) return -1;
        squares.resize(m_cubes.size());
        for (size_t i = 0; i < squares.size(); ++i) {
            const float x = m_x[i] - p.x, y = m_y[i] - p.y, z = m_z[i] - p.z;
            squares[i] = x * x + y * y + z * z;
        }
        return static_cast<int>(std::min_element(squares.begin(), squares.end()) - squares.begin());
    }

    std::vector<Lying> m_mirrors, m_panes;
    RigChain m_areas, m_traced, m_cubes, m_environment;
    std::vector<float> m_x, m_y, m_z;  // centres of the cubes
};

/// Neighbours of one row with the same rule and lights.
struct Run {
    int begin, end, rule;
    Choice choice;
};

Vec3f unit(const float* v) { return Vec3f(v[0], v[1], v[2]).normalized(); }

/// Finds the runs of each row.
struct RowReader {
    const Assignment& assignment;
    const Rig& rig;
    const Places& places;
    const Image *position, *normal;  // null where nothing asks for them

    bool is_by_place(int rule) const { return rule >= 0 && !rig.chains[static_cast<size_t>(rule)]; }

    void read(int y, std::vector<Run>& runs) const {
        std::vector<float> scratch;
        for (int x = 0; x < assignment.width; ++x) {
            const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(assignment.width) + static_cast<size_t>(x);
            const int rule = assignment.rule[pixel];
            Choice choice;
            if (is_by_place(rule)) {
                const float* p = position->at(pixel);
                const Vec3f n = normal ? unit(normal->at(pixel)) : Vec3f(0, 0, 0);
                choice = places.choose({p[0], p[1], p[2]}, n, scratch);
            }
            if (!runs.empty() && runs.back().rule == rule && runs.back().choice == choice)
                ++runs.back().end;
            else
                runs.push_back({x, x + 1, rule, choice});
        }
    }
};

using LookNumbers = std::map<std::pair<int, Choice>, int16_t>;

LookNumbers numbered(const std::vector<std::vector<Run>>& rows) {
    std::set<std::pair<int, Choice>> found;
    for (const std::vector<Run>& runs : rows)
        for (const Run& run : runs)
            if (run.rule >= 0) found.insert({run.rule, run.choice});
    if (found.size() > static_cast<size_t>(std::numeric_limits<int16_t>::max()))
        throw Error(ErrorCode::bad_argument, "assign: the frame has " + std::to_string(found.size()) +
                                                 " pairs of rule and lights; at most 32767. Name the lights of rules");
    LookNumbers numbers;
    for (const auto& key : found) numbers.emplace(key, static_cast<int16_t>(numbers.size()));
    return numbers;
}

void renumber(const std::vector<std::vector<Run>>& rows, const LookNumbers& numbers, Assignment& assignment) {
    assignment.counts.assign(numbers.size(), 0);
    for (size_t y = 0; y < rows.size(); ++y)
        for (const Run& run : rows[y]) {
            if (run.rule < 0) continue;
            const int16_t look = numbers.at({run.rule, run.choice});
            std::fill_n(&assignment.rule[y * static_cast<size_t>(assignment.width) + static_cast<size_t>(run.begin)],
                        run.end - run.begin, look);
            assignment.counts[static_cast<size_t>(look)] += static_cast<size_t>(run.end - run.begin);
        }
}

/// Every rule as it is, where none has a choice.
LitAssignment unsplit(Assignment assignment, const std::vector<RigChain>& chains) {
    LitAssignment lit{std::move(assignment), {}};
    for (size_t rule = 0; rule < chains.size(); ++rule) lit.looks.push_back({rule, chains[rule]});
    return lit;
}

}  // namespace

LitAssignment assign_lights(const AovFrame& frame, Assignment assignment, const Rig& rig) {
    const bool by_place = std::any_of(rig.chains.begin(), rig.chains.end(), [](const auto& chain) { return !chain; });
    const bool only_distant = rig.lights.size() == 1 && rig.has_environment();
    if (!by_place || only_distant) {
        std::vector<RigChain> chains;
        for (const auto& chain : rig.chains) chains.push_back(chain.value_or(RigChain{0}));
        return unsplit(std::move(assignment), chains);
    }
    const Places places(rig);
    const Role role = frame.has(Role::geometric_normal) ? Role::geometric_normal : Role::normal;
    const RowReader reader{assignment, rig, places, &frame.layer(Role::position),
                           places.has_planes() ? &frame.layer(role) : nullptr};
    std::vector<std::vector<Run>> rows(static_cast<size_t>(assignment.height));
    for_each_index(assignment.height, [&](int y) { reader.read(y, rows[static_cast<size_t>(y)]); });
    const LookNumbers numbers = numbered(rows);
    LitAssignment lit;
    for (const auto& [key, number] : numbers) {
        const auto rule = static_cast<size_t>(key.first);
        lit.looks.push_back({rule, rig.chains[rule] ? *rig.chains[rule] : places.chain(key.second)});
    }
    renumber(rows, numbers, assignment);
    lit.assignment = std::move(assignment);
    return lit;
}

}  // namespace burnish
