// Which of MERL's 100 published files a file is, byte by byte.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// A file of the database and the SHA-256 of its bytes, 64 hexadecimal digits.
struct MerlFile {
    std::string_view name, sha256;
};
std::span<const MerlFile> merl_files();

/// SHA-256 of a file's bytes in hexadecimal. Throws Error(read_failed) when it cannot be read.
std::string sha256_of(const std::string& file);

/// "brass", or "" for a file that is none of them or was changed. Throws Error(read_failed) when it cannot be read.
std::string_view merl_name(const std::string& file);

}  // namespace burnish
