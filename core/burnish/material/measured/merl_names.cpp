#include <burnish/base/error.h>
#include <burnish/base/sha256.h>
#include <burnish/material/measured/merl_names.h>

#include <algorithm>
#include <fstream>

namespace burnish {

std::span<const MerlFile> merl_files() {
    static constexpr MerlFile files[] = {
#define MERL_FILE(name, sha256) {name, sha256},
#include <burnish/material/measured/merl_files.def>
#undef MERL_FILE
    };
    return files;
}

std::string sha256_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string hash = sha256(stream);
    if (!stream.eof())
        throw Error(ErrorCode::read_failed, file + ": cannot be read; check that it is a file and its permissions");
    return hash;
}

std::string_view merl_name(const std::string& file) {
    const std::string hash = sha256_of(file);
    const auto found = std::ranges::find(merl_files(), std::string_view(hash), &MerlFile::sha256);
    return found == merl_files().end() ? "" : found->name;
}

}  // namespace burnish
