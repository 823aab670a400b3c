// MERL's .binary files, byte by byte.
#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/material/measured/merl_table.h>

#include <array>
#include <bit>
#include <filesystem>
#include <fstream>

namespace burnish {
namespace {

static_assert(std::endian::native == std::endian::little, "MERL's files are read and written as they are");

using Dimensions = std::array<int32_t, 3>;
constexpr Dimensions kDimensions{MerlTable::kThetaH, MerlTable::kThetaD, MerlTable::kPhiD};

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    throw Error(ErrorCode::read_failed, file + ": not a MERL table: " + why);
}

}  // namespace

std::shared_ptr<const MerlTable> MerlTable::read(const std::string& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) refuse(file, "no such file");
    if (const auto size = std::filesystem::file_size(file, failed); failed || size != kFileSize)
        refuse(file, "expected " + std::to_string(kFileSize) + " bytes (90 x 90 x 180 cells of three doubles), found " +
                         (failed ? "an unreadable file" : std::to_string(size)) + ". Was it copied whole?");
    std::ifstream stream(file, std::ios::binary);
    Dimensions dimensions{};
    stream.read(reinterpret_cast<char*>(dimensions.data()), sizeof(dimensions));
    if (stream && dimensions != kDimensions)
        refuse(file, "expected the dimensions 90 90 180, found " + std::to_string(dimensions[0]) + " " +
                         std::to_string(dimensions[1]) + " " + std::to_string(dimensions[2]));
    std::vector<double> numbers(3 * kCells);
    stream.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    if (!stream) refuse(file, "it cannot be read to its end; check its permissions");
    std::shared_ptr<MerlTable> table(new MerlTable(std::move(numbers)));
    if (table->measured_cells() == 0) refuse(file, "none of its numbers is a reflectance (finite and not negative)");
    table->set_file(file);
    return table;
}

void MerlTable::write(const std::string& file) const {
    AtomicFile target(file);
    std::fwrite(kDimensions.data(), sizeof(kDimensions), 1, target.handle());
    std::fwrite(m_numbers.data(), sizeof(double), m_numbers.size(), target.handle());
    target.commit();
}

}  // namespace burnish
