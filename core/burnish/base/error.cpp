#include <burnish/base/error.h>

namespace burnish {

std::string_view error_name(ErrorCode code) {
    switch (code) {
        case ErrorCode::bad_argument: return "E_BAD_ARGUMENT";
        case ErrorCode::missing_channel: return "E_MISSING_CHANNEL";
        case ErrorCode::size_mismatch: return "E_SIZE_MISMATCH";
        case ErrorCode::read_failed: return "E_READ_FAILED";
        case ErrorCode::write_failed: return "E_WRITE_FAILED";
        case ErrorCode::color_space: return "E_COLOR_SPACE";
        case ErrorCode::cancelled: return "E_CANCELLED";
    }
    return "E_UNKNOWN";
}

int exit_code(ErrorCode code) {
    switch (code) {
        case ErrorCode::bad_argument: return 2;
        case ErrorCode::cancelled: return 130;
        default: return 1;
    }
}

}  // namespace burnish
