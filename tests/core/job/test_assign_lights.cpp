// Which lights each pixel has: those that its rule names, or those of its place.
#include <burnish/base/parallel.h>
#include <burnish/job/assign_lights.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

RigLight near_light(const std::string& name, LightSettings settings) { return {name, std::move(settings), nullptr, true}; }

RigLight cube(const std::string& name, const Vec3f& centre) {
    CubeMapSettings map;
    map.centre = centre;
    return near_light(name, {map});
}

RigLight mirror(const std::string& name, float height, bool behind = false) {
    MirrorSettings settings;
    settings.plane = {Vec3f(0, 0, height), Vec3f(0, 0, 1)}, settings.behind = behind;
    return near_light(name, {settings});
}

const RigLight kLamp = near_light("lamp", {AreaSettings()}), kRoom = near_light("room", {TracedSettings()}),
               kSky = {"sky", {}, nullptr, false};

/// One row of pixels; rule 0 unless told otherwise.
struct Row {
    AovFrame frame;
    Assignment assignment;

    explicit Row(const std::vector<std::pair<Vec3f, Vec3f>>& places) {
        const int width = static_cast<int>(places.size());
        frame.data_window = frame.display_window = {0, 0, width, 1};
        Image position(width, 1, 3), normal(width, 1, 3);
        for (int x = 0; x < width; ++x) {
            const auto& [p, n] = places[static_cast<size_t>(x)];
            std::copy_n(&p.x, 3, position.at(x, 0)), std::copy_n(&n.x, 3, normal.at(x, 0));
        }
        frame.layers[Role::position] = std::move(position), frame.layers[Role::normal] = std::move(normal);
        assignment.width = width, assignment.height = 1;
        assignment.rule.assign(places.size(), 0), assignment.coverage.assign(places.size(), 1.0f);
        assignment.counts = {places.size()};
    }
};

const Vec3f kUp(0, 0, 1), kSide(1, 0, 0);

/// The names of a pixel's lights, front first.
std::string names_at(const LitAssignment& lit, const Rig& rig, size_t pixel) {
    std::string names;
    for (const size_t place : lit.looks[static_cast<size_t>(lit.assignment.rule[pixel])].chain)
        names += (names.empty() ? "" : ",") + rig.lights[place].name;
    return names;
}

Rig rig_of(std::vector<RigLight> lights, std::vector<std::optional<RigChain>> chains = {std::nullopt}) {
    Rig rig;
    rig.lights = std::move(lights), rig.chains = std::move(chains);
    return rig;
}

}  // namespace

TEST(AssignLights, ByPlaceGoFromTheMirrorToTheSky) {
    const Row row({{{1, 0, 0}, kUp}, {{1, 0, 0.5f}, kUp}, {{1, 0, 0}, kSide}, {{9, 0, 1}, kUp}});
    const Rig rig = rig_of({mirror("floor", 0), cube("left", {0, 0, 1}), cube("right", {8, 0, 1}), kLamp, kSky});
    const LitAssignment lit = assign_lights(row.frame, row.assignment, rig);
    EXPECT_EQ(names_at(lit, rig, 0), "floor,lamp,left,sky");
    EXPECT_EQ(names_at(lit, rig, 1), "lamp,left,sky") << "above the floor";
    EXPECT_EQ(names_at(lit, rig, 2), "lamp,left,sky") << "what stands on the floor is not the floor";
    EXPECT_EQ(names_at(lit, rig, 3), "lamp,right,sky");
    EXPECT_EQ(lit.looks.size(), 3u);
    EXPECT_EQ(lit.assignment.counts, (std::vector<size_t>{2, 1, 1}));
}

TEST(AssignLights, PanesHaveWhatIsReflectedAndWhatIsBehind) {
    const Row row({{{1, 0, 2}, kUp}});
    const Rig rig = rig_of({mirror("behind", 2, true), mirror("pane", 2), kSky});
    EXPECT_EQ(names_at(assign_lights(row.frame, row.assignment, rig), rig, 0), "pane,behind,sky");
}

TEST(AssignLights, TracedLightStandsForCubeMaps) {
    const Row row({{{1, 0, 2}, kUp}});
    const Rig rig = rig_of({cube("map", {0, 0, 0}), kLamp, kRoom});
    EXPECT_EQ(names_at(assign_lights(row.frame, row.assignment, rig), rig, 0), "lamp,room");
}

TEST(AssignLights, ARuleThatNamesItsLightsKeepsThem) {
    Row row({{{1, 0, 0}, kUp}, {{1, 0, 0}, kUp}, {{1, 0, 0}, kUp}});
    row.assignment.rule[1] = 1, row.assignment.rule[2] = -1, row.assignment.counts = {1, 1};
    const Rig rig = rig_of({mirror("floor", 0), kLamp, kSky}, {std::nullopt, RigChain{2, 1}});
    const LitAssignment lit = assign_lights(row.frame, row.assignment, rig);
    EXPECT_EQ(names_at(lit, rig, 0), "floor,lamp,sky");
    EXPECT_EQ(names_at(lit, rig, 1), "sky,lamp");
    EXPECT_EQ(lit.assignment.rule[2], -1);
    EXPECT_EQ(lit.looks[1].rule, 1u);
    EXPECT_TRUE(rig.is_distant({2}));
    EXPECT_FALSE(rig.is_distant({2, 1}));
}

TEST(AssignLights, ALoneEnvironmentLeavesRulesAsTheyAre) {
    Row row({{{1, 0, 0}, kUp}, {{1, 0, 0}, kUp}});
    row.assignment.rule[0] = 1, row.assignment.counts = {1, 1};
    const Rig rig = rig_of({kSky}, {std::nullopt, std::nullopt});
    const LitAssignment lit = assign_lights({}, row.assignment, rig);
    EXPECT_EQ(lit.assignment.rule, row.assignment.rule);
    ASSERT_EQ(lit.looks.size(), 2u);
    EXPECT_TRUE(rig.is_distant(lit.looks[0].chain) && rig.is_distant(lit.looks[1].chain));
}

TEST(AssignLights, TheNearestOfManyForAnyNumberOfThreads) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-5, 5);
    const auto place = [&] { return Vec3f(uniform(random), uniform(random), uniform(random)); };
    std::vector<RigLight> lights;
    for (int i = 0; i < 100; ++i) lights.push_back(cube(std::to_string(i), place()));
    std::vector<std::pair<Vec3f, Vec3f>> places;
    for (int i = 0; i < 500; ++i) places.emplace_back(place(), kUp);
    const Row row(places);
    const Rig rig = rig_of(lights);
    const LitAssignment lit = assign_lights(row.frame, row.assignment, rig);
    for (size_t i = 0; i < places.size(); ++i) {
        const auto distance = [&](const RigLight& light) {
            return (light.as<CubeMapSettings>()->centre - places[i].first).length();
        };
        const RigLight& nearest = *std::ranges::min_element(lights, {}, distance);
        EXPECT_EQ(names_at(lit, rig, i), nearest.name);
    }
    const ThreadLimit one(1);
    EXPECT_EQ(assign_lights(row.frame, row.assignment, rig).assignment.rule, lit.assignment.rule);
}
