#include <burnish/input/metadata_spec.h>

#include <cstring>

namespace burnish {
namespace {

const OIIO::ParamValue* find(const Metadata& metadata, const std::string& name) {
    constexpr bool kCaseSensitive = true;
    return metadata.spec.find_attribute(name, OIIO::TypeUnknown, kCaseSensitive);
}

}  // namespace

std::vector<std::string> attribute_names(const Metadata& metadata) {
    std::vector<std::string> names;
    for (const OIIO::ParamValue& attribute : metadata.spec.extra_attribs) names.push_back(attribute.name().string());
    return names;
}

ChannelCounts channel_counts(const Metadata& metadata) { return metadata.channels; }

std::optional<std::string> string_attribute(const Metadata& metadata, const std::string& name) {
    const OIIO::ParamValue* attribute = find(metadata, name);
    if (!attribute || attribute->type() != OIIO::TypeString) return std::nullopt;
    return attribute->get_string();
}

std::optional<double> number_attribute(const Metadata& metadata, const std::string& name) {
    const OIIO::ParamValue* attribute = find(metadata, name);
    if (!attribute) return std::nullopt;
    const OIIO::TypeDesc type = attribute->type();
    if (type == OIIO::TypeDesc::DOUBLE) return *static_cast<const double*>(attribute->data());
    if (type == OIIO::TypeFloat) return attribute->get_float();
    if (type == OIIO::TypeInt) return attribute->get_int();
    return std::nullopt;
}

std::optional<Matrix44f> matrix_attribute(const Metadata& metadata, const std::string& name) {
    const OIIO::ParamValue* attribute = find(metadata, name);
    if (!attribute) return std::nullopt;
    const OIIO::TypeDesc type = attribute->type();
    if (type != OIIO::TypeMatrix && type != OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 16)) return std::nullopt;
    Matrix44f matrix;
    std::memcpy(matrix.getValue(), attribute->data(), 16 * sizeof(float));
    return matrix;
}

}  // namespace burnish
