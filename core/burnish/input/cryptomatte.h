// Cryptomattes (specification 1.2.0): which named objects cover a pixel, and by how much.
//
// Layers {name}00, {name}01, ... hold (id, coverage, id, coverage), largest coverage first. An id is the MurmurHash3 of the
// object's UTF-8 name, kept as the bits of a 32-bit float: ids are compared as bits and never filtered. The header names the
// cryptomatte and may list the object names (the manifest), as text or in a JSON file beside the EXR.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/frame.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// Id of an object name: MurmurHash3_x86_32 with seed 0, its lowest exponent bit flipped where the float would be zero,
/// denormal, infinite or NaN.
uint32_t cryptomatte_id(std::string_view name);

/// The id that pixels show of a name with this hash. Blender's manifests list the hash itself.
constexpr uint32_t cryptomatte_id_of_hash(uint32_t hash) {
    const uint32_t exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

/// What a file holds, in terms that need no image library.
struct CryptomatteSource {
    struct Attribute {
        std::string name, value;  // string attributes, e.g. "cryptomatte/f834d0a/name"
    };
    struct Channel {
        std::string name;  // full, e.g. "ViewLayer.CryptoObject00.r"
        bool is_float;     // stored with 32 bits; half channels hold no ids
    };
    std::string file;  // the EXR: manifest files lie beside it, and messages name it
    std::vector<Attribute> attributes;
    std::vector<Channel> channels;
};

/// All cryptomattes of a file, without their pixels; object cryptomattes come before material and asset ones. A damaged one (no layers, half
/// channels) is left out, a damaged manifest is left empty, and `warnings` says so. Manifest files outside the EXR's folder
/// are not opened.
std::vector<Cryptomatte> decode_cryptomattes(const CryptomatteSource& source, std::vector<std::string>& warnings);

/// Ids of the objects that `patterns` name: comma-separated, * for any text, ? for one character, \ before a character that
/// is meant as such. A text that is exactly a name of the manifest is that name, whatever characters it has. Names without
/// wildcards work without a manifest. Sorted. Throws Error(bad_argument) for wildcards without a manifest.
std::vector<uint32_t> matching_ids(const Cryptomatte& cryptomatte, const std::string& patterns);

/// Share of one pixel that objects with the given ids (sorted) cover, in [0, 1].
float cryptomatte_coverage(const Cryptomatte& cryptomatte, const std::vector<uint32_t>& ids, size_t pixel);

/// Share of each pixel that objects with the given ids (sorted) cover, 1 channel in [0, 1].
Image cryptomatte_coverage(const Cryptomatte& cryptomatte, const std::vector<uint32_t>& ids);

}  // namespace burnish
