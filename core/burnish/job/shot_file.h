// The shot file: one JSON document that says what a job is. Its fields are the settings (settings.h), grouped in sections.
//
//     { "aovs": "shot.####.exr", "channels": {"normal": "ViewLayer.Normal"}, "camera": {...},
//       "lights": {"sky": {"type": "environment", "file": "sky.hdr", "rotate": 30}, "floor": {"type": "mirror", ...}},
//       "materials": {"brass": {...}}, "assign": [{"material": "brass", "index": 3, "light": ["floor", "sky"]}],
//       "quality": {"samples": 19}, "surface": {...}, "composite": {...}, "color": {...},
//       "output": {"file": "out.####.exr", "report": "out.json"} }
#pragma once

#include <burnish/job/job.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace burnish {

/// A job from a shot document. `where` names the document in messages ("shot.json: quality.samples: expected ...");
/// relative paths are taken from `folder`. Throws Error(bad_argument).
Job job_from_json(const nlohmann::json& document, const std::string& where, const std::filesystem::path& folder = {});

/// The document that gives this job again; settings at their defaults are left out.
nlohmann::json job_to_json(const Job& job);

/// Reads a shot file. Throws Error(read_failed) when it cannot be read and Error(bad_argument), with line and column, when
/// it is not JSON.
Job read_shot_file(const std::string& file);

/// The JSON schema of the shot file, made from the settings table; the build ships it as shot.schema.json.
nlohmann::json shot_schema();

}  // namespace burnish
