#include <burnish/input/near_names.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace burnish {
namespace {

constexpr size_t kLongest = 100;  // characters that are compared

std::string folded(const std::string& name) {
    std::string result = name.substr(0, kLongest);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Levenshtein distance.
size_t edits(const std::string& a, const std::string& b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < b.size(); ++j) {
            const size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

size_t distance(const std::string& wanted, const std::string& name) {
    const std::string a = folded(wanted), b = folded(name);
    return a.size() > 2 && b.find(a) != std::string::npos ? 1 : edits(a, b);
}

}  // namespace

std::string near_names(const std::string& wanted, const std::vector<std::string>& names, size_t count) {
    std::vector<std::pair<size_t, std::string>> ranked;
    for (const std::string& name : names) ranked.emplace_back(distance(wanted, name), name);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (size_t i = 0; i < std::min(count, ranked.size()); ++i) text += (i ? ", \"" : "\"") + ranked[i].second + "\"";
    return text;
}

}  // namespace burnish
