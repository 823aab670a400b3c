#include <burnish/input/name_pattern.h>

namespace burnish {
namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Past the UTF-8 character at `i`.
size_t next_character(std::string_view name, size_t i) {
    do ++i;
    while (i < name.size() && continues_character(name[i]));
    return i;
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

NamePattern::NamePattern(std::string_view text) {
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size())
            m_tokens.push_back({Kind::character, text[++i]});
        else if (text[i] == '*')
            m_tokens.push_back({Kind::any_text, '*'});
        else if (text[i] == '?')
            m_tokens.push_back({Kind::any_character, '?'});
        else
            m_tokens.push_back({Kind::character, text[i]});
        m_has_wildcards |= m_tokens.back().kind != Kind::character;
        m_literal += m_tokens.back().character;
    }
}

// Greedy, with one place to come back to: the last *. Time is the product of the lengths at worst, never more.
bool NamePattern::matches(std::string_view name) const {
    constexpr size_t kNone = static_cast<size_t>(-1);
    size_t t = 0, i = 0, star = kNone, resume = 0;
    while (i < name.size()) {
        const bool more = t < m_tokens.size();
        if (more && m_tokens[t].kind == Kind::any_text) {
            star = t++, resume = i;
        } else if (more && m_tokens[t].kind == Kind::any_character) {
            ++t, i = next_character(name, i);
        } else if (more && m_tokens[t].character == name[i]) {
            ++t, ++i;
        } else if (star != kNone) {
            t = star + 1, i = resume = next_character(name, resume);
        } else {
            return false;
        }
    }
    while (t < m_tokens.size() && m_tokens[t].kind == Kind::any_text) ++t;
    return t == m_tokens.size();
}

std::vector<NamePattern> name_patterns(std::string_view text) {
    std::vector<NamePattern> patterns;
    const auto add = [&patterns](std::string_view part) {
        if (part = trimmed(part); !part.empty()) patterns.emplace_back(part);
    };
    size_t begin = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == ',')
            add(text.substr(begin, i - begin)), begin = i + 1;
    }
    add(text.substr(begin));
    return patterns;
}

}  // namespace burnish
