// Where the real test data is: the folder named by BURNISH_DATA, else ../shared/data beside the source tree.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

/// The file or folder `relative` to the data folder; nothing when it is not there.
inline std::optional<std::filesystem::path> data_path(const std::string& relative) {
    const char* folder = std::getenv("BURNISH_DATA");
    const auto source = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
    const auto path = (folder ? std::filesystem::path(folder) : source / "../shared/data") / relative;
    if (!std::filesystem::exists(path)) return std::nullopt;
    return path;
}
