// The inputs of one MaterialX node, asked for by name, with the defaults of its definition. Internal: of the sources that read .mtlx.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/base/types.h>

#include <pugixml.hpp>

#include <set>
#include <string>
#include <vector>

namespace burnish {

class MaterialxInputs {
public:
    /// `where`: path to the node for messages, "wood.mtlx: SR_wood".
    MaterialxInputs(pugi::xml_node node, std::string where) : m_node(node), m_where(std::move(where)) {}

    /// A constant, or the default where it is not given or comes from a texture or graph, which is noted. Throws Error(bad_argument).
    float number(const char* name, NumberRange range, float preset);
    Color3f color(const char* name, NumberRange range, const Color3f& preset);

    /// One line for each input that was not a constant, and for each that was given and never asked for.
    std::vector<std::string> notes() const;

private:
    std::vector<float> values(const char* name, size_t count, NumberRange range, float preset);

    pugi::xml_node m_node;
    std::string m_where;
    std::set<std::string> m_asked;
    std::vector<std::string> m_notes;
};

}  // namespace burnish
