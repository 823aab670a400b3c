#include <burnish/base/error.h>
#include <burnish/material/measured/alta_file.h>
#include <burnish/material/measured/cornell_file.h>
#include <burnish/material/measured/gonio_file.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/measured/read_measured.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtensions[] = {".binary", ".brdf", ".alta", ".dat", ".gonio"};

std::string extension_of(const std::string& file) {
    std::string extension = fs::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::string beginning_of(const std::string& file) {
    std::string text(64, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(stream.gcount()));
    return text;
}

}  // namespace

bool is_measured_name(const std::string& file) {
    return std::ranges::find(kExtensions, extension_of(file)) != std::end(kExtensions);
}

std::shared_ptr<const MeasuredBrdf> read_measured(const std::string& file) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) throw Error(ErrorCode::read_failed, file + ": no such file");
    if (is_gonio_file(beginning_of(file))) return read_gonio(file);
    const std::string extension = extension_of(file);
    if (extension == ".binary") return MerlTable::read(file);
    if (extension == ".brdf") return read_cornell(file);
    if (extension == ".alta" || extension == ".dat") return read_alta(file);
    if (extension == ".gonio") throw Error(ErrorCode::read_failed, file + ": expected \"# burnish gonio 1\" in its first line");
    throw Error(ErrorCode::read_failed,
                file + ": not a measurement that burnish reads: expected MERL's .binary, Cornell's .brdf, " +
                    "ALTA's .alta or .dat, or a text that begins with \"# burnish gonio 1\"");
}

}  // namespace burnish
