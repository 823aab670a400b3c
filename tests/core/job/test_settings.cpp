// The settings table and the shot file: what goes in comes out, what cannot be meant is named.
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace burnish;
using nlohmann::json;

namespace {

std::string message_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return "no error";
}

/// A value other than the default that the setting takes.
json other_value(const Setting& setting) {
    switch (setting.kind) {
        case SettingKind::boolean: return !setting.default_value().get<bool>();
        case SettingKind::integer: return std::max(setting.range.min, 0.0) + 3;
        case SettingKind::number: return std::max(setting.range.min, 0.0) + 0.25;
        case SettingKind::text:
        case SettingKind::path: return "other";
        case SettingKind::choice:
            return setting.choices.back() == setting.default_value() ? setting.choices[0] : setting.choices.back();
        case SettingKind::names: return json::array({setting.choices.front()});
        case SettingKind::color: return {0.25, 0.5, 0.75};
        case SettingKind::vector: return {1.0, 0.0, 0.5};
        case SettingKind::pairs: return {{setting.name == "channel" ? "normal" : "gold", "other"}};
        case SettingKind::rules: return json::array({{{"material", "gold"}, {"index", 3}}});
        case SettingKind::lights: return {{"wall", {{"type", "traced"}, {"scene", "room.glb"}}}};
        case SettingKind::materials: return {{"mine", {{"model", "ggx"}, {"m", 0.2}}}};
    }
    return {};
}

}  // namespace

TEST(Settings, AreNamedOnceAndExplained) {
    std::set<std::string_view> names;
    std::set<std::pair<std::string_view, std::string_view>> places;
    for (const Setting& setting : settings()) {
        EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
        EXPECT_TRUE(places.insert({setting.section, setting.key}).second) << setting.name;
        EXPECT_GT(setting.help.size(), 5u) << setting.name;
    }
}

TEST(Settings, TakeTheirOwnDefault) {
    for (const Setting& setting : settings()) {
        Job job;
        EXPECT_NO_THROW(setting.set(job, setting.default_value(), "default")) << setting.name;
        EXPECT_EQ(setting.get(job), setting.default_value()) << setting.name;
    }
}

TEST(Settings, ChangeTheirMemberAndNoOther) {
    for (const Setting& setting : settings()) {
        Job job;
        setting.set(job, other_value(setting), "other");
        for (const Setting& other : settings())
            EXPECT_EQ(other.get(job) == other.default_value(), &other != &setting) << setting.name << " and " << other.name;
    }
}

TEST(Settings, SurviveTheShotFile) {
    for (const Setting& setting : settings()) {
        Job job;
        setting.set(job, other_value(setting), "other");
        const Job again = job_from_json(job_to_json(job), "shot");
        EXPECT_EQ(setting.get(again), setting.get(job)) << setting.name;
    }
}

TEST(Settings, KeepShortDecimals) {
    EXPECT_EQ(json(job_to_json([] {
                  Job job;
                  job.composite.gain = 0.1f;
                  return job;
              }()))
                  .dump(),
              R"({"composite":{"gain":0.1}})");
}

TEST(Settings, NameEveryPattern) {
    const std::pair<const char*, PatternKind> names[] = {
        {"auto", PatternKind::automatic}, {"circles", PatternKind::circles}, {"offset_circles", PatternKind::offset_circles},
        {"ring", PatternKind::ring},      {"rings", PatternKind::rings},     {"line", PatternKind::line},
        {"tuned", PatternKind::tuned}};
    const auto pattern = std::ranges::find(settings(), "pattern", &Setting::name);
    for (const auto& [name, kind] : names) {
        Job job;
        pattern->set(job, name, "pattern");
        EXPECT_EQ(job.estimator.pattern, kind) << name;
    }
}

TEST(SettingText, BecomesTheJsonOfItsKind) {
    const auto parsed = [](const char* name, const std::string& text) {
        for (const Setting& setting : settings())
            if (setting.name == name) return setting_from_text(setting, text, name);
        return json();
    };
    EXPECT_EQ(parsed("samples", "19"), json(19));
    EXPECT_EQ(parsed("level_bias", "-0.5"), json(-0.5));
    EXPECT_EQ(parsed("tint", "1,0.5,0"), json({1, 0.5, 0}));
    EXPECT_EQ(parsed("tint", "0.5"), json(0.5));
    EXPECT_EQ(parsed("per_pixel", "roughness,tint"), json({"roughness", "tint"}));
    EXPECT_EQ(parsed("channel", "normal=A=B"), json({{"normal", "A=B"}}));
    EXPECT_EQ(parsed("env", "12"), json("12"));
}

TEST(ShotFile, TakesPathsFromItsOwnFolder) {
    const json document = {
        {"aovs", "a.exr"}, {"output", {{"file", "/abs/o.exr"}}}, {"lights", {{"sky", {{"file", "sky/s.hdr"}}}}}};
    const Job job = job_from_json(document, "shot", "/show/shot");
    EXPECT_EQ(job.aovs, "/show/shot/a.exr");
    EXPECT_EQ(job.output.file, "/abs/o.exr");
    EXPECT_EQ(job.environment, "/show/shot/sky/s.hdr");
}

TEST(ShotFile, NamesThePathToWhatIsWrong) {
    const auto message = [](const json& document) { return message_of([&] { job_from_json(document, "s.json"); }); };
    EXPECT_NE(message({{"quality", {{"samples", -1}}}}).find("s.json: quality.samples: expected a whole number in [0, 4096]"),
              std::string::npos);
    EXPECT_NE(message({{"qualty", json::object()}}).find("did you mean \"quality\""), std::string::npos);
    EXPECT_NE(message({{"lights", {{"sky", {{"rotat", 3}}}}}})
                  .find("s.json: lights.sky: unknown field \"rotat\" (did you mean \"rotate\""),
              std::string::npos);
}

TEST(ShotFile, ReadsRulesAsTextOrObject) {
    const json rules = {"gold=index:3", "chrome=crypto:a*,b", {{"material", "varnish"}, {"material_index", 2}}, "silver"};
    const Job job = job_from_json({{"assign", rules}}, "shot");
    ASSERT_EQ(job.assign.size(), 4u);
    EXPECT_EQ(job.assign[0].object_index, 3);
    EXPECT_EQ(job.assign[1].cryptomatte, "a*,b");
    EXPECT_EQ(job.assign[2].material_index, 2);
    EXPECT_EQ(job.assign[3].material, "silver");
}
