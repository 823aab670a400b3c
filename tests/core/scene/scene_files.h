// Scene files written by tests.
#pragma once

#include "../scratch.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace burnish_test {

inline std::string written(const Scratch& folder, const std::string& name, const std::string& bytes) {
    std::ofstream(folder.file(name), std::ios::binary) << bytes;
    return folder.file(name);
}

template <class T>
void append(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A unit square in the plane z = 0 of glTF, facing +Z: positions, texture coordinates (v down, as glTF has it), indices.
inline std::string square_buffer() {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    append<float>(bytes, {0, 1, 1, 1, 1, 0, 0, 0});
    append<float>(bytes, {0, 0.5f, 0.5f, 0.5f, 0.5f, 0, 0, 0});
    append<uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    return bytes;
}

inline nlohmann::json square_gltf() {
    return nlohmann::json::parse(R"({
      "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "square", "mesh": 0, "extras": {"pass_index": 7}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "indices": 3, "material": 0}]}],
      "materials": [{"name": "lamp", "extras": {"pass_index": 4}, "emissiveFactor": [1, 0.5, 0.25],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}},
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]}}],
      "buffers": [{"byteLength": 124}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
        {"buffer": 0, "byteOffset": 80, "byteLength": 32}, {"buffer": 0, "byteOffset": 112, "byteLength": 12}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
}

inline std::string glb(std::string text, std::string buffer) {
    text.resize((text.size() + 3) / 4 * 4, ' '), buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    append<uint32_t>(bytes, {2, static_cast<uint32_t>(28 + text.size() + buffer.size()), static_cast<uint32_t>(text.size())});
    bytes += "JSON" + text;
    append<uint32_t>(bytes, {static_cast<uint32_t>(buffer.size())});
    return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::string square_glb() { return glb(square_gltf().dump(), square_buffer()); }

}  // namespace burnish_test
