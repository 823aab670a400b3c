// A file that appears whole or not at all: written under a hidden name beside the target, renamed when complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace burnish {

/// ".name.<unique>.<ext>" in the same directory: unique among the processes of a farm that write there; keeps the extension, by which
/// tools know formats.
std::filesystem::path hidden_sibling(const std::filesystem::path& target);

class AtomicFile {
public:
    /// Opens the hidden file (".name.<unique>.<ext>", same directory and extension) and makes the directory when absent.
    /// A symbolic link is written through. Throws Error(write_failed) when that is impossible or the target is a device.
    explicit AtomicFile(const std::string& target);
    /// Without commit(): removes the hidden file.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    std::FILE* handle() const { return m_file; }
    /// Where it is until commit(), for libraries that open files by name.
    const std::filesystem::path& hidden_path() const { return m_hidden; }
    /// Flushes, closes and renames over the target; throws Error(write_failed) when the disk did not take every byte.
    void commit();
    /// Throws Error(write_failed) that names the target and `reason`.
    [[noreturn]] void fail(const std::string& reason) const;

private:
    std::string m_name;  // as the caller spelt it, for messages
    std::filesystem::path m_target, m_hidden;
    std::FILE* m_file = nullptr;
};

}  // namespace burnish
