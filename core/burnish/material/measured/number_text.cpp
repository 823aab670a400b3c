#include <burnish/base/error.h>
#include <burnish/material/measured/number_text.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace burnish {
namespace {

constexpr std::uintmax_t kLargest = 1 << 25;
constexpr std::string_view kSpaces = " \t\r\v\f,;";

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// A word for a message: the beginning of it, without what a terminal might act upon.
std::string shown(std::string_view word) {
    std::string text(word.substr(0, 24));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return "\"" + text + "\"";
}

}  // namespace

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> result;
    while (!(text = trimmed(text)).empty()) {
        result.push_back(text.substr(0, text.find_first_of(kSpaces)));
        text.remove_prefix(result.back().size());
    }
    return result;
}

NumberText::NumberText(const std::string& file) : m_file(file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) refuse("no such file");
    const auto size = std::filesystem::file_size(file, failed);
    if (failed || size > kLargest) refuse("expected a text of at most 32 MB, found " + std::to_string(size) + " bytes");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse("cannot be read; check its permissions");
    m_text.assign(std::istreambuf_iterator<char>(stream), {});
    std::string_view rest = m_text;
    for (int number = 1; !rest.empty(); ++number) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        if (const std::string_view line = trimmed(rest.substr(0, end)); !line.empty()) m_lines.push_back({number, line});
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

std::vector<double> NumberText::numbers(const Line& line) const {
    std::vector<double> result;
    for (std::string_view word : words(line.text)) {
        double number = 0;
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error != std::errc() || end != digits.data() + digits.size())
            refuse(line, "expected a number, found " + shown(word));
        if (!std::isfinite(number)) refuse(line, "expected a finite number, found " + shown(word));
        result.push_back(number);
    }
    return result;
}

void NumberText::refuse(const Line& line, const std::string& why) const {
    throw Error(ErrorCode::read_failed, m_file + ": line " + std::to_string(line.number) + ": " + why);
}

void NumberText::refuse(const std::string& why) const { throw Error(ErrorCode::read_failed, m_file + ": " + why); }

}  // namespace burnish
