#include <burnish/base/error.h>
#include <burnish/material/measured/merl_names.h>

#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

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
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr);
    std::vector<char> block(1 << 16);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0)
        EVP_DigestUpdate(digest.get(), block.data(), static_cast<size_t>(stream.gcount()));
    if (!stream.eof())
        throw Error(ErrorCode::read_failed, file + ": cannot be read; check that it is a file and its permissions");
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned int count = 0;
    EVP_DigestFinal_ex(digest.get(), bytes, &count);
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < count; ++i) text += {kDigits[bytes[i] >> 4], kDigits[bytes[i] & 15]};
    return text;
}

std::string_view merl_name(const std::string& file) {
    const std::string hash = sha256_of(file);
    const auto found = std::ranges::find(merl_files(), std::string_view(hash), &MerlFile::sha256);
    return found == merl_files().end() ? "" : found->name;
}

}  // namespace burnish
