// Text files full of numbers, as goniometers write them: read whole, bounded in size, every number finite.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// The lines of a measurement's file, comments and all. Throws Error(read_failed) for one that is absent, no file or larger than 32 MB.
class NumberText {
public:
    struct Line {
        int number;
        std::string_view text;  // without spaces at its ends
    };

    explicit NumberText(const std::string& file);
    NumberText(const NumberText&) = delete;
    NumberText& operator=(const NumberText&) = delete;

    /// Those with something on them.
    const std::vector<Line>& lines() const { return m_lines; }
    /// The numbers of a line; throws Error(read_failed), naming file and line, for words and for what is not finite.
    std::vector<double> numbers(const Line& line) const;
    /// Throws Error(read_failed) "file: line n: why".
    [[noreturn]] void refuse(const Line& line, const std::string& why) const;
    [[noreturn]] void refuse(const std::string& why) const;

private:
    std::string m_file, m_text;
    std::vector<Line> m_lines;
};

/// The words of a text.
std::vector<std::string_view> words(std::string_view text);

}  // namespace burnish
