#include <burnish/job/joined_output.h>

#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/input/views.h>
#include <burnish/output/join_views.h>

#include <filesystem>

namespace burnish {
namespace {

std::string part_name(const char* part, const std::string& view) {
    return view.empty() ? part : std::string(part) + "." + view;
}

}  // namespace

JoinedOutput::~JoinedOutput() { clear(); }

void JoinedOutput::clear() {
    std::error_code ignored;
    for (const View& view : m_views) std::filesystem::remove(view.file, ignored);
    m_views.clear(), m_finished = 0;
}

std::string JoinedOutput::begin(const FrameTask& task) {
    if (task.views == 1 && !m_job.output.keep_layers) return task.output;
    if (m_views.size() == task.views || (!m_views.empty() && m_views.size() != m_finished)) clear();
    m_views.push_back({hidden_sibling(task.output).string(), task.view, task.aovs});
    return m_views.back().file;
}

void JoinedOutput::finish(const FrameTask& task) {
    if (m_views.empty()) return;
    ++m_finished;
    if (!task.is_last_view) return;
    if (m_finished != task.views) {
        clear();
        throw Error(ErrorCode::read_failed,
                    task.output + ": is not written, as another view of its frame failed; mend that one");
    }
    join(task);
    clear();
}

void JoinedOutput::join(const FrameTask& task) {
    std::vector<StoredParts> parts;
    for (const View& view : m_views) parts.push_back({view.file, part_name("burnish", view.name), view.name});
    const bool in_one_part = parts.size() > 1 && !has_view_token(m_job.aovs) && views_of_file(task.aovs).in_one_part;
    if (in_one_part && !m_job.output.keep_layers) return join_views(task.output, parts);
    if (in_one_part) {
        m_views.push_back({hidden_sibling(task.output).string(), "", ""});
        join_views(m_views.back().file, parts);
        parts = {{m_views.back().file, "burnish", ""}};
    }
    std::string kept;
    for (size_t i = 0; m_job.output.keep_layers && i < task.views; ++i)
        if (const View view = m_views[i]; view.frame != kept) {
            kept = view.frame;
            const std::string own = has_view_token(m_job.aovs) ? view.name : "";
            parts.push_back({kept, part_name("frame", own), own});
        }
    join_parts(task.output, parts);
}

}  // namespace burnish
