#include <burnish/job/finished_frames.h>

#include <burnish/input/frames.h>
#include <burnish/input/whole_exr.h>
#include <burnish/job/job_hash.h>
#include <burnish/job/settings.h>
#include <burnish/light/environment_picture.h>
#include <burnish/material/measured/table_files.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace burnish {
namespace fs = std::filesystem;
namespace {

/// Every text of a document: which of them are files shows when they are looked at.
void gather_texts(const nlohmann::json& value, std::vector<std::string>& texts) {
    if (value.is_string()) {
        const std::string text = value.get<std::string>();
        std::ranges::move(picture_files(text), std::back_inserter(texts));
        texts.push_back(text.substr(0, text.rfind('#')));  // "car.gltf#paint"
    }
    for (const nlohmann::json& item : value.is_structured() ? value : nlohmann::json::array()) gather_texts(item, texts);
}

std::vector<std::string> shared_inputs(const Job& job, const Wardrobe& wardrobe) {
    std::vector<std::string> texts;
    for (const Setting& setting : settings())
        if (setting.section != "output" && setting.name != "aovs" && setting.name != "fine_aovs")
            gather_texts(setting.get(job), texts);
    for (const auto* materials : {&wardrobe.materials, &wardrobe.old_materials})
        for (const Material& material : *materials)
            for (const LobeParameters& lobe : material.lobes) texts.push_back(table_of(lobe));
    std::ranges::sort(texts);
    texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
    return texts;
}

}  // namespace

FinishedFrames::FinishedFrames(const Job& job, const Wardrobe& wardrobe, const std::string& kind)
    : m_is_asked(job.output.skip_existing) {
    if (m_is_asked) m_hash = job_hash(job, kind), m_inputs = shared_inputs(job, wardrobe);
}

bool FinishedFrames::has(const FrameTask& task) const {
    std::error_code none;
    if (!m_is_asked || !fs::exists(task.output, none) || (!task.preview.empty() && !fs::exists(task.preview, none)))
        return false;
    std::string hash;
    return is_newer_than_inputs(task.output, task) && is_whole_exr(task.output, kJobHashAttribute, hash) && hash == m_hash;
}

bool FinishedFrames::is_newer_than_inputs(const std::string& output, const FrameTask& task) const {
    std::error_code error;
    const auto written = fs::last_write_time(output, error);
    const auto is_older = [&](const std::string& input) { return written > fs::last_write_time(input, error) && !error; };
    if (error || !is_older(task.aovs) || (!task.fine_aovs.empty() && !is_older(task.fine_aovs))) return false;
    return std::ranges::all_of(m_inputs, [&](const std::string& text) {
        const std::string file = task.frame && has_frame_token(text) ? frame_file(text, *task.frame) : text;
        std::error_code absent;
        return !fs::is_regular_file(file, absent) || is_older(file);
    });
}

}  // namespace burnish
