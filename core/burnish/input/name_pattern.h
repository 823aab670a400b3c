// Patterns over object names: comma-separated alternatives with * and ?.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// One alternative. Case matters; ? stands for one UTF-8 character; a backslash makes the next character literal.
class NamePattern {
public:
    explicit NamePattern(std::string_view text);

    bool has_wildcards() const { return m_has_wildcards; }
    /// The name itself, for a pattern without wildcards.
    const std::string& literal() const { return m_literal; }
    bool matches(std::string_view name) const;

private:
    enum class Kind : unsigned char { character, any_character, any_text };
    struct Token {
        Kind kind;
        char character;
    };
    std::vector<Token> m_tokens;
    std::string m_literal;
    bool m_has_wildcards = false;
};

/// The alternatives of `text`: split at commas that no backslash precedes, spaces around them dropped, empty ones left out.
std::vector<NamePattern> name_patterns(std::string_view text);

}  // namespace burnish
