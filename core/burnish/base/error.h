// The one exception type of burnish. Its message names what failed, what was expected and found, and the remedy.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace burnish {

enum class ErrorCode {
    bad_argument,     // a setting, JSON field or array out of its range
    missing_channel,  // a role no layer of the file can fill
    size_mismatch,    // images that should agree in size do not
    read_failed,      // file absent, unreadable, corrupt or unsupported
    write_failed,     // target not writable, disk full
    color_space,      // OpenColorIO config or colour space unknown
    cancelled,        // the user asked to stop
};

/// Stable upper-case name for logs and farms, e.g. "E_MISSING_CHANNEL".
std::string_view error_name(ErrorCode code);

/// Exit code of the command line for this error: 1 failure, 2 usage, 130 cancelled.
int exit_code(ErrorCode code);

class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), m_code(code) {}
    ErrorCode code() const { return m_code; }

private:
    ErrorCode m_code;
};

}  // namespace burnish
