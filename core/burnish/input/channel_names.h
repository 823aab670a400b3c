// What a channel name says: "ViewLayer.Diffuse Col.R" is component r of the layer "ViewLayer.Diffuse Col".
//
// Names are split at the LAST dot: view layer and pass names may hold dots' neighbours of any kind, spaces included, and
// Blender writes "ViewLayer.Pass.C". Layers are then compared by their last token in a normal form.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct ChannelName {
    std::string layer;      // "" for a bare name
    std::string component;  // as written: "R", "red", "Z", "pscale"
};

/// Splits at the last dot; names without one are all component.
ChannelName split_channel(std::string_view name);

/// "ViewLayer.Denoising Normal" -> "Denoising Normal".
std::string_view last_token(std::string_view layer);
/// "ViewLayer.Denoising Normal" -> "ViewLayer"; "" when there is one token only.
std::string_view parent_path(std::string_view layer);

/// Last token in lower case, without [ _-] and without the prefixes renderers put before pass names
/// ("vrayRE_Normals" -> "normals", "__Pworld" -> "pworld").
std::string normal_form(std::string_view layer);

/// One of r g b a x y z w u v for the spellings in use (R, red, X, ...), else the component in lower case.
std::string normal_component(std::string_view component);

/// Part or layer name without the view at its end: ("rgba_left", "left") -> "rgba".
std::string without_view(std::string_view name, std::string_view view);

}  // namespace burnish
