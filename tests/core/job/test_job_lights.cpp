// The lights of a job: from shot file, text and files; and the chains that rules name.
#include "core/scratch.h"

#include <burnish/job/job_lights.h>
#include <burnish/job/shot_file.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace burnish;
using nlohmann::json;

namespace {

const json kLamp = {{"type", "area"}, {"corners", {{0, 0, 3}, {0, 1, 3}, {1, 1, 3}}}};
const json kSky = {{"type", "environment"}, {"file", "sky.hdr"}, {"rotate", 30}};

std::string message_of(const json& document) {
    try {
        job_from_json(document, "s.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return "no error";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(JobLights, SurviveTheShotFile) {
    const json document = {{"lights", {{"dome", kSky}, {"lamp", kLamp}}},
                           {"light", {"lamp", "dome"}},
                           {"assign", {{{"material", "gold"}, {"index", 3}, {"light", {"dome"}}}}}};
    const Job job = job_from_json(document, "shot");
    EXPECT_EQ(job.environment_name, "dome");
    EXPECT_EQ(job.light.rotate_deg, 30.0f);
    ASSERT_EQ(job.lights.count("lamp"), 1u);
    EXPECT_EQ(job.chain, (std::vector<std::string>{"lamp", "dome"}));
    EXPECT_EQ(job.assign[0].chain, std::vector<std::string>{"dome"});
    const Job again = job_from_json(job_to_json(job), "again");
    EXPECT_EQ(job_to_json(again), job_to_json(job));
    EXPECT_EQ(again.environment_name, "dome");
    EXPECT_EQ(again.lights.size(), 1u);
}

TEST(JobLights, TakePathsFromTheFolderOfTheirFile) {
    const json map = {{"type", "cubemap"}, {"file", "vase.%s.exr"}, {"centre", {0, 0, 1}}};
    const Scratch folder;
    std::ofstream(folder.file("vase.json")) << map.dump();
    const json document = {{"lights", {{"near", map}, {"far", folder.file("vase.json")}}}};
    Job job = job_from_json(document, "shot", "/show");
    EXPECT_EQ(std::get<CubeMapSettings>(job.lights["near"].kind).file, "/show/vase.%s.exr");
    EXPECT_EQ(std::get<CubeMapSettings>(job.lights["far"].kind).file, folder.file("vase.%s.exr"));
}

TEST(JobLights, TakeTextAsTheCommandLineGivesIt) {
    Job job;
    set_settings(job, {{"lights", {{"lamp", kLamp.dump()}, {"sky", kSky}}}, {"default_light", "lamp,sky"}}, "");
    EXPECT_EQ(job.lights.size(), 1u);
    EXPECT_EQ(job.environment, "sky.hdr");
    EXPECT_EQ(job.chain, (std::vector<std::string>{"lamp", "sky"}));
}

TEST(JobLights, RulesNameTheirsInTextToo) {
    const json rules = {"gold=index:3@floor,sky", "chrome=crypto:vase*,pot@lamp", "silver@sky", "gold=crypto:a"};
    const Job job = job_from_json({{"assign", rules}}, "shot");
    EXPECT_EQ(job.assign[0].object_index, 3);
    EXPECT_EQ(job.assign[0].chain, (std::vector<std::string>{"floor", "sky"}));
    EXPECT_EQ(job.assign[1].cryptomatte, "vase*,pot");
    EXPECT_EQ(job.assign[1].chain, std::vector<std::string>{"lamp"});
    EXPECT_EQ(job.assign[2].material, "silver");
    EXPECT_EQ(job.assign[2].chain, std::vector<std::string>{"sky"});
    EXPECT_TRUE(job.assign[3].chain.empty());
}

TEST(JobLights, SayWhatIsWrong) {
    EXPECT_TRUE(contains(message_of({{"lights", {{"a", kSky}, {"b", {{"file", "x.hdr"}}}}}}),
                         "s.json: lights.b: a job has one environment, and 'a' is one already"));
    EXPECT_TRUE(contains(message_of({{"lights", {{"a,b", kLamp}}}}), "'a,b' cannot be a light's name"));
    EXPECT_TRUE(contains(message_of({{"lights", {{"auto", kLamp}}}}), "'auto' cannot be a light's name"));
    EXPECT_TRUE(contains(message_of({{"lights", {{"a", {{"type", "mirrow"}}}}}}), "did you mean \"mirror\""));
    EXPECT_TRUE(contains(message_of({{"assign", {{{"material", "gold"}, {"light", 3}}}}}),
                         "s.json: assign[0].light: expected a light's name"));
    EXPECT_TRUE(contains(message_of({{"lights", {{"a", "{broken"}}}}), "s.json: lights.a"));
}
