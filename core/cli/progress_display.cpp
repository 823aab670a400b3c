#include "progress_display.h"

#include <nlohmann/json.hpp>

#include <unistd.h>
#include <csignal>
#include <cstdio>

namespace burnish::cli {
namespace {

volatile std::sig_atomic_t g_signal = 0;  // a handler has no other way to speak

void remember(int signal) {
    g_signal = signal;
    std::signal(signal, SIG_DFL);
}

void draw_bar(const std::string& stage, int percent) {
    constexpr int kWidth = 32;
    const int filled = percent * kWidth / 100;
    std::fprintf(stderr, "\r\033[K[%s%s] %3d %%  %s", std::string(static_cast<size_t>(filled), '#').c_str(),
                 std::string(static_cast<size_t>(kWidth - filled), ' ').c_str(), percent, stage.c_str());
}

}  // namespace

void catch_signals() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit then fails the write, which cleans up, instead of the process
}

int caught_signal() { return g_signal; }

ProgressDisplay::ProgressDisplay(const std::string& format) : m_format(format) {
    if (format == "auto") m_format = isatty(STDERR_FILENO) ? "bar" : "none";
}

ProgressDisplay::~ProgressDisplay() {
    if (m_format == "bar" && m_percent >= 0) std::fputs("\r\033[K", stderr);
}

Progress ProgressDisplay::progress() {
    return Progress([this](const std::string& stage, float done) {
        show(stage, done);
        return g_signal == 0;
    });
}

void ProgressDisplay::show(const std::string& stage, float done) {
    const int percent = static_cast<int>(done * 100);
    if (m_format == "none" || percent == m_percent) return;
    m_percent = percent;
    if (m_format == "bar")
        draw_bar(stage, percent);
    else if (m_format == "text")
        std::fprintf(stderr, "%3d %% %s\n", percent, stage.c_str());
    else if (m_format == "alf")
        std::fprintf(stderr, "ALF_PROGRESS %d%%\n", percent);
    else if (m_format == "openjd")
        std::fprintf(stderr, "openjd_progress: %d\n", percent);
    else
        std::fprintf(stderr, "%s\n", nlohmann::json{{"stage", stage}, {"percent", percent}}.dump().c_str());
    std::fflush(stderr);
}

}  // namespace burnish::cli
