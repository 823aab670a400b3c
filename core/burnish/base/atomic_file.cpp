#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>

#include <cerrno>
#include <cstring>
#include <random>

namespace burnish {
namespace fs = std::filesystem;

fs::path hidden_sibling(const fs::path& target) {
    std::random_device entropy;
    char unique[17];
    std::snprintf(unique, sizeof(unique), "%08x%08x", entropy(), entropy());
    const std::string stem = target.stem().string(), extension = target.extension().string();
    return target.parent_path() / ("." + stem + "." + unique + extension);
}

AtomicFile::AtomicFile(const std::string& target) : m_name(target) {
    std::error_code error;
    m_target = fs::weakly_canonical(fs::absolute(target, error), error);
    if (error || m_target.empty()) fail("the path is not usable");
    const fs::file_status status = fs::status(m_target, error);
    if (fs::is_directory(status)) fail("it is a directory; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail("it is a device, not a file");

    fs::create_directories(m_target.parent_path(), error);
    if (error) fail("cannot make its directory (" + error.message() + ")");
    m_hidden = hidden_sibling(m_target);
    m_file = std::fopen(m_hidden.c_str(), "wbx");
    if (!m_file) fail("cannot create a file in its directory (" + std::string(std::strerror(errno)) + ")");
}

AtomicFile::~AtomicFile() {
    if (m_file) std::fclose(m_file);
    std::error_code ignored;
    if (!m_hidden.empty()) fs::remove(m_hidden, ignored);
}

void AtomicFile::commit() {
    errno = 0;
    const bool written = !std::ferror(m_file) && std::fflush(m_file) == 0;
    const bool closed = std::fclose(m_file) == 0;
    m_file = nullptr;
    if (!written || !closed) fail(errno ? std::strerror(errno) : "the disk did not take all data; is it full?");
    std::error_code error;
    fs::rename(m_hidden, m_target, error);
    if (error) fail(error.message());
    m_hidden.clear();
}

void AtomicFile::fail(const std::string& reason) const {
    throw Error(ErrorCode::write_failed, m_name + ": cannot be written: " + reason);
}

}  // namespace burnish
