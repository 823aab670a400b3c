// The OpenColorIO config burnish uses where a studio has none: linear Rec.709 and the ACES spaces with Bradford adaptation,
// the piecewise sRGB curve, no tone mapping. Aliases are the names renderers and the common configs give the same spaces.
#pragma once

namespace burnish {

inline constexpr const char* kPlainColorConfig = R"(ocio_profile_version: 2
strictparsing: true
roles:
  default: lin_rec709
  scene_linear: lin_rec709
  rendering: lin_rec709
  aces_interchange: ACES2065-1
  data: raw
  color_picking: sRGB
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  sRGB:
    - !<View> {name: Standard, colorspace: sRGB}
    - !<View> {name: Raw, colorspace: raw}
active_displays: [sRGB]
active_views: [Standard, Raw]
colorspaces:
  - !<ColorSpace>
    name: lin_rec709
    aliases: [linear, lin_srgb, lin_rec709_scene, lin_rec709_srgb, Linear Rec.709, Linear Rec.709 (sRGB), Utility - Linear - sRGB]
    family: Linear
    encoding: scene-linear
  - !<ColorSpace>
    name: ACEScg
    aliases: [lin_ap1, lin_ap1_scene, ACES - ACEScg]
    family: Linear
    encoding: scene-linear
    to_scene_reference: !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD}
  - !<ColorSpace>
    name: ACES2065-1
    aliases: [lin_ap0, lin_ap0_scene, ACES - ACES2065-1]
    family: Linear
    encoding: scene-linear
    to_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1, direction: inverse}
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD}
  - !<ColorSpace>
    name: sRGB
    aliases: [srgb_texture, srgb_tx, srgb_rec709_scene, sRGB - Texture, sRGB Encoded Rec.709 (sRGB), Utility - sRGB - Texture]
    family: Encoded
    encoding: sdr-video
    to_scene_reference: !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055}
  - !<ColorSpace>
    name: raw
    aliases: [non-color, Utility - Raw]
    family: Data
    isdata: true
)";

}  // namespace burnish
