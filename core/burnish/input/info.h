// What burnish sees in a frame, why, and what it can do with it: the text behind `burnish info`.
#pragma once

#include <burnish/input/frame.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace burnish {

/// Something a job can do with a frame, and what the frame lacks for it.
struct Possibility {
    std::string name;                  // "add", "replace", ...
    std::string help;                  // what it does
    std::vector<std::string> missing;  // empty: it can be done
};

/// add, lights, replace, difference, diffuse, objects, cryptomatte, anisotropy; for a frame read with all roles and cryptomattes.
std::vector<Possibility> possibilities(const AovFrame& frame);

/// Lines for people: windows, decisions, warnings, possibilities.
std::string describe(const AovFrame& frame);

/// The same for machines: {file, renderer, data_window, display_window, roles, cryptomattes, camera, notes, warnings, jobs}.
/// Windows are [x, y, width, height]. Bytes that are not UTF-8 are replaced.
nlohmann::json describe_json(const AovFrame& frame);

}  // namespace burnish
