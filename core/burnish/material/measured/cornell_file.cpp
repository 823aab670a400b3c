#include <burnish/material/measured/cornell_file.h>
#include <burnish/material/measured/gonio_pairs.h>
#include <burnish/material/measured/number_text.h>
#include <burnish/material/measured/spectrum_color.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr double kMostWavelengths = 1000;

std::vector<double> all_numbers(const NumberText& text) {
    std::vector<double> all;
    for (const NumberText::Line& line : text.lines()) {
        if (line.text.starts_with('#')) continue;
        const std::vector<double> numbers = text.numbers(line);
        all.insert(all.end(), numbers.begin(), numbers.end());
    }
    return all;
}

/// Takes the wavelengths off the front.
std::vector<double> take_wavelengths(const NumberText& text, std::vector<double>& numbers) {
    if (numbers.empty()) text.refuse("holds no numbers");
    const double count = numbers.front();
    if (!(count >= 2 && count <= kMostWavelengths && count == std::floor(count) && count < static_cast<double>(numbers.size())))
        text.refuse("expected the number of wavelengths first, from 2 to 1000, found " + std::to_string(count));
    const auto first = numbers.begin() + 1, end = first + static_cast<std::ptrdiff_t>(count);
    const std::vector<double> wavelengths(first, end);
    if (std::ranges::adjacent_find(wavelengths, std::greater_equal{}) != wavelengths.end())
        text.refuse("expected rising wavelengths in nm after their number");
    numbers.erase(numbers.begin(), end);
    return wavelengths;
}

}  // namespace

std::shared_ptr<const GonioTable> read_cornell(const std::string& file) {
    const NumberText text(file);
    std::vector<double> numbers = all_numbers(text);
    const std::vector<double> wavelengths = take_wavelengths(text, numbers);
    const size_t row_size = 4 + wavelengths.size();
    if (numbers.empty() || numbers.size() % row_size != 0)
        text.refuse("expected rows of four angles and " + std::to_string(wavelengths.size()) + " values, found " +
                    std::to_string(numbers.size()) + " numbers in all. Was it copied whole?");
    const SpectrumColor color(wavelengths);
    std::vector<BrdfSample> samples;
    for (const double* row = numbers.data(); row < numbers.data() + numbers.size(); row += row_size) {
        const auto sample = gonio_sample({row[0], row[1], row[2], row[3], color(row + 4)}, false);
        if (sample) samples.push_back(*sample);
    }
    if (samples.empty()) text.refuse("no row is above the horizon; are its angles in radians?");
    auto table = std::make_shared<GonioTable>(std::move(samples), true);
    table->set_file(file);
    return table;
}

}  // namespace burnish
