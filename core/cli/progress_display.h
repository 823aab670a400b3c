// How progress is shown on stderr: a bar for people, lines for farms. Data never mixes with it.
#pragma once

#include <burnish/base/progress.h>

#include <memory>
#include <string>

namespace burnish::cli {

/// Formats: `auto` a bar on a terminal, else none; `text` the bar as lines; `alf` Tractor and hqueue; `json` one object a
/// line; `openjd` Open Job Description; `none`.
inline constexpr const char* kProgressFormats[] = {"auto", "none", "text", "alf", "json", "openjd"};

class ProgressDisplay {
public:
    explicit ProgressDisplay(const std::string& format);
    /// Ends the bar's line.
    ~ProgressDisplay();
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    /// Shows whole percents as they come; asks to stop once Ctrl-C or SIGTERM has arrived.
    Progress progress();

private:
    void show(const std::string& stage, float done);

    std::string m_format;
    int m_percent = -1;
};

/// Takes SIGINT and SIGTERM: the first asks the work to stop, a second one ends the process at once.
void catch_signals();
/// The signal that arrived, or 0.
int caught_signal();
/// Plus the signal: exit code of a run that one stopped.
inline constexpr int kSignalBase = 128;

}  // namespace burnish::cli
