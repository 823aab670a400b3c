// One rendered frame as burnish sees it: layers by role, windows, camera, ids and the metadata to keep.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>
#include <burnish/input/renderer.h>
#include <burnish/input/roles.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// Opaque copy of the input file's attributes (windows, camera, timecode, ...), written back by the EXR writer.
struct Metadata;

/// One cryptomatte of a file (specification 1.2.0), ranks in descending coverage.
struct Cryptomatte {
    std::string name;                          // layer prefix, e.g. "ViewLayer.CryptoObject"
    std::vector<Image> ranks;                  // each 2 channels: id (float whose bits are the hash), coverage in [0, 1]
    std::map<std::string, uint32_t> manifest;  // object name -> id bits; empty when the file has none
    std::vector<std::string> channels;         // of the file, two a rank, by layer and component
};

/// A frame in memory, or a band of its rows. Every layer has the size of `data_window`. Layers are linear; data layers are never colour managed.
struct AovFrame {
    std::string file;
    Renderer renderer = Renderer::unknown;  // by the file's fingerprint; says what its passes mean
    Window data_window, display_window;
    int margin_above = 0,
        margin_below = 0;  // rows of a band that are there for their neighbours only: not counted, not written
    int shaded_above = 0, shaded_below = 0;  // those of the margins, next to the band, that are shaded all the same
    bool has_shaded_margins() const { return shaded_above + shaded_below > 0; }
    std::map<Role, Image> layers;
    std::optional<Camera> camera;
    std::vector<Cryptomatte> cryptomattes;
    std::shared_ptr<const Metadata> metadata;
    bool divided_by_albedo = false;  // light passes are to be multiplied by their colour pass (Cycles, V-Ray raw)
    std::vector<std::string> notes;  // what was found and why, one line each, for `info` and the report
    std::vector<std::string> warnings;

    /// What messages call the frame: its file, or "frame" for one made of arrays.
    std::string label() const { return file.empty() ? "frame" : file; }
    size_t pixel_count() const { return static_cast<size_t>(data_window.width) * static_cast<size_t>(data_window.height); }
    bool has(Role role) const { return layers.count(role) != 0; }
    /// The layer that fills `role`, or null.
    const Image* find(Role role) const {
        const auto found = layers.find(role);
        return found == layers.end() ? nullptr : &found->second;
    }
    /// The layer that fills `role`; throws Error(missing_channel), naming what was looked for, when there is none.
    const Image& layer(Role role) const;
};

}  // namespace burnish
